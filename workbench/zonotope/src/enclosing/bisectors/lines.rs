//! The lines ℓ_t as the kernel reads them: rows of doubles made block by block, and exact lines where decisions need
//! them.

use std::cmp::Ordering;

use super::corners::Corners;
use super::frame::Frame;
use super::pairs::PairLine;
use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::lad::kernel_input::{ExactLine, ExactLines, LineError, MadeLines};
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::{BoundedDoubleDouble, DoubleDouble};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, UNIT};

/// The lines ℓ_t in the frame of the kernel, made from the points of the hull when they are read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lines<'h> {
    pub(super) hull: &'h ConvexHull,
    pub(super) farthest: &'h [FarthestVertex],
    pub(super) frame: Frame,
}

impl Lines<'_> {
    /// The row of the edge between two scaled vertices, and the magnitude of d with row · (x, y, 1) = edge × (x − d),
    /// the smaller one of the two that its ends give.
    #[inline(always)]
    fn between(&self, from: [f64; 2], to: [f64; 2], far: FarthestVertex) -> ([f64; 3], f64) {
        let far = self.frame.scaled(self.hull.vertex(far.vertex()));
        let edge = [to[0] - from[0], to[1] - from[1]];
        let [rx, ry] = self.frame.reference;
        // The line runs through the midpoints of the farthest vertex and both ends. Opposite an edge that is nearly
        // parallel to it, only one of them is near the centre of the hull.
        let d = [from, to].map(|[x, y]| [sum_from_reference(far[0], x, rx), sum_from_reference(far[1], y, ry)]);
        let [own, other] = d.map(|[x, y]| if x.abs() > y.abs() { x.abs() } else { y.abs() });
        let (d, spread) = if other < own { (d[1], other) } else { (d[0], own) };
        ([-edge[1], edge[0], edge[1] * d[0] - edge[0] * d[1]], spread)
    }

    /// The error of a row whose d has magnitude `spread`: each coordinate of d is within 3 UNIT of its value, each edge
    /// coordinate within UNIT, and the offset takes two products and a difference.
    fn error(spread: f64) -> LineError {
        LineError { offset_relative: 0.0, offset_per_normal: 8.0 * UNIT * spread }
    }

    /// A line by pairs of doubles; `None` where the frame rounds its points.
    fn by_pairs(&self, t: usize) -> Option<PairLine> {
        Some(PairLine::new(self.scaled_exactly(t)?, self.frame.reference))
    }

    /// The two ends of an edge and its farthest vertex in the frame, if none of them was rounded on the way there.
    pub(super) fn scaled_exactly(&self, t: usize) -> Option<[[f64; 2]; 3]> {
        let next = if t + 1 < self.farthest.len() { t + 1 } else { 0 };
        self.scaled_points([t, next, self.farthest[t].vertex().get()])
    }

    /// Vertices in the frame, if none of them was rounded on the way there.
    pub(super) fn scaled_points<const N: usize>(&self, vertices: [usize; N]) -> Option<[[f64; 2]; N]> {
        let points = vertices.map(|vertex| self.hull.vertices()[vertex]);
        points.iter().all(|&point| self.frame.scales_exactly(point)).then(|| points.map(|p| self.frame.scaled(p)))
    }

    /// The vertices whose midpoint is on two lines, if both lines run through the midpoint of the same two vertices.
    pub(super) fn shared_midpoint(&self, lines: [usize; 2]) -> Option<[usize; 2]> {
        let [first, second] = lines.map(|t| {
            let far = self.farthest[t].vertex().get();
            let next = if t + 1 < self.farthest.len() { t + 1 } else { 0 };
            [t, next].map(|end| [end.min(far), end.max(far)])
        });
        first.into_iter().find(|ends| second.contains(ends))
    }

    /// The kernel point of the midpoint of two vertices, without an error; `None` where it takes more than two doubles.
    fn midpoint(&self, ends: [usize; 2]) -> Option<[BoundedDoubleDouble; 2]> {
        let [a, b] = self.scaled_points(ends)?;
        let [x, y] = [0, 1].map(|axis| {
            let (sum, tail) = exact_sum(a[axis], b[axis]);
            let (head, rest) = exact_sum(sum, -self.frame.reference[axis]);
            let (tail, lost) = exact_sum(rest, tail);
            (lost == 0.0).then(|| BoundedDoubleDouble::of_parts(head, tail, 0.0))
        });
        Some([x?, y?])
    }

    /// The two vertices of an edge of the hull.
    fn ends(&self, t: usize) -> [[f64; 2]; 2] {
        let vertices = self.hull.vertices();
        [vertices[t], vertices[if t + 1 < vertices.len() { t + 1 } else { 0 }]]
    }
}

