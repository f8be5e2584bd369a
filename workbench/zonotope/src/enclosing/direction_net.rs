//! Nets of directions with a proven mesh: every unit vector is within the mesh of a direction of the net, or of its
//! opposite.
//!
//! The faces x_i = 1 of the cube [−1, 1]^d meet every line through the origin. A grid divides each face into m^{d−1}
//! cells of width 2/m, and the net consists of the middles of the cells, or of their corners, scaled to length 1. A
//! cube is taken since a sphere has no grid whose mesh is so easy to prove: a unit vector u, scaled until its largest
//! coordinate is ±1, lies in a cell of a face or is opposite to a point of one. There it is within sqrt(d − 1)/m of the
//! cell's middle and within 2 sqrt(d − 1)/m of each of its corners. The faces lie outside the open unit ball, where x ↦
//! x/|x| increases no distance. So the bounds hold for the unit vectors as well.

/// The nets that [`by_direction_net`](crate::enclosing::min_total_length::by_direction_net) takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Net {
    /// The net of Theorem 4.7: middles of cells with mesh ε/d, and the axes.
    Paper,
    /// The corners of cells of diameter sqrt(2ε / (1 + ε)), which prove the same ratio with fewer directions.
    Cells,
}

impl Net {
    /// The number of cells along a side of a face of the cube, in a number of dimensions.
    fn cells_per_side(self, dimension: usize, epsilon: f64) -> usize {
        let width = (dimension as f64 - 1.0).sqrt();
        let mesh = match self {
            Self::Paper => epsilon / dimension as f64,
            Self::Cells => (2.0 * epsilon / (1.0 + epsilon)).sqrt() / 2.0,
        };
        // One cell more than the integer part of the quotient makes the mesh finer by a margin that exceeds rounding.
        ((width / mesh).floor() as usize).saturating_add(1)
    }

    /// An upper bound of the number of directions in the net for a precision: it counts a direction that lies on
    /// several faces once for each of them.
    pub fn size(self, dimension: usize, epsilon: f64) -> usize {
        let side = self.cells_per_side(dimension, epsilon).saturating_add(usize::from(self == Self::Cells));
        dimension.saturating_mul(side.saturating_pow(dimension as u32 - 1)).saturating_add(dimension)
    }

    /// The directions of the net for R^rank, with zeros for the coordinates beyond the first `rank`.
    pub(super) fn directions<const D: usize>(self, rank: usize, epsilon: f64) -> Vec<[f64; D]> {
        match rank {
            1 => self.embedded::<1, D>(epsilon),
            2 => self.embedded::<2, D>(epsilon),
            3 => self.embedded::<3, D>(epsilon),
            _ => self.embedded::<D, D>(epsilon),
        }
    }

    /// The directions of the net for R^R, with zeros for the coordinates beyond the first R.
    fn embedded<const R: usize, const D: usize>(self, epsilon: f64) -> Vec<[f64; D]> {
        let cells = self.cells_per_side(R, epsilon);
        let mut net: Vec<[f64; R]> = match self {
            Self::Paper => cell_middles(cells),
            Self::Cells => cell_corners(cells),
        };
        if self == Self::Paper {
            let axes = (0..R).map(|a| std::array::from_fn(|c| f64::from(u8::from(a == c))));
            for axis in axes {
                if !net.contains(&axis) {
                    net.push(axis);
                }
            }
        }
        net.iter().map(|v| std::array::from_fn(|c| if c < R { v[c] } else { 0.0 })).collect()
    }
}

/// The middles of the cells of grids with `cells` cells along a side, scaled to length 1: every unit vector or its
/// opposite is within sqrt(D − 1) / `cells` of one of them, but for rounding.
pub fn cell_middles<const D: usize>(cells: usize) -> Vec<[f64; D]> {
    let middle = |i: usize| (2 * i + 1) as f64 / cells as f64 - 1.0;
    on_faces(cells, middle)
}

