//! The lines ℓ_t of Section 4.1, which bound where the centre must lie for a hull edge to be an edge of Z(O).
//!
//! For the edge from P_t to P_{t+1} with farthest vertex P_s, the line ℓ_t runs through the midpoints of P_s P_t and
//! P_s P_{t+1}. The edge is an edge of Z(O) iff O is not to the right of ℓ_t. With X = 2O and e_t = P_{t+1} − P_t that
//! is e_t × (X − P_s − P_t) ≥ 0, and the area of Z(O) is a constant plus ½ Σ_t |e_t × (X − P_s − P_t)|.
//!
//! Derivation of the area f(O): let O move away from ℓ_t, on the side where e_t is an edge of Z(O). By central symmetry
//! the area grows at the rate 2 |e_t|. On the other side of ℓ_t it does not depend on e_t. So f(O) = C + 2 Σ_t max(0,
//! e_t × (O − m_t)) with m_t on ℓ_t. Since max(0, d) = (d + |d|) / 2 and the edges of a polygon add up to zero, the
//! linear parts cancel up to a constant.

use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::lad::LadProblem;
use crate::lad::kernel_input::{ExactLine, ExactLines, LineError, MadeLines};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::{ExactSum, exact_sum};
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::numeric::tolerance::UNIT;

/// The frame of the kernel, in which a point O of the plane is x = 2 · 2^−scale · O − reference. The scale takes the
/// points of the hull to magnitude at most 1, and the reference is near twice their middle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub(crate) scale: i64,
    pub(crate) reference: [f64; 2],
    /// Two powers of two with the product 2^−scale; the product itself may leave the range of doubles.
    factors: [f64; 2],
}

/// The lines ℓ_t of a hull with area.
#[derive(Debug)]
pub struct Bisectors<'h> {
    hull: &'h ConvexHull,
    farthest: &'h [FarthestVertex],
    pub(crate) frame: Frame,
}

impl<'h> Bisectors<'h> {
    /// The lines of a hull, given the farthest vertex of each edge.
    ///
    /// # Panics
    /// When `farthest` does not have one vertex for each edge of the hull, or names one that the hull does not have.
    pub fn new(hull: &'h ConvexHull, farthest: &'h [FarthestVertex]) -> Self {
        assert_eq!(farthest.len(), hull.edge_count(), "one farthest vertex for each edge");
        Self { hull, farthest, frame: Frame::of(hull, farthest) }
    }

    /// The kernel problem whose objective at the kernel point x of a point O is Σ_t |e_t × (X − P_s − P_t)| divided by
    /// 4^scale. O(1), as the lines are made when they are read.
    pub fn kernel_problem(&self) -> LadProblem<'h> {
        let lines = Lines { hull: self.hull, farthest: self.farthest, frame: self.frame };
        LadProblem::from_made_lines(Box::new(lines), Box::new(lines))
    }

    /// The kernel point of a centre, both in homogeneous coordinates.
    pub(crate) fn kernel_point(&self, [x, y, w]: &[Dyadic; 3]) -> [Dyadic; 3] {
        let shifted = |v: &Dyadic, axis: usize| {
            v.clone().scaled(1 - self.frame.scale) - &Dyadic::from_f64(self.frame.reference[axis]) * w
        };
        [shifted(x, 0), shifted(y, 1), w.clone()]
    }

    /// The midpoints of P_s P_t and P_s P_{t+1} on ℓ_t, rounded.
    ///
    /// # Panics
    /// When the hull has no edge t.
    pub fn midpoints(&self, t: usize) -> [[f64; 2]; 2] {
        let vertices = self.hull.vertices();
        let far = self.hull.vertex(self.farthest[t].vertex());
        let ends = [vertices[t], vertices[(t + 1) % vertices.len()]];
        ends.map(|end| [0, 1].map(|i| end[i] / 2.0 + far[i] / 2.0))
    }
}

impl Frame {
    /// The frame for a hull and the farthest vertices of its edges.
    fn of(hull: &ConvexHull, farthest: &[FarthestVertex]) -> Self {
        let largest = largest_magnitude(hull.vertices().as_flattened());
        let scale = binary_exponent(largest).map_or(0, |e| i64::from(e) + 1);
        let half = scale / 2;
        let factors = [-half, half - scale].map(|e| scale_by_power_of_two(1.0, e));
        let frame = Self { scale, reference: [0.0; 2], factors };
        // If the hull is nearly symmetric, the median over a few lines is near every P_s + P_t, so that offsets are
        // small. Else any reference does.
        let step = farthest.len() / 32 + 1;
        let sums = (0..farthest.len()).step_by(step).map(|t| {
            let (a, b) = (frame.scaled(hull.vertices()[t]), frame.scaled(hull.vertex(farthest[t].vertex())));
            [a[0] + b[0], a[1] + b[1]]
        });
        let sums: Vec<[f64; 2]> = sums.collect();
        let median = |axis: usize| {
            let mut values: Vec<f64> = sums.iter().map(|v| v[axis]).collect();
            values.sort_unstable_by(f64::total_cmp);
            values.get(values.len() / 2).copied().unwrap_or(0.0)
        };
        Self { reference: [median(0), median(1)], ..frame }
    }

