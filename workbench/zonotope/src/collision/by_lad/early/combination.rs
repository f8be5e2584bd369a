//! Coefficients in terms of a solution of the smooth problem: written, summed up, and proved as they stand.
//!
//! The sum of the written combination is known but for rounding. Its distance from the point, and all rounding
//! errors, are small: three generators that span space can balance them, whatever they are, if their coefficients
//! have a little room.

use wide::f64x2;

use crate::collision::by_lad::early::huber_dual::{Among, Lengths, Moments, ROUGH_EXCESS, WELL_WITHIN};
use crate::collision::by_lad::early::passes::{Carried, EarlyQuery, Passes};
use crate::collision::{Query, Witness};
use crate::lad::of_generators::linear_map::LinearMap;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::lanes::{Columns, clipped, columns, product, size, total, totals};
use crate::numeric::linear::{cross, dot, sum_norm};
use crate::numeric::tolerance::{CUBABLE_SIZES, LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Generators whose sums are taken together, so that a term goes through few additions.
const BLOCK: usize = 512;

/// How many generators the basis is chosen from.
const BASIS_SAMPLE: usize = 16;

/// Memory for fewer coefficients is cleared when it is taken, for more when it is first touched.
const CLEARED_WHEN_TAKEN: usize = 1 << 14;

/// Coefficients in terms of y, z and μ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Combination {
    y: [f64; 3],
    z: [f64; 3],
    factor: f64,
    lengths: Lengths,
    /// What coefficients are clipped to in the end.
    limit: f64,
}

/// Some generators, and the places of their coefficients.
pub(crate) type Part<'a> = (&'a [[f64; 3]], &'a mut [f64]);

/// Sums over coefficients that were written.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Written {
    /// Σ c v.
    pub(crate) sum: [f64; 3],
    /// At least Σ |v|.
    pub(crate) magnitude: f64,
    pub(crate) count: usize,
}

impl Written {
    /// Adds what was summed up over the last generators.
    #[inline(always)]
    fn add(&mut self, sum: &mut Columns, sizes: &mut f64x2, fresh: &mut usize) {
        let own = Self { sum: totals(sum), magnitude: total(*sizes), count: *fresh };
        *self = self.with(&own);
        (*sum, *sizes, *fresh) = Default::default();
    }

    pub(crate) fn with(&self, other: &Self) -> Self {
        let sum = [0, 1, 2].map(|k| self.sum[k] + other.sum[k]);
        Self { sum, magnitude: self.magnitude + other.magnitude, count: self.count + other.count }
    }

    /// The proof with these coefficients, if three of them can correct what they are off by.
    pub(crate) fn witness(
        &self,
        query: &impl EarlyQuery,
        p: &BoundedVector,
        coefficients: Vec<f64>,
    ) -> Option<Witness> {
        let rest = rest(p, &self.sum, additions(self.count), self.magnitude, self.count);
        let basis = correcting_basis(query, &coefficients, rest, self.magnitude)?;
        Some(Witness { coefficients, basis })
    }
}

impl Carried for Written {
    #[inline]
    fn carried(self, map: &LinearMap<'_>) -> Self {
        Self { sum: map.image(&self.sum), magnitude: map.carried_magnitude(self.magnitude), count: self.count }
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        self.with(&other)
    }
}

impl Moments {
    /// Coefficients that combine to p, if these are well within (−1, 1), or, where they need not be `exact`, if few
    /// of them are not.
    pub(crate) fn combination(
        &self,
        generators: &(impl Passes + ?Sized),
        lengths: Lengths,
        y: &[f64; 3],
        p: &[f64; 3],
        among: Among<'_>,
        exact: bool,
    ) -> Option<Combination> {
        let factor = dot(p, y) / dot(&self.sum, y);
        if !(factor > 0.0 && factor < WELL_WITHIN) {
            return None;
        }
        let z = self.solve_thick(&[0, 1, 2].map(|k| p[k] - factor * self.sum[k]))?;
        let room = if exact { WELL_WITHIN - factor } else { ROUGH_EXCESS };
        (lengths.largest(among, generators, &z) <= room).then(|| Combination::new(y, z, factor, lengths))
    }
}

impl Combination {
    /// The least coefficients that combine to p, where H z = p for all generators; `None` if, seen from some
    /// generators, they are likely to be too large, or, where they need not be `exact`, much too large.
    pub(crate) fn least(
        generators: &(impl Passes + ?Sized),
        z: [f64; 3],
        lengths: Lengths,
        among: Among<'_>,
        exact: bool,
    ) -> Option<Self> {
        let limit = if exact { WELL_WITHIN } else { WELL_WITHIN + ROUGH_EXCESS };
        (lengths.largest(among, generators, &z) <= limit).then_some(Self::linear(z, lengths))
    }

    fn linear(z: [f64; 3], lengths: Lengths) -> Self {
        Self::new(&[0.0; 3], z, 0.0, lengths)
    }