/// The corners of the cells of grids with `cells` cells along a side, scaled to length 1, each direction once: every
/// unit vector or its opposite lies in the cone of a cell all of whose corners are within 2 sqrt(D − 1) / `cells` of
/// it.
pub fn cell_corners<const D: usize>(cells: usize) -> Vec<[f64; D]> {
    let corner = |i: usize| 2.0 * i as f64 / cells as f64 - 1.0;
    let mut corners: Vec<[f64; D]> = on_faces(cells + 1, corner);
    // A corner on an edge of the cube belongs to several faces, from which it may come with either sign.
    for u in &mut corners {
        if u.iter().find(|c| **c != 0.0).is_some_and(|c| *c < 0.0) {
            *u = u.map(|c| -c);
        }
    }
    corners.sort_by(|a, b| {
        a.iter().zip(b).map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    });
    corners.dedup_by(|a, b| a.iter().zip(b.iter()).all(|(x, y)| (*x - *y).abs() < 1e-12));
    corners
}

/// Points of grids on the D faces x_i = 1, `count` of them along a side at the coordinates that `place` gives, scaled
/// to length 1.
fn on_faces<const D: usize>(count: usize, place: impl Fn(usize) -> f64) -> Vec<[f64; D]> {
    let mut found = Vec::new();
    for face in 0..D {
        let others: Vec<usize> = (0..D).filter(|&c| c != face).collect();
        let mut index = vec![0; others.len()];
        loop {
            let mut u = [0.0; D];
            u[face] = 1.0;
            for (&c, &i) in others.iter().zip(&index) {
                u[c] = place(i);
            }
            let length = u.iter().map(|c| c * c).sum::<f64>().sqrt();
            found.push(u.map(|c| c / length));
            let Some(slot) = index.iter().position(|&i| i + 1 < count) else { break };
            index[..slot].fill(0);
            index[slot] += 1;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    fn distance<const D: usize>(u: &[f64; D], v: &[f64; D]) -> f64 {
        let along = |sign: f64| u.iter().zip(v).map(|(a, b)| (a - sign * b) * (a - sign * b)).sum::<f64>().sqrt();
        along(1.0).min(along(-1.0))
    }

    fn random_unit<const D: usize>(rng: &mut rand_pcg::Pcg64) -> [f64; D] {
        loop {
            let v: [f64; D] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            if length > 0.1 && length <= 1.0 {
                return v.map(|c| c / length);
            }
        }
    }

    fn keeps_its_mesh<const D: usize>() {
        let mut rng = rand_pcg::Pcg64::seed_from_u64(3);
        for cells in [1, 2, 3, 6] {
            let (middles, corners) = (cell_middles::<D>(cells), cell_corners::<D>(cells));
            assert_eq!(middles.len(), D * cells.pow(D as u32 - 1));
            let mesh = (D as f64 - 1.0).sqrt() / cells as f64 + 1e-12;
            for _ in 0..300 {
                let u = random_unit::<D>(&mut rng);
                assert!(middles.iter().any(|v| distance(&u, v) <= mesh));
                // The 2^(D − 1) corners of the cell of u are within the bound, and they are at least D.
                assert!(corners.iter().filter(|v| distance(&u, v) <= 2.0 * mesh).count() >= D);
            }
        }
    }

    #[test]
    fn every_direction_is_near_one_of_the_net() {
        keeps_its_mesh::<2>();
        keeps_its_mesh::<3>();
        keeps_its_mesh::<4>();
    }

    #[test]
    fn nets_of_the_plane_by_hand() {
        let half = 0.5f64.sqrt();
        assert_eq!(cell_middles::<2>(1), [[1.0, 0.0], [0.0, 1.0]]);
        let corners = cell_corners::<2>(2);
        assert_eq!(corners.len(), 4);
        assert!(corners.iter().any(|u| (u[0] - half).abs() < 1e-15 && (u[1] + half).abs() < 1e-15));
    }
}
