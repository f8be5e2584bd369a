//! Z(O) rounded outward edge by edge during the walk around it, for coordinates in a range where nothing overflows. No
//! list of the edges is made, and one bound holds for all errors.
//!
//! A half-edge is off by one rounding of the result and one of a far smaller tail. The area of Z(O)
//! is Σ (vertex − O) × (next vertex − vertex) over half the boundary; no term is negative.

use super::widened::{Outward, sense, widened};
use crate::enclosing::bisectors::Frame;
use crate::enclosing::boundary_vertex::BoundaryVertex;
use crate::enclosing::half_turn::{EdgeVisitor, HalfTurn};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::outward::{above, at_least, at_most};
use crate::numeric::tolerance::{UNDERFLOW, UNIT};

/// For hulls of at most this many edges Z(O) is rounded in exact arithmetic, which costs little there.
const EXACT_EDGE_LIMIT: usize = 64;

/// If the relative error of the area may exceed this, the area is computed exactly.
const AREA_PRECISION: f64 = 5e-14;

/// Z(O) rounded outward, in O(h). `None` where exact arithmetic is needed, or costs little.
pub(super) fn round_outward(half_turn: &HalfTurn, frame: &Frame) -> Option<Outward> {
    let hull = half_turn.hull();
    if hull.edge_count() <= EXACT_EDGE_LIMIT || !half_turn.center_is_double() || !frame.sums_are_finite() {
        return None;
    }
    let mut gathered = Gathered {
        vertices: hull.vertices(),
        center: half_turn.center(),
        scale: frame.scaled([1.0; 2]),
        // Half the boundary has hardly more edges than the hull.
        generators: Vec::with_capacity(hull.vertex_count() + 3),
        extent: [0.0; 2],
        area: BlockedSum::default(),
    };
    half_turn.walk(&mut gathered);
    gathered.finish(frame)
}

/// The generators found so far on a walk, with the sums that bound their errors and the area.
struct Gathered<'a> {
    vertices: &'a [[f64; 2]],
    center: [f64; 2],
    /// The powers of two that scale the largest coordinate of each axis, or of both, to about 1.
    scale: [f64; 2],
    generators: Vec<[f64; 2]>,
    /// The sums of the magnitudes of the half-edges' coordinates, scaled.
    extent: [f64; 2],
    /// Half the area, scaled.
    area: BlockedSum,
}

impl Gathered<'_> {
    /// Adds a half-edge that starts at a vertex of the hull or its reflection.
    #[inline(always)]
    fn add(&mut self, start: [f64; 2], sense: f64, half_edge: [f64; 2]) {
        if half_edge != [0.0, 0.0] {
            self.generators.push(half_edge);
        }
        let [x, y] = [0, 1].map(|axis| half_edge[axis] * self.scale[axis]);
        let arm = [0, 1].map(|axis| (start[axis] - self.center[axis]) * self.scale[axis]);
        self.extent[0] += x.abs();
        self.extent[1] += y.abs();
        self.area.add(sense * (arm[0] * y - arm[1] * x));
    }

    /// The zonogon and the areas; `None` if the area is not precise enough.
    fn finish(self, frame: &Frame) -> Option<Outward> {
        let Self { center, generators, extent, .. } = self;
        let sums = 1.0 + (8.0 + 2.0 * self.vertices.len() as f64) * UNIT;
        let extent = extent.map(|v| v * sums);
        // Each half-edge is off by at most 2 UNIT times its length and the smallest double.
        let least = (self.area.terms + 2) as f64 * f64::from_bits(1);
        let slack = [0, 1].map(|axis| above(2.0 * UNIT * extent[axis] / self.scale[axis] + least));
        let [a, b] = frame.scaled(slack).map(|v| 2.0 * v);
        let [width, height] = [2.0 * extent[0] + 2.0 * (a + b), 2.0 * extent[1] + 2.0 * (a + b)];
        // No arm is longer than half the zonogon is wide or high, which bounds all products together by width · height,
        // and an edge off by ε moves its term by at most |arm| ε.
        let (half_area, rounding_error) = self.area.finish(width * height);
        let area = 2.0 * half_area;
        let error = 2.0 * rounding_error + 2.0 * (a * height + b * width);
        let excess = (2.0 * a * height + 2.0 * b * width + 4.0 * a * b) * (1.0 + 16.0 * UNIT) + UNDERFLOW;
        let in_input_units = |area: f64| frame.unscaled_area(Dyadic::from_f64(area));
        let area_below = in_input_units((area - error) * (1.0 - 4.0 * UNIT));
        let area_above = in_input_units((area + error + excess) * (1.0 + 4.0 * UNIT));
        (2.0 * error + excess <= AREA_PRECISION * area).then(|| Outward {
            zonogon: widened(center, generators, slack),
            area_below: at_most(&area_below),
            area_above: at_least(&area_above),
        })
    }
}

impl EdgeVisitor for Gathered<'_> {
    #[inline(always)]
    fn hull_edge(&mut self, from: BoundaryVertex, to: usize) {
        let (a, b) = (self.vertices[from.vertex.get()], self.vertices[to]);
        let half = sense(from) / 2.0;
        self.add(a, sense(from), [half * (b[0] - a[0]), half * (b[1] - a[1])]);
    }

    #[inline(always)]
    fn bridge(&mut self, from: BoundaryVertex, to: usize) {
        let (a, b) = (self.vertices[from.vertex.get()], self.vertices[to]);
        let half = sense(from) / 2.0;
        let half_edge = |axis: usize| {
            let (head, tail) = exact_sum(a[axis], b[axis]);
            let (sum, sum_tail) = exact_sum(2.0 * self.center[axis], -head);
            half * (sum + (sum_tail - tail))
        };
        self.add(a, sense(from), [half_edge(0), half_edge(1)]);
    }
}

/// A sum of terms, none negative, each the difference of two products, with a bound on its error for factors that are
/// two roundings off.
///
/// The terms of a block are summed up in doubles; the block's sum joins the total, whose rounding errors are summed up
/// beside it.
#[derive(Default)]
struct BlockedSum {
    total: f64,
    carried: f64,
    block: f64,
    terms: usize,
}

impl BlockedSum {
    const BLOCK: usize = 64;

    #[inline(always)]
    fn add(&mut self, term: f64) {
        self.block += term;
        self.terms += 1;
        if self.terms.is_multiple_of(Self::BLOCK) {
            self.join_block();
        }
    }

    #[inline(always)]
    fn join_block(&mut self) {
        let (total, tail) = exact_sum(self.total, self.block);
        self.total = total;
        self.carried += tail;
        self.block = 0.0;
    }

    /// The sum and a bound on its error, for products whose magnitudes add up to at most `magnitude`.
    fn finish(mut self, magnitude: f64) -> (f64, f64) {
        self.join_block();
        let sum = self.total + self.carried;
        let blocks = (self.terms / Self::BLOCK + 1) as f64;
        let additions = self.terms.min(Self::BLOCK) as f64 + 4.0 + blocks * blocks * UNIT;
        let error = 8.0 * magnitude * (1.0 + blocks * UNIT) + additions * sum.abs();
        (sum, UNIT * error + UNDERFLOW)
    }
}
