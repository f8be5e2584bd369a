//! The implicit form of a zonotope in any dimension.

use thiserror::Error;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{dot, sum_of_products};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::outward::{Loss, at_least};
use crate::numeric::tolerance::UNIT;

/// The zonotope { center + Σ δ_i generators_i : |δ_i| ≤ 1 }; generators are half-segments, in any order, zero and
/// parallel ones allowed. Every coordinate is finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Zonotope<const D: usize> {
    pub(super) center: [f64; D],
    pub(super) generators: Vec<[f64; D]>,
}

/// Why a centre and generators are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ZonotopeError {
    /// A coordinate of the centre or of a generator is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// A list of coordinates does not divide into generators.
    #[error("{length} coordinates are not a whole number of generators of dimension {dimension}")]
    RaggedRows {
        /// How many coordinates there are.
        length: usize,
        /// How many a generator has.
        dimension: usize,
    },
}

/// The value of the support function and a vertex where it is taken.
#[derive(Debug, Clone, PartialEq)]
pub struct Support<const D: usize> {
    /// max { direction · x : x in the zonotope } = direction · center + Σ |direction · g_i|, exactly.
    pub exact_value: Dyadic,
    /// A point of the zonotope that attains it, exactly: center + Σ ± g_i.
    pub exact_point: [Dyadic; D],
}

impl<const D: usize> Zonotope<D> {
    /// A zonotope from its centre and generators. O(n).
    ///
    /// # Errors
    /// [`ZonotopeError`] names the first coordinate that is not finite.
    pub fn new(center: [f64; D], generators: Vec<[f64; D]>) -> Result<Self, ZonotopeError> {
        NonFinite::check_vector("the center", &center)?;
        NonFinite::check_list("generator", &generators)?;
        Ok(Self { center, generators })
    }

    /// The zonotope of a centre and generators that were rounded and, along each axis that lost something, a generator
    /// that makes up for it.
    ///
    /// # Errors
    /// As [`new`](Self::new), if a coordinate left the range of doubles.
    pub(crate) fn enclosing_rounded(
        center: [f64; D],
        mut generators: Vec<[f64; D]>,
        loss: &Loss<D>,
    ) -> Result<Self, ZonotopeError> {
        generators.extend(loss.generators());
        Self::new(center, generators)
    }

    /// The centre.
    pub fn center(&self) -> [f64; D] {
        self.center
    }

    /// The generators.
    pub fn generators(&self) -> &[[f64; D]] {
        &self.generators
    }

    /// The support function in a direction of finite coordinates and an extreme vertex, exactly; where the direction is
    /// orthogonal to a generator, the vertex has it with coefficient 1. O(n) exact operations.
    ///
    /// # Panics
    /// If a coordinate of the direction is NaN or infinite.
    pub fn support(&self, direction: [f64; D]) -> Support<D> {
        let (exact_value, point) =
            support_of(&direction, &self.center, self.generators.iter().map(<[f64; D]>::as_slice));
        Support { exact_value, exact_point: std::array::from_fn(|i| point[i].clone()) }
    }

    /// The total length Σ |g_i| of the generators, rounded up: at most a relative 10^-14 above the exact one.
    pub fn total_length(&self) -> f64 {
        length_above(self.generators())
    }
}

impl<const D: usize> Support<D> {
    /// The value, within a relative 2^-50; infinite where it leaves the range of doubles.
    pub fn value(&self) -> f64 {
        self.exact_value.to_f64()
    }

    /// The vertex, each coordinate within a relative 2^-50.
    pub fn point(&self) -> [f64; D] {
        std::array::from_fn(|i| self.exact_point[i].to_f64())
    }
}

/// The value and the vertex of [`Zonotope::support`] for a body whose number of coordinates is no constant.
///
/// # Panics
/// If a number is NaN or infinite, or if a vector has fewer coordinates than the direction.
pub fn support_of<'a>(
    direction: &[f64],
    center: &[f64],
    generators: impl Iterator<Item = &'a [f64]>,
) -> (Dyadic, Vec<Dyadic>) {
    let exact = |v: &[f64]| -> Vec<Dyadic> { v.iter().copied().map(Dyadic::from_f64).collect() };
    let direction = exact(direction);
    let mut point = exact(center);
    let mut value = sum_of_products(&point, &direction);
    for generator in generators.map(exact) {
        let gain = sum_of_products(&generator, &direction);
        for (sum, v) in point.iter_mut().zip(&generator) {
            *sum = if gain.sign().is_lt() { &*sum - v } else { &*sum + v };
        }
        value = value + gain.abs();
    }
    (value, point)
}

/// The total length Σ |g_i|, rounded up.
fn length_above<const D: usize>(generators: &[[f64; D]]) -> f64 {
    let lengths = generators.iter().map(|g| {
        let largest = g.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        let axes = g.iter().filter(|c| **c != 0.0).count();
        if axes <= 1 {
            return Dyadic::from_f64(largest);
        }
        let unit = g.map(|c| c / largest);
        let factor = dot(&unit, &unit).sqrt() * (1.0 + 8.0 * D as f64 * UNIT);
        // The product is exact: as a double it might be denormal, with few bits.
        &Dyadic::from_f64(largest) * &Dyadic::from_f64(factor)
    });
    let length = at_least(&lengths.fold(Dyadic::zero(), |sum, length| sum + length));
    if length < f64::MIN_POSITIVE { tiny_length_above(generators) } else { length }
}

/// The total length rounded up, for generators as short as the least doubles: these are so far apart that a factor
/// above 1 may cost a whole step between them, so each length is the root of an exact square.
fn tiny_length_above<const D: usize>(generators: &[[f64; D]]) -> f64 {
    let square = |g: &[f64; D]| g.iter().map(|c| Dyadic::from_f64(*c)).fold(Dyadic::zero(), |sum, c| sum + &c * &c);
    let length = generators.iter().map(|g| square(g).root_above()).fold(Dyadic::zero(), |sum, length| sum + length);
    at_least(&length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_total_length_is_never_below_the_exact_one() {
        let body = Zonotope::new([0.0, 0.0], vec![[3.0, 4.0], [0.0, -2.0], [0.0, 0.0]]).expect("finite numbers");
        assert!((7.0..7.0 * (1.0 + 1e-14)).contains(&body.total_length()), "{}", body.total_length());
        let axes = Zonotope::new([5.0, 0.0], vec![[1.0, 0.0], [0.0, 0.5]]).expect("finite numbers");
        assert_eq!(axes.total_length(), 1.5);
        let tiny = Zonotope::new([0.0, 0.0], vec![[5e-324, 0.0]; 3]).expect("finite numbers");
        assert_eq!(tiny.total_length(), 1.5e-323);
    }
}
