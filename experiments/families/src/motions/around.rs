//! Bodies that go around others.

use std::f64::consts::TAU;

use super::family::{Course, MotionFamily, MovingPair};
use super::shapes::{between, leaning_axis, prism, turned_box, upright_box};
use crate::source::RandomSource;

/// Sides of half the prism that is circled.
const SIDES: usize = 6;

/// A box around a prism.
pub(super) const ORBIT: MotionFamily = MotionFamily {
    id: "orbit",
    title: "A box that circles a prism",
    description: "a box in a random position that circles a prism once",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let circling = turned_box(&mut source, [1.5, 0.0, 0.0], [0.3, 0.2, 0.2]);
        // the axis is off the middle of the prism, so that the box comes nearest once
        let (sine, cosine) = libm::sincos(between(&mut source, 0.5, TAU - 0.5));
        let middle = [0.2 * cosine, 0.2 * sine, 0.0];
        MovingPair {
            bodies: [circling, prism(middle, SIDES, 0.8, 0.5)],
            courses: [Course::turn([0.0; 3], leaning_axis(&mut source), TAU), Course::REST],
            aside: [-cosine, -sine, 0.0],
        }
    },
};

/// A link around a body.
pub(super) const RING: MotionFamily = MotionFamily {
    id: "ring",
    title: "A link that goes round a body",
    description: "a long link that goes round a box in a random position, its side to it",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let link = upright_box([1.0, 0.0, 0.0], [0.08, 0.8, 0.08]);
        let (sine, cosine) = libm::sincos(between(&mut source, 0.5, 5.0));
        let inner = turned_box(&mut source, [0.1 * cosine, 0.1 * sine, 0.0], [0.5, 0.4, 0.3]);
        let angle = between(&mut source, 5.2, TAU);
        MovingPair {
            bodies: [link, inner],
            courses: [Course::turn([0.0; 3], leaning_axis(&mut source), angle), Course::REST],
            aside: [-cosine, -sine, 0.0],
        }
    },
};
