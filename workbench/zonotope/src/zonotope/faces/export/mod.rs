//! The face lattice in file formats of meshes, as text or bytes: writing them anywhere is the caller's part.
//!
//! | file | format |
//! |---|---|
//! | `obj` | Wavefront OBJ: text, polygons as they are |
//! | `ply` | PLY: text, doubles, polygons as they are |
//! | `stl` | binary STL: triangles, single precision |

mod obj;
mod ply;
mod stl;
#[cfg(test)]
mod tests;
