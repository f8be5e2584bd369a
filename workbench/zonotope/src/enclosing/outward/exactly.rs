//! Z(O) rounded outward with the exact error of each half-edge, and exact areas.

use super::{Outward, above, rounded_towards, widened};
use crate::enclosing::bisectors::Frame;
use crate::enclosing::centered_zonogon::{BoundaryVertex, CenteredZonogon};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::UNIT;

/// A rounded number and a bound on its error.
#[derive(Clone, Copy, Default)]
struct Rounded {
    value: f64,
    error: f64,
}

/// Rounds Z(O) outward. O(h) exact operations.
pub(crate) fn round_outward(exact: &CenteredZonogon, frame: &Frame) -> Outward {
    let rounding = Rounding { exact, doubled_center: exact.center().map(|v| 2.0 * v), safe: frame.sums_are_doubles() };
    let half = exact.half_boundary();
    let mut generators = Vec::with_capacity(half.len() + 2);
    let mut slack = [0.0; 2];
    for pair in half.windows(2) {
        let edge = [0, 1].map(|axis| rounding.half_edge(pair[0], pair[1], axis));
        for axis in 0..2 {
            slack[axis] += edge[axis].error;
        }
        if edge.iter().any(|coordinate| coordinate.value != 0.0) {
            generators.push(edge.map(|coordinate| coordinate.value));
        }
    }
    let sums = 1.0 + (8.0 + half.len() as f64) * UNIT;
    let zonogon = widened(exact.center(), generators, slack.map(|v| above(v * sums)));
    Outward {
        area_below: rounded_towards(&exact.exact_area(), f64::NEG_INFINITY),
        area_above: rounded_towards(&zonogon.exact_area(), f64::INFINITY),
        zonogon,
    }
}

struct Rounding<'a, 'h> {
    exact: &'a CenteredZonogon<'h>,
    doubled_center: [f64; 2],
    /// Whether sums of three coordinates stay in the range of doubles.
    safe: bool,
}

impl Rounding<'_, '_> {
    fn half_edge(&self, from: BoundaryVertex, to: BoundaryVertex, axis: usize) -> Rounded {
        if !self.safe {
            return self.exact_half_edge(from, to, axis);
        }
        let hull = self.exact.hull();
        let (a, b) = (hull.vertex(from.vertex)[axis], hull.vertex(to.vertex)[axis]);
        let edge = match (from.reflected, to.reflected) {
            (false, false) => difference(b, a),
            (true, true) => difference(a, b),
            (false, true) => self.bridge(a, b, axis),
            (true, false) => {
                let bridge = self.bridge(a, b, axis);
                Rounded { value: -bridge.value, ..bridge }
            }
        };
        let half = edge.value / 2.0;
        let lost = if 2.0 * half == edge.value { 0.0 } else { f64::from_bits(1) };
        Rounded { value: half, error: half_above(edge.error) + lost }
    }

    /// 2 O − a − b.
    fn bridge(&self, a: f64, b: f64, axis: usize) -> Rounded {
        let (sum, sum_tail) = exact_sum(a, b);
        let (head, head_tail) = exact_sum(self.doubled_center[axis], -sum);
        let (tail, lost) = exact_sum(head_tail, -sum_tail);
        let (value, rounded) = exact_sum(head, tail);
        Rounded { value, error: if lost == 0.0 { rounded.abs() } else { above(rounded.abs() + lost.abs()) } }
    }

    fn exact_half_edge(&self, from: BoundaryVertex, to: BoundaryVertex, axis: usize) -> Rounded {
        let [from, to] = [from, to].map(|v| self.exact.exact_vertex(v)[axis].clone());
        let exact = (to - from).scaled(-1);
        let value = exact.to_f64().clamp(-f64::MAX, f64::MAX);
        let error = (exact - Dyadic::from_f64(value)).abs();
        Rounded { value, error: rounded_towards(&error, f64::INFINITY) }
    }
}

fn difference(a: f64, b: f64) -> Rounded {
    let (value, tail) = exact_sum(a, -b);
    Rounded { value, error: tail.abs() }
}

/// At least half of a non-negative double, zero staying zero.
fn half_above(value: f64) -> f64 {
    if value < f64::MIN_POSITIVE { value } else { value / 2.0 }
}
