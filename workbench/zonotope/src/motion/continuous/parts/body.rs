//! A body with the sum that bounds the rounding of passes over its generators.

use crate::motion::scalar::Scalar;
use crate::numeric::tolerance::LONG_SUM;
use crate::zonotope::Zonotope;

/// A body of space, and Σ |g|_1 over its generators.
#[derive(Debug, Clone, Copy)]
pub(in crate::motion::continuous) struct Body<'a> {
    pub(in crate::motion::continuous) zonotope: &'a Zonotope<3>,
    magnitude: f64,
}

impl<'a> Body<'a> {
    pub(in crate::motion::continuous) fn of(zonotope: &'a Zonotope<3>) -> Self {
        let magnitude: f64 = zonotope.generators().iter().flatten().map(|c| c.abs()).sum();
        Self { zonotope, magnitude: magnitude * LONG_SUM }
    }

    pub(in crate::motion::continuous) fn generators(&self) -> &'a [[f64; 3]] {
        self.zonotope.generators()
    }

    pub(in crate::motion::continuous) fn center(&self) -> [f64; 3] {
        self.zonotope.center()
    }

    /// A bound above Σ |g|_1, but for overflow.
    pub(in crate::motion::continuous) fn magnitude(&self) -> f64 {
        self.magnitude
    }

    /// Σ |u · g| for each direction.
    pub(in crate::motion::continuous) fn reaches<T: Scalar, const K: usize>(&self, directions: &[[T; 3]; K]) -> [T; K] {
        T::reaches(self.generators(), self.magnitude, directions)
    }
}
