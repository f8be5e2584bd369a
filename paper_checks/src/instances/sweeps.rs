//! Bodies that turn about an axis and translate, random ones and those that random draws miss.

use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::motion::space_time::Sweep;

use crate::definitions::ratio::{exactly, integer};
use crate::definitions::space::{Body, Vector};
use crate::definitions::turning::Turning;
use crate::instances::bodies::{BodyInstance, bodies, doubles, random_vector};

/// A body with more generators than this has too many facets for exact checks of many placements.
const MOST_GENERATORS: usize = 6;

/// A relative excess of the angle in doubles over the exact one, above the rounding of its computation.
const ANGLE_EXCESS: f64 = 1e-14;

/// A body and its motion, exactly and as the library takes it.
pub(crate) struct SweepInstance {
    /// The body.
    pub(crate) instance: BodyInstance,
    /// The motion in rationals.
    pub(crate) turning: Turning,
    /// The motion in doubles: the same but for the angle, which is larger by rounding alone.
    pub(crate) sweep: Sweep,
}

/// Random and degenerate bodies under rotations by less than half a turn, about axes near and far, and translations,
/// one in five without a rotation and one in five without a translation.
pub(crate) fn sweeps(random: &mut Pcg64Mcg, count: usize) -> Vec<SweepInstance> {
    let drawn = bodies(random, count).into_iter().filter(|instance| instance.generators.len() <= MOST_GENERATORS);
    drawn.enumerate().filter_map(|(index, instance)| sweep(random, index, instance)).collect()
}

fn sweep(random: &mut Pcg64Mcg, index: usize, instance: BodyInstance) -> Option<SweepInstance> {
    let axis = std::iter::repeat_with(|| random_vector(random, 3)).find(|axis| *axis != [0; 3])?;
    let axis_point = random_vector(random, [0, 2, 50][index % 3]);
    let translation = if index % 5 == 1 { [0; 3] } else { random_vector(random, 9) };
    let half_tangent = if index % 5 == 2 { 0.0 } else { f64::from(random.random_range(1..=8)) / 8.0 };
    let length = axis.iter().map(|c| (c * c) as f64).sum::<f64>().sqrt();
    let angle = 2.0 * libm::atan(half_tangent * length) * (1.0 + ANGLE_EXCESS);
    let turning = Turning {
        axis_point: Vector::at(axis_point),
        axis: Vector::at(axis),
        half_tangent: exactly(half_tangent),
        translation: Vector::at(translation),
    };
    let sweep = Sweep::new(doubles(axis_point), doubles(axis), angle, doubles(translation)).ok()?;
    Some(SweepInstance { instance, turning, sweep })
}

/// A zonotope of the library in exact rationals.
pub(crate) fn exact_body(body: &zonotope::zonotope::Zonotope<3>) -> Body {
    Body {
        center: Vector::exactly(body.center()),
        generators: body.generators().iter().map(|g| Vector::exactly(*g)).collect(),
    }
}

/// The points of a body with every choice of signs: its vertices are among them.
pub(crate) fn sign_points(body: &Body) -> Vec<Vector> {
    body.generators.iter().fold(vec![body.center.clone()], |points, generator| {
        points.iter().flat_map(|point| [-1, 1].map(|sign| point.plus(&integer(sign), generator))).collect()
    })
}
