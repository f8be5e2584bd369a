//! Answers about bodies that move.

mod turning;

pub(crate) mod sweep;
