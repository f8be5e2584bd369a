//! The body and the rectangle of least area around the arcs of its vertices.
//!
//! # Statement
//! Input: a sweep, a body. Output: a zonotope that contains every placement exactly.
//!
//! # Source
//! Section 6, Figure 3: "If we can enclose these arcs in a tight-fitting parallelogram". The paper takes a square
//! around a circle; a rectangle around the arcs themselves is smaller and lies beside their common origin.
//!
//! # Method
//! 1. Around the arcs R(φ) x − x of all vertices x of the shadow, points are laid whose hull holds them: every
//!    sixteenth of half a turn a point and a corner of the tangents, 0.5 % beyond the arc.
//! 2. A rectangle of least area has a side along an edge of their hull; four points go around it with the edge.
//!
//! # Complexity
//! O(n log n) for n generators.
//!
//! # Shapes
//! Input and output: centres and generators of space, generators in half-lengths; zero and parallel ones, none, and
//! bodies that the axis goes through are allowed.
//!
//! # Numerics
//! The rectangle is found in doubles, of the points over a power of two of their own: a body may be as far along its
//! axis as doubles go, and its arcs so small that their squares are zero. A box of some 2^-45 of the distance of the
//! farthest vertex from the axis point holds what rounding loses.
//!
//! # Errors
//! [`SweepError::OutOfRange`] ⇔ a coordinate of the volume is above the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), which holds exact placements against all facets; the check of `sweep` answers
//! in the crate `verifier`.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::motion::space_time::{Sweep, by_least_rectangle::volume};
//!
//! // a point at distance 1 goes along a quarter of a circle, from (1, 0) to (0, 1)
//! let point = Zonotope::new([1.0, 0.0, 0.0], vec![])?;
//! let around = volume(&Sweep::new([0.0; 3], [0.0, 0.0, 1.0], 1.5707963267948966, [0.0; 3])?, &point)?;
//! assert!(around.contains([0.7071067811865476, 0.7071067811865476, 0.0])? && around.contains([0.0, 1.0, 0.0])?);
//! assert!(around.total_length() < 0.88); // the square of Theorem 6.1 has 2.83
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::parts::arcs::ArcPoints;
use super::parts::plane::Plane;
use super::parts::scaled_body::ScaledBody;
use super::parts::shadow::Shadow;
use super::parts::volume::Volume;
use crate::hull::convex_hull;
use crate::motion::sweep::{Sweep, SweepError};
use crate::numeric::bounded::Bounded;
use crate::numeric::linear::{dot, norm_of_any_size};
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::zonotope::Zonotope;

/// The volume with the least rectangle around the arcs.
///
/// # Errors
/// [`SweepError::OutOfRange`] if it leaves the range of doubles.
pub fn volume(sweep: &Sweep, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
    if sweep.angle == 0.0 {
        return Volume::of_translation(body, sweep);
    }
    let (plane, scaled) = (Plane::orthogonal_to(sweep.axis), ScaledBody::of(body, sweep.axis_point));
    let arcs = ArcPoints::of(&Shadow::of(&plane, &scaled, &mut ()), sweep.angle);
    let mut volume = Volume::of_body(body, sweep, scaled.exponent);
    let hull = convex_hull(&arcs.points, &mut ()).map_err(|_| SweepError::OutOfRange)?;
    let exponent = binary_exponent(largest_magnitude(hull.vertices().as_flattened())).map_or(0, i64::from);
    let corners: Vec<[f64; 2]> =
        hull.vertices().iter().map(|corner| corner.map(|c| scale_by_power_of_two(c, -exponent))).collect();
    let in_space = |v: [f64; 2]| {
        let [x, y] = v.map(|c| scale_by_power_of_two(c, exponent));
        plane.vector(&[0.0, x, y].map(Bounded::exact))
    };
    let rectangle = least_rectangle(&corners);
    volume.move_center(&in_space(rectangle.center));
    rectangle.sides.iter().for_each(|side| volume.add(&in_space(*side)));
    // the sides and the centre were rounded, by less than the points
    volume.add_ball(2.0 * arcs.off);
    volume.finished()
}

/// A rectangle by its centre and half of its sides.
struct Rectangle {
    center: [f64; 2],
    sides: [[f64; 2]; 2],
    area: f64,
}

/// The rectangle of least area around the corners of a convex polygon, counter-clockwise, in floating point.
///
/// Calipers go around the polygon for the areas. Where the polygon is as thin as rounding they may stop too early; so
/// the rectangle that is least by them is taken around all corners.
fn least_rectangle(corners: &[[f64; 2]]) -> Rectangle {
    let count = corners.len();
    let edge = |i: usize| {
        let (from, to) = (corners[i % count], corners[(i + 1) % count]);
        unit([to[0] - from[0], to[1] - from[1]])
    };
    // the corners that are farthest along the edge, across it and against it
    let mut farthest = [0, 0, 0];
    let mut least = around(corners, [1.0, 0.0]);
    for i in 0..count {
        let along = edge(i);
        let across = [-along[1], along[0]];
        let directions = [along, across, along.map(|c| -c)];
        let mut start = i;
        for (corner, direction) in farthest.iter_mut().zip(&directions) {
            *corner = (*corner).max(start);
            let height = |i: usize| dot(&corners[i % count], direction);
            while *corner < i + count && height(*corner + 1) > height(*corner) {
                *corner += 1;
            }
            start = *corner;
        }
        let reach = |k: usize| dot(&corners[farthest[k] % count], &directions[k]);
        let area = (reach(0) + reach(2)) * (reach(1) - dot(&corners[i], &across)) / 4.0;
        if area < least.area {
            let rectangle = around(corners, along);
            if rectangle.area < least.area {
                least = rectangle;
            }
        }
    }
    least
}

/// The direction of an edge of any length, as a unit vector; that of the first axis if it has none. The first division
/// is by a length that may have few bits.
fn unit(edge: [f64; 2]) -> [f64; 2] {
    let over_its_length = |v: [f64; 2]| v.map(|c| c / norm_of_any_size(&[v[0], v[1], 0.0]));
    if edge == [0.0; 2] { [1.0, 0.0] } else { over_its_length(over_its_length(edge)) }
}

/// The rectangle around all corners with sides along a unit vector and across it.
fn around(corners: &[[f64; 2]], along: [f64; 2]) -> Rectangle {
    let across = [-along[1], along[0]];
    let [first, second] = [along, across].map(|direction| {
        let heights = corners.iter().map(|corner| dot(corner, &direction));
        let extremes = |[low, high]: [f64; 2], height: f64| [low.min(height), high.max(height)];
        let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], extremes);
        [(low + high) / 2.0, (high - low) / 2.0]
    });
    Rectangle {
        center: [0, 1].map(|k| first[0] * along[k] + second[0] * across[k]),
        sides: [along.map(|c| first[1] * c), across.map(|c| second[1] * c)],
        area: first[1] * second[1],
    }
}
