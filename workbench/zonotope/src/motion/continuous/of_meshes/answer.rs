//! The first contact of two moving meshes, with its proof.

use thiserror::Error;

use crate::motion::continuous::FreeStretch;

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
