//! Coefficients in terms of a solution of the smooth problem: written, summed up, and proved as they stand.
//!
//! The sum of the written combination is known but for rounding. Its distance from the point, and all rounding
//! errors, are small: three generators that span space can balance them, whatever they are, if their coefficients
//! have a little room.

use std::ops::Range;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::collision::Witness;
use crate::collision::by_lad::early::correcting_basis::correcting_basis;
use crate::collision::by_lad::early::huber_dual::{Among, Lengths, Moments, ROUGH_EXCESS, WELL_WITHIN};
use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Carried;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, Units, product, size};
use crate::numeric::lanes::octet::{LANES, Octet, reordered, splat, store_first, total, totals};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNIT};

/// Generators whose sums are taken together, so that a term goes through few additions.
const BLOCK: usize = 512;

/// Memory for fewer coefficients is cleared when it is taken, for more when it is first touched.
const CLEARED_WHEN_TAKEN: usize = 1 << 14;

/// Coefficients as functions of the generators: that of v is clip(v · y / l) times the factor f, and v · z / l more
/// where nothing was clipped; the header of `huber_dual` says why these combine to a point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Combination {
    y: [f64; 3],
    z: [f64; 3],
    /// f; with 0 the coefficients are products with z alone.
    factor: f64,
    /// The lengths l by which products are divided.
    lengths: Lengths,
    /// The bound to which coefficients are clipped in the end.
    limit: f64,
}

/// The rows of a run to which one pass gives coefficients: of every `period` rows in succession those at the places of
/// a range. All numbers are multiples of [`LANES`].
#[derive(Debug, Clone)]
pub(crate) struct Stretches {
    pub(crate) period: usize,
    pub(crate) range: Range<usize>,
}

impl Stretches {
    const ALL: Self = Self { period: BLOCK, range: 0..BLOCK };
}

/// Sums over coefficients that were written.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Written {
    /// Σ c v.
    pub(crate) sum: [f64; 3],
    /// At least Σ |v|_∞.
    pub(crate) magnitude: f64,
    pub(crate) count: usize,
}

impl Written {
    pub(crate) fn with(&self, other: &Self) -> Self {
        let sum = [0, 1, 2].map(|k| self.sum[k] + other.sum[k]);
        Self { sum, magnitude: self.magnitude + other.magnitude, count: self.count + other.count }
    }

    /// The proof with these coefficients, if three of them can correct what they are off by.
    pub(crate) fn witness(
        &self,
        query: &impl KernelQuery,
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
    fn carried(self, frame: &Frame<'_>) -> Self {
        Self { sum: frame.image(&self.sum), magnitude: frame.carried_magnitude(self.magnitude), count: self.count }
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
        generators: &impl Generators,
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
        let z = self.hessian.solve_regular(&[0, 1, 2].map(|k| p[k] - factor * self.sum[k]))?;
        let room = if exact { WELL_WITHIN - factor } else { ROUGH_EXCESS };
        (lengths.largest(among, generators, &z) <= room).then(|| Combination::new(y, z, factor, lengths))
    }
}

impl Combination {
    /// The least coefficients that combine to p, where H z = p for all generators; `None` if, seen from some
    /// generators, they are likely to be too large, or, where they need not be `exact`, much too large.
    pub(crate) fn least(
        generators: &impl Generators,
        z: [f64; 3],
        lengths: Lengths,
        among: Among<'_>,
        exact: bool,
    ) -> Option<Self> {
        let limit = if exact { WELL_WITHIN } else { WELL_WITHIN + ROUGH_EXCESS };
        (lengths.largest(among, generators, &z) <= limit).then_some(Self::linear(z, lengths))
    }

    pub(crate) fn linear(z: [f64; 3], lengths: Lengths) -> Self {
        Self::new(&[0.0; 3], z, 0.0, lengths)
    }

    pub(crate) fn new(y: &[f64; 3], z: [f64; 3], factor: f64, lengths: Lengths) -> Self {
        Self { y: *y, z, factor, lengths, limit: WELL_WITHIN }
    }

