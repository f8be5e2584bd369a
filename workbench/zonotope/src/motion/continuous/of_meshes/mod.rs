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
//! 1. Take a pair of nodes with a stretch of time, the earliest of its pair. A direction along which the control points
//!    of its volumes are apart proves it free, as it does for two zonotopes.
//! 2. Where the volumes seem disjoint at the middle of the stretch, its halves are taken; else the larger node is opened.
//! 3. Pairs of triangles are proved free in the same way, by their corners, and halved until they are; where both meet
//!    at a time, exactly, nothing after it matters to any pair.
//!
//! # Complexity
//! One search of a direction for each pair and stretch that is reached: the node tests of a few static questions where
//! the step is no more than a quarter turn, O(m n) pairs at worst.
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

mod descent;
mod placed;
#[cfg(test)]
mod tests;

use thiserror::Error;

use self::descent::Descent;
use super::FreeStretch;
use super::by_control_points::{DEFAULT_RESOLUTION, FINEST_RESOLUTION};
use crate::bvh::{BoundingVolume, Bvh};
use crate::motion::Motion;
use crate::tally::Tally;

/// When two moving meshes meet first. Each pair of triangles is in some of the free pairs, and the stretches of these
/// cover the time until the contact or the doubt, or all of it.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshContact {
    /// The meshes are disjoint during the whole step.
    Separate {
        /// The proof.
        free: Vec<FreePair>,
    },
    /// The meshes are disjoint before `time[0]`, and two triangles meet at `time[1]`.
    Contact {
        /// The proof that nothing meets before.
        free: Vec<FreePair>,
        /// Two times not farther apart than the resolution; equal where they meet at the start.
        time: [f64; 2],
        /// The triangles, which meet exactly then.
        triangles: [usize; 2],
    },
    /// The meshes are disjoint before `time[0]`; about the two triangles neither was proved between the times.
    Grazing {
        /// The proof that nothing meets before.
        free: Vec<FreePair>,
        /// Two times.
        time: [f64; 2],
        /// The triangles.
        triangles: [usize; 2],
    },
}

/// A stretch of time in which no triangle of one part meets one of another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreePair {
    /// The parts of the first and the second mesh.
    pub parts: [Part; 2],
    /// The stretch and the direction.
    pub stretch: FreeStretch,
}

/// A part of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The triangles below a node of the hierarchy.
    Node(usize),
    /// A triangle of the mesh.
    Triangle(usize),
}

/// A motion has no rational placements: it is a rotation at constant rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("motion {body} is a rotation at constant rate; meshes are asked about under rational motions")]
pub struct NotRational {
    /// The mesh, 0 or 1.
    pub body: usize,
}

impl MeshContact {
    /// The pairs that are proved free.
    pub fn free(&self) -> &[FreePair] {
        match self {
            Self::Separate { free } | Self::Contact { free, .. } | Self::Grazing { free, .. } => free,
        }
    }

    /// The name of the case in records: `separate`, `contact` or `grazing`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Separate { .. } => "separate",
            Self::Contact { .. } => "contact",
            Self::Grazing { .. } => "grazing",
        }
    }
}

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
    Ok(Descent::new(hierarchies, motions, resolution.max(FINEST_RESOLUTION)).first_contact(tally))
}
