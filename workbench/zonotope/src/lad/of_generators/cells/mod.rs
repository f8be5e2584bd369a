//! Cells of directions, and the generators whose sign is fixed in them.
//!
//! | file | what it has |
//! |---|---|
//! | [`reduced`] | the problem of the generators that cross a cell, with that sum |
//! | [`nested`] | the signs of all generators, from the cells of a search |

pub(crate) mod nested;
pub(crate) mod reduced;
