//! Shared parts of the figures of the duality: the arrangement, the tiling and one separator of both, drawn side by
//! side.

mod crossings;
mod drawing;
mod dual_pair;
mod general_position;

pub(crate) use drawing::{
    GENERATORS, Separator, arrangement_frame, draw_arrangement, draw_tiles, draw_tiling, generator_stroke,
    number_tiles, tiling_frame,
};
pub(crate) use dual_pair::DualPair;
pub use general_position::PositionError;
pub(crate) use general_position::{Placed, in_general_position};
