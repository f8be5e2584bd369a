//! The facets of the zonotopes along some directions, each with its neighbours: the one that a ray from the centre
//! meets is few steps from one that a ray near it met.
//!
//! Which directions span a facet, and on which side of it each other one is, depends on the directions alone, not on
//! their coefficients. So the map is drawn once, as far as rays lead into it, and is good for all zonotopes along these
//! directions. With S = Σ s_j c_j v_j over the directions off the basis b of a facet, q = Σ a_i v_b(i) + a_last S: the
//! ray of q meets the facet just when |a_i| ≤ c_b(i) a_last for all i, and leaves there at the multiple 1 / a_last.
//! Where |a_i| is larger the ray passes beyond that edge of the facet, and the facet on the other side of the edge is
//! nearer. Opposite facets share a chart. Rays that are far from all facets known so far are searched for by
//! [`FacetDescent`].

use std::collections::BTreeMap;

use super::chart::{Chart, NOWHERE};
use super::descent::FacetDescent;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::directions::cube_faces::cell_at;

/// The facets of zonotopes along directions, as far as they are known.
pub(crate) struct FacetMap<const D: usize> {
    rank: usize,
    directions: Vec<[f64; D]>,
    coefficients: Vec<f64>,
    descent: FacetDescent<D>,
    /// Which coefficients these are, counted from 1.
    edition: u32,
    charts: Vec<Chart<D>>,
    place_of: BTreeMap<[usize; D], u32>,
    /// For each cell of directions the facet that the last ray there met.
    cells: Vec<u32>,
    /// How many cells there are along an edge of a face of the cube.
    per_edge: usize,
}

/// Where a ray leaves the zonotope.
pub(crate) struct Exit<const D: usize> {
    /// The multiple of the ray's vector at which the ray leaves: 1 over the gauge of that vector.
    pub(crate) reach: f64,
    /// The facet's normal of length 1, away from the centre.
    pub(crate) normal: [f64; D],
    /// The directions that span the facet, in increasing order.
    pub(crate) basis: [usize; D],
    /// Σ δ_i c_i v_i as it was summed up in floating point, for coefficients of this size at most.
    pub(crate) sum: [f64; D],
    pub(crate) most: f64,
}

/// A walk along known facets ends after this many steps;
const STEP_LIMIT: usize = 64;

/// and after this many facets that were not yet known: the ray's exit is then searched for anew.
const NEW_FACET_LIMIT: usize = 8;

/// The charts hold at most about this many numbers.
const KEPT_NUMBER_LIMIT: usize = 1 << 24;

/// The map has about this many cells of directions, each with a chart to start at.
const CELL_COUNT: usize = 1 << 13;

/// A coefficient beyond its limit by less than this part is within it.
const COEFFICIENT_TOLERANCE: f64 = 1e-13;

impl<const D: usize> FacetMap<D> {
    /// An empty map for directions that span the first `rank` coordinates.
    pub(crate) fn new(rank: usize, directions: &[[f64; D]]) -> Self {
        let per_edge =
            (1..).find(|&edge: &usize| rank * edge.pow(rank as u32 - 1) >= CELL_COUNT || rank == 1).unwrap_or(1);
        Self {
            rank,
            directions: directions.to_vec(),
            coefficients: vec![0.0; directions.len()],
            descent: FacetDescent::new(rank, directions),
            edition: 0,
            charts: Vec::new(),
            place_of: BTreeMap::new(),
            cells: vec![NOWHERE; rank * per_edge.pow(rank as u32 - 1)],
            per_edge,
        }
    }

    /// From now on the zonotope is that of these coefficients.
    pub(crate) fn set_coefficients(&mut self, coefficients: &[f64]) {
        self.coefficients.copy_from_slice(coefficients);
        let generators: Vec<[f64; D]> =
            self.directions.iter().zip(coefficients).map(|(v, c)| v.map(|v| v * c)).collect();
        self.descent = FacetDescent::new(self.rank, &generators);
        self.edition += 1;
    }

    /// Where the ray of a vector leaves; `None` as for [`FacetDescent::facet`].
    pub(crate) fn exit(&mut self, ray: &[f64; D]) -> Option<Exit<D>> {
        let cell = self.cell(ray);
        let start = self.cells[cell];
        if let Some((place, exit)) = self.walk(start, ray) {
            self.cells[cell] = place;
            return Some(exit);
        }
        let found = self.descent.facet(ray)?;
        let length = dot(&found.normal, &found.normal).sqrt();
        let normal = found.normal.map(|c| c / length);
        if let Some(chart) = Chart::at(self.rank, &self.directions, found.basis, &found.coefficients) {
            self.cells[cell] = self.insert(chart);
        }
        let terms = self.directions.iter().zip(&self.coefficients).zip(&found.coefficients);
        let sum = terms.fold([0.0; D], |sum, ((v, c), delta)| std::array::from_fn(|i| sum[i] + v[i] * c * delta));
        let reach = found.reach;
        let sum = sum.map(|c| c / reach);
        let basis = sorted(self.rank, found.basis);
        Some(Exit { reach, normal, basis, sum, most: 1.0 / reach })
    }

