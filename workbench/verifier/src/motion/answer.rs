//! The answer to "when do two moving bodies meet first" as it is written, and what is proved of it.

use std::fmt::{self, Display};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstContactAnswer {
    /// The claim.
    pub encounter: Encounter,
    /// The intervals in which the bodies are disjoint, with what proves it.
    pub intervals: Vec<FreeInterval>,
}

/// The claim of an answer, by its status.
#[derive(Debug, Clone, PartialEq)]
pub enum Encounter {
    /// The bodies are disjoint from 0 to 1.
    Separate,
    /// The bodies are disjoint before the first time and have a common point at the second.
    Contact {
        /// Two times, not farther apart than the resolution.
        time: [f64; 2],
        /// A coefficient in [−1, 1] for each generator, those of the first body first.
        coefficients: Vec<f64>,
        /// At most three generators whose coefficients are solved for.
        basis: Vec<usize>,
    },
    /// The bodies are disjoint before the first time and near each other at the second.
    Grazing {
        /// Two times.
        time: [f64; 2],
        /// Two points of the bodies are within this distance at the second time.
        distance_at_most: f64,
    },
}

/// An interval of time in which two bodies are disjoint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeInterval {
    /// When it begins.
    pub from: f64,
    /// When it ends.
    pub to: f64,
    /// The direction along which there is a gap at every time between.
    pub direction: MovingDirection,
}

/// A direction from the first body to the second, of any length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MovingDirection {
    /// Fixed in space.
    Space([f64; 3]),
    /// Turning with the first body.
    A([f64; 3]),
    /// Turning with the second body.
    B([f64; 3]),
    /// The normal (R_a e) × (R_b f) of an edge of each body.
    Edges([[f64; 3]; 2]),
}

/// The proof.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstContactProof {
    pub(super) intervals: usize,
    pub(super) end: ProvedEnd,
}

/// The end of a proof.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ProvedEnd {
    Separate,
    Contact([f64; 2]),
    Grazing([f64; 2], f64),
}

impl Display for FirstContactProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let intervals = match self.intervals {
            0 => "no interval".to_owned(),
            1 => "1 interval with a gap at every time".to_owned(),
            count => format!("{count} intervals with a gap at every time"),
        };
        match self.end {
            ProvedEnd::Separate => write!(f, "separate; {intervals}"),
            ProvedEnd::Contact([_, at]) => {
                write!(f, "contact; {intervals}, and a common point at the time {at:?}")
            }
            ProvedEnd::Grazing([_, at], distance) => {
                write!(f, "grazing; {intervals}, and at the time {at:?} two points within {distance:?}")
            }
        }
    }
}
