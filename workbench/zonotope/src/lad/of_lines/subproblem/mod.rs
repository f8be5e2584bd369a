//! Subproblems: some of a problem's lines, with a linear term that stands for the others.
//!
//! | file | what it holds |
//! |---|---|
//! | `part` | [`Subproblem`]: which lines, in floating point and exactly, and which linear term |
//! | `exact_linear` | the exact linear term, summed up on demand from the signs of lines left out |
//! | `vertex` | [`Vertex`]: the point where two lines meet, in exact homogeneous coordinates |
//! | `sign_pass` | one pass that tells the side of each line on which a point or a cell certainly lies |
//! | `subdifferential` | [`Subdifferential`]: what one pass at a vertex says about the objective there |

mod exact_linear;
mod part;
pub(crate) mod sign_pass;
mod subdifferential;
mod vertex;

pub(crate) use exact_linear::ExactLinear;
pub(crate) use part::Subproblem;
pub(crate) use subdifferential::Subdifferential;
pub(crate) use vertex::Vertex;
