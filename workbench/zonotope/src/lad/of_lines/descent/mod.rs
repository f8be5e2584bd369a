//! The descent that every method ends with: the exact minimum along one line, whether a vertex is optimal, and where to go from it.

mod cone;
pub(crate) mod decide;
pub(crate) mod line_search;
pub(crate) mod solution;
pub(crate) mod solve;