    pub(crate) fn new(y: &[f64; 3], z: [f64; 3], factor: f64, lengths: Lengths) -> Self {
        Self { y: *y, z, factor, lengths, limit: WELL_WITHIN }
    }

    /// Nearly the same coefficients with one product for each: those of μ y + z, clipped to μ.
    pub(crate) fn merged(&self) -> Self {
        if self.factor == 0.0 {
            return *self;
        }
        let z = [0, 1, 2].map(|k| self.factor * self.y[k] + self.z[k]);
        Self { limit: self.factor, ..Self::linear(z, self.lengths) }
    }

    /// The proof that p is inside, if the coefficients combine to p but for a rest that three of them can balance.
    pub(crate) fn witness(&self, query: &impl EarlyQuery, p: &BoundedVector) -> Option<Witness> {
        let n = query.count();
        let mut coefficients = if n < CLEARED_WHEN_TAKEN { Vec::with_capacity(n) } else { vec![0.0; n] };
        coefficients.resize(n, 0.0);
        let all = self.write_all(query, &mut coefficients, |combination, run, places| {
            combination.write(run.chunks(BLOCK).zip(places.chunks_mut(BLOCK)))
        });
        all.witness(query, p, coefficients)
    }

    /// Writes the coefficients of both runs, each as a function writes them for the rows of a run.
    #[inline(always)]
    pub(crate) fn write_all(
        &self,
        query: &impl Passes,
        coefficients: &mut [f64],
        write: impl Fn(&Self, &[[f64; 3]], &mut [f64]) -> Written,
    ) -> Written {
        query.over([&self.y, &self.z], |[first, second], range, [y, z]| {
            let combination = Self { y, z, ..*self };
            let (own, others) = coefficients[range].split_at_mut(first.len());
            write(&combination, first, own).with(&write(&combination, second, others))
        })
    }

    /// Writes the coefficients of some generators, a part at a time.
    #[inline]
    pub(crate) fn write<'a>(&self, parts: impl Iterator<Item = Part<'a>>) -> Written {
        match (self.lengths, self.factor == 0.0) {
            (Lengths::Own, false) => self.write_as::<true, false>(parts),
            (Lengths::Own, true) => self.write_as::<true, true>(parts),
            (Lengths::Even(_), false) => self.write_as::<false, false>(parts),
            (Lengths::Even(_), true) => self.write_as::<false, true>(parts),
        }
    }

    fn write_as<'a, const OWN: bool, const LINEAR: bool>(&self, parts: impl Iterator<Item = Part<'a>>) -> Written {
        let scale = 1.0 / self.lengths.scale();
        let [y, z] = [self.y, self.z].map(|vector| vector.map(|c| f64x2::splat(c * scale)));
        let (one, factor, limit) = (f64x2::splat(1.0), f64x2::splat(self.factor), f64x2::splat(self.limit));
        let (mut sum, mut sizes) = (Columns::default(), f64x2::default());
        let (mut written, mut fresh) = (Written::default(), 0);
        for (generators, places) in parts {
            let mut read = |v: Columns| {
                let scaled = if OWN {
                    let length = size(&v);
                    sizes += length;
                    let weight = one / length;
                    v.map(|c| weight * c)
                } else {
                    sizes += v[0].abs() + v[1].abs() + v[2].abs();
                    v
                };
                let mut coefficient = product(&scaled, &z);
                if !LINEAR {
                    let t = product(&scaled, &y);
                    coefficient = factor * clipped(t, one) + (coefficient & t.abs().simd_lt(one));
                }
                let coefficient = clipped(coefficient, limit);
                for (sum, c) in sum.iter_mut().zip(v) {
                    *sum += coefficient * c;
                }
                coefficient.to_array()
            };
            let (pairs, last) = generators.as_chunks::<2>();
            let (pair_places, last_place) = places.as_chunks_mut::<2>();
            for (pair, place) in pairs.iter().zip(pair_places) {
                *place = read(columns(*pair));
            }
            if let ([last], [place]) = (last, last_place) {
                *place = read(columns([*last, [0.0; 3]]))[0];
            }
            fresh += generators.len();
            if fresh >= BLOCK {
                written.add(&mut sum, &mut sizes, &mut fresh);
            }
        }
        written.add(&mut sum, &mut sizes, &mut fresh);
        written
    }
}

/// The number of additions that a term of the sum over `count` coefficients goes through; a part of at most `BLOCK`
/// is written at a time.
fn additions(count: usize) -> usize {
    BLOCK + count / BLOCK + 64
}

/// A bound of the distance of p from the exact sum of `count` generators with coefficients of at most 1, whose
/// computed sum is `sum`: each term is rounded, and each of the `additions` that a term goes through. `magnitude` is
/// at least Σ |v|.
#[inline]
pub(crate) fn rest(p: &BoundedVector, sum: &[f64; 3], additions: usize, magnitude: f64, count: usize) -> f64 {
    let off = |k: usize| (p[k].value - sum[k]).abs() + p[k].error;
    // a sum and not a maximum: NaN stays NaN
    (off(0) + off(1) + off(2) + UNIT * additions as f64 * magnitude + count as f64 * PRODUCT_UNDERFLOW) * LONG_SUM
}

