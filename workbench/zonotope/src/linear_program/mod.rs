//! Linear programs: minimise cost · x subject to sparse rows and bounds, by engines whose answers are only guesses.
//!
//! The engines compute in floating point and stop within tolerances of their own, so nothing in this library believes
//! them: the caller turns the primal and dual values of a [`Guess`] into a candidate and proves it exactly, or says
//! that it could not.
//!
//! | engine | what it is |
//! |---|---|
//! | [`Clarabel`] | a primal-dual interior-point method: smooth in its cost, ends near a face rather than on it |
//! | [`Microlp`] | a revised simplex method: ends on a basis; the dual values cost a second solution |

mod engine;
mod interior_point;
mod program;
mod simplex;

pub use engine::{Engine, Guess};
pub use interior_point::Clarabel;
pub use program::{BoundedVariable, LinearProgram, LinearProgramError, Relation, Row};
pub use simplex::Microlp;

#[cfg(test)]
mod tests;
