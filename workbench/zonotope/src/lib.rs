//! Zonotopes as bounding volumes: exact, certified algorithms of computational geometry.

pub mod arrangement;
pub mod enclosing;
pub mod hull;
pub mod lad;
pub mod numeric;
pub mod tally;
pub mod zonotope;
