//! The methods for the first contact by name.

use super::{FirstContact, by_chord, by_conservative_advancement, by_control_points, by_space_time_volumes};
use crate::motion::Motion;
use crate::tables::methods;
use crate::tally::Tally;
use crate::zonotope::Zonotope;

methods! {
    /// A method that finds when two moving bodies meet first, with a proof.
    pub enum Method;
    /// The number of stretches at a clearance ε with n generators, and the cost of one.
    fn cost;

    /// [`by_control_points`], the default.
    ByControlPoints => "by_control_points", "Bernstein coefficients of the gap along a direction",
        "up to 1/√ε stretches of O(n)";
    /// [`by_chord`].
    ByChord => "by_chord", "The chord of the gap along a direction", "up to 1/√ε stretches of O(n)";
    /// [`by_conservative_advancement`].
    ByConservativeAdvancement => "by_conservative_advancement", "Steps of the distance over a bound of the speed",
        "up to 1/ε steps of O(n)";
    /// [`by_space_time_volumes`].
    BySpaceTimeVolumes => "by_space_time_volumes", "Zonotopes around the swept volumes, and bisection",
        "up to 1/ε stretches of O(n log n)";
}

impl Method {
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
