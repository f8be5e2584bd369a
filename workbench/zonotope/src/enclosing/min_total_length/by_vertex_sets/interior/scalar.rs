//! The scalar of the interior-point method: doubles, or pairs of doubles where doubles are not precise enough.

use std::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

use crate::numeric::double_double::DoubleDouble;

/// This many rows are multiplied with two others at once.
pub(in crate::enclosing::min_total_length::by_vertex_sets) const BLOCK: usize = 4;

/// A floating-point number.
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
    /// A pivot below this, relative to its diagonal entry, is what rounding left of zero.
    const PIVOT_TOLERANCE: f64;

    /// The cost of a product and a sum, relative to those of doubles.
    const RELATIVE_COST: f64;

    fn sqrt(self) -> Self;

    /// The nearest double.
    fn value(self) -> f64;

    /// The products of some rows with two others, all of the same even length.
    fn products(rows: [&[Self]; BLOCK], others: [&[Self]; 2]) -> [[Self; 2]; BLOCK] {
        rows.map(|row| others.map(|other| Self::product(row, other)))
    }

    /// The dot product of two rows of equal length.
    fn product(a: &[Self], b: &[Self]) -> Self {
        a.iter().zip(b).fold(Self::from(0.0), |sum, (a, b)| sum + *a * *b)
    }
}

impl Scalar for DoubleDouble {
    const PIVOT_TOLERANCE: f64 = 1e-30;
    const RELATIVE_COST: f64 = 50.0;

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn value(self) -> f64 {
        self.high
    }
}

impl Scalar for f64 {
    const PIVOT_TOLERANCE: f64 = 1e-15;
    const RELATIVE_COST: f64 = 1.0;

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

    /// The dot product, in eight partial sums.
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
