//! The vector that a vertex leaves of λ p when the coefficients of its two generators are kept within [−1, 1].
//!
//! If these two are nearly parallel, their coefficients are not known well, and the vector that they leave is small
//! all the same.

use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, UNIT};

/// The vector g + δ_a v_a + δ_b v_b − μ p for δ_a and δ_b in [−1, 1] and μ near λ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rest {
    /// δ_a and δ_b.
    pub(crate) coefficients: [f64; 2],
    /// At least |r|_1, r being that vector.
    pub(super) size: f64,
    /// At least λ / μ − 1.
    pub(super) stretch: f64,
}

impl Rest {
    /// Of the optimum for sure, whose coefficients are within [−1, 1] and whose λ needs no bound but that by its ends.
    pub(super) fn of_sure_optimum(coefficients: [f64; 2]) -> Self {
        Self { coefficients, size: f64::INFINITY, stretch: f64::INFINITY }
    }

    /// From g, the two vectors, their coefficients, g · u and p · u.
    pub(super) fn new(
        sum: &BoundedVector,
        vectors: &[BoundedVector; 2],
        coefficients: [f64; 2],
        [reach, along]: [Bounded; 2],
        p: &BoundedVector,
    ) -> Self {
        let factor = reach.value / along.value;
        let mut coefficients = coefficients.map(|c| c.clamp(-1.0, 1.0));
        // one coefficient after the other, so that the second corrects the error of the first
        for (i, own) in vectors.iter().enumerate() {
            let [a, b] = vectors;
            let rest = |k: usize| {
                let value = a[k].value * coefficients[0] + b[k].value * coefficients[1];
                sum[k].value + value - p[k].value * factor
            };
            let rest = [rest(0), rest(1), rest(2)];
            let own = [own[0].value, own[1].value, own[2].value];
            let [part, square] = [&rest, &own].map(|v| dot(v, &own));
            coefficients[i] = (coefficients[i] - part / square).clamp(-1.0, 1.0);
        }
        let [first, second] = coefficients.map(Bounded::exact);
        let rest = |k: usize| sum[k] + vectors[0][k] * first + vectors[1][k] * second - p[k] * Bounded::exact(factor);
        let size = (rest(0).magnitude() + rest(1).magnitude() + rest(2).magnitude()) * FIVE_ROUNDINGS;
        // twice the relative error to first order, which covers the higher orders while it is small
        let off = reach.error / reach.value + along.error / along.value + 8.0 * UNIT;
        Self { coefficients, size, stretch: if off < 0.25 { 2.0 * off } else { f64::INFINITY } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::bounded::{approximate, exact};
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::linear::sum_norm;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The exact |g + δ_a v_a + δ_b v_b − μ p|_1 of doubles.
    fn exact_size(sum: &[f64; 3], [a, b]: &[[f64; 3]; 2], [first, second]: [f64; 2], factor: f64, p: &[f64; 3]) -> f64 {
        let of = Dyadic::from_f64;
        let rest = |k: usize| of(sum[k]) + of(a[k]) * of(first) + of(b[k]) * of(second) + of(-p[k]) * of(factor);
        (rest(0).abs() + rest(1).abs() + rest(2).abs()).to_f64()
    }

    #[test]
    fn the_size_is_that_of_what_the_coefficients_leave() {
        let random = &mut Pcg64Mcg::seed_from_u64(61);
        for round in 0..400 {
            let scale = [1.0, 1e-4, 1e4][round % 3];
            let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
            let (sum, p) = (vector(scale), vector(1.0));
            let vectors = [vector(scale), vector(scale)];
            let part = vector(1.0);
            let (reach, along) = (Bounded { value: 2.0 * scale, error: 0.0 }, Bounded { value: 3.0, error: 0.0 });
            let rest = Rest::new(&exact(sum), &vectors.map(exact), [part[0], 3.0 * part[1]], [reach, along], &exact(p));
            let own = exact_size(&sum, &vectors, rest.coefficients, reach.value / along.value, &p);
            assert!(rest.size >= own && rest.size <= own * (1.0 + 1e-12) + 1e-13 * scale, "{rest:?} {own}");
            assert!(rest.coefficients.iter().all(|c| c.abs() <= 1.0), "{rest:?}");
            // errors of the sum, the vectors and the displacement count as well
            let off = |v: [f64; 3]| approximate(v, 1e-6);
            let wide = Rest::new(&off(sum), &vectors.map(off), [part[0], 3.0 * part[1]], [reach, along], &off(p));
            let most = 6e-6 * (sum_norm(&sum) + sum_norm(&vectors[0]) + sum_norm(&vectors[1]) + scale * sum_norm(&p));
            assert!(wide.size > own + 1e-6 * sum_norm(&sum) && wide.size <= 1.001 * (own + most), "{wide:?} {own}");
        }
    }

    /// Each of two nearly parallel vectors corrects what the other one leaves along both.
    #[test]
    fn wrong_coefficients_of_nearly_parallel_vectors_leave_little() {
        let random = &mut Pcg64Mcg::seed_from_u64(62);
        for round in 0..200 {
            let scale = [1.0, 1e-4, 1e4][round % 3];
            let mut vector = |size: f64| [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0f64));
            let (a, small, p) = (vector(1.0), vector(1e-12), vector(1.0));
            let square = dot(&a, &a);
            if square < 0.1 {
                continue;
            }
            let vectors = [a, [0, 1, 2].map(|k| 0.5 * a[k] + small[k])].map(|v| v.map(|c| scale * c));
            let true_parts = [0.3, -0.4];
            // the factor is reach / along = 5 scale
            let sum =
                [0, 1, 2].map(|k| 5.0 * scale * p[k] - true_parts[0] * vectors[0][k] - true_parts[1] * vectors[1][k]);
            let (reach, along) = (Bounded::exact(10.0 * scale), Bounded::exact(2.0));
            let wrong = [0.3 + 0.25, -0.4 + 0.25];
            let rest = Rest::new(&exact(sum), &vectors.map(exact), wrong, [reach, along], &exact(p));
            assert!(rest.size < 1e-10 * scale, "{rest:?} {vectors:?}");
        }
    }

    #[test]
    fn the_stretch_is_at_least_what_errors_of_the_quotient_make_of_it() {
        let p = exact([1.0, 0.0, 0.0]);
        let of = |reach: Bounded, along: Bounded| {
            Rest::new(
                &exact([1.0, 0.0, 0.0]),
                &[exact([0.0, 1.0, 0.0]), exact([0.0, 0.0, 1.0])],
                [0.0; 2],
                [reach, along],
                &p,
            )
            .stretch
        };
        for size in [1.0, 1e-6, 1e6] {
            for length in [1.0, 1e-5, 1e5] {
                for (first, second) in [(0.0, 0.0), (1e-9, 0.0), (0.0, 1e-9), (1e-3, 1e-2), (0.1, 0.05)] {
                    let reach = Bounded { value: size, error: first * size };
                    let along = Bounded { value: length, error: second * length };
                    // λ is at most (1 + first) / (1 − second) times the quotient, which is rounded
                    let most = (1.0 + first) / (1.0 - second) - 1.0;
                    let stretch = of(reach, along);
                    assert!(stretch >= most * (1.0 + 1e-12) + UNIT, "{stretch} {first} {second}");
                    assert!(stretch <= 2.5 * most + 40.0 * UNIT, "{stretch} {first} {second}");
                }
                let wide = Bounded { value: size, error: 0.15 * size };
                assert_eq!(of(wide, Bounded { value: length, error: 0.15 * length }), f64::INFINITY);
            }
        }
    }
}