    /// A point times 2^−scale.
    #[inline(always)]
    pub(crate) fn scaled(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = point;
        [x * self.factors[0] * self.factors[1], y * self.factors[0] * self.factors[1]]
    }

    /// Whether a point is scaled without underflow.
    fn scales_exactly(&self, point: [f64; 2]) -> bool {
        let scaled = self.scaled(point);
        let is_exact = |i: usize| {
            scaled[i].abs() >= f64::MIN_POSITIVE || scaled[i] / self.factors[1] / self.factors[0] == point[i]
        };
        is_exact(0) && is_exact(1)
    }

    /// A length times 2^−scale.
    #[inline(always)]
    pub(crate) fn scaled_length(&self, length: f64) -> f64 {
        length * self.factors[0] * self.factors[1]
    }

    /// Whether sums of four coordinates of the input neither overflow nor come near underflow.
    pub(crate) fn sums_are_doubles(&self) -> bool {
        (-900..1000).contains(&self.scale)
    }

    /// A point times 2^−scale, exactly.
    pub(crate) fn exact(&self, point: [f64; 2]) -> [Dyadic; 2] {
        point.map(|v| Dyadic::from_f64(v).scaled(-self.scale))
    }

    /// The point O of a kernel point, the inverse of [`Bisectors::kernel_point`], both in homogeneous coordinates.
    pub(crate) fn center_of(&self, [x, y, w]: &[Dyadic; 3]) -> [Dyadic; 3] {
        let [rx, ry] = self.reference.map(Dyadic::from_f64);
        let unscale = |v: Dyadic| v.scaled(self.scale - 1);
        [unscale(x + &(&rx * w)), unscale(y + &(&ry * w)), w.clone()]
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

/// The lines ℓ_t in the frame of the kernel, made from the points of the hull when they are read.
#[derive(Debug, Clone, Copy)]
struct Lines<'h> {
    hull: &'h ConvexHull,
    farthest: &'h [FarthestVertex],
    frame: Frame,
}

impl Lines<'_> {
    /// The row of the edge between two scaled vertices, and the magnitude of d with row · (x, y, 1) = edge × (x − d).
    #[inline(always)]
    fn between(&self, from: [f64; 2], to: [f64; 2], far: FarthestVertex) -> ([f64; 3], f64) {
        let far = self.frame.scaled(self.hull.vertex(far.vertex()));
        let edge = [to[0] - from[0], to[1] - from[1]];
        let [rx, ry] = self.frame.reference;
        let d = [sum_from_reference(far[0], from[0], rx), sum_from_reference(far[1], from[1], ry)];
        ([-edge[1], edge[0], edge[1] * d[0] - edge[0] * d[1]], d[0].abs().max(d[1].abs()))
    }

    /// The error of a row whose d has magnitude `spread`: each coordinate of d is within 3 UNIT of its value, each edge
    /// coordinate within UNIT, and the offset takes two products and a difference.
    fn error(spread: f64) -> LineError {
        LineError { offset_relative: 0.0, offset_per_normal: 8.0 * UNIT * spread }
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

    fn certainly_passing(&self, point: [f64; 2]) -> Box<dyn Fn(usize) -> bool + '_> {
        let shifted = [0, 1].map(|axis| exact_sum(point[axis], self.frame.reference[axis]));
        Box::new(move |t| {
            let ends = [self.hull.vertices()[t], self.hull.vertex(self.farthest[t].vertex())];
            let [from, far] = ends.map(|end| self.frame.scaled(end));
            (0..2).all(|axis| exact_sum(far[axis], from[axis]) == shifted[axis])
                && ends.iter().all(|&end| self.frame.scales_exactly(end))
        })
    }

    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let mut sums = [ExactSum::default(), ExactSum::default()];
        for (t, sign) in terms {
            let sign = f64::from(sign);
            let [from, to] = self.ends(t);
            for (sum, axis) in sums.iter_mut().zip([0, 1]) {
                sum.add(sign * to[axis]);
                sum.add(-sign * from[axis]);
            }
        }
        let [x, y] = sums.map(|sum| sum.value().scaled(-self.frame.scale));
        [-y, x]
    }
}
