//! Nets of directions with a proven mesh: every unit vector is within the mesh of a direction of the net, or of its
//! opposite.
//!
//! The faces x_i = 1 of the cube [−1, 1]^d meet every line through the origin. A grid divides each face into m^{d−1}
//! cells of width 2/m, and the net consists of the middles of the cells, or of their corners, scaled to length 1. A
//! cube is taken since a sphere has no grid whose mesh is so easy to prove: a unit vector u, scaled until its largest
//! coordinate is ±1, lies in a cell of a face or is opposite to a point of one. There it is within sqrt(d − 1)/m of the
//! cell's middle and within 2 sqrt(d − 1)/m of each of its corners. The faces lie outside the open unit ball, where x ↦
//! x/|x| increases no distance. So the bounds hold for the unit vectors as well.

pub use crate::zonotope::directions::cube_faces::{cell_corners, cell_middles};

/// The nets that [`by_direction_net`](super::by_direction_net) takes.
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
