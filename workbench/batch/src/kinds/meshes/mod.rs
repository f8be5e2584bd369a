//! Kinds about meshes of triangles.

pub(super) mod mesh;
