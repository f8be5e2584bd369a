//! The solution of a subproblem: a minimiser with the coefficients that prove it, or a direction of unbounded descent.

use crate::lad::of_lines::cells::Cell;
use crate::lad::of_lines::subproblem::Vertex;
use crate::numeric::dyadic::Dyadic;

/// The solution of a subproblem, whose lines are numbered within it.
#[derive(Debug)]
pub(crate) enum Solution {
    Optimal(Box<Optimal>),
    Unbounded {
        /// A direction along which the objective falls without bound.
        direction: [Dyadic; 2],
        /// The line of the subproblem that has this direction, and whether it is its forward direction.
        along: Option<(u32, bool)>,
    },
}

/// A minimiser and the coefficients that prove it.
///
/// With δ = `signs` off the basis and δ in [−1, 1] on it, linear + Σ δ · normal = 0 and δ · value = |value| for each
/// line.
#[derive(Debug)]
pub(crate) struct Optimal {
    /// The minimiser, which is absent when the objective does not depend on the point.
    pub(crate) vertex: Option<Vertex>,
    /// The lines that define it: two, or one when all lines are parallel, or none.
    pub(crate) defining: Vec<u32>,
    /// The lines through the minimiser whose normal is not zero.
    pub(crate) through: Vec<u32>,
    /// The coefficient δ of each line off the basis, 1 or −1; 0 for the basis and for lines whose coefficients are all
    /// zero.
    pub(crate) signs: Vec<i8>,
    /// The lines, at most two, whose coefficients δ are what the equation leaves for them.
    pub(crate) basis: Vec<u32>,
    /// The dimension of the set of all minimisers.
    pub(crate) face_dimension: u8,
    /// A cell in which most lines have the sign that they have at the minimiser, where pruning found one.
    pub(crate) near: Option<Near>,
}

/// Cells around a minimiser, and the lines that may cross all of them: all others have one sign where they overlap.
#[derive(Debug, Clone)]
pub(crate) struct Near {
    pub(crate) cells: Vec<Cell>,
    pub(crate) crossing: Vec<u32>,
}

impl Near {
    /// The same with further cells, found among the crossing lines, by whose numbers theirs go.
    pub(crate) fn narrowed(mut self, inner: Self) -> Self {
        self.crossing = inner.crossing.into_iter().map(|line| self.crossing[line as usize]).collect();
        self.cells.extend(inner.cells);
        self
    }

    /// Whether a point, given within a relative 8 UNIT, certainly lies in the interior of all cells.
    pub(crate) fn contains(&self, point: [f64; 2]) -> bool {
        self.cells.iter().all(|cell| cell.contains(point))
    }
}

/// The next move at a point that is minimal along the line on which it was found.
#[derive(Debug)]
pub(crate) enum Decision {
    /// The point is a minimiser; the lines through it have these signs, 0 for the basis.
    Optimal { through: Vec<(u32, i8)>, basis: Vec<u32>, face_dimension: u8 },
    /// The objective falls along this line, forward or backward.
    Descend { line: u32, forward: bool },
}
