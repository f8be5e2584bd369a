//! Problem: where two meshes of triangles meet, and how far apart they are, by hierarchies of bounding volumes.
//!
//! A [`Mesh`] is a surface: vertices and triangles. A [`Bvh`] is a tree over its triangles with a [`BoundingVolume`]
//! around those below each node. Two meshes under poses are asked about by descending pairs of nodes: whose volumes are
//! proved disjoint, their triangles are. Answers do not depend on the volume, only the number of tests does.
//!
//! | stage | what it does | cost for n triangles |
//! |---|---|---|
//! | `mesh` | vertices and triangles, and where a pose puts them | O(n) |
//! | `volume` | the trait of bounding volumes, and what a test of two must hold to | |
//! | `hierarchy` | a mesh with its tree and volumes | |
//! | [`build`] | the tree, by the surface area heuristic | O(n log n) |
//! | `refit` | the volume of each node, from the leaves up; also after a deformation | O(n log n) times a fit |
//! | `question` | two hierarchies under poses in one [`frame`] | O(1) for rotations, else a refit |
//! | [`traverse`] | all pairs of triangles that meet, or the first | a test a pair of nodes |
//! | [`nearest`] | the distance between two bounds | a test a pair of nodes |
//! | `doors` | the questions as methods of hierarchies | |
//! | [`triangles`] | whether two triangles meet, and how far apart they are | O(1) |
//! | [`validate`] | whether every volume contains its triangles, exactly | O(n log n) exact tests |
//! | [`brute_force`] | all pairs of triangles that meet, without a tree: the truth | O(n²) |
//!
//! The volumes are tabulated in [`volumes`]; [`Method`] names them. Sets are closed: triangles that touch meet. Poses
//! are taken as the exact matrices that they are, rotations or not.

pub mod brute_force;
pub mod build;
mod doors;
pub mod frame;
mod hierarchy;
mod mesh;
mod method;
pub mod nearest;
pub(crate) mod question;
mod refit;
#[cfg(test)]
mod tests;
pub mod traverse;
pub mod triangles;
pub mod validate;
mod volume;
pub mod volumes;

pub use build::{BuildOptions, Topology};
pub use doors::{BeyondDoubles, Enclosed, meet};
pub use frame::Frame;
pub use hierarchy::{Bvh, PlacedBvh};
pub use mesh::{Mesh, MeshError, PlacedMesh};
pub use method::{Encounter, Method};
pub use nearest::MeshDistance;
pub use validate::Fault;
pub use volume::BoundingVolume;
pub use volumes::aabb::Aabb;
pub use volumes::discrete_polytope::{Dop18, Dop26};
pub use volumes::oriented_box::OrientedBox;
pub use volumes::shape::Shaped;
pub use volumes::sphere::Sphere;
pub use volumes::zonotope::{Zonotope3, Zonotope4, Zonotope5, Zonotope6, Zonotope7, Zonotope8};
pub use volumes::zonotope_by_cost::ZonotopeByCost;