    /// Products with z, clipped.
    pub(crate) fn clipped(z: &[f64; 3], lengths: Lengths, limit: f64) -> Self {
        Self { limit, ..Self::linear(*z, lengths) }
    }

    /// Nearly the same coefficients with one product for each: those of f y + z, clipped to f.
    pub(crate) fn merged(&self) -> Self {
        if self.factor == 0.0 {
            return *self;
        }
        let z = [0, 1, 2].map(|k| self.factor * self.y[k] + self.z[k]);
        Self { limit: self.factor, ..Self::linear(z, self.lengths) }
    }

    /// The proof that p is inside, if the coefficients combine to p but for a rest that three of them can balance.
    pub(crate) fn witness(&self, query: &impl KernelQuery, p: &BoundedVector) -> Option<Witness> {
        let n = query.len();
        let mut coefficients = if n < CLEARED_WHEN_TAKEN { Vec::with_capacity(n) } else { vec![0.0; n] };
        coefficients.resize(n, 0.0);
        let all = self.write_all(query, &Stretches::ALL, &mut coefficients);
        all.witness(query, p, coefficients)
    }

    /// Writes the coefficients of the rows of some stretches of both runs.
    #[inline(always)]
    pub(crate) fn write_all(
        &self,
        query: &impl Generators,
        stretches: &Stretches,
        coefficients: &mut [f64],
    ) -> Written {
        query.over([&self.y, &self.z], |[first, second], range, [y, z]| {
            let combination = Self { y, z, ..*self };
            let (own, others) = coefficients[range].split_at_mut(first.len());
            combination.write(first, stretches, own).with(&combination.write(second, stretches, others))
        })
    }

    fn write(&self, rows: Rows<'_>, stretches: &Stretches, places: &mut [f64]) -> Written {
        let (at, is_linear) = ((rows, stretches), self.factor == 0.0);
        let level = level();
        match (self.lengths, rows.sums()) {
            (Lengths::Own, _) if is_linear => {
                dispatch!(level, simd => write::<_, true, true, true>(simd, self, at, places))
            }
            (Lengths::Own, _) => dispatch!(level, simd => write::<_, true, false, true>(simd, self, at, places)),
            (Lengths::Even(_), None) if is_linear => {
                dispatch!(level, simd => write::<_, false, true, true>(simd, self, at, places))
            }
            (Lengths::Even(_), None) => {
                dispatch!(level, simd => write::<_, false, false, true>(simd, self, at, places))
            }
            (Lengths::Even(_), Some(sums)) => {
                let written = if is_linear {
                    dispatch!(level, simd => write::<_, false, true, false>(simd, self, at, places))
                } else {
                    dispatch!(level, simd => write::<_, false, false, false>(simd, self, at, places))
                };
                Written { magnitude: sums.magnitude(), ..written }
            }
        }
    }
}

/// A combination in all lanes.
struct Wide<S: Simd> {
    y: Octet<S>,
    z: Octet<S>,
    factor: f64x8<S>,
    limit: f64x8<S>,
    least: f64x8<S>,
    units: Units<f64x8<S>>,
}

impl<S: Simd> Wide<S> {
    /// The coefficients of eight generators, and their lengths.
    #[inline(always)]
    fn coefficients<const OWN: bool, const LINEAR: bool>(&self, v: &Octet<S>) -> [f64x8<S>; 2] {
        let Units { zero, one, .. } = self.units;
        let (mut scaled, mut length) = (*v, v[0].magnitude() + v[1].magnitude() + v[2].magnitude());
        if OWN {
            length = size(v, &self.units);
            let weight = one / length;
            scaled = [weight * v[0], weight * v[1], weight * v[2]];
        }
        let mut coefficient = product(&scaled, &self.z);
        if !LINEAR {
            let t = product(&scaled, &self.y);
            let magnitude = t.magnitude();
            let others = magnitude.if_less(one, coefficient, zero);
            coefficient = self.factor * magnitude.if_less(one, t, one.signed_as(t)) + others;
        }
        [coefficient.min(self.limit).max(self.least), length]
    }
}

/// Writes coefficients and sums them up, about [`BLOCK`] of them at a time.
#[inline(always)]
fn write<S: Simd, const OWN: bool, const LINEAR: bool, const SIZED: bool>(
    simd: S,
    combination: &Combination,
    (rows, stretches): (Rows<'_>, &Stretches),
    places: &mut [f64],
) -> Written {
    let scale = 1.0 / combination.lengths.scale();
    let [y, z] = [combination.y, combination.z].map(|vector| vector.map(|c| c * scale));
    let wide = Wide::<S> {
        y: splat(simd, &y),
        z: splat(simd, &z),
        factor: f64x8::splat(simd, combination.factor),
        limit: f64x8::splat(simd, combination.limit),
        least: f64x8::splat(simd, -combination.limit),
        units: Units::wide(simd),
    };
    let (mut sums, mut fresh) = (WideSums::new(simd), 0);
    let mut written = Written::default();
    let octets = rows.octets();
    let (whole, last) = places.as_chunks_mut::<LANES>();
    for start in (0..rows.len()).step_by(stretches.period) {
        let [first, end] = [stretches.range.start, stretches.range.end].map(|place| (start + place) / LANES);
        let own = first.min(whole.len())..end.min(whole.len());
        fresh += LANES * own.len();
        match rows.blocks() {
            Some(blocks) => {
                for (place, block) in whole[own.clone()].iter_mut().zip(&blocks[own]) {
                    sums.read::<OWN, LINEAR, SIZED>(simd, &wide, &block.load(simd)).store_slice(place);
                }
            }
            None => {
                for k in own {
                    let octet = octets.load(simd, k);
                    sums.read::<OWN, LINEAR, SIZED>(simd, &wide, &octet).store_slice(&mut whole[k]);
                }
            }
        }
        if !last.is_empty() && (first..end).contains(&whole.len()) {
            let octet = octets.load(simd, whole.len());
            store_first(sums.read::<OWN, LINEAR, SIZED>(simd, &wide, &octet), last);
            fresh += last.len();
        }
        if fresh >= BLOCK {
            written = written.with(&sums.total(fresh));
            (sums, fresh) = (WideSums::new(simd), 0);
        }
    }
    written.with(&sums.total(fresh))
}

/// Sums over coefficients in lanes.
struct WideSums<S: Simd> {
    sum: Octet<S>,
    sizes: f64x8<S>,
}

impl<S: Simd> WideSums<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        let zero = f64x8::splat(simd, 0.0);
        Self { sum: [zero; 3], sizes: zero }
    }

