//! Proofs of a location, from an optimum of the kernel.

pub(crate) mod basis;
pub(crate) mod member_from_exact;
pub(crate) mod member_in_doubles;
pub(crate) mod pivot_to_doubles;
pub(crate) mod separation;
