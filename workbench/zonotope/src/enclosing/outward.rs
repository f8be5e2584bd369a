//! Z(O) in doubles: generators rounded so that the zonogon still contains every point, and its area enclosed.
//!
//! Z(O) has half-edges γ_k; each is replaced by a generator g_k with |γ_k − g_k| ≤ ε_k in each coordinate, bounded exactly. Then
//! Σ [−1, 1] γ_k ⊂ Σ [−1, 1] g_k ⊕ box(Σ ε_k), so adding the box's two generators gives a zonogon that contains Z(O). It lies
//! itself in Z(O) ⊕ box(2 Σ ε_k), which bounds its area.

use super::bisectors::Frame;
use super::centered_zonogon::{BoundaryVertex, CenteredZonogon};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::zonotope::Zonotope;

/// A zonogon in doubles around Z(O), with areas.
#[derive(Debug)]
pub(crate) struct Outward {
    /// The zonogon that contains Z(O).
    pub(crate) zonogon: Zonotope<2>,
    /// A lower bound of the area of Z(O).
    pub(crate) area_below: f64,
    /// An upper bound of the area of the zonogon.
    pub(crate) area_above: f64,
}

/// A rounded number and a bound on its error.
#[derive(Clone, Copy, Default)]
struct Rounded {
    value: f64,
    error: f64,
}

/// Rounds Z(O) outward. O(h).
///
/// Its area is Σ (vertex − O) × (next vertex − vertex) over half the boundary; no term is negative.
pub(crate) fn round_outward(exact: &CenteredZonogon, frame: &Frame) -> Outward {
    let half = exact.half_boundary();
    let center = exact.center();
    let rounding = Rounding { exact, doubled_center: center.map(|v| 2.0 * v), safe: frame.sums_are_doubles() };
    let scaled_center = frame.scaled(center);
    let mut generators = Vec::with_capacity(half.len() + 1);
    let (mut slack, mut extent) = ([0.0; 2], [0.0; 2]);
    let mut area = TermSum::default();
    for pair in half.windows(2) {
        let edge = [0, 1].map(|axis| rounding.half_edge(pair[0], pair[1], axis));
        let value = edge.map(|coordinate| coordinate.value);
        let point = frame.scaled(exact.hull().vertex(pair[0].vertex));
        let arm =
            [0, 1].map(|i| if pair[0].reflected { scaled_center[i] - point[i] } else { point[i] - scaled_center[i] });
        let long = value.map(|v| 2.0 * frame.scaled_length(v));
        area.add(arm[0] * long[1], -arm[1] * long[0]);
        for axis in 0..2 {
            slack[axis] = above(slack[axis] + edge[axis].error);
            extent[axis] += long[axis].abs();
        }
        if value != [0.0, 0.0] {
            generators.push(value);
        }
    }
    if slack[0] > 0.0 {
        generators.push([slack[0], 0.0]);
    }
    if slack[1] > 0.0 {
        generators.push([0.0, slack[1]]);
    }
    let zonogon = Zonotope::new(center, generators).expect("half-edges of finite points are finite");
    let [a, b] = slack.map(|v| 2.0 * frame.scaled_length(v));
    let [width, height] = extent.map(|v| v * (1.0 + (8.0 + half.len() as f64) * UNIT) + 2.0 * (a + b));
    // An edge off by ε moves its term by at most |arm| ε, and no arm is longer than the whole zonogon is wide or high.
    let (area, rounding_error) = area.finish();
    let error = rounding_error + 2.0 * (a * height + b * width);
    let excess = (2.0 * a * height + 2.0 * b * width + 4.0 * a * b) * (1.0 + 16.0 * UNIT) + UNDERFLOW;
    if half.len() <= FEW || 2.0 * error + excess > PRECISE * area {
        let area_below = rounded_towards(&exact.exact_area(), f64::NEG_INFINITY);
        let area_above = rounded_towards(&zonogon.exact_area(), f64::INFINITY);
        return Outward { zonogon, area_below, area_above };
    }
    let in_input_units = |area: f64| Dyadic::from_f64(area).scaled(2 * frame.scale);
    let area_below = in_input_units((area - error) * (1.0 - 4.0 * UNIT));
    let area_above = in_input_units((area + error + excess) * (1.0 + 4.0 * UNIT));
    Outward {
        zonogon,
        area_below: rounded_towards(&area_below, f64::NEG_INFINITY),
        area_above: rounded_towards(&area_above, f64::INFINITY),
    }
}