impl MadeLines for Lines<'_> {
    fn len(&self) -> usize {
        self.farthest.len()
    }

    fn row(&self, t: usize) -> ([f64; 3], LineError) {
        let [from, to] = self.ends(t).map(|end| self.frame.scaled(end));
        let (row, spread) = self.between(from, to, self.farthest[t]);
        (row, Self::error(spread))
    }

    fn make(&self, start: usize, [normal_x, normal_y, offset]: [&mut [f64]; 3]) -> LineError {
        let mut from = self.frame.scaled(self.hull.vertices()[start]);
        let mut spread = 0.0;
        let after = self.hull.vertices()[start + 1..].iter().chain(&self.hull.vertices()[..1]);
        let normals = normal_x.iter_mut().zip(normal_y);
        for (((x, y), b), (far, &to)) in normals.zip(offset).zip(self.farthest[start..].iter().zip(after)) {
            let to = self.frame.scaled(to);
            let (row, own_spread) = self.between(from, to, *far);
            [*x, *y, *b] = row;
            spread = if own_spread > spread { own_spread } else { spread };
            from = to;
        }
        Self::error(spread)
    }
}

impl ExactLines for Lines<'_> {
    fn line(&self, t: usize) -> ExactLine {
        let [from, to] = self.ends(t).map(|end| self.frame.exact(end));
        let far = self.frame.exact(self.hull.vertex(self.farthest[t].vertex()));
        let reference = self.frame.reference.map(Dyadic::from_f64);
        let d = [0, 1].map(|i| &(&far[i] + &from[i]) - &reference[i]);
        let edge = [0, 1].map(|i| &to[i] - &from[i]);
        let offset = &edge[1] * &d[0] - &edge[0] * &d[1];
        let [x, y] = edge;
        ExactLine { normal: [-y, x], offset }
    }

    fn normals_sum_to_zero(&self) -> bool {
        true
    }

    /// The mean of the points P_s + P_t. Where no two edges are parallel, as of a regular polygon of an odd number of
    /// corners, every edge of the hull may be an edge of Z(O).
    fn balanced_center(&self) -> Option<[f64; 2]> {
        let vertices = self.hull.vertices();
        let mut sums = [[0.0; 2]; 2];
        for (from, far) in vertices.iter().zip(self.farthest) {
            let far = self.hull.vertex(far.vertex());
            sums = [0, 1].map(|axis| [sums[axis][0] + from[axis], sums[axis][1] + far[axis]]);
        }
        let mean = |which: usize| self.frame.scaled([0, 1].map(|axis| sums[axis][which] / vertices.len() as f64));
        let ([x, y], [far_x, far_y], [rx, ry]) = (mean(0), mean(1), self.frame.reference);
        Some([sum_from_reference(x, far_x, rx), sum_from_reference(y, far_y, ry)])
    }

    fn certainly_passing(&self, point: [f64; 2]) -> Box<dyn Fn(usize) -> bool + '_> {
        let shifted = [0, 1].map(|axis| exact_sum(point[axis], self.frame.reference[axis]));
        Box::new(move |t| {
            let ends = [self.hull.vertices()[t], self.hull.vertex(self.farthest[t].vertex())];
            let [from, far] = ends.map(|end| self.frame.scaled(end));
            (0..2).all(|axis| exact_sum(far[axis], from[axis]) == shifted[axis])
                && ends.iter().all(|&end| self.frame.scales_exactly(end))
        })
    }

    fn certain_signs(&self, [x, y, w]: &[Dyadic; 3]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        if !w.is_zero() {
            return self.certain_sides([x, y].map(|c| BoundedDoubleDouble::of_ratio(c, w)));
        }
        let direction = [x, y].map(BoundedDoubleDouble::of);
        Box::new(move |t| self.by_pairs(t)?.rate(&direction).sign())
    }

    /// Differences of coordinates tell the side of nearly all lines of a hull that is nearly symmetric, whose lines
    /// nearly meet in one point: in doubles where only the differences are small, by pairs of doubles where the lines
    /// pass so near to the point that the products cancel, too.
    fn certain_sides(&self, place: [BoundedDoubleDouble; 2]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        let reference = self.frame.reference;
        Box::new(move |t| {
            let [from, to, far] = self.scaled_exactly(t)?;
            let offsets = [from, to].map(|end| [0, 1].map(|i| offset_from(&place[i], far[i], end[i], reference[i])));
            let [own, other] = offsets.map(|[x, y]| x.value.abs().max(y.value.abs()));
            let [x, y] = if other < own { offsets[1] } else { offsets[0] };
            let [edge_x, edge_y] = [0, 1].map(|i| Bounded::exact(to[i]) - Bounded::exact(from[i]));
            let by_pairs = || PairLine::new([from, to, far], reference).value(&place).sign();
            (edge_x * y - edge_y * x).sign().or_else(by_pairs)
        })
    }

    fn meeting_point(&self, first: usize, second: usize) -> Option<[BoundedDoubleDouble; 2]> {
        let shared = self.shared_midpoint([first, second]);
        shared.and_then(|ends| self.midpoint(ends)).or_else(|| self.by_pairs(first)?.meet(&self.by_pairs(second)?))
    }

    fn value_near(&self, t: usize, place: &[BoundedDoubleDouble; 2]) -> Option<BoundedDoubleDouble> {
        Some(self.by_pairs(t)?.value(place))
    }

    /// The normals are edges turned by a quarter, so the rate is the cross product of two vectors: of the line's edge
    /// and of the signed sum of edges. Where these are all edges of the hull but for the line's own, the sum is the
    /// opposite of that edge, and the rate is zero without any arithmetic.
    fn certain_rate(&self, signs: &[i8], along: usize) -> Option<Ordering> {
        let corners = Corners::of(signs);
        if corners.are_ends_of(along, signs.len()) {
            return Some(Ordering::Equal);
        }
        let sum = corners.sum(|vertex| {
            let point = self.hull.vertices()[vertex];
            self.frame.scales_exactly(point).then(|| self.frame.scaled(point))
        })?;
        self.by_pairs(along)?.edge_times(&sum).sign().map(|sign| sign.cmp(&0))
    }

    /// Where edges of one sign follow each other, their sum is the difference of its two ends.
    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let mut signs = vec![0; self.len()];
        terms.for_each(|(t, sign)| signs[t] += sign);
        let [x, y] = Corners::of(&signs).exact_sum(self.hull.vertices());
        [-y.scaled(-self.frame.scale(1)), x.scaled(-self.frame.scale(0))]
    }
}

/// The sum a + b − r, within 3 UNIT of its value unless it underflows.
///
/// The sum a + b is head + tail exactly. If the difference head − r is rounded at all, it is not smaller than half of
/// the head, hence not smaller than the tail. If it is smaller, it is exact.
fn sum_from_reference(a: f64, b: f64, r: f64) -> f64 {
    let (head, tail) = exact_sum(a, b);
    (head - r) + tail
}

/// The difference p − (a + b − r) for a coordinate p, precise however much of it cancels.
fn offset_from(p: &BoundedDoubleDouble, a: f64, b: f64, r: f64) -> Bounded {
    let (DoubleDouble { high, low }, missing) = p.parts();
    let (sum, sum_tail) = exact_sum(a, b);
    let (shifted, shifted_tail) = exact_sum(sum, -r);
    let (head, tail) = exact_sum(high, -shifted);
    let value = head + (((tail - shifted_tail) - sum_tail) + low);
    let tails = tail.abs() + shifted_tail.abs() + sum_tail.abs() + low.abs();
    Bounded { value, error: (UNIT * (value.abs() + 4.0 * tails) + missing) * FIVE_ROUNDINGS }
}
