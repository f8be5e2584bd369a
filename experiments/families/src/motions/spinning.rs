//! Bodies that spin where they are.

use std::f64::consts::PI;

use super::family::{BodyRow, Course, MotionFamily, MovingPair};
use super::shapes::{between, prism, upright_box};
use crate::bodies::unit_vector;
use crate::source::RandomSource;

/// Generators of each of two random bodies.
const GENERATORS: usize = 6;

/// Sides of half the prism that spins; its height is a generator, too.
const SIDES: usize = 9;

/// Two bodies about axes of their own.
pub(super) const BOTH_SPINNING: MotionFamily = MotionFamily {
    id: "both_spinning",
    title: "Two spinning bodies",
    description: "two random bodies of six generators that spin about axes of their own",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let (first, second) = (random_body(&mut source, [0.0; 3]), random_body(&mut source, [2.0, 0.0, 0.0]));
        let courses = [first.center, second.center].map(|center| {
            let angle = between(&mut source, 2.0, 4.0);
            Course::turn(center, unit_vector(&mut source), angle)
        });
        MovingPair { bodies: [first, second], courses, aside: [1.0, 0.0, 0.0] }
    },
};

/// A prism beside a plate.
pub(super) const SPINNING_PRISM: MotionFamily = MotionFamily {
    id: "spinning_prism",
    title: "A prism that spins beside a plate",
    description: "a prism of ten generators that spins half a turn beside a plate, always as near but for its corners",
    generate: |seed| {
        let mut source = RandomSource::new(seed);
        let half_height = between(&mut source, 0.3, 0.8);
        let plate = upright_box([1.6, 0.0, between(&mut source, -0.2, 0.2)], [0.1, 0.8, 0.8]);
        MovingPair {
            bodies: [prism([0.0; 3], SIDES, 1.0, half_height), plate],
            courses: [Course::turn([0.0; 3], [0.0, 0.0, 1.0], between(&mut source, 3.0, PI)), Course::REST],
            aside: [1.0, 0.0, 0.0],
        }
    },
};

fn random_body(source: &mut RandomSource, center: [f64; 3]) -> BodyRow {
    let generator = |_| {
        let length = between(source, 0.1, 0.25);
        unit_vector(source).map(|c| length * c)
    };
    BodyRow { center, generators: (0..GENERATORS).map(generator).collect() }
}
