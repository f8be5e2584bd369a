//! The plane of directions { u : u · p = 1 } in coordinates, and the line v · u = 0 of each generator in it: in
//! doubles, for guesses, and exactly.

pub(crate) mod exact_chart;
pub(crate) mod in_doubles;
