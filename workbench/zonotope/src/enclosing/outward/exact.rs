//! Z(O) rounded outward with exact errors and exact areas.
//!
//! Where sums of coordinates leave the range of doubles, a half-edge may be as short as its rounding error. There the
//! error of each half-edge is carried on to the next one, so that errors do not add up. Let E_k be the sum of the first
//! k errors g − γ, and E_n the sum of all. The vertex of Z(O) after the first k edges differs by 2 E_k − E_n from Σ ±
//! g_i with the same signs, a point of the rounded zonogon. So that zonogon contains Z(O) if it is widened by max |2
//! E_k − E_n| along each axis.

use super::areas::{area_of_centered, area_of_ordered};
use super::widened::{Outward, widened};
use crate::enclosing::bisectors::Frame;
use crate::enclosing::centered_zonogon::{BoundaryVertex, CenteredZonogon};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::outward::{above, at_least, at_most, certain_at_least, certain_at_most};
use crate::numeric::tolerance::UNIT;

/// A rounded number and a bound on its error.
#[derive(Clone, Copy, Default)]
struct Rounded {
    value: f64,
    error: f64,
}

/// Z(O) rounded outward. O(h) exact operations.
pub(crate) fn round_outward(exact: &CenteredZonogon, frame: &Frame) -> Outward {
    let (mut generators, slack) =
        if frame.sums_are_doubles() { one_by_one(exact) } else { with_errors_carried_on(exact) };
    generators.retain(|generator| *generator != [0.0, 0.0]);
    let (area_below, area_above) = if frame.sums_are_doubles() {
        let above = area_of_ordered(&generators, slack).and_then(|area| certain_at_least(&area));
        (area_of_centered(exact).and_then(|area| certain_at_most(&area)), above)
    } else {
        (None, None)
    };
    let zonogon = widened(exact.center(), generators, slack);
    Outward {
        area_below: area_below.unwrap_or_else(|| at_most(&exact.exact_area())),
        area_above: area_above.unwrap_or_else(|| at_least(&zonogon.exact_area())),
        zonogon,
    }
}

/// Generators from half-edges that are rounded independently, and the sum of their errors along each axis, rounded up.
fn one_by_one(exact: &CenteredZonogon) -> (Vec<[f64; 2]>, [f64; 2]) {
    let rounding = Rounding { exact, doubled_center: exact.center().map(|v| 2.0 * v) };
    let half = exact.half_boundary();
    let mut slack = [0.0; 2];
    let half_edge = |pair: &[BoundaryVertex]| {
        [0, 1].map(|axis| {
            let Rounded { value, error } = rounding.half_edge(pair[0], pair[1], axis);
            slack[axis] += error;
            value
        })
    };
    let generators = half.windows(2).map(half_edge).collect();
    let sums = 1.0 + (8.0 + half.len() as f64) * UNIT;
    (generators, slack.map(|v| above(v * sums)))
}

/// Generators from half-edges that are rounded with the errors carried on, and the largest error of a vertex along each
/// axis, rounded up.
fn with_errors_carried_on(exact: &CenteredZonogon) -> (Vec<[f64; 2]>, [f64; 2]) {
    let half = exact.half_boundary();
    let mut generators = vec![[0.0; 2]; half.len() - 1];
    let slack = [0, 1].map(|axis| {
        let [mut off, mut least, mut most] = [(); 3].map(|()| Dyadic::zero());
        for (pair, generator) in half.windows(2).zip(&mut generators) {
            let [from, to] = [pair[0], pair[1]].map(|v| exact.exact_vertex(v)[axis].clone());
            let wanted = (to - from).scaled(-1) - off;
            let value = wanted.to_f64().clamp(-f64::MAX, f64::MAX);
            generator[axis] = value;
            off = Dyadic::from_f64(value) - wanted;
            least = least.min(off.clone());
            most = most.max(off.clone());
        }
        let farthest = [least, most].map(|extreme| (extreme.scaled(1) - off.clone()).abs());
        let [a, b] = farthest.map(|distance| at_least(&distance));
        a.max(b)
    });
    (generators, slack)
}

/// The half-edges of Z(O), rounded with a bound on their errors.
struct Rounding<'a, 'h> {
    exact: &'a CenteredZonogon<'h>,
    doubled_center: [f64; 2],
}

impl Rounding<'_, '_> {
    /// A coordinate of half the edge between two vertices of the boundary.
    fn half_edge(&self, from: BoundaryVertex, to: BoundaryVertex, axis: usize) -> Rounded {
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

    /// The coordinate 2 O − a − b of a bridge from vertex a to the reflection of vertex b.
    fn bridge(&self, a: f64, b: f64, axis: usize) -> Rounded {
        let (sum, sum_tail) = exact_sum(a, b);
        let (head, head_tail) = exact_sum(self.doubled_center[axis], -sum);
        let (tail, lost) = exact_sum(head_tail, -sum_tail);
        let (value, rounded) = exact_sum(head, tail);
        Rounded { value, error: if lost == 0.0 { rounded.abs() } else { above(rounded.abs() + lost.abs()) } }
    }
}

/// The difference a − b.
fn difference(a: f64, b: f64) -> Rounded {
    let (value, tail) = exact_sum(a, -b);
    Rounded { value, error: tail.abs() }
}

/// A bound above half of a non-negative double; zero for zero.
fn half_above(value: f64) -> f64 {
    if value < f64::MIN_POSITIVE { value } else { value / 2.0 }
}
