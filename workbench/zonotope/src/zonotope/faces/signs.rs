//! Faces as sign vectors, exactly: on which side of its plane each generator lies for the normals of the face.

use std::cmp::Ordering;

use super::lattice::{Edge, FaceLattice, Facet, Vertex, Zone};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::orientation::in_space::determinant_sign;

/// The coefficient of a generator in a face: at one end of its segment, or anywhere on it (`Equal`).
type Signs = Vec<Ordering>;

impl FaceLattice {
    /// For each generator, the coefficient that every point of the facet has: 1 (`Greater`), −1 (`Less`), or for the
    /// generators along the facet and zero ones none (`Equal`). O(n) exact determinants.
    pub fn facet_signs(&self, facet: Facet) -> Signs {
        self.of_generators(&self.facet_zone_signs(facet))
    }

    /// As [`facet_signs`](Self::facet_signs), for an edge.
    pub fn edge_signs(&self, edge: Edge) -> Signs {
        let mut signs = self.vertex_zone_signs(self.edge_ends(edge)[0]);
        signs[self.edge_zone(edge).0 as usize] = Ordering::Equal;
        self.of_generators(&signs)
    }

    /// As [`facet_signs`](Self::facet_signs), for a vertex: only zero generators have none.
    pub fn vertex_signs(&self, vertex: Vertex) -> Signs {
        self.of_generators(&self.vertex_zone_signs(vertex))
    }

    /// A vertex exactly: the centre and ± every generator. O(n) exact operations.
    pub fn exact_point(&self, vertex: Vertex) -> [Dyadic; 3] {
        let signs = self.vertex_signs(vertex);
        let center = self.body.center().map(Dyadic::from_f64);
        self.body.generators().iter().zip(signs).fold(center, |sum, (generator, sign)| {
            let term = generator.map(Dyadic::from_f64);
            let add = |k: usize| match sign {
                Ordering::Less => &sum[k] - &term[k],
                Ordering::Equal => sum[k].clone(),
                Ordering::Greater => &sum[k] + &term[k],
            };
            std::array::from_fn(add)
        })
    }

    /// The outward normal of a facet, exactly: the cross product of two generators along it or the opposite.
    pub fn exact_normal(&self, facet: Facet) -> [Dyadic; 3] {
        let half = self.facet_count() as u32 / 2;
        let [a, b] = self.spanning_zones(facet.0 % half);
        let [a, b] = [a, b].map(|zone| self.circles.directions[zone].original().map(Dyadic::from_f64));
        let minor = |k: usize, l: usize| &a[k] * &b[l] - &a[l] * &b[k];
        let normal = [minor(1, 2), minor(2, 0), minor(0, 1)];
        if facet.0 < half { normal } else { normal.map(|c| -c) }
    }

    /// The outward normal of a facet, of any length but neither tiny nor huge; its direction within 2^-38.
    pub fn normal(&self, facet: Facet) -> [f64; 3] {
        let half = self.facet_count() as u32 / 2;
        let [a, b] = self.spanning_zones(facet.0 % half).map(|zone| self.circles.directions[zone].scaled());
        let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        // coordinates of a and b are below 2, so each of the normal's is off by less than 2^-49
        if normal.iter().any(|c| c.abs() > 1.0 / 1024.0) {
            return if facet.0 < half { normal } else { normal.map(|c| -c) };
        }
        let exact = self.exact_normal(facet);
        let exponent = exact.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        exact.map(|c| c.scaled(-exponent).to_f64())
    }

    /// Two zones of a facet of the first half, the one further north first: their generators' cross product points
    /// outward.
    fn spanning_zones(&self, facet: u32) -> [usize; 2] {
        let mut zones = self.facet_zones(Facet(facet)).map(|zone| zone.0 as usize);
        [0, 1].map(|_| zones.next().expect("a facet has at least two zones, in the order from north to south"))
    }

    fn facet_zone_signs(&self, facet: Facet) -> Signs {
        let half = self.facet_count() as u32 / 2;
        let [a, b] = self.spanning_zones(facet.0 % half).map(|zone| &self.circles.directions[zone]);
        let sign = |v| determinant_sign(a, b, v);
        let signs = self.circles.directions.iter().map(sign);
        if facet.0 < half { signs.collect() } else { signs.map(Ordering::reverse).collect() }
    }

    /// The signs of a cell: those of the crossing where it begins in the west, and the circles through it that are
    /// north of the cell.
    fn vertex_zone_signs(&self, vertex: Vertex) -> Signs {
        let half = self.vertex_count() as u32 / 2;
        if vertex.0 >= half {
            let opposite = self.vertex_zone_signs(self.opposite_vertex(vertex));
            return opposite.into_iter().map(Ordering::reverse).collect();
        }
        if vertex.0 + 1 == half {
            return vec![Ordering::Greater; self.zone_count()];
        }
        let (mut low, mut high) = (0, self.facet_count() as u32 / 2);
        while high - low > 1 {
            let middle = low.midpoint(high);
            if self.first_vertex_of(middle) <= vertex.0 { low = middle } else { high = middle }
        }
        let facet = Facet(low);
        let south_of = vertex.0 - self.first_vertex_of(low) + 1;
        let mut signs = self.facet_zone_signs(facet);
        let zones: Vec<Zone> = self.facet_zones(facet).collect();
        for (from_south, zone) in zones.iter().rev().enumerate() {
            // east of the crossing its circles have changed places: the last of the zones is the northernmost circle
            signs[zone.0 as usize] = if from_south < south_of as usize { Ordering::Less } else { Ordering::Greater };
        }
        signs
    }

    /// Signs of zones as signs of generators.
    fn of_generators(&self, zones: &[Ordering]) -> Signs {
        let mut signs = vec![Ordering::Equal; self.body.generators().len()];
        for (zone, &sign) in zones.iter().enumerate() {
            for member in self.zone_generators(Zone(zone as u32)) {
                signs[member.generator] = if member.reversed { sign.reverse() } else { sign };
            }
        }
        signs
    }
}
