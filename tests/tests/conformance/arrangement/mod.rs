//! Arrangements of lines, and what is walked over them.

mod cutting;
mod dynamic_hull;
mod facet_walk;
mod slope_selection;
mod tiling;
