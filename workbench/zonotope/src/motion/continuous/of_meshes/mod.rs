//! The first contact of two moving meshes, by descending pairs of nodes of their hierarchies in space and time.
//!
//! # Statement
//! Input: hierarchies over two meshes of triangles, a rational motion of each, a resolution. Output: when the meshes
//! meet first, as [`MeshContact`] has it, with a direction for each pair of nodes or triangles and each stretch of time
//! in which it is free. Meshes are the unions of their closed triangles: what touches meets.
//!
//! # Source
//! Sections 1 and 6 name both halves: hierarchies of bounding volumes, and space-time volumes of bodies that move.
//!
//! # Method
//! 1. Take a pair of nodes with a stretch of time, the earliest of its pair. Their volumes are tested where they stand
//!    at the middle of the stretch; if they are apart, a direction is searched for along which the control points of
//!    both are apart, which proves the pair free, as it does for two zonotopes.
//! 2. A stretch on which nodes go far beside their size is halved while that proves some; else the larger is opened.
//! 3. Pairs of triangles are proved free in the same way, by their corners, and also along directions that turn with
//!    them. Others are cut shortly before the gap along a direction vanishes, or halved; where both triangles meet at a
//!    time, exactly, nothing after it matters to any pair.
//!
//! # Complexity
//! One test of volumes for each pair of nodes and stretch that is reached, and a search for a direction where they are
//! apart: a few times the node tests of one static question where the step is no more than half a turn, O(m n) pairs at
//! worst.
//!
//! # Shapes
//! `hierarchies`: over meshes as they stand before the motions; times in [0, 1]; triangles by their positions.
//!
//! # Numerics
//! Volumes are taken as zonotopes that contain them exactly, triangles by their own corners; a direction is proved in
//! bounded doubles or exactly, a contact exactly, by triangles times a common positive number.
//!
//! # Checked by
//! Exact gaps of corners at rational times, a count of all pairs of triangles and times that are proved, and samples.
//!
//! # Example
//! ```
//! use zonotope::bvh::{Aabb, Bvh, Mesh};
//! use zonotope::motion::{Motion, continuous::of_meshes::{MeshContact, first_contact}};
//! let triangle = |x: f64| Mesh::new(vec![[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]], vec![[0, 1, 2]]);
//! let [a, b] = [Bvh::<Aabb>::build(&triangle(0.0)?), Bvh::build(&triangle(6.0)?)];
//! let right = Motion::translation([8.0, 0.0, 0.0])?;
//! // 6 apart, and 8 in a step
//! match first_contact([&a, &b], [&right, &Motion::rest()])? {
//!     MeshContact::Contact { time: [before, met], .. } => assert!(before < 0.75 && 0.75 <= met),
//!     answer => panic!("{answer:?}"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod descent;
mod placed;
mod sizes;
mod slice;
#[cfg(test)]
mod tests;
mod triangles;

pub use self::answer::{FreePair, MeshContact, NotRational, Part};

use self::descent::Descent;
use self::sizes::MeshScene;
use super::by_control_points::{DEFAULT_RESOLUTION, FINEST_RESOLUTION};
use crate::bvh::{BoundingVolume, Bvh};
use crate::motion::Motion;
use crate::tally::Tally;

/// When two moving meshes meet first during the time from 0 to 1, a contact between two times that are not farther
/// apart than 2^-30.
///
/// # Errors
/// [`NotRational`] for a rotation at constant rate; [`Motion::through`] makes rational motions.
pub fn first_contact<V: BoundingVolume>(
    hierarchies: [&Bvh<V>; 2],
    motions: [&Motion; 2],
) -> Result<MeshContact, NotRational> {
    first_contact_counted(hierarchies, motions, DEFAULT_RESOLUTION, &mut ())
}

/// The same with another resolution, counting pairs of nodes and of triangles with their stretches.
///
/// # Errors
/// [`NotRational`] for a rotation at constant rate.
pub fn first_contact_counted<V: BoundingVolume>(
    hierarchies: [&Bvh<V>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    tally: &mut dyn Tally,
) -> Result<MeshContact, NotRational> {
    if let Some(body) = motions.iter().position(|motion| !motion.is_rational()) {
        return Err(NotRational { body });
    }
    let scene = MeshScene::new(hierarchies, motions);
    Ok(Descent::new(&scene, resolution.max(FINEST_RESOLUTION)).first_contact(tally))
}
