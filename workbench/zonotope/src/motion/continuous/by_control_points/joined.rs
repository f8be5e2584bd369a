//! Neighbouring stretches that one direction proves, joined to one.
//!
//! Stretches are halves of each other, and where a direction proves less than a half of one and more than a half of the
//! next, the halves stand apart. A proof of fewer parts is shorter to write and to check.

use super::directions;
use crate::motion::continuous::FreeStretch;
use crate::motion::continuous::moving::Moving;
use crate::tally::Tally;

/// The fewest stretches of which some are joined: of fewer a search costs as much again as finding them.
const LEAST_COUNT: usize = 4;

/// The stretches, each joined with the one before it where a direction proves both.
pub(super) fn joined(moving: &Moving<'_>, free: Vec<FreeStretch>, tally: &mut dyn Tally) -> Vec<FreeStretch> {
    if free.len() < LEAST_COUNT {
        return free;
    }
    let mut joined: Vec<FreeStretch> = Vec::with_capacity(free.len());
    for stretch in free {
        match joined.last_mut() {
            Some(last) if last.until == stretch.from => match both(moving, last, &stretch, tally) {
                Some(one) => *last = one,
                None => joined.push(stretch),
            },
            _ => joined.push(stretch),
        }
    }
    joined
}

/// One stretch in place of two.
fn both(moving: &Moving<'_>, first: &FreeStretch, second: &FreeStretch, tally: &mut dyn Tally) -> Option<FreeStretch> {
    let times = [first.from, second.until];
    if are_halves(first, second) || !moving.is_whole(times) {
        return None;
    }
    let stretch = moving.rounded_stretch(times);
    let known = [Some(first.direction), Some(second.direction), None];
    let direction = directions::separating(moving, &stretch, times, &known, tally)?;
    Some(FreeStretch { from: first.from, until: second.until, direction })
}

/// Whether two stretches are the halves of one that was not proved. First stretches that are no powers of two of a step
/// long may be taken for others than they are, which costs a search.
fn are_halves(first: &FreeStretch, second: &FreeStretch) -> bool {
    let width = first.until - first.from;
    width == second.until - second.from && (first.from / (2.0 * width)).fract() == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Motion;
    use crate::motion::continuous::SeparatingDirection;
    use crate::motion::continuous::scene::Scene;
    use crate::zonotope::Zonotope;

    fn eighths(direction: SeparatingDirection) -> Vec<FreeStretch> {
        (0..8)
            .map(|i| [i, i + 1].map(|k| f64::from(k) / 8.0))
            .map(|[from, until]| FreeStretch { from, until, direction })
            .collect()
    }

    /// A cube passes above another one: the direction upwards proves all of it, but the first two eighths are halves of
    /// a quarter, which is taken to have been tried.
    #[test]
    fn stretches_of_one_direction_are_one_stretch_but_for_halves() {
        let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
        let other = cube.translated([-4.0, 0.0, 3.0]).expect("finite");
        let motion = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
        let rest = Motion::rest();
        let scene = Scene::new([&cube, &other], [&rest, &motion]);
        let up = SeparatingDirection::Space([0.0, 0.0, 1.0]);
        let found = joined(&scene.moving, eighths(up), &mut ());
        let times: Vec<[f64; 2]> = found.iter().map(|stretch| [stretch.from, stretch.until]).collect();
        assert_eq!(times, [[0.0, 0.125], [0.125, 1.0]]);
        // what no direction proves stays as it is, and so do few stretches
        let through = other.translated([0.0, 0.0, -3.0]).expect("finite");
        let scene = Scene::new([&cube, &through], [&rest, &motion]);
        assert_eq!(joined(&scene.moving, eighths(up), &mut ()), eighths(up));
        assert_eq!(joined(&scene.moving, eighths(up)[..3].to_vec(), &mut ()).len(), 3);
    }
}
