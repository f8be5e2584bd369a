//! Strategies of proptest, for tests: every way of being degenerate that the methods promise to handle.

pub mod bodies;
pub mod directions;
pub mod lines;
pub mod numbers;
pub mod points;
pub mod properties;
