//! Some of a problem's lines with a linear term that stands for the others, and what one pass over them tells at a vertex.

pub(crate) mod instance;
pub(crate) mod sides;
pub(crate) mod vertex;
