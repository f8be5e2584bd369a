//! Coefficients that make up a point well within the body: those of least size, with the largest ones clipped.
//!
//! Let l_i = |v_i|_∞, the largest magnitude of a coordinate, t_i = v_i · y / l_i, and b_i the t_i clipped to [−1, 1].
//! The y with Σ b_i v_i = q minimises a convex function, Σ l_i huber(t_i) − q · y, whose Hessian is H = Σ v_i v_iᵀ /
//! l_i over the generators that are not clipped. Such a y exists just if q is in the body; else y goes to infinity
//! where a direction separates. From any y, with s = Σ b_i v_i, the coefficients f b_i, and v_i · z / l_i more where
//! nothing was clipped, combine to p = f s + H z, and none is larger than f + |z|_1. Where lengths are even, the
//! longest length takes the place of all, which spares a division for each generator.
//!
//! All this only finds coefficients (`combination` writes and proves them).

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::part::Carried;
use crate::numeric::lanes::body_sums::{add_square, sizes, squares, weighted};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, Units, product};
use crate::numeric::lanes::octet::{self, LANES, splat, total};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::lanes::rows::{Runs, count_of};
use crate::numeric::linear::{SymmetricMatrix, dot, sum_norm};

/// No coefficient is nearer to ±1 than this leaves room for.
pub(crate) const WELL_WITHIN: f64 = 0.9999;

/// The factor by which the coefficients of all generators are taken to exceed those of some.
pub(crate) const SAMPLE_MARGIN: f64 = 1.15;

/// The most by which clipped coefficients may move where a part of them need not be exact.
pub(crate) const ROUGH_EXCESS: f64 = 0.3;

/// Lengths are even if the longest is no longer than this, in terms of the mean.
const EVEN_LENGTHS: f64 = 4.0;

/// Sums over generators at some y.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moments {
    /// H.
    pub(crate) hessian: SymmetricMatrix,
    /// s.
    pub(crate) sum: [f64; 3],
    /// Σ |v · y|.
    pub(crate) reach: f64,
}

/// The divisor of a product with a generator: its own length, or one for all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lengths {
    Own,
    Even(f64),
}

impl Lengths {
    /// The length of the longest generator, if they are even; of posed bodies, that of the longest row.
    #[inline(always)]
    pub(crate) fn of(generators: &impl Generators) -> Self {
        generators.over([], |runs, _, []| Self::of_runs(runs))
    }

    fn of_runs(runs: Runs<'_>) -> Self {
        let [longest, sum] = sizes(runs);
        if longest * count_of(runs) as f64 <= EVEN_LENGTHS * sum { Self::Even(longest) } else { Self::Own }
    }

    /// An upper bound of (v · z) / l: for any v, or for even generators by those of some, with room for others.
    #[inline(always)]
    pub(crate) fn largest(self, among: Among<'_>, generators: &impl Generators, z: &[f64; 3]) -> f64 {
        match among {
            Among::Sample(few) => self.largest_of(Rows::new(few), z),
            Among::First(count) => {
                let first = |run: Rows<'_>, z| Largest(self.largest_of(run.part(0..run.len().min(count)), &z));
                generators.over([z], |[run, _], _, [z]| first(run, z)).0
            }
        }
    }

    fn largest_of(self, among: Rows<'_>, z: &[f64; 3]) -> f64 {
        let Self::Even(longest) = self else { return sum_norm(z).min((3.0 * dot(z, z)).sqrt()) };
        SAMPLE_MARGIN * dispatch!(level(), simd => largest_product(simd, among, z)) / longest
    }

    /// The length by which products are divided before they are clipped; 1 where each is divided by its own.
    pub(crate) fn scale(self) -> f64 {
        match self {
            Self::Own => 1.0,
            Self::Even(length) => length,
        }
    }
}

/// The generators by which the largest coefficient is estimated.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Among<'a> {
    /// A sample of all.
    Sample(&'a [[f64; 3]]),
    /// The first ones of the first run, at most this many.
    First(usize),
}

/// The largest of some numbers.
struct Largest(f64);

impl Carried for Largest {
    #[inline]
    fn carried(self, _: &Frame<'_>) -> Self {
        self
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
}

impl Carried for Lengths {
    #[inline]
    fn carried(self, _: &Frame<'_>) -> Self {
        self
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        match (self, other) {
            (Self::Even(first), Self::Even(second)) => Self::Even(first.max(second)),
            _ => Self::Own,
        }
    }
}

/// The largest |v · z|.
#[inline(always)]
fn largest_product<S: Simd>(simd: S, vectors: Rows<'_>, z: &[f64; 3]) -> f64 {
    let (wide, octets) = (splat(simd, z), vectors.octets());
    let mut largest = f64x8::splat(simd, 0.0);
    for k in 0..octets.len() {
        let along = product(&octets.load(simd, k), &wide).magnitude();
        // a product that is not a number is passed over
        largest = largest.if_less(along, along, largest);
    }
    octet::largest(largest)
}

/// Sums over generators, in lanes or not.
struct Sums<T> {
    hessian: [T; 6],
    sum: [T; 3],
    reach: T,
}

impl<T: Number> Sums<T> {
    #[inline(always)]
    fn new(units: &Units<T>) -> Self {
        Self { hessian: [units.zero; 6], sum: [units.zero; 3], reach: units.zero }
    }

