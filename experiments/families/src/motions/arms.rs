//! Arms that turn about a joint at the origin.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::family::{Course, MotionFamily, MovingPair};
use super::shapes::{between, leaning_axis, turned_box, upright_box};
use crate::source::RandomSource;

/// A link above a box.
pub(super) const LINKS: MotionFamily = MotionFamily {
    id: "links",
    title: "A link past a box",
    description: "a link that turns a quarter about a joint above a box in a random position",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let (sine, cosine) = libm::sincos(between(&mut source, 0.2, FRAC_PI_2 - 0.2));
        let reach = between(&mut source, 1.0, 1.8);
        let obstacle = turned_box(&mut source, [reach * cosine, reach * sine, 0.0], [0.4, 0.3, 0.25]);
        let course = Course::turn([0.0; 3], leaning_axis(&mut source), FRAC_PI_2);
        MovingPair {
            bodies: [upright_box([1.0, 0.0, 0.0], [1.0, 0.08, 0.08]), obstacle],
            courses: [course, Course::REST],
            aside: [0.0, 0.0, -1.0],
        }
    },
};

/// Two links, one above the other.
pub(super) const TWO_TURNING_LINKS: MotionFamily = MotionFamily {
    id: "two_turning_links",
    title: "Two turning links",
    description: "two links that turn a quarter about joints of their own, one above the other",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let joint = [between(&mut source, 1.4, 2.0), between(&mut source, -0.2, 0.2), 0.0];
        let center = [joint[0] - 0.9, joint[1], 0.0];
        let first = Course::turn([0.0; 3], leaning_axis(&mut source), between(&mut source, 1.2, FRAC_PI_2));
        let second = Course::turn(joint, leaning_axis(&mut source), between(&mut source, 0.8, FRAC_PI_2));
        MovingPair {
            bodies: [upright_box([1.0, 0.0, 0.0], [1.0, 0.08, 0.08]), upright_box(center, [0.9, 0.07, 0.1])],
            courses: [first, second],
            aside: [0.0, 0.0, -1.0],
        }
    },
};

/// Half a turn.
pub(super) const SWING_180: MotionFamily = MotionFamily {
    id: "swing_180",
    title: "A swing of half a turn",
    description: "a box on an arm that swings half a turn past a cube",
    generate: |seed| swing(seed, PI),
};

/// A whole turn.
pub(super) const SWING_360: MotionFamily = MotionFamily {
    id: "swing_360",
    title: "A swing of a whole turn",
    description: "a box on an arm that swings a whole turn past a cube",
    generate: |seed| swing(seed, TAU),
};

fn swing(seed: u64, angle: f64) -> MovingPair {
    let mut source = RandomSource::new(seed);
    let (sine, cosine) = libm::sincos(between(&mut source, 1.0, 2.1));
    let swung = turned_box(&mut source, [1.0, 0.0, 0.0], [0.5, 0.25, 0.25]);
    let cube = turned_box(&mut source, [1.8 * cosine, 1.8 * sine, 0.0], [0.4; 3]);
    MovingPair {
        bodies: [swung, cube],
        courses: [Course::turn([0.0; 3], leaning_axis(&mut source), angle), Course::REST],
        aside: [cosine, sine, 0.0],
    }
}
