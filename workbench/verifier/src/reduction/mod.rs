//! Zonotopes around zonotopes, and how far apart two zonotopes are at most.

pub(crate) mod difference;
pub(crate) mod hausdorff;
pub(crate) mod nearest_point;
pub(crate) mod reduced;
mod rounded_search;
pub(crate) mod shares;
mod vertices;
mod within;
