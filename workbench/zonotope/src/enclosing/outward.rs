//! Z(O) in doubles: generators rounded so that the zonogon still contains every point, and its area enclosed.
//!
//! Z(O) has half-edges γ_k; each is replaced by a generator g_k with |γ_k − g_k| ≤ ε_k in each coordinate, bounded exactly. Then
//! Σ [−1, 1] γ_k ⊂ Σ [−1, 1] g_k ⊕ box(Σ ε_k), so adding the box's two generators gives a zonogon that contains Z(O). It lies
//! itself in Z(O) ⊕ box(2 Σ ε_k), which bounds its area.

use super::bisectors::Frame;
use super::centered_zonogon::{BoundaryVertex, CenteredZonogon};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
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
/// Many edges in an ordinary range are rounded with one bound for all errors; where that, or doubles at all, are not
/// precise enough, each error is taken exactly and the areas are measured exactly.
pub(crate) fn round_outward(exact: &CenteredZonogon, frame: &Frame) -> Outward {
    let rounding = Rounding { exact, doubled_center: exact.center().map(|v| 2.0 * v), safe: frame.sums_are_doubles() };
    if rounding.safe && exact.half_boundary().len() > FEW {
        let (outward, is_precise) = gather(exact, frame, |from, to, axis| rounding.quick_half_edge(from, to, axis));
        if is_precise {
            return outward;
        }
    }
    let (outward, _) = gather(exact, frame, |from, to, axis| rounding.half_edge(from, to, axis));
    Outward {
        area_below: rounded_towards(&exact.exact_area(), f64::NEG_INFINITY),
        area_above: rounded_towards(&outward.zonogon.exact_area(), f64::INFINITY),
        zonogon: outward.zonogon,
    }
}

/// The zonogon of the rounded half-edges, with the areas in floating point and whether they are known precisely.
///
/// The area of Z(O) is Σ (vertex − O) × (next vertex − vertex) over half the boundary; no term is negative.
fn gather(
    exact: &CenteredZonogon,
    frame: &Frame,
    half_edge: impl Fn(BoundaryVertex, BoundaryVertex, usize) -> Rounded,
) -> (Outward, bool) {
    let half = exact.half_boundary();
    let scaled_center = frame.scaled(exact.center());
    let mut generators = Vec::with_capacity(half.len() + 1);
    let (mut slack, mut extent) = ([0.0; 2], [0.0; 2]);
    let mut area = TermSum::default();
    for pair in half.windows(2) {
        let edge = [half_edge(pair[0], pair[1], 0), half_edge(pair[0], pair[1], 1)];
        let value = [edge[0].value, edge[1].value];
        let point = frame.scaled(exact.hull().vertex(pair[0].vertex));
        let sense = sense(pair[0]);
        let arm = [sense * (point[0] - scaled_center[0]), sense * (point[1] - scaled_center[1])];
        let long = [2.0 * frame.scaled_length(value[0]), 2.0 * frame.scaled_length(value[1])];
        area.add(arm[0] * long[1], -arm[1] * long[0]);
        for axis in 0..2 {
            slack[axis] += edge[axis].error;
            extent[axis] += long[axis].abs();
        }
        if value != [0.0, 0.0] {
            generators.push(value);
        }
    }
    let sums = 1.0 + (8.0 + half.len() as f64) * UNIT;
    let slack = slack.map(|v| above(v * sums));
    if slack[0] > 0.0 {
        generators.push([slack[0], 0.0]);
    }
    if slack[1] > 0.0 {
        generators.push([0.0, slack[1]]);
    }
    let zonogon = Zonotope::new(exact.center(), generators).expect("half-edges of finite points are finite");
    let [a, b] = slack.map(|v| 2.0 * frame.scaled_length(v));
    let [width, height] = extent.map(|v| v * sums + 2.0 * (a + b));
    // An edge off by ε moves its term by at most |arm| ε, and no arm is longer than the whole zonogon is wide or high.
    let (area, rounding_error) = area.finish();
    let error = rounding_error + 2.0 * (a * height + b * width);
    let excess = (2.0 * a * height + 2.0 * b * width + 4.0 * a * b) * (1.0 + 16.0 * UNIT) + UNDERFLOW;
    let in_input_units = |area: f64| Dyadic::from_f64(area).scaled(2 * frame.scale);
    let area_below = in_input_units((area - error) * (1.0 - 4.0 * UNIT));
    let area_above = in_input_units((area + error + excess) * (1.0 + 4.0 * UNIT));
    let outward = Outward {
        zonogon,
        area_below: rounded_towards(&area_below, f64::NEG_INFINITY),
        area_above: rounded_towards(&area_above, f64::INFINITY),
    };
    (outward, 2.0 * error + excess <= PRECISE * area)
}

/// 1 for a vertex of the hull, −1 for a reflected one.
fn sense(vertex: BoundaryVertex) -> f64 {
    1.0 - 2.0 * f64::from(u8::from(vertex.reflected))
}

/// Boundaries of at most this many vertices are rounded and measured exactly at once.
const FEW: usize = 64;

/// Areas known less precisely than this, relatively, are measured exactly.
const PRECISE: f64 = 5e-14;

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
        let (total, tail) = exact_sum(self.total, self.block[0]);
        self.total = total;
        self.carried += tail;
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
    /// The half-edge, in a range where nothing overflows; off by one rounding of the result and one of a far smaller tail.
    #[inline(always)]
    fn quick_half_edge(&self, from: BoundaryVertex, to: BoundaryVertex, axis: usize) -> Rounded {
        let hull = self.exact.hull();
        let (a, b) = (sense(from) * hull.vertex(from.vertex)[axis], sense(to) * hull.vertex(to.vertex)[axis]);
        let centers = f64::from(u8::from(to.reflected)) - f64::from(u8::from(from.reflected));
        let (head, tail) = exact_sum(b, -a);
        let (sum, sum_tail) = exact_sum(centers * self.doubled_center[axis], head);
        let value = (sum + (sum_tail + tail)) / 2.0;
        Rounded { value, error: 2.0 * UNIT * value.abs() + f64::from_bits(1) }
    }

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

/// A double above a non-negative one, zero staying zero.
fn above(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.next_up() }
}
