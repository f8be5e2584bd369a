//! The size of the least coefficients where they are scaled up and clipped, as a sample of them shows.
//!
//! The least coefficients t_i = v_i · y of a point p, with (Σ v vᵀ) y = p, are too large where p is not well inside.
//! Those of α y, clipped to [−1, 1], sum up to about r(α) p with r(α) = Σ clip(α t_i) t_i / Σ t_i², as the clipped sum
//! has nearly the direction of p in a body that is nearly round. So one equation in one unknown tells where Newton
//! steps are to start, and mostly spares them. Both sums of the quotient are over the same sample, so that its error is
//! far below that of either.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Carried;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::{Number, clipped, product};
use crate::numeric::lanes::octet::{self, LANES, splat, total};
use crate::numeric::lanes::rows::Runs;

/// The number of octets of generators in a sample, or nearly.
const SAMPLE: usize = 16;

/// Steps on the equation. Each starts below its root, and so does the next one, as r is concave.
const STEPS: usize = 5;

/// A step's slope is at least this part of that at α = 0.
const LEAST_SLOPE: f64 = 1e-3;

/// Products t of generators from all over the list with one vector.
pub(super) struct ScaledProducts {
    products: [[f64; LANES]; 2 * SAMPLE],
    sums: Sums,
}

/// Sums over the sample.
#[derive(Debug, Clone, Copy)]
struct Sums {
    octets: usize,
    /// Σ t².
    squares: f64,
    /// Σ |t|.
    reach: f64,
    /// The largest |t|.
    largest: f64,
}

impl Carried for Sums {
    #[inline]
    fn carried(self, _: &Frame<'_>) -> Self {
        self
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        Self {
            octets: self.octets + other.octets,
            squares: self.squares + other.squares,
            reach: self.reach + other.reach,
            largest: self.largest.max(other.largest),
        }
    }
}

impl ScaledProducts {
    /// The products of a sample with y.
    #[inline]
    pub(super) fn of(query: &impl KernelQuery, y: &[f64; 3]) -> Self {
        let mut products = [[0.0; LANES]; 2 * SAMPLE];
        let mut places = &mut products[..];
        let step = (query.len() / (SAMPLE * LANES)).max(1);
        let sums = query.over([y], |runs, _, [y]| {
            let sums = dispatch!(level(), simd => read(simd, runs, &y, step, places));
            places = &mut std::mem::take(&mut places)[sums.octets..];
            sums
        });
        Self { products, sums }
    }

    /// The number of generators in the sample.
    pub(super) fn count(&self) -> usize {
        LANES * self.sums.octets
    }

    /// Σ t² / Σ |t|, which is the gauge of p if y is the direction in which p is farthest out.
    pub(super) fn gauge(&self) -> f64 {
        self.sums.squares / self.sums.reach
    }

    /// The largest |t|.
    pub(super) fn largest(&self) -> f64 {
        self.sums.largest
    }

    /// The α at which r(α) is what is wanted, at least 1.
    pub(super) fn factor(&self, wanted: f64) -> f64 {
        let products = &self.products[..self.sums.octets];
        dispatch!(level(), simd => factor(simd, products, self.sums.squares, wanted))
    }
}

/// Writes the products of every `step`-th octet.
#[inline(always)]
fn read<S: Simd>(simd: S, runs: Runs<'_>, y: &[f64; 3], step: usize, places: &mut [[f64; LANES]]) -> Sums {
    let (y, zero) = (splat(simd, y), f64x8::splat(simd, 0.0));
    let (mut squares, mut reach, mut largest) = (zero, zero, zero);
    let mut places = places.iter_mut();
    let all = places.len();
    for run in runs {
        let (octets, _) = run.octets().whole_and_rest();
        for (k, place) in (0..octets.len()).step_by(step).zip(&mut places) {
            let t = product(&octets.load(simd, k), &y);
            t.store_slice(place);
            squares += t * t;
            reach += t.magnitude();
            largest = largest.larger(t.magnitude());
        }
    }
    let octets = all - places.len();
    Sums { octets, squares: total(squares), reach: total(reach), largest: octet::largest(largest) }
}

/// The root, by steps of Newton's method.
#[inline(always)]
fn factor<S: Simd>(simd: S, products: &[[f64; LANES]], squares: f64, wanted: f64) -> f64 {
    let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
    let mut factor = 1.0;
    for _ in 0..STEPS {
        let alpha = f64x8::splat(simd, factor);
        let (mut sum, mut slope) = (zero, zero);
        for t in products {
            let t = f64x8::from_slice(simd, t);
            let scaled = alpha * t;
            sum += clipped(scaled, one) * t;
            slope += scaled.magnitude().if_less(one, t * t, zero);
        }
        factor += (wanted * squares - total(sum)) / total(slope).max(LEAST_SLOPE * squares);
    }
    factor
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Query;
    use crate::numeric::linear::dot;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn the_clipped_sum_is_the_one_that_was_wanted() {
        let random = &mut Pcg64Mcg::seed_from_u64(11);
        let body: Vec<[f64; 3]> = (0..2000).map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0))).collect();
        let (y, query) = ([0.7, -0.4, 0.5], Query::new([0.0; 3], [0.0; 3], &body).expect("finite"));
        let products = ScaledProducts::of(&query, &y);
        let sample: Vec<f64> = products.products[..products.sums.octets].as_flattened().to_vec();
        assert!(sample.len() >= 100 && sample.iter().all(|t| body.iter().any(|v| (dot(v, &y) - t).abs() < 1e-12)));
        let [squares, reach] = [sample.iter().map(|t| t * t).sum::<f64>(), sample.iter().map(|t| t.abs()).sum()];
        assert!((products.gauge() - squares / reach).abs() < 1e-12);
        assert_eq!(products.largest(), sample.iter().fold(0.0, |m: f64, t| m.max(t.abs())));
        for wanted in [1.0, 1.1, 1.3] {
            let alpha = products.factor(wanted);
            let sum: f64 = sample.iter().map(|t| (alpha * t).clamp(-1.0, 1.0) * t).sum();
            assert!(alpha >= 1.0 && (sum / squares - wanted).abs() < 0.01, "{wanted}: {}", sum / squares);
        }
    }
}
