//! Zonotopes around points: the least area, the least total length along given directions and over all.

mod center_rounding;
mod lower_bound;
pub(crate) mod min_area;
pub(crate) mod min_length_all;
pub(crate) mod min_length_dirs;

#[cfg(test)]
mod tests;
