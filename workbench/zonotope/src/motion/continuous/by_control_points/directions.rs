//! A direction that proves a stretch of time: known ones, then those that searches over control zonotopes find, then
//! normals of edges.

use super::super::SeparatingDirection;
use super::super::gap::Stretch;
use super::super::moving::Moving;
use super::super::scene::Hint;
use super::control_zonotopes::{ControlZonotopes, Found};
use super::edges;
use crate::tally::Tally;
use smallvec::SmallVec;

/// A direction that proves a stretch, the first that does, from known ones.
pub(in crate::motion::continuous) fn separating(
    moving: &Moving<'_>,
    stretch: &Stretch<'_, f64>,
    times: [f64; 2],
    known: &[Hint; 3],
    tally: &mut dyn Tally,
) -> Option<SeparatingDirection> {
    let mut turning = known.iter().flatten().filter(|direction| direction.fixed_in_space().is_none());
    if let Some(direction) = turning.find(|direction| moving.is_proved(stretch, times, direction, tally)) {
        return Some(*direction);
    }
    let mut first: SmallVec<[[f64; 3]; 3]> =
        known.iter().flatten().filter_map(SeparatingDirection::fixed_in_space).collect();
    if first.is_empty() {
        first.push(middle_path(stretch));
    }
    let found = ControlZonotopes::in_space(stretch).separating_direction(&first, tally);
    if let Some(direction) = confirmed(moving, found, times, tally) {
        return Some(direction);
    }
    [0, 1].into_iter().find_map(|own| {
        let arc = &stretch.arcs[own];
        // of a body that only translates, the frame is that of space
        if arc.is_translation {
            return None;
        }
        let sign = [1.0, -1.0][own];
        let first = arc.turned_back(&first[0]).map(|c| sign * c);
        let found = ControlZonotopes::in_frame(stretch, own).separating_direction(&[first], tally);
        confirmed(moving, found, times, tally)
    })
}

/// A direction fixed in space that proves a stretch of two nodes, searched for from a first one. The frames of the
/// bodies are left to triangles: a search in them costs as much as both tests of the nodes' halves.
pub(in crate::motion::continuous) fn in_space(
    moving: &Moving<'_>,
    stretch: &Stretch<'_, f64>,
    times: [f64; 2],
    first: [f64; 3],
    tally: &mut dyn Tally,
) -> Option<[f64; 3]> {
    let found = ControlZonotopes::in_space(stretch).separating_direction(&[first], tally);
    confirmed(moving, found, times, tally)?.fixed_in_space()
}

/// A direction that was found, if it proves the stretch.
fn confirmed(
    moving: &Moving<'_>,
    found: Option<Found>,
    times: [f64; 2],
    tally: &mut dyn Tally,
) -> Option<SeparatingDirection> {
    let Found { direction, is_proved } = found?;
    (is_proved || moving.is_proved_with_bounds(times, &direction, tally)).then_some(direction)
}

/// The normal of two edges that proves a stretch, by the first of some directions that separate the bodies at its
/// middle, or near it.
pub(in crate::motion::continuous) fn of_edges(
    moving: &Moving<'_>,
    stretch: &Stretch<'_, f64>,
    times: [f64; 2],
    known: &[Hint],
    tally: &mut dyn Tally,
) -> Option<SeparatingDirection> {
    let u = known.iter().flatten().find_map(SeparatingDirection::fixed_in_space)?;
    if stretch.arcs.iter().all(|arc| arc.is_translation) {
        return None;
    }
    edges::normals(stretch, u).find(|direction| moving.is_proved(stretch, times, direction, tally))
}

/// The path between the centres of the bodies at the middle of a stretch.
fn middle_path(stretch: &Stretch<'_, f64>) -> [f64; 3] {
    let [from, to] = [0, 1].map(|i| stretch.arcs[i].middle_of(&stretch.bodies[i].center()));
    [0, 1, 2].map(|k| to[k] - from[k])
}
