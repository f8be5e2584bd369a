//! The scalar of the interior-point method: doubles, or pairs of doubles where doubles are not precise enough.

use std::ops::{Add, Div, Mul, Neg, Sub};

use wide::f64x2;

use crate::numeric::double_double::DoubleDouble;

/// The number of rows in a block whose products with two other rows are computed at once.
pub(in crate::enclosing::min_total_length::by_vertex_sets) const BLOCK: usize = 4;

/// A floating-point number in which the interior-point method computes.
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
    /// A pivot below this, relative to its diagonal entry, counts as zero: it is the rounding error of one.
    const PIVOT_TOLERANCE: f64;

    /// The cost of a multiplication and an addition, relative to that for doubles.
    const RELATIVE_COST: f64;

    /// The square root.
    fn sqrt(self) -> Self;

    /// The nearest double.
    fn value(self) -> f64;

    /// The dot products of the rows of a block with two other rows, all of the same even length.
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

    /// The dot product of two rows of equal length, in eight partial sums, which the processor can take side by side.
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

/// The zero vector.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn zero<R: Scalar, const D: usize>() -> [R; D] {
    [R::from(0.0); D]
}

/// A vector of doubles as a vector of scalars.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn real<R: Scalar, const D: usize>(v: &[f64; D]) -> [R; D] {
    v.map(R::from)
}

/// The doubles nearest to the scalars of a vector.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn values<R: Scalar, const D: usize>(
    v: &[R; D],
) -> [f64; D] {
    v.map(R::value)
}

/// The dot product a · b.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn dot<R: Scalar, const D: usize>(
    a: &[R; D],
    b: &[R; D],
) -> R {
    a.iter().zip(b).fold(R::from(0.0), |sum, (a, b)| sum + *a * *b)
}

/// The vector a + factor · b.
pub(in crate::enclosing::min_total_length::by_vertex_sets) fn plus<R: Scalar, const D: usize>(
    a: &[R; D],
    factor: R,
    b: &[R; D],
) -> [R; D] {
    std::array::from_fn(|c| a[c] + factor * b[c])
}
