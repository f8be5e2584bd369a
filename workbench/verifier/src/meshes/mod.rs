//! Meshes of triangles: where two of them meet, and how far apart they are.
//!
//! There is no certificate: the check looks at every pair of triangles whose boxes leave a doubt, in whole numbers.

pub(crate) mod check;
mod sweep;
pub(crate) mod triangles;
