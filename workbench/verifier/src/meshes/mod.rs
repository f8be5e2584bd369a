//! Meshes of triangles: where two of them meet, and how far apart they are.
//!
//! Of a level of a hierarchy every corner is held against the volume around it. Of two meshes there is no certificate
//! either: the check looks at every pair of triangles whose boxes leave a doubt, in whole numbers.

pub(crate) mod check;
pub(crate) mod level;
mod sweep;
pub(crate) mod triangles;
