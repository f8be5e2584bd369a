//! What a method finds on an instance.

use crate::lad::of_lines::cell::Cell;
use crate::lad::of_lines::subproblem::vertex::Vertex;
use crate::numeric::dyadic::Dyadic;

/// The outcome of a search on an instance; lines are counted within the instance.
#[derive(Debug)]
pub(crate) enum Solution {
    Optimal(Box<Optimal>),
    Unbounded {
        /// A direction along which the objective falls without bound.
        direction: [Dyadic; 2],
        /// The line of the instance that has this direction, and whether it is its forward direction.
        along: Option<(u32, bool)>,
    },
}

/// A minimiser and the coefficients that prove it.
///
/// With δ = `signs` off the basis and δ in [−1, 1] on it, linear + Σ δ · normal = 0 and δ · value = |value| for each line.
#[derive(Debug)]
pub(crate) struct Optimal {
    /// The minimiser; absent when the objective does not depend on the point.
    pub(crate) vertex: Option<Vertex>,
    /// The lines that define it: two, or one when all lines are parallel, or none.
    pub(crate) defining: Vec<u32>,
    /// The lines through the minimiser whose normal is not zero.
    pub(crate) through: Vec<u32>,
    /// 1 or −1 for each line, 0 for the basis and for lines without any coefficient.
    pub(crate) signs: Vec<i8>,
    /// The lines, at most two, whose coefficients solve the equation exactly.
    pub(crate) basis: Vec<u32>,
    /// The dimension of the set of all minimisers.
    pub(crate) face_dimension: u8,
    /// Where the signs of most lines are those at the minimiser, if that is known.
    pub(crate) near: Option<Near>,
}

/// A cell around a minimiser, and the lines that may cross it: all others have one sign in it.
#[derive(Debug, Clone)]
pub(crate) struct Near {
    pub(crate) cell: Cell,
    pub(crate) crossing: Vec<u32>,
}

/// What to do at a point that is minimal along the line on which it was found.
#[derive(Debug)]
pub(crate) enum Decision {
    /// It is a minimiser, with the signs of the lines through it (0 for the basis).
    Optimal { through: Vec<(u32, i8)>, basis: Vec<u32>, face_dimension: u8 },
    /// The objective falls along this line, forward or backward.
    Descend { line: u32, forward: bool },
}