    /// From facet to facet towards the ray; `None` where that takes long.
    fn walk(&mut self, start: u32, ray: &[f64; D]) -> Option<(u32, Exit<D>)> {
        let last = self.rank - 1;
        let (mut place, mut is_new) = (start, 0);
        for _ in 0..STEP_LIMIT {
            if place == NOWHERE {
                return None;
            }
            let chart = &mut self.charts[place as usize];
            chart.refresh(self.rank, &self.directions, &self.coefficients, self.edition);
            let turned: [f64; D] = std::array::from_fn(|i| dot(&chart.rows[i], ray));
            let flip = if turned[last] < 0.0 { -1.0 } else { 1.0 };
            let a = turned.map(|a| a * flip);
            if a[last].is_nan() || a[last] <= 0.0 {
                return None;
            }
            let mut worst = (0.0, NOWHERE as usize);
            for (i, &b) in chart.basis[..last].iter().enumerate() {
                let limit = self.coefficients[b] * a[last];
                let beyond = a[i].abs() - limit * (1.0 + COEFFICIENT_TOLERANCE);
                if beyond > worst.0 {
                    let size: f64 = chart.rows[i].iter().zip(ray).map(|(r, q)| (r * q).abs()).sum();
                    if beyond > 8.0 * UNIT * size {
                        worst = (beyond, i);
                    }
                }
            }
            let (beyond, leaving) = worst;
            if beyond == 0.0 {
                let bases = chart.basis[..last].iter().zip(&a);
                let sum = bases.fold(chart.sum.map(|c| c * a[last]), |sum, (&b, a)| {
                    std::array::from_fn(|c| sum[c] + a * self.directions[b][c])
                });
                let [normal, sum] = [chart.normal, sum].map(|v| v.map(|c| c * flip));
                let basis = sorted(self.rank, chart.basis);
                let most = a[last] * (1.0 + 2.0 * COEFFICIENT_TOLERANCE);
                return Some((place, Exit { reach: 1.0 / a[last], normal, basis, sum, most }));
            }
            let side = usize::from(a[leaving] < 0.0);
            place = match chart.next[leaving][side] {
                NOWHERE if is_new < NEW_FACET_LIMIT => {
                    is_new += 1;
                    let next = chart.beyond(self.rank, &self.directions, leaving, side)?;
                    let found = self.insert(next);
                    self.charts[place as usize].next[leaving][side] = found;
                    found
                }
                next => next,
            };
        }
        None
    }

    /// The place of a facet, old or new.
    fn insert(&mut self, chart: Chart<D>) -> u32 {
        let key = sorted(self.rank, chart.basis);
        if let Some(&place) = self.place_of.get(&key) {
            return place;
        }
        if self.charts.len().saturating_mul(self.directions.len() + 8 * D * D) > KEPT_NUMBER_LIMIT {
            return NOWHERE;
        }
        let place = self.charts.len() as u32;
        self.charts.push(chart);
        self.place_of.insert(key, place);
        place
    }

    /// The cell of a ray's line: a face of the cube, and a square on it.
    fn cell(&self, ray: &[f64; D]) -> usize {
        let face = (0..self.rank).fold(0, |face, c| if ray[c].abs() > ray[face].abs() { c } else { face });
        let others = (0..self.rank).filter(|&c| c != face);
        others.fold(face, |cell, c| cell * self.per_edge + cell_at(ray[c] / ray[face], self.per_edge as u32) as usize)
    }
}

fn sorted<const D: usize>(rank: usize, mut basis: [usize; D]) -> [usize; D] {
    basis[..rank - 1].sort_unstable();
    basis
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    fn agrees<const D: usize>(directions: &[[f64; D]], coordinate: &mut impl FnMut() -> f64) {
        let mut map = FacetMap::new(D, directions);
        for _ in 0..3 {
            let coefficients: Vec<f64> = directions.iter().map(|_| coordinate().abs() + 0.01).collect();
            map.set_coefficients(&coefficients);
            let generators: Vec<[f64; D]> =
                directions.iter().zip(&coefficients).map(|(v, c)| v.map(|v| v * c)).collect();
            let mut descent = FacetDescent::new(D, &generators);
            for _ in 0..60 {
                let ray: [f64; D] = std::array::from_fn(|_| coordinate());
                let (exit, facet) = (map.exit(&ray).expect("they span"), descent.facet(&ray).expect("they span"));
                assert!((exit.reach - facet.reach).abs() <= 1e-11 * facet.reach, "{} {}", exit.reach, facet.reach);
                let height: f64 = generators.iter().map(|g| dot(g, &exit.normal).abs()).sum();
                assert!((height - exit.reach * dot(&exit.normal, &ray)).abs() <= 1e-11 * height);
                assert!((0..D).all(|c| (exit.sum[c] - ray[c]).abs() <= 1e-11));
                assert!((exit.most * exit.reach - 1.0).abs() < 1e-12);
            }
        }
        assert!(map.charts.len() > 1 || D == 1);
    }

    #[test]
    fn rays_leave_where_a_search_finds() {
        let mut rng = rand_pcg::Pcg64::seed_from_u64(3);
        for count in [4, 7, 20] {
            let mut coordinate = || rng.random_range(-1.0..1.0);
            let directions: Vec<[f64; 3]> = (0..count).map(|_| std::array::from_fn(|_| coordinate())).collect();
            agrees(&directions, &mut coordinate);
            let directions: Vec<[f64; 2]> = (0..count).map(|_| std::array::from_fn(|_| coordinate())).collect();
            agrees(&directions, &mut coordinate);
            let directions: Vec<[f64; 4]> = (0..count).map(|_| std::array::from_fn(|_| coordinate())).collect();
            agrees(&directions, &mut coordinate);
        }
        agrees(&[[0.5]], &mut || 0.25);
    }

    #[test]
    fn many_directions_in_a_plane() {
        let mut rng = rand_pcg::Pcg64::seed_from_u64(4);
        let side = [-1.0, 0.0, 1.0];
        let all = side.iter().flat_map(|&x| side.iter().flat_map(move |&y| side.map(move |z| [x, y, z])));
        // one of each line
        let directions: Vec<[f64; 3]> =
            all.filter(|v| v.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0)).collect();
        agrees(&directions, &mut || rng.random_range(-1.0..1.0));
    }
}
