//! The first contact of two moving bodies, by the chord of the gap along a direction.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a resolution. Output: when they meet first, as [`FirstContact`]
//! has it.
//!
//! # Source
//! The bisection of Section 6 with another bound on a stretch of time: that of a function by its chord.
//!
//! # Method
//! Along a direction that is fixed in space the gap is the least of smooth functions, one for each choice of the signs
//! of the generators. The second derivative of each is at most K = Σ (ω² + |ω'|) |u⊥| (Σ |v⊥| + |c⊥|) over the bodies,
//! so the gap is at least the chord between its values at both ends, less K / 8. The directions that are tried
//! separate the bodies at the ends of the stretch; the last one is that of the shortest vector between them at its
//! middle.
//!
//! # Complexity
//! O(n) a stretch; a clearance ε takes some 1/√ε stretches.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1].
//!
//! # Numerics
//! Gaps at the ends are doubles with bounds, K is a double that is rounded up; contacts are decided exactly.
//!
//! # Checked by
//! The first contact by control points, and exact gaps of its directions.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, motion::Motion};
//! use zonotope::motion::continuous::{FirstContact, by_chord::first_contact_counted};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! let found = first_contact_counted([&cube, &other], [&right, &Motion::rest()], 1e-6, &mut ());
//! let FirstContact::Contact { time: [before, met], .. } = found else { panic!("they meet") };
//! assert!(before < 0.5 && 0.5 <= met && met - before <= 1e-6);
//! ```

use super::bisection::{self, Bound};
use super::gap::Stretch;
use super::ordinary_sizes;
use super::parts::rates::Rates;
use super::scene::Scene;
use super::{FirstContact, SeparatingDirection};
use crate::motion::Motion;
use crate::numeric::bounded::Bounded;
use crate::numeric::linear::norm_of_any_size;
use crate::numeric::tolerance::RATE_ROUNDING;
use crate::tally::{Operation, Tally};
use crate::zonotope::Zonotope;

/// When two moving bodies meet first during the time from 0 to 1, within a resolution; counting operations.
pub fn first_contact_counted(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    tally: &mut dyn Tally,
) -> FirstContact {
    ordinary_sizes::first_contact(bodies, motions, |scene| bisection::first_contact(&scene, &Chord, resolution, tally))
}

struct Chord;

impl Bound for Chord {
    fn proof(
        &self,
        scene: &Scene<'_>,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        known: &[[f64; 3]],
        tally: &mut dyn Tally,
    ) -> Option<[f64; 3]> {
        let rates = stretch.rates();
        let mut proves = |u: &[f64; 3]| {
            // one value for each body at each end
            tally.add(Operation::SupportEvaluation, 4);
            is_proved_by_chord(stretch, &rates, u)
        };
        if let Some(u) = known.iter().find(|u| proves(u)) {
            return Some(*u);
        }
        let nearest = scene.proximity_at(times[0] + (times[1] - times[0]) / 2.0, tally)?.gap()?.direction();
        tally.add(Operation::SupportEvaluation, 4);
        is_proved_by_chord(stretch, &rates, &nearest).then_some(nearest)
    }
}

fn is_proved_by_chord(stretch: &Stretch<'_, Bounded>, rates: &[Rates; 2], u: &[f64; 3]) -> bool {
    let length = norm_of_any_size(u);
    let unit = u.map(|c| c / length);
    let bend = length * (rates[0].bend_along(&unit) + rates[1].bend_along(&unit)) / 8.0 * RATE_ROUNDING;
    // the least of a chord is at one of its ends
    let least = stretch.least_end_gap(&SeparatingDirection::Space(*u));
    bend.is_finite() && least > bend
}
