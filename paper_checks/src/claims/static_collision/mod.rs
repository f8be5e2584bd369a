//! Sections 5 and 5.1: whether two zonotopes intersect.

pub(crate) mod explicit_size;
pub(crate) mod index_order;
pub(crate) mod lemma_5_1;
pub(crate) mod separators;
pub(crate) mod theorem_5_2;
pub(crate) mod upper_and_lower_hull;
