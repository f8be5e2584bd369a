//! Coefficients that make up a point well within the body: those of least size, with the largest ones clipped.
//!
//! Let |v| be the largest magnitude of a coordinate of v, t_i = v_i · y / |v_i| and b_i = t_i, clipped to [−1, 1]. The y with Σ b_i v_i = q minimises a
//! convex function, Σ |v_i| huber(t_i) − q · y, whose Hessian is H = Σ v_i v_iᵀ / |v_i| over those that are not clipped. It exists just
//! if q is in the body; else y goes to infinity where a direction separates. From any y, with s = Σ b_i v_i, the coefficients
//! μ b_i, and v_i · z / |v_i| more where nothing was clipped, make up p = μ s + H z, and none is larger than μ + |z|_1. Where lengths are
//! even, one length, that of the longest, does for all and spares a division for each.
//!
//! All this only finds coefficients. They are proved as they stand, from the sum of what was written.

use wide::f64x2;

use crate::collision::{Displacement, Witness};
use crate::numeric::bounded::BoundedVector;
use crate::numeric::tolerance::UNIT;

/// No coefficient is nearer to ±1 than this leaves room for.
pub(super) const WELL_WITHIN: f64 = 0.9999;

/// Generators whose sums are taken together, so that a term goes through few additions.
const BLOCK: usize = 512;

/// How many generators the basis is chosen from.
const PICKS: usize = 16;

/// Sums of lengths between which no product of three leaves the range of doubles.
const LARGEST: f64 = f64::from_bits((1023 + 300) << 52);
const SMALLEST: f64 = f64::from_bits((1023 - 200) << 52);

/// Covers the underflow of a product.
const TINY: f64 = f64::from_bits((1023 - 1000) << 52);

/// Covers products of rounding errors.
const SLACK: f64 = 1.0 + 1.0 / 1_048_576.0;

/// What is added to the diagonal of a matrix, in terms of its trace, so that flat bodies have an inverse as well.
const THIN: f64 = 4e-15;

/// How much larger than those of some generators the coefficients of all are taken to be.
const MORE: f64 = 1.15;

/// Memory for fewer coefficients is cleared when it is taken, for more when it is first touched.
const MANY: usize = 1 << 14;

/// Lengths are even if the longest is no longer than this, in terms of the mean.
const UNEVEN: f64 = 4.0;

/// With a determinant below this, in terms of the trace, a body may be flat.
const FLAT: f64 = 4e-15;

/// Generators in two runs.
pub(super) type Runs<'a> = [&'a [[f64; 3]]; 2];

/// Sums over generators at some y.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moments {
    /// H: xx, xy, xz, yy, yz, zz.
    hessian: [f64; 6],
    /// s.
    pub(super) sum: [f64; 3],
    /// Σ |v · y|.
    pub(super) reach: f64,
}

/// Coefficients in terms of y, z and μ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Combination {
    pub(super) y: [f64; 3],
    pub(super) z: [f64; 3],
    pub(super) factor: f64,
    pub(super) lengths: Lengths,
}

/// Two generators side by side.
type Columns = [f64x2; 3];

/// What a product with a generator is divided by: its own length, or one for all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lengths {
    Own,
    Even(f64),
}

impl Lengths {
    /// The length of the longest generator, if they are even.
    pub(super) fn of(runs: Runs<'_>) -> Self {
        let (mut longest, mut total) = (f64x2::default(), f64x2::default());
        for run in runs {
            for_pairs(run, |v| {
                let size = size(&v);
                longest = longest.fast_max(size);
                total += size;
            });
        }
        let [first, second] = longest.to_array();
        let longest = first.max(second);
        let count = (runs[0].len() + runs[1].len()) as f64;
        if longest * count <= UNEVEN * total.reduce_add() { Self::Even(longest) } else { Self::Own }
    }

    /// What (v · z) / |v| is at most: for any v, or for even generators by those of some, with room for others.
    fn largest(self, among: &[[f64; 3]], z: &[f64; 3]) -> f64 {
        let Self::Even(longest) = self else { return length(z).min((3.0 * dot(z, z)).sqrt()) };
        let wide = z.map(f64x2::splat);
        let mut largest = f64x2::default();
        for_pairs(among, |v| largest = largest.fast_max(product(&v, &wide).abs()));
        let [first, second] = largest.to_array();
        MORE * first.max(second) / longest
    }

