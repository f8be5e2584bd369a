//! Numbers that the steps are taken in: doubles, or pairs of doubles where rounding ends those.

use std::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

use crate::numeric::double_double::DoubleDouble;

/// Rows whose products with two others are summed side by side.
pub(in crate::enclosing::min_total_length::by_vertex_sets) const BLOCK: usize = 4;

/// A number with rounding.
pub(in crate::enclosing::min_total_length::by_vertex_sets) trait Scalar:
    Copy
    + PartialOrd
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// What is left of a number by rounding alone, beside it.
    const NOTHING: f64;

    /// How dear a product and a sum are, beside those of doubles.
    const WORK: f64;

    fn sqrt(self) -> Self;

    /// The nearest double.
    fn value(self) -> f64;

    /// The sums of products of some rows with two others, of even length.
    fn products(rows: [&[Self]; BLOCK], others: [&[Self]; 2]) -> [[Self; 2]; BLOCK] {
        rows.map(|row| others.map(|other| Self::product(row, other)))
    }

    /// The sum of products.
    fn product(a: &[Self], b: &[Self]) -> Self {
        a.iter().zip(b).fold(Self::from(0.0), |sum, (a, b)| sum + *a * *b)
    }
}

impl Scalar for DoubleDouble {
    const NOTHING: f64 = 1e-30;
    const WORK: f64 = 50.0;

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn value(self) -> f64 {
        self.high
    }
}

impl Scalar for f64 {
    const NOTHING: f64 = 1e-15;
    const WORK: f64 = 1.0;

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn value(self) -> f64 {
        self
    }

    fn products([p, q, r, s]: [&[f64]; BLOCK], [a, b]: [&[f64]; 2]) -> [[f64; 2]; BLOCK] {
        let mut sums = [[f64x2::ZERO; 2]; BLOCK];
        let [p, q, r, s, a, b] = [p, q, r, s, a, b].map(|row| row.as_chunks::<2>().0);
        for (((((p, q), r), s), a), b) in p.iter().zip(q).zip(r).zip(s).zip(a).zip(b) {
            let (a, b) = (f64x2::from(*a), f64x2::from(*b));
            for (sums, row) in sums.iter_mut().zip([p, q, r, s]) {
                let row = f64x2::from(*row);
                sums[0] += row * a;
                sums[1] += row * b;
            }
        }
        sums.map(|pair| pair.map(|sum| sum.to_array().iter().sum()))
    }

    /// In eight partial sums.
    fn product(a: &[f64], b: &[f64]) -> f64 {
        let (mut a, mut b) = (a.chunks_exact(8), b.chunks_exact(8));
        let mut sums = [0.0; 8];
        for (x, y) in a.by_ref().zip(b.by_ref()) {
            for i in 0..8 {
                sums[i] += x[i] * y[i];
            }
        }
        let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(x, y)| x * y).sum();
        sums.iter().sum::<f64>() + rest
    }
}

pub(in crate::enclosing::min_total_length::by_vertex_sets) fn zero<R: Scalar, const D: usize>() -> [R; D] {
    [R::from(0.0); D]
}

/// A vector of doubles.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn real<R: Scalar, const D: usize>(v: &[f64; D]) -> [R; D] {
    v.map(R::from)
}

/// The nearest doubles.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn values<R: Scalar, const D: usize>(
    v: &[R; D],
) -> [f64; D] {
    v.map(R::value)
}

/// a · b.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn dot<R: Scalar, const D: usize>(
    a: &[R; D],
    b: &[R; D],
) -> R {
    a.iter().zip(b).fold(R::from(0.0), |sum, (a, b)| sum + *a * *b)
}

/// a + factor · b.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn plus<R: Scalar, const D: usize>(
    a: &[R; D],
    factor: R,
    b: &[R; D],
) -> [R; D] {
    std::array::from_fn(|c| a[c] + factor * b[c])
}
