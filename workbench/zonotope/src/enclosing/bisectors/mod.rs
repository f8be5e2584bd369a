//! The lines ℓ_t of Section 4.1, which bound where the centre must lie for a hull edge to be an edge of Z(O).
//!
//! For the edge from P_t to P_{t+1} with farthest vertex P_s, the line ℓ_t runs through the midpoints of P_s P_t and
//! P_s P_{t+1}. The edge is an edge of Z(O) iff O is not to the right of ℓ_t. With X = 2O and e_t = P_{t+1} − P_t that
//! is e_t × (X − P_s − P_t) ≥ 0, and the area of Z(O) is a constant plus ½ Σ_t |e_t × (X − P_s − P_t)|.
//!
//! Derivation of the area f(O): let O move away from ℓ_t, on the side where e_t is an edge of Z(O). By central symmetry
//! the area grows at the rate 2 |e_t|. On the other side of ℓ_t it does not depend on e_t. So f(O) = C + 2 Σ_t max(0,
//! e_t × (O − m_t)) with m_t on ℓ_t. Since max(0, d) = (d + |d|) / 2 and the edges of a polygon add up to zero, the
//! linear parts cancel up to a constant.

mod corners;
mod frame;
mod lines;
mod pairs;
mod search;

use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::lad::LadProblem;
use crate::lad::kernel_input::MadeLines;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
pub(crate) use frame::{Frame, NearestCenter};
use lines::Lines;
pub use search::{Candidate, PruningCell};

/// The lines ℓ_t of a hull with area.
#[derive(Debug, Clone)]
pub struct Bisectors<'h> {
    hull: &'h ConvexHull,
    farthest: &'h [FarthestVertex],
    pub(crate) frame: Frame,
}

impl<'h> Bisectors<'h> {
    /// The lines of a hull, given the farthest vertex of each edge.
    ///
    /// # Panics
    /// When `farthest` does not have one vertex for each edge of the hull, or names one that the hull does not have.
    pub fn new(hull: &'h ConvexHull, farthest: &'h [FarthestVertex]) -> Self {
        assert_eq!(farthest.len(), hull.edge_count(), "one farthest vertex for each edge");
        Self { hull, farthest, frame: Frame::of(hull, farthest) }
    }

    /// The kernel problem whose objective at the kernel point x of a point O is Σ_t |e_t × (X − P_s − P_t)| divided by
    /// the powers of two of both scales. O(1), as the lines are made when they are read.
    pub fn kernel_problem(&self) -> LadProblem<'h> {
        let lines = self.lines();
        LadProblem::from_made_lines(Box::new(lines), Box::new(lines))
    }

    /// Rows (a, b, c), rounded, with e_t × (X − P_s − P_t) = a x + b y + c at the kernel point (x, y) of O.
    pub(crate) fn rows(&self) -> Vec<[f64; 3]> {
        let lines = self.lines();
        (0..self.farthest.len()).map(|t| lines.row(t).0).collect()
    }

    fn lines(&self) -> Lines<'h> {
        Lines { hull: self.hull, farthest: self.farthest, frame: self.frame }
    }

    /// The doubles nearest to the centre where two lines meet, given their common point by pairs of doubles; `None`
    /// where these leave open which doubles are nearest or whether they are the centre.
    ///
    /// A line runs through the midpoints of the farthest vertex and either end of the edge, and lines of few points
    /// often meet in such a midpoint. Then it is known without error.
    pub(crate) fn nearest_center(&self, lines: [usize; 2], place: &[BoundedDoubleDouble; 2]) -> Option<NearestCenter> {
        let doubled = match self.lines().shared_midpoint(lines) {
            Some(ends) => {
                let [a, b] = self.lines().scaled_points(ends)?;
                [0, 1].map(|axis| BoundedDoubleDouble::of_parts(a[axis], b[axis], 0.0))
            }
            None => self.frame.doubled_center(place),
        };
        self.frame.nearest_center(&doubled)
    }

    /// The kernel point of a centre, both in homogeneous coordinates.
    pub(crate) fn kernel_point(&self, [x, y, w]: &[Dyadic; 3]) -> [Dyadic; 3] {
        let shifted = |v: &Dyadic, axis: usize| {
            v.clone().scaled(1 - self.frame.scale(axis)) - &Dyadic::from_f64(self.frame.reference[axis]) * w
        };
        [shifted(x, 0), shifted(y, 1), w.clone()]
    }

    /// The midpoints of P_s P_t and P_s P_{t+1} on ℓ_t, rounded.
    ///
    /// # Panics
    /// When the hull has no edge t.
    pub fn midpoints(&self, t: usize) -> [[f64; 2]; 2] {
        let vertices = self.hull.vertices();
        let far = self.hull.vertex(self.farthest[t].vertex());
        let ends = [vertices[t], vertices[(t + 1) % vertices.len()]];
        ends.map(|end| [0, 1].map(|i| end[i] / 2.0 + far[i] / 2.0))
    }
}

#[cfg(test)]
mod tests;
