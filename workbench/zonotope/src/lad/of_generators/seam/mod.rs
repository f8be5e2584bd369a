//! The seam: all that stands between the kernel and whoever holds the generators.
//!
//! | file | what it has |
//! |---|---|
//! | [`generators`] | what the kernel asks: rows in at most two parts, sums over a cell, support values, a likely cell |
//! | [`part`] | one of the parts: rows, and the matrix that they are to be taken under |
//! | [`frame`] | the matrix of a pose between the kernel and the rows, and what its products may be off by |
//! | [`direction_cone`] | a cell: a cone around an ellipse or a ball, and whether a direction is in it |
//! | [`sign_pass`] | the pass that sums up the generators whose sign is fixed in a cell |
//! | [`direction_signs`] | the signs of the generators for an exact direction, nearly all from pairs of doubles |

pub(crate) mod direction_cone;
pub(crate) mod direction_signs;
pub(crate) mod frame;
pub(crate) mod generators;
pub(crate) mod kernel_query;
pub(crate) mod part;
pub(crate) mod sign_pass;
