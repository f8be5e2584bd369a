//! Two copies of a mesh at a distance, asked about by hierarchies of every bounding volume.
//!
//! The tree, the leaf size, the traversal and the tests of triangles are the same for all volumes.

mod approach;
mod asked;
mod courses;
mod every_pair;
mod meshes;
mod scene;
mod touching;

pub use approach::{DISTANCES, Placed};
pub use asked::{Asked, Tests};
pub use courses::{Course, MovedMesh, middles_apart, poses_of};
pub use every_pair::pairs_by_every_pair;
pub use meshes::{MESHES, mesh};
pub use scene::{Scene, scene};
pub use touching::TouchingPoses;
