//! Kinds about bodies that move.

pub(super) mod sweep;
