//! Sections 5 and 5.1: whether two zonotopes intersect.

pub(crate) mod centered_body;
pub(crate) mod comparisons;
pub(crate) mod explicit_size;
pub(crate) mod explicit_test;
pub(crate) mod index_order;
pub(crate) mod lemma_5_1;
pub(crate) mod monotone_subdivision;
pub(crate) mod separator_length;
pub(crate) mod separators;
pub(crate) mod theorem_5_2;
pub(crate) mod upper_and_lower_hull;
