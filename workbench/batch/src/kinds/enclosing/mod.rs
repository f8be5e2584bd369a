//! Kinds about bodies around points.

pub(super) mod min_area;
pub(super) mod min_length_all;
pub(super) mod min_length_dirs;
mod outer;
