//! The rate at which a body turns on a stretch, and the distance of its points from the axis: bounds in doubles.
//!
//! q(s) = (1 − s) q0 + s q1 turns about one axis by twice the angle between the quaternions. The rate is
//! ω = 2 |q0| |q1| sin φ / |q|², φ the angle between q0 and q1, and its change is ω (|q|²)' / |q|², where (|q|²)' is
//! linear in s: greatest at an end.
//!
//! All bounds are made larger by [`RATE_ROUNDING`](crate::numeric::tolerance::RATE_ROUNDING), and sums over generators
//! by a rounding for each. Bodies are zonotopes here: corners are not read.

use super::body::Body;
use crate::motion::arc::Arc;
use crate::motion::quaternion::{composition, conjugate};
use crate::numeric::linear::{cross, dot, norm_of_any_size, sum_norm};
use crate::numeric::tolerance::{MODERATE_SIZES, RATE_ROUNDING, SINE_OF_QUATERNIONS, UNIT};

/// A body that turns about an axis and whose base goes along a segment, for s from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(in crate::motion::continuous) struct Rates {
    /// A unit vector of the axis in space; zero where nothing turns.
    pub(in crate::motion::continuous) axis: [f64; 3],
    /// The sine of the largest angle between that vector and the axis; 1 where nothing is known of the axis.
    axis_error: f64,
    /// The angle of the stretch.
    pub(in crate::motion::continuous) angle: f64,
    /// The largest rate of the angle.
    pub(in crate::motion::continuous) rate: f64,
    /// The largest change of that rate.
    pub(in crate::motion::continuous) change: f64,
    /// Σ |v⊥| over the generators, and |c⊥| of the centre from the base.
    pub(in crate::motion::continuous) from_axis: f64,
    /// The way of the base.
    pub(in crate::motion::continuous) travel: [f64; 3],
}

impl Rates {
    pub(in crate::motion::continuous) fn of(arc: &Arc<f64>, body: &Body<'_>) -> Self {
        let [from, to] = &arc.turns;
        let [x, y, z] = [0, 1, 2].map(|k| (arc.base[1][k] - arc.base[0][k]) / arc.weight);
        let still = Self {
            axis: [0.0; 3],
            axis_error: 0.0,
            angle: 0.0,
            rate: 0.0,
            change: 0.0,
            from_axis: 0.0,
            travel: [x, y, z],
        };
        if arc.is_translation {
            return still;
        }
        // the turn in space is q1 q0⁻¹, in the body's frame q0⁻¹ q1
        let [w, axis_x, axis_y, axis_z] = composition(to, &conjugate(from));
        let [_, own_x, own_y, own_z] = composition(&conjugate(from), to);
        let (axis, own) = ([axis_x, axis_y, axis_z], [own_x, own_y, own_z]);
        let squares = [from, to].map(|q| dot(q, q));
        if !squares.iter().all(|square| MODERATE_SIZES.contains(square)) {
            // quaternions of which products vanish: nothing is known of the rate
            let unknown = f64::INFINITY;
            return Self { angle: unknown, rate: unknown, change: unknown, ..still };
        }
        let sine = norm_of_any_size(&axis);
        let error = SINE_OF_QUATERNIONS * (squares[0] * squares[1]).sqrt();
        let axis_error = if sine > error { error / sine } else { 1.0 };
        let unit = |v: [f64; 3]| {
            let length = norm_of_any_size(&v);
            if length > 0.0 { v.map(|c| c / length) } else { v }
        };
        let step: [f64; 4] = std::array::from_fn(|k| to[k] - from[k]);
        let (at_begin, at_end) = (dot(from, &step), dot(to, &step));
        let (at_ends, chord) = (squares[0].min(squares[1]), dot(&step, &step));
        let least = if at_begin < 0.0 && at_end > 0.0 {
            // the squared distance of the chord from the origin, and a bound for one so short that its sine is unknown
            ((sine - error).max(0.0).powi(2) / chord).max(at_ends - chord / 4.0)
        } else {
            at_ends
        };
        let rate = 2.0 * (sine + error) / least * RATE_ROUNDING;
        let change = rate * 2.0 * at_begin.abs().max(at_end.abs()) / least * RATE_ROUNDING;
        let own = unit(own);
        let off_axis = |v: &[f64; 3]| norm_of_any_size(&cross(&own, v));
        let arm = arc.arm_of(&body.center()).map(|c| c / arc.weight);
        let from_axis = body.generators().iter().fold(off_axis(&arm), |sum, g| sum + off_axis(g));
        let size = body.magnitude() + sum_norm(&body.center()) + sum_norm(&arc.arm) / arc.weight;
        let of_sum = 2.0 * UNIT * body.generators().len() as f64;
        let from_axis = from_axis * (RATE_ROUNDING + of_sum) + (RATE_ROUNDING - 1.0 + axis_error) * size;
        let angle = 2.0 * libm::atan((sine + error) / w.max(0.0));
        Self { axis: unit(axis), axis_error, angle, rate, change, from_axis, travel: still.travel }
    }

    /// A bound of the speed of a point of the body along a unit direction, beside that of the base.
    pub(in crate::motion::continuous) fn speed_along(&self, u: &[f64; 3]) -> f64 {
        self.rate * self.from_axis * self.off_axis(u)
    }

    /// The largest second derivative of the place of a point along a unit direction, summed up over the generators.
    pub(in crate::motion::continuous) fn bend_along(&self, u: &[f64; 3]) -> f64 {
        (self.rate * self.rate + self.change) * self.from_axis * self.off_axis(u)
    }

    fn off_axis(&self, u: &[f64; 3]) -> f64 {
        norm_of_any_size(&cross(&self.axis, u)) + (RATE_ROUNDING - 1.0 + self.axis_error)
    }
}