    /// The coefficients of eight generators, in the order of their rows.
    #[inline(always)]
    fn read<const OWN: bool, const LINEAR: bool, const SIZED: bool>(
        &mut self,
        simd: S,
        wide: &Wide<S>,
        v: &Octet<S>,
    ) -> f64x8<S> {
        let [coefficient, length] = wide.coefficients::<OWN, LINEAR>(v);
        for (sum, c) in self.sum.iter_mut().zip(v) {
            *sum += coefficient * *c;
        }
        if SIZED {
            self.sizes += length;
        }
        reordered(simd, coefficient)
    }

    #[inline(always)]
    fn total(&self, count: usize) -> Written {
        Written { sum: totals(&self.sum), magnitude: total(self.sizes), count }
    }
}

/// The number of additions that a term of the sum over `count` coefficients goes through; a part of at most `BLOCK`
/// is written at a time.
fn additions(count: usize) -> usize {
    BLOCK + count / BLOCK + 64
}

/// A bound of the distance of p from the exact sum of `count` generators with coefficients of at most 1, whose
/// computed sum is `sum`: each term is rounded, and each of the `additions` that a term goes through. `magnitude` is
/// at least Σ |v|_∞.
#[inline]
pub(crate) fn rest(p: &BoundedVector, sum: &[f64; 3], additions: usize, magnitude: f64, count: usize) -> f64 {
    let off = |k: usize| (p[k].value - sum[k]).abs() + p[k].error;
    // a sum and not a maximum: NaN stays NaN
    (off(0) + off(1) + off(2) + UNIT * additions as f64 * magnitude + count as f64 * PRODUCT_UNDERFLOW) * LONG_SUM
}
