//! The scalar of the interior-point method: doubles, or pairs of doubles where doubles are not precise enough.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::numeric::double_double::DoubleDouble;
use crate::numeric::lanes::{product_in_eights, products_of_four_rows};
use crate::numeric::linear::{Ring, sum_of_products};

/// The number of rows in a block whose products with two other rows are computed at once.
pub(super) const BLOCK: usize = 4;

/// A floating-point number in which the interior-point method computes.
pub(super) trait Scalar:
    Ring
    + Copy
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
    /// The same of loops that gather their terms.
    const RELATIVE_COST_OF_SUMS: f64;

    /// The square root.
    fn sqrt(self) -> Self;

    /// The nearest double.
    fn value(self) -> f64;

    /// The dot products of the rows of a block with two other rows, all of the same even length.
    fn products(rows: [&[Self]; BLOCK], others: [&[Self]; 2]) -> [[Self; 2]; BLOCK] {
        rows.map(|row| others.map(|other| Self::row_product(row, other)))
    }

    /// The dot product of two rows of equal length.
    fn row_product(a: &[Self], b: &[Self]) -> Self {
        sum_of_products(a, b)
    }
}

impl Scalar for DoubleDouble {
    const PIVOT_TOLERANCE: f64 = 1e-30;
    const RELATIVE_COST: f64 = 50.0;
    const RELATIVE_COST_OF_SUMS: f64 = 25.0;

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
    const RELATIVE_COST_OF_SUMS: f64 = 1.0;

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn value(self) -> f64 {
        self
    }

    fn products(rows: [&[f64]; BLOCK], others: [&[f64]; 2]) -> [[f64; 2]; BLOCK] {
        products_of_four_rows(rows, others)
    }

    fn row_product(a: &[f64], b: &[f64]) -> f64 {
        product_in_eights(a, b)
    }
}

/// The zero vector.
pub(super) fn zero<R: Scalar, const D: usize>() -> [R; D] {
    [R::from(0.0); D]
}

/// A vector of doubles as a vector of scalars.
pub(super) fn real<R: Scalar, const D: usize>(v: &[f64; D]) -> [R; D] {
    v.map(R::from)
}

/// The doubles nearest to the scalars of a vector.
pub(super) fn values<R: Scalar, const D: usize>(v: &[R; D]) -> [f64; D] {
    v.map(R::value)
}

/// The vector a + factor · b.
pub(super) fn plus<R: Scalar, const D: usize>(a: &[R; D], factor: R, b: &[R; D]) -> [R; D] {
    std::array::from_fn(|c| a[c] + factor * b[c])
}
