//! The optimum in exact arithmetic.
//!
//! | file | what it has |
//! |---|---|
//! | [`solve`] | the exact optimum: of the generators that cross cells, of some, of all |
//! | [`vertex`] | the exact optimum at a vertex that doubles found, or near it |
//! | [`vertex_signs`] | the signs of all generators at a vertex, and those of its facet |
//! | [`bundle`] | the parallel generators of a facet as one |
//! | [`best_on_line`] | the best vertex on the line of a generator, where a search ended at none |
//! | [`pivot`] | whether a vertex is the optimum, and from one that is not to the best one on a line through it |
//! | [`longest_first`] | the optimum of the longest generators, if it is that of all |

mod best_on_line;
mod bundle;
pub(crate) mod longest_first;
mod pivot;
pub(crate) mod solve;
pub(crate) mod vertex;
mod vertex_signs;
