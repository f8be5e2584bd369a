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

/// A cell around a minimiser, and the lines that may cross it: all others have one sign in it.
#[derive(Debug, Clone)]
pub(crate) struct Near {
    pub(crate) cell: Cell,
    pub(crate) crossing: Vec<u32>,
}

/// The next move at a point that is minimal along the line on which it was found.
#[derive(Debug)]
pub(crate) enum Decision {
    /// The point is a minimiser; the lines through it have these signs, 0 for the basis.
    Optimal { through: Vec<(u32, i8)>, basis: Vec<u32>, face_dimension: u8 },
    /// The objective falls along this line, forward or backward.
    Descend { line: u32, forward: bool },
}
