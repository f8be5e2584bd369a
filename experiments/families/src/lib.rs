//! Families of instances as plain arrays: deterministic ones by name, for experiments, figures, claims and tests alike,
//! and with the feature `drawn` strategies of proptest, for tests.
//!
//! - [`points`]: point sets in the plane; [`clouds`]: point clouds in two to four dimensions;
//! - [`lines`]: lines for the kernel;
//! - [`bodies`]: generators of zonotopes; [`motions`]: bodies that move past each other; [`meshes`]: surfaces of
//!   triangles;
//! - [`source`]: the random source that all of them draw from.
//!
//! A family is a static value; the instance is a function of the family, the number of its parts and a seed.
//! Transcendental functions come from `libm`, so instances agree bit for bit on every machine. The crate knows nothing
//! of the library, whose unit tests use it as well.

pub mod bodies;
pub mod clouds;
#[cfg(feature = "drawn")]
pub mod drawn;
pub mod lines;
pub mod meshes;
pub mod motions;
pub mod points;
pub mod source;

#[cfg(test)]
mod tests;
