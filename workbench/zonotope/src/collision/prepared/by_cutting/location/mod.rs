//! Where the optimum of a query lies relative to a cut.
//!
//! | file | what it has |
//! |---|---|
//! | [`circle`] | the directions along a cut, and the gradients between the places where generators turn |
//! | [`line_minimum`] | the minimum along a cut, by binary search |
//! | [`decision`] | the side of the cut on which the optimum lies, or the optimum if it is on the cut |

pub(crate) mod circle;
pub(crate) mod decision;
mod line_minimum;
