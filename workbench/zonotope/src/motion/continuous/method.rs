//! The methods for the first contact by name.

use super::{FirstContact, by_chord, by_conservative_advancement, by_control_points, by_space_time_volumes};
use crate::motion::Motion;
use crate::tally::Tally;
use crate::zonotope::Zonotope;

/// A method that finds when two moving bodies meet first, with a proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_control_points`], the default.
    #[default]
    ByControlPoints,
    /// [`by_chord`].
    ByChord,
    /// [`by_conservative_advancement`].
    ByConservativeAdvancement,
    /// [`by_space_time_volumes`].
    BySpaceTimeVolumes,
}

impl Method {
    /// Every method, better ones first.
    pub const ALL: [Self; 4] =
        [Self::ByControlPoints, Self::ByChord, Self::ByConservativeAdvancement, Self::BySpaceTimeVolumes];

    /// The name of the method's file.
    pub const fn id(self) -> &'static str {
        match self {
            Self::ByControlPoints => "by_control_points",
            Self::ByChord => "by_chord",
            Self::ByConservativeAdvancement => "by_conservative_advancement",
            Self::BySpaceTimeVolumes => "by_space_time_volumes",
        }
    }

    /// The method with a name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The name for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::ByControlPoints => "Bernstein coefficients of the gap along a direction",
            Self::ByChord => "The chord of the gap along a direction",
            Self::ByConservativeAdvancement => "Steps of the distance over a bound of the speed",
            Self::BySpaceTimeVolumes => "Zonotopes around the swept volumes, and bisection",
        }
    }

    /// The number of stretches at a clearance ε with n generators, and the cost of one.
    pub fn cost(self) -> &'static str {
        match self {
            Self::ByControlPoints | Self::ByChord => "up to 1/√ε stretches of O(n)",
            Self::ByConservativeAdvancement => "up to 1/ε steps of O(n)",
            Self::BySpaceTimeVolumes => "up to 1/ε stretches of O(n log n)",
        }
    }

    /// When two moving bodies meet first during the time from 0 to 1, a contact within a resolution; counting
    /// operations.
    pub fn first_contact(
        self,
        bodies: [&Zonotope<3>; 2],
        motions: [&Motion; 2],
        resolution: f64,
        tally: &mut dyn Tally,
    ) -> FirstContact {
        let of = match self {
            Self::ByControlPoints => by_control_points::first_contact_counted,
            Self::ByChord => by_chord::first_contact_counted,
            Self::ByConservativeAdvancement => by_conservative_advancement::first_contact_counted,
            Self::BySpaceTimeVolumes => by_space_time_volumes::first_contact_counted,
        };
        of(bodies, motions, resolution, tally)
    }
}
