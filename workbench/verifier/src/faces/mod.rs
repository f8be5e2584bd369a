//! Facets and vertices of a zonotope gone through: containment, the farthest vertex, supporting directions.

pub(crate) mod cone;
pub(crate) mod containment;
pub(crate) mod dual_reach;
pub(crate) mod facets;
#[cfg(test)]
mod near_ties;
pub(crate) mod normals;
mod pencils;
mod wide_vector;
