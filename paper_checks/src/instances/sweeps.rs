//! Bodies that turn about an axis and translate, random ones and those that random draws miss.

use dashu_ratio::RBig;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use zonotope::motion::space_time::{Sweep, by_farthest_vertex};
use zonotope::tally::OperationCounts;

use crate::definitions::ratio::{exactly, integer};
use crate::definitions::space::{Body, Vector};
use crate::definitions::turning::Turning;
use crate::growth;
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

/// A half-side of the library's square may exceed the exact radius by this part of it.
pub(crate) const RADIUS_EXCESS: f64 = 1e-12;

/// The sides of the square that the library adds to a body: the added generators that are as long as the radius, but
/// for rounding upwards. There are two, where the square of the radius is right and not zero.
pub(crate) fn square_sides(
    volume: &zonotope::zonotope::Zonotope<3>,
    body: &zonotope::zonotope::Zonotope<3>,
    squared_radius: &RBig,
) -> Vec<Vector> {
    let most = squared_radius * (integer(1) + exactly(RADIUS_EXCESS));
    let added = volume.generators()[body.generators().len()..].iter().map(|side| Vector::exactly(*side));
    added.filter(|side| (squared_radius..=&most).contains(&&side.dot(side))).collect()
}

/// Operations of Theorem 6.1's volume for random bodies that turn about an axis, with the numbers of generators.
pub(crate) fn volume_operations(random: &mut Pcg64Mcg) -> Result<Vec<(f64, f64)>, String> {
    let mut samples = Vec::new();
    for exponent in 5..=12 {
        for _ in 0..2 {
            let n = 1 << exponent;
            let generators = (0..n).map(|_| std::array::from_fn(|_| random.random_range(-1.0..=1.0))).collect();
            let body = zonotope::zonotope::Zonotope::new([1.0, 2.0, 3.0], generators);
            let sweep = Sweep::new([0.0; 3], [1.0, 2.0, 2.0], 1.0, [4.0, 0.0, 0.0]);
            let (body, sweep) = (body.map_err(|e| e.to_string())?, sweep.map_err(|e| e.to_string())?);
            let mut counts = OperationCounts::default();
            by_farthest_vertex::volume(&sweep, &body, &mut counts).map_err(|e| e.to_string())?;
            samples.push(growth::sample(n, &counts));
        }
    }
    Ok(samples)
}
