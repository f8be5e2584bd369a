//! Bodies that fly past each other.

use super::family::{BodyRow, Course, MotionFamily, MovingPair};
use super::shapes::{between, turned_box, upright_box};
use crate::bodies::unit_vector;
use crate::source::RandomSource;

/// Two thin bars.
pub(super) const THIN_BARS: MotionFamily = MotionFamily {
    id: "thin_bars",
    title: "Thin bars",
    description: "a thin bar that passes another one while it turns about its middle",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let start = [between(&mut source, -1.2, -0.8), between(&mut source, -0.3, 0.3), 0.0];
        let axis = [0.05 * source.signed_unit(), 0.05 * source.signed_unit(), 1.0];
        let translation = [2.0, between(&mut source, -0.5, 0.5), 0.0];
        let other = turned_bar(&mut source);
        MovingPair {
            bodies: [upright_box(start, [1.5, 0.01, 0.01]), other],
            courses: [
                Course { axis_point: start, axis, angle: between(&mut source, 1.0, 2.5), translation },
                Course::REST,
            ],
            aside: [0.0, 0.0, -1.0],
        }
    },
};

/// Everything at random.
pub(super) const FAST_BOXES: MotionFamily = MotionFamily {
    id: "fast_boxes",
    title: "Fast boxes",
    description: "random boxes that turn up to twice about random axes while they fly past each other",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let mut halves = || [0; 3].map(|_| between(&mut source, 0.05, 0.6));
        let halves = [halves(), halves()];
        let apart = unit_vector(&mut source).map(|c| 2.5 * c);
        let bodies = [turned_box(&mut source, [0.0; 3], halves[0]), turned_box(&mut source, apart, halves[1])];
        let course = |source: &mut RandomSource, center: [f64; 3]| {
            let joint = unit_vector(source);
            Course {
                axis_point: [0, 1, 2].map(|k| center[k] + joint[k]),
                axis: unit_vector(source),
                angle: between(source, -12.0, 12.0),
                translation: unit_vector(source).map(|c| 4.0 * c),
            }
        };
        let courses = [course(&mut source, [0.0; 3]), course(&mut source, apart)];
        MovingPair { bodies, courses, aside: apart.map(|c| c / 2.5) }
    },
};

/// A bar through the origin that leans a little out of the plane z = 0.
fn turned_bar(source: &mut RandomSource) -> BodyRow {
    let (sine, cosine) = libm::sincos(between(source, 1.1, 2.0));
    let lean = 0.1 * source.signed_unit();
    let along = [1.5 * cosine, 1.5 * sine, 1.5 * lean];
    let across = [-0.01 * sine, 0.01 * cosine, 0.0];
    BodyRow { center: [0.0; 3], generators: vec![along, across, [0.0, 0.0, 0.01]] }
}
