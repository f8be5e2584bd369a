//! Problem: whether two zonotopes that move rigidly meet during a step of time, and when first.
//!
//! The answer is a [`FirstContact`]: separate during the whole step, a contact between two times, or grazing, where
//! neither is proved. It comes with stretches of time that follow each other and, for each, a direction along which
//! there is a gap at every moment of it; and for a contact with coefficients that prove it.
//!
//! | method | what it does on a stretch of time |
//! |---|---|
//! | [`by_control_points`] (default) | looks for a direction along which all Bernstein coefficients of the gap are positive |
//! | [`by_chord`] | bounds the gap along a direction by its chord and its second derivative |
//! | [`by_conservative_advancement`] | goes on by the distance over a bound of the speed |
//! | [`by_space_time_volumes`] | encloses the swept volumes, as the paper does |
//! | [`of_meshes`] | descends pairs of nodes over two meshes, with the same proofs |
//! | [`brute_force`] | the truth at one rational time: placements and gaps in rationals |
//!
//! The files are read in this order: `parts/body`, `gap` (two bodies on a stretch, and the polynomial below their gap),
//! `doubles`, `parts/margin`, `moving`, `meeting`, `scene` (the questions at one time), `simplex_search`; then
//! `by_control_points`, and any other method.
//!
//! [`Method`] names those that prove their answers. Of a scene they may find different stretches, and
//! each may leave it grazing; never does one prove a contact and another that the bodies are separate.
//!
//! The paper (Section 6) encloses the volumes that both bodies sweep, and halves the step where these meet. Volumes of
//! space forget the time; a direction for a stretch of time is a separating hyperplane of space-time.

mod bisection;
pub mod brute_force;
pub mod by_chord;
pub mod by_conservative_advancement;
pub mod by_control_points;
pub mod by_space_time_volumes;
mod doubles;
mod gap;
mod meeting;
mod method;
mod moving;
pub mod of_meshes;
mod ordinary_sizes;
mod parts;
mod scene;
mod simplex_search;
#[cfg(test)]
mod tests;

pub use by_control_points::{first_contact, first_contact_within};
pub use method::Method;

use crate::collision::Witness;
use crate::numeric::linear::sum_norm;

/// When two moving bodies meet first. The stretches without contact follow each other, from 0 to 1 or to where the
/// contact or the doubt begins.
#[derive(Debug, Clone, PartialEq)]
pub enum FirstContact {
    /// The bodies are disjoint during the whole step.
    Separate {
        /// The proof: stretches from 0 to 1.
        free: Vec<FreeStretch>,
    },
    /// The bodies are disjoint before `time[0]` and meet at `time[1]`; [0, 0] where they meet at the start.
    Contact {
        /// The proof that nothing meets before.
        free: Vec<FreeStretch>,
        /// Two times not farther apart than the resolution.
        time: [f64; 2],
        /// The proof that the bodies meet at the second time: coefficients of the generators of both, as for an
        /// intersection of the bodies as they are placed then.
        witness: Witness,
    },
    /// The bodies are disjoint before `time[0]`, and at `time[1]` they are so near that neither a direction nor
    /// coefficients were found.
    Grazing {
        /// The proof that nothing meets before.
        free: Vec<FreeStretch>,
        /// Two times.
        time: [f64; 2],
        /// At the second time two points of the bodies are within this distance.
        distance_at_most: f64,
    },
}

/// A stretch of time in which two bodies are disjoint, with the proof. Where a motion jumps at its end, the placements
/// before the jump are meant; those after it are at the begin of the next stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeStretch {
    /// When it begins.
    pub from: f64,
    /// When it ends.
    pub until: f64,
    /// The direction from the first body to the second along which there is a gap at every time between.
    pub direction: SeparatingDirection,
}

/// A direction from the first body to the second, which may turn with one of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SeparatingDirection {
    /// A direction that is fixed in space.
    Space([f64; 3]),
    /// A direction that turns with the first body: at a time t it is R_a(t) u.
    First([f64; 3]),
    /// A direction that turns with the second body.
    Second([f64; 3]),
    /// The normal of an edge of each body: R_a(t) e × R_b(t) f.
    Edges([[f64; 3]; 2]),
}

impl SeparatingDirection {
    /// The direction, if it is fixed in space.
    fn fixed_in_space(&self) -> Option<[f64; 3]> {
        match self {
            Self::Space(u) => Some(*u),
            _ => None,
        }
    }

    /// Whether all its coordinates are finite.
    fn is_finite(&self) -> bool {
        match self {
            Self::Space(u) | Self::First(u) | Self::Second(u) => u.iter().all(|c| c.is_finite()),
            Self::Edges(edges) => edges.iter().flatten().all(|c| c.is_finite()),
        }
    }

    /// A bound of its length: the sum of the magnitudes of its coordinates.
    fn length_at_most(&self) -> f64 {
        match self {
            Self::Space(u) | Self::First(u) | Self::Second(u) => sum_norm(u),
            Self::Edges([e, f]) => sum_norm(e) * sum_norm(f),
        }
    }
}

impl FirstContact {
    /// The stretches without contact.
    pub fn free(&self) -> &[FreeStretch] {
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
