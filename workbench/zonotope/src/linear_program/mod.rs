//! Linear programs: minimise cost · x subject to sparse rows and bounds, by engines whose answers are only guesses.
//!
//! The engines compute in floating point and stop within tolerances of their own, so nothing in this library believes
//! them: the caller turns the primal and dual values of a [`Guess`] into a candidate and proves it exactly, or says
//! that it could not.
//!
//! The engine is [`Clarabel`], a primal-dual interior-point method: smooth in its cost, it ends near a face rather than
//! on it. Any other is one that has the trait [`Engine`].

mod engine;
mod interior_point;
mod program;

pub use engine::{Engine, Guess};
pub use interior_point::Clarabel;
pub use program::{BoundedVariable, LinearProgram, LinearProgramError, Relation, Row};

#[cfg(test)]
mod tests;