/// Three generators whose coefficients stay within (−1, 1) when they make up for a rest of which no coordinate is
/// larger than `rest`.
///
/// Let r be that rest and a, b, c the three: the correction of the coefficient of a is r · (b × c) / a · (b × c).
#[inline]
pub(crate) fn correcting_basis(
    query: &impl EarlyQuery,
    coefficients: &[f64],
    rest: f64,
    magnitude: f64,
) -> Option<Vec<usize>> {
    let n = query.count();
    if n < 3 || !CUBABLE_SIZES.contains(&magnitude) {
        return None;
    }
    let any = [0, n / 2, n - 1];
    let mut basis = if corrects(query, any, coefficients, rest) {
        any
    } else {
        well_spread(n, |i| query.vector(i).0).filter(|basis| corrects(query, *basis, coefficients, rest))?
    };
    if !basis.is_sorted() {
        basis.sort_unstable();
    }
    Some(basis.to_vec())
}

/// Two generators that balance a rest in a plane, whose normal has only coordinates 0, 1 and −1.
///
/// With the normal n for the third vector of a basis the correction of the coefficient of a is r · (b × n) / a · (b ×
/// n), and that of n is zero.
pub(crate) fn correcting_pair(
    query: &Query<'_, 3>,
    plane: &SimplePlane,
    rest: f64,
    magnitude: f64,
) -> Option<Vec<usize>> {
    let [a, b] = plane.pair.map(|i| query.generator(i));
    let volume = sum_norm(&a) * sum_norm(&b) * sum_norm(&plane.normal);
    let determinant = dot(&a, &cross(&b, &plane.normal)).abs() - 8.0 * UNIT * volume - PRODUCT_UNDERFLOW;
    let longest = sum_norm(&a).max(sum_norm(&b)) * sum_norm(&plane.normal);
    let is_moderate = CUBABLE_SIZES.contains(&magnitude) && determinant > CUBABLE_SIZES.start * CUBABLE_SIZES.start;
    let corrects = rest * longest * LONG_SUM < (1.0 - WELL_WITHIN) * determinant;
    (is_moderate && corrects).then(|| plane.pair.to_vec())
}

/// Whether the coefficients of three generators stay within (−1, 1) when they balance a rest.
#[inline(always)]
fn corrects<Q: EarlyQuery>(query: &Q, basis: [usize; 3], coefficients: &[f64], rest: f64) -> bool {
    let [(a, first), (b, second), (c, third)] =
        [query.vector(basis[0]), query.vector(basis[1]), query.vector(basis[2])];
    let normal = cross(&b, &c);
    let lengths = [first, second, third];
    let volume = lengths[0] * lengths[1] * lengths[2];
    let determinant = dot(&a, &normal).abs() - Q::DETERMINANT_ERROR * volume - PRODUCT_UNDERFLOW;
    // false for NaN as well
    let is_spanning = determinant > CUBABLE_SIZES.start * CUBABLE_SIZES.start * CUBABLE_SIZES.start;
    if !is_spanning {
        return false;
    }
    // |b × c|_1 is at most |b|_1 |c|_1, and no coefficient is nearer to an end than WELL_WITHIN is
    let longest = lengths[0].max(lengths[1]).max(lengths[2]);
    if rest * longest * longest * LONG_SUM < (1.0 - WELL_WITHIN) * determinant {
        return true;
    }
    let normals = [normal, cross(&c, &a), cross(&a, &b)];
    (0..3).all(|k| {
        let across = sum_norm(&normals[k]) + Q::DETERMINANT_ERROR * volume / lengths[k] + PRODUCT_UNDERFLOW;
        coefficients[basis[k]].abs() + rest * across / determinant * LONG_SUM < 1.0
    })
}

/// Three of some generators: the longest, the one farthest from its line, the one farthest from the plane of both.
pub(crate) fn well_spread(count: usize, generator: impl Fn(usize) -> [f64; 3]) -> Option<[usize; 3]> {
    let step = count.div_ceil(BASIS_SAMPLE).max(1);
    let best = |key: &dyn Fn(&[f64; 3]) -> f64| {
        let keyed = (0..count).step_by(step).map(|i| (key(&generator(i)), i));
        keyed.fold((0.0, usize::MAX), |best, own| if own.0 > best.0 { own } else { best }).1
    };
    let first = best(&|v| dot(v, v));
    let a = (first != usize::MAX).then(|| generator(first))?;
    let second = best(&|v| {
        let product = cross(&a, v);
        dot(&product, &product)
    });
    let normal = (second != usize::MAX).then(|| cross(&a, &generator(second)))?;
    let third = best(&|v| dot(&normal, v).abs());
    (third != usize::MAX && third != first && third != second).then_some([first, second, third])
}
