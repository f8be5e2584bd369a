//! What the figures of the duality share: the arrangement, the tiling and one separator of both, drawn side by side.

mod drawing;
mod dual_pair;

pub(crate) use drawing::{GENERATORS, Separator, draw_arrangement, draw_tiling, generator_stroke};
pub(crate) use dual_pair::DualPair;
