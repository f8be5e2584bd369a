//! Arithmetic without rounding: doubles as whole multiples of one power of two, and what is built on these integers.

pub(crate) mod fraction;
pub(crate) mod grid;
pub(crate) mod inversions;
pub(crate) mod length;
pub(crate) mod linear;
pub(crate) mod plain_point;
pub(crate) mod polygon;
pub(crate) mod proportion;
pub(crate) mod subsets;
pub(crate) mod turns;
pub(crate) mod wide;

use dashu_int::IBig;

use self::fraction::{Fraction, common_denominator, whole_numbers};

/// A direction as whole numbers of one unit: the length of a direction says nothing.
pub fn whole_direction(direction: &[Fraction]) -> Vec<IBig> {
    whole_numbers(direction, &common_denominator(direction))
}
