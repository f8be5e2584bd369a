//! Cells of directions, and the generators whose sign is fixed in them.
//!
//! | file | what it has |
//! |---|---|
//! | [`direction_cone`] | a cell: a cone around an ellipse or a ball, and whether a direction is in it |
//! | [`sign_pass`] | the pass that sums up the generators whose sign is fixed in a cell |
//! | [`reduced`] | the problem of the generators that cross a cell, with that sum |
//! | [`nested`] | the signs of all generators, from the cells of a search |

pub(crate) mod direction_cone;
pub(crate) mod nested;
pub(crate) mod reduced;
pub(crate) mod sign_pass;
