//! The optimum in exact arithmetic.
//!
//! | file | what it has |
//! |---|---|
//! | [`solve`] | the exact optimum: of the generators that cross cells, of a ball around another optimum, of all |
//! | [`vertex`] | the exact optimum at a vertex that doubles found, or near it |
//! | [`pivot`] | from a vertex that is not the optimum to the best one on a line through it |
//! | [`longest_first`] | the optimum of the longest generators, if it is that of all |
//! | [`direction_signs`] | the signs of the generators for an exact direction, nearly all from pairs of doubles |

pub(crate) mod direction_signs;
pub(crate) mod longest_first;
mod pivot;
pub(crate) mod solve;
pub(crate) mod vertex;
