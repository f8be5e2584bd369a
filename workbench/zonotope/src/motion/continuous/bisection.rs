//! The bisection that the methods have in common which try one bound on a stretch: it proves the stretch, or both
//! halves are stretches of their own.

use super::by_control_points::{SHORTEST_STRETCH, STRETCH_LIMIT};
use super::gap::Stretch;
use super::scene::{Hint, Position, Scene};
use super::{FirstContact, FreeStretch, SeparatingDirection};
use crate::collision::Witness;
use crate::numeric::bounded::Bounded;
use crate::tally::{Operation, Tally};

/// A bound that may prove a stretch of a scene between two times, from directions that separate the bodies near by.
pub(super) trait Bound {
    /// A direction fixed in space along which there is a gap during the whole stretch.
    fn proof(
        &self,
        scene: &Scene<'_>,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        known: &[[f64; 3]],
        tally: &mut dyn Tally,
    ) -> Option<[f64; 3]>;
}

struct Open {
    times: [f64; 2],
    hints: [Hint; 2],
    meets: Option<Witness>,
}

/// The first contact by a bound on stretches.
pub(super) fn first_contact(
    scene: &Scene<'_>,
    bound: &impl Bound,
    resolution: f64,
    tally: &mut dyn Tally,
) -> FirstContact {
    let resolution = resolution.max(SHORTEST_STRETCH);
    let mut free = Vec::new();
    let start = match scene.position_at(0.0, tally) {
        Position::Meeting(witness) => return FirstContact::Contact { free, time: [0.0; 2], witness },
        Position::NotProved(found) => found,
    };
    let open = |times| Open { times, hints: [start, None], meets: None };
    let mut stack: Vec<Open> = scene.moving.first_stretches().into_iter().rev().map(open).collect();
    for _ in 0..STRETCH_LIMIT {
        let Some(Open { times, hints, meets }) = stack.pop() else { return FirstContact::Separate { free } };
        tally.add(Operation::Stretch, 1);
        let [from, until] = times;
        let width = until - from;
        match meets {
            Some(witness) if width <= resolution => return FirstContact::Contact { free, time: times, witness },
            Some(_) => {}
            None if scene.moving.is_whole(times) => {
                let known: Vec<[f64; 3]> =
                    hints.iter().rev().flatten().filter_map(SeparatingDirection::fixed_in_space).collect();
                if let Some(u) = bound.proof(scene, &scene.moving.stretch(times), times, &known, tally) {
                    free.push(FreeStretch { from, until, direction: SeparatingDirection::Space(u) });
                    continue;
                }
                if width <= SHORTEST_STRETCH {
                    if let Position::Meeting(witness) = scene.position_at(until, tally) {
                        return FirstContact::Contact { free, time: times, witness };
                    }
                    let distance_at_most = scene.distance_at_most(until, tally);
                    return FirstContact::Grazing { free, time: times, distance_at_most };
                }
            }
            None => {}
        }
        let middle = from + width / 2.0;
        match scene.position_at(middle, tally) {
            Position::Meeting(witness) => {
                stack.clear();
                stack.push(Open { times: [from, middle], hints: [hints[0], None], meets: Some(witness) });
            }
            Position::NotProved(found) => {
                stack.push(Open { times: [middle, until], hints: [found, hints[1]], meets });
                stack.push(Open { times: [from, middle], hints: [hints[0], found], meets: None });
            }
        }
    }
    match stack.pop() {
        Some(Open { times, .. }) => {
            let distance_at_most = scene.distance_at_most(times[1], tally);
            FirstContact::Grazing { free, time: times, distance_at_most }
        }
        None => FirstContact::Separate { free },
    }
}
