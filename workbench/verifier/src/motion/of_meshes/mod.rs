//! Answers to "when do two moving meshes of triangles meet first".
//!
//! **Idea.** The triangles of each mesh are put in an order, and a part of a mesh is a run of that order. A stretch of
//! time with a direction proves two parts free, as an interval does two zonotopes: the gap is that of the hulls of
//! their corners. Each such proof is a box, positions by positions by times, and the boxes must hold all pairs of
//! triangles until the contact or the doubt: `cover` looks for one that is left out. At a contact the two triangles are
//! placed in whole numbers, and meet. Of a grazing nothing is proved but that the meshes are disjoint before.
//!
//! **Cost.** The corners of the parts of every stretch once for each direction that is measured; for k stretches of a
//! hierarchy that was descended O(k log k) steps, times its height at worst, for the cover.

mod check;
mod cover;
#[cfg(test)]
mod tests;

pub use self::check::check_mesh_contact;

use super::answer::FreeInterval;
use super::path::Motion;

/// A mesh of triangles in motion.
#[derive(Debug, Clone, Copy)]
pub struct MovingSurface<'a> {
    /// The vertices before the motion.
    pub vertices: &'a [Vec<f64>],
    /// The triangles: three positions of vertices from 0 each.
    pub triangles: &'a [Vec<usize>],
    /// The motion, which consists of pieces.
    pub motion: &'a Motion,
}

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshContactAnswer {
    /// The claim.
    pub encounter: MeshEncounter,
    /// The triangles of either mesh in the order that parts are runs of.
    pub order: [Vec<usize>; 2],
    /// The stretches of time in which parts of the meshes are disjoint.
    pub intervals: Vec<FreeParts>,
}

/// The claim of an answer, by its status.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MeshEncounter {
    /// The meshes are disjoint from 0 to 1.
    Separate,
    /// The meshes are disjoint before the first time, and the triangles meet at the second.
    Contact {
        /// Two times, not farther apart than the resolution.
        time: [f64; 2],
        /// A triangle of each mesh.
        triangles: [usize; 2],
    },
    /// The meshes are disjoint before the first time, from which on nothing is proved of the triangles.
    Grazing {
        /// Two times.
        time: [f64; 2],
        /// A triangle of each mesh.
        triangles: [usize; 2],
    },
}

/// A stretch of time in which two parts of meshes are disjoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeParts {
    /// The stretch and the direction.
    pub interval: FreeInterval,
    /// The first position in the order of each mesh, and the one after the last.
    pub parts: [[usize; 2]; 2],
}
