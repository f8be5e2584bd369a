//! Kinds about meshes of triangles.

pub(in crate::kinds) mod level;
pub(in crate::kinds) mod mesh;