    /// What products with a vector are to be taken with, and what sums of them are to be divided by.
    fn scale(self) -> f64 {
        match self {
            Self::Own => 1.0,
            Self::Even(length) => length,
        }
    }
}

#[inline(always)]
fn columns([[a, b, c], [d, e, f]]: [[f64; 3]; 2]) -> Columns {
    [[a, d], [b, e], [c, f]].map(f64x2::new)
}

#[inline(always)]
fn for_pairs(generators: &[[f64; 3]], mut read: impl FnMut(Columns)) {
    let (pairs, last) = generators.as_chunks::<2>();
    for pair in pairs {
        read(columns(*pair));
    }
    if let [last] = last {
        read(columns([*last, [0.0; 3]]));
    }
}

#[inline(always)]
fn product(v: &Columns, u: &Columns) -> f64x2 {
    v[0] * u[0] + v[1] * u[1] + v[2] * u[2]
}

#[inline(always)]
fn size(v: &Columns) -> f64x2 {
    v[0].abs().fast_max(v[1].abs()).fast_max(v[2].abs()).fast_max(f64x2::splat(f64::MIN_POSITIVE))
}

#[inline(always)]
fn clipped(t: f64x2, limit: f64) -> f64x2 {
    t.fast_min(f64x2::splat(limit)).fast_max(f64x2::splat(-limit))
}

#[derive(Default)]
struct Sums {
    hessian: [f64x2; 6],
    sum: Columns,
    reach: f64x2,
}

impl Sums {
    /// Adds two generators; y is scaled where lengths are not their own.
    #[inline(always)]
    fn read<const AT_ZERO: bool, const OWN: bool>(&mut self, v: &Columns, y: &Columns) {
        let one = f64x2::splat(1.0);
        let weight = if OWN { one / size(v) } else { one };
        let mut scaled = if OWN { v.map(|c| weight * c) } else { *v };
        if !AT_ZERO {
            let t = product(&scaled, y);
            let coefficient = clipped(t, 1.0);
            for (sum, c) in self.sum.iter_mut().zip(v) {
                *sum += coefficient * *c;
            }
            self.reach += if OWN { product(v, y) } else { t }.abs();
            let is_inner = t.abs().simd_lt(one);
            scaled = scaled.map(|c| c & is_inner);
        }
        let [x, y, z] = scaled;
        let terms = [x * v[0], x * v[1], x * v[2], y * v[1], y * v[2], z * v[2]];
        for (sum, term) in self.hessian.iter_mut().zip(terms) {
            *sum += term;
        }
    }
}

impl Moments {
    /// Σ v vᵀ / |v|, and nothing else.
    pub(super) fn at_zero(runs: Runs<'_>, lengths: Lengths) -> Self {
        match lengths {
            Lengths::Own => Self::read::<true, true>(runs, &[0.0; 3], 1.0),
            Lengths::Even(length) => Self::read::<true, false>(runs, &[0.0; 3], length),
        }
    }

    pub(super) fn at(runs: Runs<'_>, lengths: Lengths, y: &[f64; 3]) -> Self {
        match lengths {
            Lengths::Own => Self::read::<false, true>(runs, y, 1.0),
            Lengths::Even(length) => Self::read::<false, false>(runs, y, length),
        }
    }

    fn read<const AT_ZERO: bool, const OWN: bool>(runs: Runs<'_>, y: &[f64; 3], length: f64) -> Self {
        let wide = y.map(|c| f64x2::splat(c / length));
        let mut sums = Sums::default();
        for run in runs {
            for_pairs(run, |v| sums.read::<AT_ZERO, OWN>(&v, &wide));
        }
        Self {
            hessian: sums.hessian.map(|sum| sum.reduce_add() / length),
            sum: sums.sum.map(f64x2::reduce_add),
            reach: sums.reach.reduce_add() * length,
        }
    }

