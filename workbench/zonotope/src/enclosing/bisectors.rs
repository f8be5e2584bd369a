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
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::{BoundedDoubleDouble, DoubleDouble};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::{ExactSum, exact_sum};
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, UNIT};

/// The axes of a hull whose extents differ by more than this power of two are scaled apart.
const THIN_EXPONENT: i64 = 10;

/// The frame of the kernel, in which a coordinate of a point O of the plane is x = 2 · 2^−scale · O − reference. The
/// scales take the points of the hull to magnitude at most 1, and the reference is near twice their middle.
///
/// A hull that is thin along an axis has a scale of its own for that axis. A map of the axes keeps areas in proportion
/// and zonogons zonogons, and in the frame the hull is not thin: doubles tell its lines apart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    scales: [i64; 2],
    pub(crate) reference: [f64; 2],
    /// For each axis two powers of two with the product 2^−scale; the product itself may leave the range of doubles.
    factors: [[f64; 2]; 2],
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
    /// the powers of two of both scales. O(1), as the lines are made when they are read.
    pub fn kernel_problem(&self) -> LadProblem<'h> {
        let lines = Lines { hull: self.hull, farthest: self.farthest, frame: self.frame };
        LadProblem::from_made_lines(Box::new(lines), Box::new(lines))
    }

    /// The kernel point of a centre, both in homogeneous coordinates.
    pub(crate) fn kernel_point(&self, [x, y, w]: &[Dyadic; 3]) -> [Dyadic; 3] {
        let shifted = |v: &Dyadic, axis: usize| {
            v.clone().scaled(1 - self.frame.scales[axis]) - &Dyadic::from_f64(self.frame.reference[axis]) * w
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
        let scales = [0, 1].map(|axis| {
            let largest = hull.vertices().iter().fold(0.0f64, |largest, vertex| largest.max(vertex[axis].abs()));
            binary_exponent(largest).map_or(0, |e| i64::from(e) + 1)
        });
        let is_thin = (scales[0] - scales[1]).abs() > THIN_EXPONENT;
        let scales = if is_thin { scales } else { [scales[0].max(scales[1]); 2] };
        let factors = scales.map(|scale| [-(scale / 2), scale / 2 - scale].map(|e| scale_by_power_of_two(1.0, e)));
        let frame = Self { scales, reference: [0.0; 2], factors };
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

    /// A point in the units of the frame.
    #[inline(always)]
    pub(crate) fn scaled(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [[a, b], [c, d]] = self.factors;
        [x * a * b, y * c * d]
    }

    /// Whether a point is scaled without underflow.
    fn scales_exactly(&self, point: [f64; 2]) -> bool {
        let scaled = self.scaled(point);
        let is_exact = |i: usize| {
            let [a, b] = self.factors[i];
            scaled[i].abs() >= f64::MIN_POSITIVE || scaled[i] / b / a == point[i]
        };
        is_exact(0) && is_exact(1)
    }

    /// An area in the units of the input, given that in the units of the frame.
    pub(crate) fn unscaled_area(&self, area: Dyadic) -> Dyadic {
        area.scaled(self.scales[0] + self.scales[1])
    }

    /// Whether sums of four coordinates of the input neither overflow nor come near underflow.
    pub(crate) fn sums_are_doubles(&self) -> bool {
        self.scales.iter().all(|scale| (-900..1000).contains(scale))
    }

    /// A point in the units of the frame, exactly.
    pub(crate) fn exact(&self, point: [f64; 2]) -> [Dyadic; 2] {
        [0, 1].map(|axis| Dyadic::from_f64(point[axis]).scaled(-self.scales[axis]))
    }

    /// The point O of a kernel point, the inverse of [`Bisectors::kernel_point`], both in homogeneous coordinates.
    pub(crate) fn center_of(&self, [x, y, w]: &[Dyadic; 3]) -> [Dyadic; 3] {
        let [rx, ry] = self.reference.map(Dyadic::from_f64);
        let unscale = |v: Dyadic, axis: usize| v.scaled(self.scales[axis] - 1);
        [unscale(x + &(&rx * w), 0), unscale(y + &(&ry * w), 1), w.clone()]
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

/// The sign of the cross product of a vector with an edge, given the edge's ends.
fn side_by_pairs([x, y]: [BoundedDoubleDouble; 2], from: [f64; 2], to: [f64; 2]) -> Option<i8> {
    let exact = BoundedDoubleDouble::exact;
    let edge = |axis: usize| exact(to[axis]) - exact(from[axis]);
    (edge(0) * y - edge(1) * x).sign()
}

/// At most this many coordinates are added up one by one: an accumulator for all exponents costs more to set up.
const ONE_BY_ONE_LIMIT: usize = 24;

/// The vertices in a sum of edges with signs, each with the factor that it has in the sum. Where edges of one sign
/// follow each other, their sum is the difference of its two ends.
fn corners(terms: &mut dyn Iterator<Item = (usize, i8)>) -> Vec<(usize, f64)> {
    let mut corners = Vec::new();
    let mut run: Option<(usize, i8)> = None;
    for (t, sign) in terms {
        if run != Some((t, sign)) {
            corners.extend(run.map(|(end, sign)| (end, f64::from(sign))));
            corners.push((t, -f64::from(sign)));
        }
        run = Some((t + 1, sign));
    }
    corners.extend(run.map(|(end, sign)| (end, f64::from(sign))));
    corners
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

    /// Differences of coordinates tell the side of nearly all lines of a hull that is nearly symmetric, whose lines
    /// nearly meet in one point: in doubles where only the differences are small, by pairs of doubles where the lines
    /// pass so near to the point that the products cancel, too.
    fn certain_signs(&self, [x, y, w]: &[Dyadic; 3]) -> Box<dyn Fn(usize) -> Option<i8> + '_> {
        let is_point = !w.is_zero();
        let place = [x, y].map(|c| match is_point {
            true => BoundedDoubleDouble::of_ratio(c, w),
            false => BoundedDoubleDouble::of(c),
        });
        let reference = self.frame.reference;
        Box::new(move |t| {
            let [from, to] = self.ends(t);
            let far = self.hull.vertex(self.farthest[t].vertex());
            if ![from, to, far].iter().all(|&point| self.frame.scales_exactly(point)) {
                return None;
            }
            let [from, to, far] = [from, to, far].map(|point| self.frame.scaled(point));
            if !is_point {
                return side_by_pairs(place, from, to);
            }
            let [x, y] = [0, 1].map(|i| offset_from(&place[i], far[i], from[i], reference[i]));
            let [edge_x, edge_y] = [0, 1].map(|i| Bounded::exact(to[i]) - Bounded::exact(from[i]));
            (edge_x * y - edge_y * x).sign().or_else(|| {
                let exact = BoundedDoubleDouble::exact;
                let off = |i: usize| place[i] - ((exact(far[i]) - exact(reference[i])) + exact(from[i]));
                side_by_pairs([off(0), off(1)], from, to)
            })
        })
    }

    fn signed_normal_sum(&self, terms: &mut dyn Iterator<Item = (usize, i8)>) -> [Dyadic; 2] {
        let (corners, vertices) = (corners(terms), self.hull.vertices());
        let [x, y] = [0, 1].map(|axis| {
            let coordinates = corners.iter().map(|&(t, factor)| factor * vertices[t % vertices.len()][axis]);
            if corners.len() <= ONE_BY_ONE_LIMIT {
                coordinates.fold(Dyadic::zero(), |sum, c| sum + Dyadic::from_f64(c))
            } else {
                let mut sum = ExactSum::default();
                coordinates.for_each(|c| sum.add(c));
                sum.value()
            }
        });
        [-y.scaled(-self.frame.scales[1]), x.scaled(-self.frame.scales[0])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hull::antipodal::farthest_vertices;
    use crate::hull::convex_hull;

    /// A regular polygon, whose lines nearly meet, made thin along one axis.
    fn ellipse(corners: u32, height: f64) -> ConvexHull {
        let angle = |k: u32| f64::from(k) * std::f64::consts::TAU / f64::from(corners);
        let points: Vec<[f64; 2]> = (0..corners).map(|k| [libm::cos(angle(k)), height * libm::sin(angle(k))]).collect();
        convex_hull(&points).expect("the points are finite")
    }

    #[test]
    fn certain_signs_are_those_of_exact_values() {
        for (corners, height) in [(30, 1.0), (64, 1.0), (31, 1e-6), (40, 1e-300)] {
            let hull = ellipse(corners, height);
            let farthest = farthest_vertices(&hull);
            let lines = Lines { hull: &hull, farthest: &farthest, frame: Bisectors::new(&hull, &farthest).frame };
            let count = hull.edge_count();
            let (mut told, mut asked) = (0, 0);
            for t in 0..count {
                let (first, second) = (lines.line(t), lines.line((t + count / 3) % count));
                let mut point = first.meet(&second);
                if point[2].sign().is_lt() {
                    point = point.map(|c| -c);
                }
                let at_infinity = [point[0].clone(), point[1].clone(), Dyadic::zero()];
                for place in [point, at_infinity] {
                    let signs = lines.certain_signs(&place);
                    for other in 0..count {
                        let exact = lines.line(other).evaluate(&place).sign() as i8;
                        assert!(signs(other).is_none_or(|sign| sign == exact), "{corners} {height:e} {t} {other}");
                        asked += i32::from(exact != 0);
                        told += i32::from(signs(other).is_some());
                    }
                }
            }
            assert!(10 * told >= 9 * asked, "{told} of {asked} for {corners} corners of height {height:e}");
        }
    }

    #[test]
    fn a_sum_of_edges_is_that_of_its_corners() {
        let hull = ellipse(12, 1.0);
        let farthest = farthest_vertices(&hull);
        let lines = Lines { hull: &hull, farthest: &farthest, frame: Bisectors::new(&hull, &farthest).frame };
        let signs = [1, 1, -1, -1, -1, 0, 1, 1, 1, 1, -1, 1];
        let mut terms = signs.into_iter().enumerate().filter(|(_, sign)| *sign != 0);
        let one_by_one = terms.clone().fold([Dyadic::zero(), Dyadic::zero()], |[x, y], (t, sign)| {
            let [a, b] = lines.line(t).normal;
            if sign > 0 { [x + a, y + b] } else { [x - a, y - b] }
        });
        assert_eq!(lines.signed_normal_sum(&mut terms), one_by_one);
        let all = lines.signed_normal_sum(&mut (0..12).map(|t| (t, 1)));
        assert_eq!(all, [Dyadic::zero(), Dyadic::zero()]);
    }
}