/// Boundaries of at most this many vertices are measured exactly at once.
const FEW: usize = 64;

/// Areas known less precisely than this, relatively, are measured exactly.
const PRECISE: f64 = 1e-13;

/// The double nearest to a number, or the next one on the given side if it lies on the other.
pub(crate) fn rounded_towards(exact: &Dyadic, side: f64) -> f64 {
    let mut value = exact.to_f64().clamp(-f64::MAX, f64::MAX);
    while side > value && Dyadic::from_f64(value) < *exact {
        value = value.next_up();
        if value == f64::INFINITY {
            return value;
        }
    }
    while side < value && Dyadic::from_f64(value) > *exact {
        value = value.next_down();
    }
    value
}

/// A sum of differences of products, with a bound on its error when each factor is two roundings off.
///
/// Blocks of terms are summed plainly and joined to the total with their rounding errors carried along.
#[derive(Default)]
struct TermSum {
    total: f64,
    carried: f64,
    magnitude: f64,
    block: [f64; 2],
    terms: usize,
}

impl TermSum {
    const BLOCK: usize = 64;

    fn add(&mut self, left: f64, right: f64) {
        self.block[0] += left + right;
        self.block[1] += left.abs() + right.abs();
        self.terms += 1;
        if self.terms.is_multiple_of(Self::BLOCK) {
            self.settle();
        }
    }

    fn settle(&mut self) {
        let total = self.total + self.block[0];
        self.carried += tail_of_sum(self.total, self.block[0], total);
        self.total = total;
        self.magnitude += self.block[1];
        self.block = [0.0; 2];
    }

    /// The sum and a bound on its error.
    fn finish(mut self) -> (f64, f64) {
        self.settle();
        let sum = self.total + self.carried;
        let blocks = (self.terms / Self::BLOCK + 1) as f64;
        let additions = self.terms.min(Self::BLOCK) as f64 + 4.0 + blocks * blocks * UNIT;
        let error = 8.0 * self.magnitude * (1.0 + blocks * UNIT) + additions * sum.abs();
        (sum, UNIT * error + UNDERFLOW)
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
        let sum = a + b;
        let sum_tail = tail_of_sum(a, b, sum);
        let head = self.doubled_center[axis] - sum;
        let head_tail = tail_of_sum(self.doubled_center[axis], -sum, head);
        let tail = head_tail - sum_tail;
        let tail_error = if tail_of_sum(head_tail, -sum_tail, tail) == 0.0 { 0.0 } else { above(UNIT * tail.abs()) };
        let value = head + tail;
        let error = tail_of_sum(head, tail, value).abs();
        Rounded { value, error: if tail_error == 0.0 { error } else { above(error + tail_error) } }
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
    let value = a - b;
    Rounded { value, error: tail_of_sum(a, -b, value).abs() }
}

/// a + b − sum, exactly, where sum is a + b rounded.
fn tail_of_sum(a: f64, b: f64, sum: f64) -> f64 {
    let b_in_sum = sum - a;
    (a - (sum - b_in_sum)) + (b - b_in_sum)
}

/// At least half of a non-negative double, zero staying zero.
fn half_above(value: f64) -> f64 {
    if value < f64::MIN_POSITIVE { value } else { value / 2.0 }
}

/// A double above a non-negative one, zero staying zero.
fn above(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.next_up() }
}
