//! Kinds about bodies as they are: how far they reach, their faces, bodies around them.

pub(super) mod combinatorics;
pub(super) mod hausdorff;
pub(super) mod reduce;
pub(super) mod support;
