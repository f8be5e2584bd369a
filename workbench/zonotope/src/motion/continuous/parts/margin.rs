//! Bounds of how far a rotation at constant rate is from the stretch that encloses it, along a direction.
//!
//! Let the rotation about an axis be off by at most the angle δ.
//! - Along a direction u that does not turn with the body, a point at the distance d from the axis is off by at most
//!   δ d |u × a|, a the unit vector of the axis: it moves across the axis.
//! - A direction that turns with the body turns as the motion does, not as the stretch does. Seen from the body it
//!   stands still, and so does the body; points of the *other* body are off by δ times their distance from the axis.
//! - The normal of an edge e of this body and an edge f of the other one: along it the gap is made of determinants
//!   det(R e, f, y − P) over the other body's points y and det(R e, f, R x) over this body's own points P + R x, P a
//!   point of the axis. The first is off by δ |e| |f| times the distance of y from P, as R e is off by δ |e|. The
//!   second is the determinant of e, R⁻¹ f and x, off by δ |e| |f| |x|. The bodies are moved one after the other, each
//!   while the other one stands where the motion has it, so nothing of second order is left over.
//!
//! The base of an arc is on the axis, and the body's frame has the same axis, as a body is unturned at the time 0.
//!
//! The verifier lets a direction turn as the stretch does and bounds the points alone (`motion/gap` of its crate).

use super::super::SeparatingDirection;
use super::body::Body;
use crate::motion::arc::Arc;
use crate::motion::quaternion::{image, polar_rotation};
use crate::numeric::linear::{cross, dot, norm_of_any_size, sum_norm};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, MARGIN_AXIS_ROUNDING, MODERATE_SIZES};

/// Bounds of how far a body is from its place on a stretch, as a rotation at constant rate is off by an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::motion::continuous) struct Margin {
    /// The largest distance of a point of the body from its place.
    pub(in crate::motion::continuous) distance: f64,
    /// The unit vector of the axis, rounded: points are off across it.
    pub(in crate::motion::continuous) axis: [f64; 3],
    /// The largest distance of a point of the other body from its place, as this body sees it.
    pub(in crate::motion::continuous) of_other: f64,
    /// The error of a determinant with an edge of each body, for edges of length 1.
    pub(in crate::motion::continuous) of_normals: f64,
}

impl Margin {
    /// The margin of a body that is where the stretch puts it.
    pub(in crate::motion::continuous) const NONE: Self =
        Self { distance: 0.0, axis: [0.0; 3], of_other: 0.0, of_normals: 0.0 };

    /// The margins of a body that turns about an axis and is off by an angle: by the largest distance of its points
    /// from the axis, its stretch, and those of the other body.
    pub(in crate::motion::continuous) fn new(
        angle: f64,
        axis: [f64; 3],
        own_from_axis: f64,
        [(arc, body), other]: [(&Arc<f64>, Body<'_>); 2],
    ) -> Self {
        let [from_axis, from_base] = distances(arc, axis, other);
        let own = norm_of_any_size(&arc.arm_of(&body.center())) / arc.weight + body.magnitude();
        let off = |distance: f64| (angle * distance * FIVE_ROUNDINGS).next_up();
        Self {
            distance: (angle * own_from_axis).next_up(),
            axis,
            of_other: off(from_axis),
            of_normals: off(from_base + own),
        }
    }

    /// Whether it is a bound: angles and distances of any size may leave the range of doubles.
    pub(in crate::motion::continuous) fn is_finite(&self) -> bool {
        self.total().is_finite() && self.axis.iter().all(|c| c.is_finite())
    }

    /// The sum of all its bounds.
    pub(in crate::motion::continuous) fn total(&self) -> f64 {
        self.distance + self.of_other + self.of_normals
    }

    /// A bound of how far points at such a distance from their places are off along a direction that does not turn.
    fn across(&self, distance: f64, u: &[f64; 3]) -> f64 {
        // the sum of the magnitudes of the coordinates is at least the length
        distance * (sum_norm(&cross(u, &self.axis)) + MARGIN_AXIS_ROUNDING * sum_norm(u))
    }
}

/// Bounds of the distances of another body's points from a body's axis, and from the point of it that is the base, at
/// all times of a stretch. The other body's centre goes along the chord between its places at both ends, but for twice
/// its distance from the point about which it turns.
fn distances(arc: &Arc<f64>, axis: [f64; 3], (other, body): (&Arc<f64>, Body<'_>)) -> [f64; 2] {
    let center = other.arm_of(&body.center()).map(|c| c / other.weight);
    let arm = norm_of_any_size(&center);
    let size = arc.base_size / arc.weight + other.base_size / other.weight + arm;
    let spread = if other.is_translation { 0.0 } else { 2.0 * arm } + body.magnitude() + MARGIN_AXIS_ROUNDING * size;
    let at_the_ends = [0, 1].map(|end| {
        let turn = &other.turns[end];
        let (turned, square) = (image(&polar_rotation(turn, turn), &center), dot(turn, turn));
        [0, 1, 2].map(|k| turned[k] / square + other.base[end][k] / other.weight - arc.base[end][k] / arc.weight)
    });
    let largest = |norm: &dyn Fn(&[f64; 3]) -> f64| norm(&at_the_ends[0]).max(norm(&at_the_ends[1])) + spread;
    [largest(&|v| norm_of_any_size(&cross(v, &axis))), largest(&norm_of_any_size)]
}

/// The margin of a gap: a rotation at constant rate may leave the gap of two bodies along a direction, which turns as
/// the motion does, smaller than that of the stretch, but by no more than this. It is infinite where products with the
/// direction may vanish.
pub(in crate::motion::continuous) fn along(margins: &[Margin; 2], direction: &SeparatingDirection) -> f64 {
    let [first, second] = margins;
    if (first.distance, second.distance) == (0.0, 0.0) {
        return 0.0;
    }
    if !MODERATE_SIZES.contains(&direction.length_at_most()) {
        return f64::INFINITY;
    }
    let bound = match direction {
        SeparatingDirection::Space(u) => first.across(first.distance, u) + second.across(second.distance, u),
        SeparatingDirection::First(u) => first.across(first.of_other, u) + second.distance * sum_norm(u),
        SeparatingDirection::Second(u) => first.distance * sum_norm(u) + second.across(second.of_other, u),
        SeparatingDirection::Edges(_) => direction.length_at_most() * (first.of_normals + second.of_normals),
    };
    (bound * FIVE_ROUNDINGS * FIVE_ROUNDINGS).next_up()
}
