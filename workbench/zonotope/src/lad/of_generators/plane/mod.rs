//! The plane of directions { u : u · p = 1 } in coordinates, and the line v · u = 0 of each generator in it.

pub(crate) mod exact_chart;
pub(crate) mod guess;
pub(crate) mod rounded_chart;
pub(crate) mod rounded_lines;
