//! The first contact of two moving bodies, by zonotopes around the volumes that they sweep.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a resolution. Output: when they meet first, as [`FirstContact`]
//! has it.
//!
//! # Source
//! Section 6 and Theorem 6.1, with the generators of the translation and of the disc as they must be.
//!
//! # Method
//! The volume of Theorem 6.1 ([`by_farthest_vertex`]) is put around each body's placements on a stretch. Bodies whose
//! volumes are disjoint do not meet on the stretch; else it is halved.
//!
//! # Complexity
//! O(n log n) a stretch for the farthest vertex of the projected body. A clearance ε takes some 1/ε stretches where the
//! bodies pass each other side by side.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1].
//!
//! # Numerics
//! Volumes are doubles that are made larger by more than their rounding; volumes and contacts are decided exactly.
//!
//! # Checked by
//! The first contact by control points, and exact gaps of its directions.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, motion::Motion};
//! use zonotope::motion::continuous::{FirstContact, by_space_time_volumes::first_contact_counted};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! let found = first_contact_counted([&cube, &other], [&right, &Motion::rest()], 1e-6, &mut ());
//! let FirstContact::Contact { time: [before, met], .. } = found else { panic!("they meet") };
//! assert!(before < 0.5 && 0.5 <= met && met - before <= 1e-6);
//! ```

use super::FirstContact;
use super::bisection::{self, Bound};
use super::gap::Stretch;
use super::ordinary_sizes;
use super::parts::body::Body;
use super::parts::rates::Rates;
use super::scene::Scene;
use crate::collision::by_lad::decide;
use crate::collision::{Location, Separation};
use crate::motion::Motion;
use crate::motion::arc::Arc;
use crate::motion::quaternion::{image, polar_rotation};
use crate::motion::space_time::by_farthest_vertex;
use crate::motion::sweep::Sweep;
use crate::numeric::bounded::Bounded;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::RATE_ROUNDING;
use crate::tally::{Operation, OperationCounts, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::query::Query;

/// When two moving bodies meet first during the time from 0 to 1, within a resolution; counting operations.
pub fn first_contact_counted(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    tally: &mut dyn Tally,
) -> FirstContact {
    ordinary_sizes::first_contact(bodies, motions, |scene| {
        bisection::first_contact(&scene, &Volumes, resolution, tally)
    })
}

struct Volumes;

impl Bound for Volumes {
    fn proof(
        &self,
        scene: &Scene<'_>,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        _: &[[f64; 3]],
        tally: &mut dyn Tally,
    ) -> Option<[f64; 3]> {
        let [a, b] = [0, 1].map(|i| {
            let pad = (RATE_ROUNDING - 1.0) * stretch.size_of(i) + scene.moving.margin(times);
            volume(&stretch.bodies[i], &stretch.arcs[i].rounded(), pad)
        });
        let (a, b) = (a?, b?);
        let mut counts = OperationCounts::default();
        let location = decide(&Query::between(&a, &b), &mut counts);
        let generators = (a.generators().len() + b.generators().len()).max(1) as u64;
        let passes = counts.get(Operation::GeneratorRead).div_ceil(generators).max(1);
        tally.add(Operation::SupportEvaluation, 2 * passes);
        match location {
            Location::Outside(Separation::Rounded(u)) => Some(u),
            _ => None,
        }
    }
}

/// A zonotope around all placements of a body on a stretch; `None` where it leaves the range of doubles.
///
/// It is that of the body as it is rounded at the start, larger by a pad of more than all roundings and the margin.
fn volume(body: &Body<'_>, arc: &Arc<f64>, pad: f64) -> Option<Zonotope<3>> {
    let [turn, _] = &arc.turns;
    let square = dot(turn, turn);
    let rotation = polar_rotation(turn, turn).map(|row| row.map(|c| c / square));
    let arm = arc.arm_of(&body.center()).map(|c| c / arc.weight);
    let base = arc.base[0].map(|c| c / arc.weight);
    let Rates { axis, angle, travel, .. } = Rates::of(arc, body);
    let moved = image(&rotation, &arm);
    let generators = body.generators().iter().map(|g| image(&rotation, g)).collect();
    let placed = Zonotope::new([0, 1, 2].map(|k| base[k] + moved[k]), generators).ok()?;
    let axis = if axis == [0.0; 3] { [1.0, 0.0, 0.0] } else { axis };
    let sweep = Sweep::new(base, axis, angle * RATE_ROUNDING, travel).ok()?;
    let swept = by_farthest_vertex::volume(&sweep, &placed, &mut ()).ok()?;
    let padding = [0, 1, 2].map(|axis| [0, 1, 2].map(|k| if k == axis { pad } else { 0.0 }));
    let generators = swept.generators().iter().copied().chain(padding).collect();
    Zonotope::new(swept.center(), generators).ok()
}
