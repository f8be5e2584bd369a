//! The random source that every generator draws from: a seeded PCG with the few distributions that are needed.
//!
//! The distributions are written out here so that an instance depends on this file, on the generator and on `libm`
//! alone, and never on how a library version chooses to turn words into floats.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use std::f64::consts::TAU;

/// 2^-53: the spacing of the floats that `unit` returns.
const UNIT_STEP: f64 = 1.0 / 9_007_199_254_740_992.0;

/// A deterministic stream of random numbers.
pub struct RandomSource(Pcg64Mcg);

impl RandomSource {
    /// The stream that belongs to `seed`.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * UNIT_STEP
    }

    /// Uniform in [-1, 1).
    pub fn signed_unit(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Uniform among 0 .. `bound`, for `bound` at least 1 (the bias is below `bound` / 2^64).
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }

    /// A uniformly random unit vector, up to rounding.
    pub fn unit_vector(&mut self) -> [f64; 2] {
        let (sin, cos) = libm::sincos(TAU * self.unit());
        [cos, sin]
    }

    /// Two independent standard normal numbers (Box and Muller).
    pub fn normal_pair(&mut self) -> [f64; 2] {
        let radius = (-2.0 * libm::log(1.0 - self.unit())).sqrt();
        let [cos, sin] = self.unit_vector();
        [radius * cos, radius * sin]
    }

    /// A uniform point of the closed unit disc.
    pub fn disc_point(&mut self) -> [f64; 2] {
        loop {
            let point = [self.signed_unit(), self.signed_unit()];
            if point[0] * point[0] + point[1] * point[1] <= 1.0 {
                return point;
            }
        }
    }

    /// Puts `items` into a uniformly random order (Fisher and Yates).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}