    /// H^{-1} r, and whether H is certainly not singular.
    pub(super) fn solve(&self, r: &[f64; 3]) -> ([f64; 3], bool) {
        let [xx, xy, xz, yy, yz, zz] = self.hessian;
        let trace = xx + yy + zz;
        let more = THIN * trace;
        let rows = [[xx + more, xy, xz], [xy, yy + more, yz], [xz, yz, zz + more]];
        let minors = [cross(&rows[1], &rows[2]), cross(&rows[2], &rows[0]), cross(&rows[0], &rows[1])];
        let determinant = dot(&rows[0], &minors[0]);
        let inverse = 1.0 / determinant;
        let solve = |r: &[f64; 3]| minors.map(|row| dot(&row, r) * inverse);
        let first = solve(r);
        // what was added to the diagonal is taken back
        let second = solve(&first.map(|c| more * c));
        ([0, 1, 2].map(|k| first[k] + second[k]), determinant > FLAT * trace * trace * trace)
    }

    /// The slope of the smooth problem along a step.
    pub(super) fn slope(&self, step: &[f64; 3], target: &[f64; 3]) -> f64 {
        dot(&self.sum, step) - dot(target, step)
    }

    /// Coefficients that make up p, if these are well within (−1, 1); and the Newton step towards `target`.
    pub(super) fn combination(
        &self,
        lengths: Lengths,
        y: &[f64; 3],
        p: &[f64; 3],
        target: &[f64; 3],
        among: &[[f64; 3]],
    ) -> (Option<Combination>, [f64; 3]) {
        let factor = dot(p, y) / dot(&self.sum, y);
        let (z, is_thick) = self.solve(&[0, 1, 2].map(|k| p[k] - factor * self.sum[k]));
        let (step, _) = self.solve(&[0, 1, 2].map(|k| target[k] - self.sum[k]));
        let is_within = is_thick && factor > 0.0 && factor + lengths.largest(among, &z) <= WELL_WITHIN;
        (is_within.then_some(Combination { y: *y, z, factor, lengths }), step)
    }
}

impl Combination {
    /// The least coefficients that make up p, where H z = p for all generators; none if they are likely to be too large, seen from some.
    pub(super) fn least(z: [f64; 3], lengths: Lengths, among: &[[f64; 3]]) -> Option<Self> {
        (lengths.largest(among, &z) <= WELL_WITHIN).then_some(Self::of(z, lengths))
    }

    /// The same, however large they are.
    pub(super) fn of(z: [f64; 3], lengths: Lengths) -> Self {
        Self { y: [0.0; 3], z, factor: 0.0, lengths }
    }

    /// The proof that p is inside, if the coefficients make it up but for what three of them can correct.
    ///
    /// The sum of what was written is off by at most a rounding of each term and one for each addition that it goes through. Let r be p less that sum and a, b, c the three: the
    /// correction of the coefficient of a is r · (b × c) / a · (b × c). A product of vectors and determinants is off by less than 8 u times the
    /// product of the lengths |·|_1.
    pub(super) fn witness(&self, question: &Displacement<'_, 3>, p: &BoundedVector) -> Option<Witness> {
        let n = question.len();
        let mut coefficients = if n < MANY { Vec::with_capacity(n) } else { vec![0.0; n] };
        coefficients.resize(n, 0.0);
        let [first, second] = question.runs();
        let (own, others) = coefficients.split_at_mut(first.len());
        let (mut sum, mut magnitude) = ([0.0; 3], 0.0);
        for (run, places) in [(first, own), (second, others)] {
            for (block, places) in run.chunks(BLOCK).zip(places.chunks_mut(BLOCK)) {
                let (part, size) = self.write(block, places);
                sum = [0, 1, 2].map(|k| sum[k] + part[k]);
                magnitude += size;
            }
        }
        let additions = (BLOCK / 2 + n / BLOCK + 16) as f64;
        let rest = (0..3).fold(0.0f64, |m, k| m.max((p[k].value - sum[k]).abs() + p[k].error));
        let rest = (rest + UNIT * additions * magnitude + n as f64 * TINY) * SLACK;
        let is_basis = |basis: &[usize; 3]| {
            let [a, b, c] = basis.map(|i| question.generator(i));
            let normals = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
            let lengths = [&a, &b, &c].map(length);
            let volume = lengths[0] * lengths[1] * lengths[2];
            let determinant = dot(&a, &normals[0]).abs() - 8.0 * UNIT * volume - TINY;
            let is_within = |k: usize| {
                let across = length(&normals[k]) + 8.0 * UNIT * volume / lengths[k] + TINY;
                coefficients[basis[k]].abs() + rest * across / determinant * SLACK < 1.0
            };
            determinant > SMALLEST * SMALLEST * SMALLEST && (0..3).all(is_within)
        };
        if n < 3 || !(SMALLEST..LARGEST).contains(&magnitude) {
            return None;
        }
        let any = Some([0, n / 3, 2 * n / 3]).filter(&is_basis);
        let mut basis = any.or_else(|| well_spread(question).filter(is_basis))?.to_vec();
        basis.sort_unstable();
        Some(Witness { coefficients, basis })
    }

