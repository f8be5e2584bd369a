//! The first contact of two moving bodies, by steps of the distance over a bound of the speed.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a resolution. Output: when they meet first, as [`FirstContact`]
//! has it.
//!
//! # Source
//! The method that collision engines have beside Section 6: conservative advancement.
//!
//! # Method
//! At a time the shortest vector between the bodies is found, of length d and direction u. No point of either body goes
//! along u faster than that of its base and the rate of its turn times its distance from the axis; so the bodies are
//! disjoint until d over that speed has passed, and u separates them until then. Where a step is shorter than the
//! resolution, the bodies are asked whether they meet at its end.
//!
//! # Complexity
//! O(n) for each step of each search for the shortest vector. Each step brings a contact nearer by a share of the time
//! that is left; a pass side by side at a clearance ε takes up to 1/ε steps.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1].
//!
//! # Numerics
//! Distances are within two units in the last place; the speed is a double that is rounded up; contacts are decided
//! exactly.
//!
//! # Checked by
//! The first contact by control points, and exact gaps of its directions.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, motion::Motion};
//! use zonotope::motion::continuous::{FirstContact, by_conservative_advancement::first_contact_counted};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! let found = first_contact_counted([&cube, &other], [&right, &Motion::rest()], 1e-6, &mut ());
//! let FirstContact::Contact { time: [before, met], .. } = found else { panic!("they meet") };
//! assert!(before < 0.5 && 0.5 <= met && met - before <= 1e-6);
//! ```

use super::by_control_points::{SHORTEST_STRETCH, STRETCH_LIMIT};
use super::moving::spans;
use super::ordinary_sizes;
use super::scene::{Position, Scene};
use super::{FirstContact, FreeStretch, SeparatingDirection};
use crate::motion::Motion;
use crate::numeric::linear::{dot, norm_of_any_size};
use crate::numeric::tolerance::{POSE_ROUNDING, RATE_ROUNDING};
use crate::tally::{Operation, Tally};
use crate::zonotope::Zonotope;

/// Of the distance, the margin of a rotation at constant rate takes at most twice one part in so many.
const MARGIN_SHARE: f64 = 16.0;

/// When two moving bodies meet first during the time from 0 to 1, within a resolution; counting operations.
pub fn first_contact_counted(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    tally: &mut dyn Tally,
) -> FirstContact {
    let resolution = resolution.max(SHORTEST_STRETCH);
    ordinary_sizes::first_contact(bodies, motions, |scene| advanced(&scene, resolution, tally))
}

fn advanced(scene: &Scene<'_>, resolution: f64, tally: &mut dyn Tally) -> FirstContact {
    let mut free = Vec::new();
    if let Position::Meeting(witness) = scene.position_at(0.0, tally) {
        return FirstContact::Contact { free, time: [0.0; 2], witness };
    }
    let mut steps = 0;
    for [mut from, end] in spans(scene.moving.motions) {
        while from < end {
            steps += 1;
            tally.add(Operation::Stretch, 1);
            let step = (steps <= STRETCH_LIMIT).then(|| step(scene, [from, end], tally)).flatten();
            let (until, direction) = step.unwrap_or((from, SeparatingDirection::Space([0.0; 3])));
            if until - from < (resolution / 2.0).min(end - from) {
                // the bodies are near: do they meet shortly after?
                let near = (from + resolution).min(end);
                let near = if near - from > resolution { near.next_down() } else { near };
                if let Position::Meeting(witness) = scene.position_at(near, tally) {
                    return FirstContact::Contact { free, time: [from, near], witness };
                }
                if until - from < SHORTEST_STRETCH {
                    let time = [from, near];
                    let distance_at_most = scene.distance_at_most(near, tally);
                    return FirstContact::Grazing { free, time, distance_at_most };
                }
            }
            free.push(FreeStretch { from, until, direction });
            from = until;
        }
    }
    FirstContact::Separate { free }
}

/// The time for which the bodies stay disjoint for certain, from a time on and not beyond another, and the direction
/// that separates them until then.
fn step(scene: &Scene<'_>, [from, end]: [f64; 2], tally: &mut dyn Tally) -> Option<(f64, SeparatingDirection)> {
    let proximity = scene.proximity_at(from, tally)?;
    let u = proximity.gap()?.direction();
    let length = norm_of_any_size(&u);
    let unit = u.map(|c| c / length);
    // the placements were rounded, and those of a rotation at constant rate are off; beyond the doubles the distance is
    // at least the largest
    let distance = proximity.distance().min(f64::MAX) * (2.0 - RATE_ROUNDING);
    let mut until = end;
    while until > from
        && (!scene.moving.is_whole([from, until]) || scene.moving.margin([from, until]) > distance / MARGIN_SHARE)
    {
        until = from + (until - from) / 2.0;
    }
    let stretch = scene.moving.stretch([from, until]);
    let size = stretch.size_of(0) + stretch.size_of(1);
    // the margin once for the begin and once for the end; an arc that need not be timed is moved outwards by more, but
    // then its rates, which are taken, are those of the longer arc
    let distance = distance - POSE_ROUNDING * size - 2.0 * scene.moving.margin([from, until]);
    let [first, second] = stretch.rates();
    let nearing = dot(&unit, &first.travel) - dot(&unit, &second.travel) + (RATE_ROUNDING - 1.0) * size;
    let speed = (nearing + first.speed_along(&unit) + second.speed_along(&unit)) * RATE_ROUNDING;
    let is_free_to_the_end = speed * RATE_ROUNDING <= distance;
    let until = if is_free_to_the_end { until } else { (from + (until - from) * (distance / speed)).next_down() };
    (distance > 0.0 && until > from).then_some((until, SeparatingDirection::Space(u)))
}
