//! Motions that random draws miss: bodies that graze, whole turns, long thin bodies, axes through a body and far away.

use std::f64::consts::TAU;

use super::family::{BodyRow, Course, MotionFamily, MovingPair};
use super::shapes::upright_box;
use crate::source::RandomSource;

/// Shapes: a box, a long thin bar, a plate, a segment and a point, by their half sides.
const HALVES: [[f64; 3]; 5] = [[0.5, 0.25, 0.25], [2.0, 0.01, 0.01], [1.0, 1.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 0.0]];

/// Points of the axis: in the middle of the first body, at its end, on its surface, and far away.
const AXIS_POINTS: [[f64; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.25, 0.0], [100.0, 0.0, 0.0]];

const AXES: [[f64; 3]; 4] = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 0.0]];

/// Turns: half a one, a whole one, several, back, a quarter and none.
const TURNS: [f64; 6] = [0.5, 1.0, 3.0, -5.5, 0.25, 0.0];

const TRANSLATIONS: [[f64; 3]; 3] = [[0.0; 3], [0.0, 0.0, 2.0], [-3.0, 0.0, 0.0]];

/// Distances of the second body, at which faces touch, and by how much it is off them.
const AWAY: [f64; 5] = [0.5, 0.75, 1.0, 1.5, 2.0];
const OFF: [f64; 5] = [0.0, 1e-9, -1e-9, 1e-12, -1e-6];

const SIDES: [[f64; 3]; 4] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.8, 0.0]];

/// Everything from short lists.
pub(super) const CRAFTED: MotionFamily = MotionFamily {
    id: "crafted_motions",
    title: "Crafted motions",
    description: "boxes, thin bars, plates, segments and points that turn by whole and half turns about axes through \
                  them and far away, past bodies that they touch or graze",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let mut index = |count: usize| ((source.unit() * count as f64) as usize).min(count - 1);
        let bodies = [HALVES[index(5)], HALVES[index(5)]];
        let course = Course {
            axis_point: AXIS_POINTS[index(4)],
            axis: AXES[index(4)],
            angle: TURNS[index(6)] * TAU,
            translation: TRANSLATIONS[index(3)],
        };
        let (away, side) = (AWAY[index(5)] + OFF[index(5)], SIDES[index(4)]);
        MovingPair {
            bodies: [body([0.0; 3], bodies[0]), body(side.map(|c| away * c), bodies[1])],
            courses: [course, Course::REST],
            aside: side,
        }
    },
};

/// A box without the sides that have no length.
fn body(center: [f64; 3], halves: [f64; 3]) -> BodyRow {
    let mut row = upright_box(center, halves);
    row.generators.retain(|g| *g != [0.0; 3]);
    row
}
