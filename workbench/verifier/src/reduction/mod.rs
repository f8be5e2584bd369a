//! Zonotopes around zonotopes, and how far apart two zonotopes are at most.

pub(crate) mod hausdorff;
pub(crate) mod reduced;
pub(crate) mod shares;
mod within;
