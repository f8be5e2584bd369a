//! Nets of directions with a proven mesh: every unit vector is near one of them, or its opposite.
//!
//! The faces x_i = 1 of the cube [−1, 1]^d carry every direction up to sign. Each face gets a grid of m^(d−1) cells, 2/m wide, and the net consists of the middles
//! of the cells (or their corners), made unit vectors. Proof of the mesh: a unit vector u, scaled so that its largest coordinate is ±1, lies in a cell of a face, so
//! it is within sqrt(d−1)/m of the cell's middle and within 2 sqrt(d−1)/m of each of its corners. Both are outside the unit ball, and
//! there x ↦ x/|x| brings no two points farther apart. So the same bounds hold for the distance of unit vectors.

/// Which net.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Net {
    /// Theorem 4.7 as it stands: mesh ε/d, and the axes.
    Paper,
    /// The corners of cells of diameter sqrt(2ε / (1 + ε)): enough for the same ratio.
    Cells,
}

impl Net {
    /// Cells along a side of a face of the cube in so many dimensions.
    fn cells(self, dimension: usize, epsilon: f64) -> usize {
        let width = (dimension as f64 - 1.0).sqrt();
        let mesh = match self {
            Self::Paper => epsilon / dimension as f64,
            Self::Cells => (2.0 * epsilon / (1.0 + epsilon)).sqrt() / 2.0,
        };
        // One more than the quotient's integer part: the mesh keeps a margin over rounding.
        ((width / mesh).floor() as usize).saturating_add(1)
    }

    /// How many directions the net for a precision has in R^dimension, or a few more: those that several cells share are counted more than once.
    pub fn size(self, dimension: usize, epsilon: f64) -> usize {
        let side = self.cells(dimension, epsilon).saturating_add(usize::from(self == Self::Cells));
        dimension.saturating_mul(side.saturating_pow(dimension as u32 - 1)).saturating_add(dimension)
    }

    /// The directions, in the first `rank` coordinates.
    pub(super) fn directions<const D: usize>(self, rank: usize, epsilon: f64) -> Vec<[f64; D]> {
        match rank {
            1 => self.embedded::<1, D>(epsilon),
            2 => self.embedded::<2, D>(epsilon),
            3 => self.embedded::<3, D>(epsilon),
            _ => self.embedded::<D, D>(epsilon),
        }
    }

    fn embedded<const R: usize, const D: usize>(self, epsilon: f64) -> Vec<[f64; D]> {
        let cells = self.cells(R, epsilon);
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

/// The middles of the cells of a grid with `cells` a side, unit vectors up to rounding: every unit vector or its opposite is within sqrt(D − 1) / `cells` of one.
pub fn cell_middles<const D: usize>(cells: usize) -> Vec<[f64; D]> {
    let middle = |i: usize| (2 * i + 1) as f64 / cells as f64 - 1.0;
    on_faces(cells, middle)
}

/// The corners of the cells, each direction once: every unit vector is in the cone of a cell, all of whose corners are within
/// 2 sqrt(D − 1) / `cells` of it.
pub fn cell_corners<const D: usize>(cells: usize) -> Vec<[f64; D]> {
    let corner = |i: usize| 2.0 * i as f64 / cells as f64 - 1.0;
    let mut corners: Vec<[f64; D]> = on_faces(cells + 1, corner);
    // Corners on the edges of the cube come from several faces, with either sign.
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

/// The grid points with `count` places a side on the D faces x_i = 1, made unit vectors.
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
                // all corners of the cell of u: at least D of them are within the bound, and they span
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