    /// Writes the coefficients of some generators; Σ c v, and at least Σ |v|.
    fn write(&self, generators: &[[f64; 3]], places: &mut [f64]) -> ([f64; 3], f64) {
        match (self.lengths, self.factor == 0.0) {
            (Lengths::Own, false) => self.write_as::<true, false>(generators, places),
            (Lengths::Own, true) => self.write_as::<true, true>(generators, places),
            (Lengths::Even(_), false) => self.write_as::<false, false>(generators, places),
            (Lengths::Even(_), true) => self.write_as::<false, true>(generators, places),
        }
    }

    #[inline(always)]
    fn write_as<const OWN: bool, const LINEAR: bool>(
        &self,
        generators: &[[f64; 3]],
        places: &mut [f64],
    ) -> ([f64; 3], f64) {
        let scale = 1.0 / self.lengths.scale();
        let [y, z] = [self.y, self.z].map(|vector| vector.map(|c| f64x2::splat(c * scale)));
        let (one, factor) = (f64x2::splat(1.0), f64x2::splat(self.factor));
        let (mut sum, mut total) = (Columns::default(), Columns::default());
        let mut read = |v: Columns| {
            let scaled = if OWN {
                let size = size(&v);
                total[0] += size;
                let weight = one / size;
                v.map(|c| weight * c)
            } else {
                for (total, c) in total.iter_mut().zip(v) {
                    *total += c.abs();
                }
                v
            };
            let mut coefficient = product(&scaled, &z);
            if !LINEAR {
                let t = product(&scaled, &y);
                coefficient = factor * clipped(t, 1.0) + (coefficient & t.abs().simd_lt(one));
            }
            let coefficient = clipped(coefficient, WELL_WITHIN);
            for (sum, c) in sum.iter_mut().zip(v) {
                *sum += coefficient * c;
            }
            coefficient.to_array()
        };
        let (pairs, last) = generators.as_chunks::<2>();
        let (places, last_place) = places.as_chunks_mut::<2>();
        for (pair, place) in pairs.iter().zip(places) {
            *place = read(columns(*pair));
        }
        if let ([last], [place]) = (last, last_place) {
            *place = read(columns([*last, [0.0; 3]]))[0];
        }
        (sum.map(f64x2::reduce_add), total.map(f64x2::reduce_add).iter().sum())
    }
}

/// Three of some generators: the longest, the one farthest from its line, the one farthest from the plane of both.
pub(super) fn well_spread(question: &Displacement<'_, 3>) -> Option<[usize; 3]> {
    let step = question.len().div_ceil(PICKS).max(1);
    let best = |key: &dyn Fn(&[f64; 3]) -> f64| {
        let keyed = (0..question.len()).step_by(step).map(|i| (key(&question.generator(i)), i));
        keyed.fold((0.0, usize::MAX), |best, own| if own.0 > best.0 { own } else { best }).1
    };
    let first = best(&|v| dot(v, v));
    let a = (first != usize::MAX).then(|| question.generator(first))?;
    let second = best(&|v| {
        let product = cross(&a, v);
        dot(&product, &product)
    });
    let normal = (second != usize::MAX).then(|| cross(&a, &question.generator(second)))?;
    let third = best(&|v| dot(&normal, v).abs());
    (third != usize::MAX && third != first && third != second).then_some([first, second, third])
}

pub(super) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// |a|_1.
pub(super) fn length(a: &[f64; 3]) -> f64 {
    a[0].abs() + a[1].abs() + a[2].abs()
}