    /// Adds generators; y is scaled where lengths are not their own.
    #[inline(always)]
    fn read<const OWN: bool>(&mut self, units: &Units<T>, v: &[T; 3], y: &[T; 3]) {
        let mut scaled = weighted::<_, OWN>(v, units);
        let t = product(&scaled, y);
        let magnitude = t.magnitude();
        let coefficient = magnitude.if_less(units.one, t, units.one.signed_as(t));
        for k in 0..3 {
            self.sum[k] += coefficient * v[k];
            scaled[k] = magnitude.if_less(units.one, scaled[k], units.zero);
        }
        self.reach += if OWN { product(v, y) } else { t }.magnitude();
        add_square(&mut self.hessian, &scaled, v);
    }
}

/// The sums over all rows with one length, or with their own.
#[inline(always)]
fn moments<S: Simd, const OWN: bool>(simd: S, (runs, share): (Runs<'_>, usize), y: &[f64; 3], length: f64) -> Moments {
    let y = [y[0] / length, y[1] / length, y[2] / length];
    let (wide, units) = (splat(simd, &y), Units::wide(simd));
    let (mut sums, mut few) = (Sums::new(&units), Sums::new(&Units::SINGLE));
    for run in runs {
        let (octets, rest) = run.octets().whole_and_rest();
        for k in (share - 1..octets.len()).step_by(share) {
            sums.read::<OWN>(&units, &octets.load(simd, k), &wide);
        }
        // the octet that is not full has its turn as well
        let rest = if octets.len() % share == share - 1 { rest } else { &[] };
        for v in rest {
            few.read::<OWN>(&Units::SINGLE, v, &y);
        }
    }
    if count_of(runs) >= LANES {
        for k in 0..6 {
            few.hessian[k] += total(sums.hessian[k]);
        }
        for k in 0..3 {
            few.sum[k] += total(sums.sum[k]);
        }
        few.reach += total(sums.reach);
    }
    Moments { hessian: divided(few.hessian, length), sum: few.sum, reach: few.reach * length }
}

#[inline(always)]
fn divided([xx, xy, xz, yy, yz, zz]: [f64; 6], length: f64) -> SymmetricMatrix {
    SymmetricMatrix([xx / length, xy / length, xz / length, yy / length, yz / length, zz / length])
}

/// Σ v vᵀ / l, which is H at y = 0, where no coefficient is clipped.
#[inline(always)]
pub(crate) fn hessian_at_zero(generators: &impl Generators, lengths: Lengths) -> SymmetricMatrix {
    generators.over([], |runs, _, []| match lengths {
        Lengths::Own => SymmetricMatrix(squares::<true>(runs)),
        Lengths::Even(length) => divided(squares::<false>(runs), length),
    })
}

impl Moments {
    /// The sums at some y.
    #[inline(always)]
    pub(crate) fn at<G: Generators>(generators: &G, lengths: Lengths, y: &[f64; 3]) -> Self {
        generators.over([y], |runs, _, [y]| {
            let read = (runs, G::share());
            match lengths {
                Lengths::Own => dispatch!(level(), simd => moments::<_, true>(simd, read, &y, 1.0)),
                Lengths::Even(length) => dispatch!(level(), simd => moments::<_, false>(simd, read, &y, length)),
            }
        })
    }

    /// The slope of the smooth problem along a step.
    pub(crate) fn slope(&self, step: &[f64; 3], target: &[f64; 3]) -> f64 {
        dot(&self.sum, step) - dot(target, step)
    }

    /// The Newton step towards a target.
    pub(crate) fn step(&self, target: &[f64; 3]) -> [f64; 3] {
        self.hessian.solve(&[0, 1, 2].map(|k| target[k] - self.sum[k])).0
    }
}

impl Carried for SymmetricMatrix {
    #[inline]
    fn carried(self, frame: &Frame<'_>) -> Self {
        frame.congruent(&self)
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        self.plus(&other)
    }
}

impl Carried for Moments {
    #[inline]
    fn carried(self, frame: &Frame<'_>) -> Self {
        Self { hessian: frame.congruent(&self.hessian), sum: frame.image(&self.sum), reach: self.reach }
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        Self {
            hessian: self.hessian.plus(&other.hessian),
            sum: [0, 1, 2].map(|k| self.sum[k] + other.sum[k]),
            reach: self.reach + other.reach,
        }
    }
}
