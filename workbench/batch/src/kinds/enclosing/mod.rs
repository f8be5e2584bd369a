//! Kinds about bodies around points.

mod forces;
pub(super) mod min_area;
pub(super) mod min_length_all;
pub(super) mod min_length_dirs;
mod outer;
