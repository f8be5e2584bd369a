//! What is prepared: a cutting of the dual plane, with the generators along each cut and the sums of the others.
//!
//! | file | what it has |
//! |---|---|
//! | [`tree`] | the structure: steps of the search, cuts, trapezoids |
//! | [`build`] | its construction from a cutting |
//! | [`boundary`] | lines and walls as planes of directions |
//! | [`crossing_lists`] | the lines that cross each part of the plane |
//! | [`turning_order`] | the order of generators along a cut |
//! | [`inner_direction`] | a direction within a part, which gives the other generators their signs |
//! | [`sums`] | exact sums in pairs of doubles, or in long numbers |

pub(crate) mod boundary;
mod build;
mod crossing_lists;
mod inner_direction;
pub(crate) mod sums;
pub(crate) mod tree;
mod turning_order;
