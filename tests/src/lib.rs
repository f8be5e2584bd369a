//! Shared parts of the tests of the workspace: the source tree, the instances, the exact twins and the program.
//!
//! The tests themselves are in `tests/tests/`, one file or folder a subject. Nothing here is used outside of them.

pub mod body_questions;
pub mod dice;
pub mod direction_families;
pub mod judged;
pub mod kernel_twin;
pub mod line_families;
pub mod point_families;
pub mod questions;
pub mod runner;
pub mod sources;
