//! The second-order cone x_0 ≥ |(x_1 … x_d)| and its Jordan algebra.
//!
//! The cone is its own dual. A vector x is in its interior if x_0 and the determinant xᵀ J x are positive, where
//! J = diag(1, −1 … −1). The Jordan product a ∘ b = (a · b, a_0 b' + b_0 a') has the unit (1, 0) and the inverse
//! x⁻¹ = J x / xᵀ J x.

use super::scalar::{Scalar, plus, zero};
use crate::numeric::linear::dot;

/// A vector (x_0, x') with the head x_0 and the rest x'. It is in the cone if the head is at least the length of the
/// rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ConeVector<R, const D: usize> {
    pub(super) head: R,
    pub(super) rest: [R; D],
}

impl<R: Scalar, const D: usize> ConeVector<R, D> {
    pub(super) fn zero() -> Self {
        Self { head: R::from(0.0), rest: zero() }
    }

    pub(super) fn dot(&self, other: &Self) -> R {
        self.head * other.head + dot(&self.rest, &other.rest)
    }

    pub(super) fn plus(&self, factor: R, other: &Self) -> Self {
        Self { head: self.head + factor * other.head, rest: plus(&self.rest, factor, &other.rest) }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(R::from(-1.0), other)
    }

    pub(super) fn times(&self, factor: R) -> Self {
        Self { head: self.head * factor, rest: self.rest.map(|c| c * factor) }
    }

    /// The vector J x, whose rest is negated.
    pub(super) fn reflected(&self) -> Self {
        Self { head: self.head, rest: self.rest.map(|c| -c) }
    }

    /// The determinant xᵀ J x = x_0² − |x'|², positive inside the cone.
    pub(super) fn determinant(&self) -> R {
        let length = dot(&self.rest, &self.rest).sqrt();
        (self.head - length) * (self.head + length)
    }

    /// The dual variable z = μ s⁻¹ of this slack s on the central path, where s ∘ z = (μ, 0).
    pub(super) fn dual_at(&self, mu: R) -> Self {
        self.reflected().times(mu / self.determinant())
    }

    /// The multiple of a direction that leads from this vector, inside the cone, to the boundary of the cone; infinite
    /// if every multiple stays inside.
    pub(super) fn reach(&self, direction: &Self) -> f64 {
        let none = R::from(0.0);
        let a = direction.head * direction.head - dot(&direction.rest, &direction.rest);
        let b = self.head * direction.head - dot(&self.rest, &direction.rest);
        let c = self.determinant();
        let discriminant = b * b - a * c;
        if discriminant < none || (a >= none && b >= none) {
            return f64::INFINITY;
        }
        (c / (discriminant.sqrt() - b)).value()
    }
}

/// The Jordan product a ∘ b.
pub(super) fn jordan<R: Scalar, const D: usize>(a: &ConeVector<R, D>, b: &ConeVector<R, D>) -> ConeVector<R, D> {
    ConeVector { head: a.dot(b), rest: std::array::from_fn(|c| a.head * b.rest[c] + b.head * a.rest[c]) }
}
