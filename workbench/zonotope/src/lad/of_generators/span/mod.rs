//! Bodies that do not span space: as prisms over what they span.

pub(crate) mod flat;
pub(crate) mod prism;
