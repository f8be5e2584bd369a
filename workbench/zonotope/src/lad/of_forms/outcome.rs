//! The answer to a problem in three variables, with its proof.

use crate::numeric::Rational;

/// A minimum, or a direction along which there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum SpaceOutcome {
    /// A minimiser with its certificate.
    Optimal(SpaceOptimum),
    /// The objective falls without end along this direction.
    Unbounded {
        /// A direction in which the slope at infinity is negative.
        direction: [Rational; 3],
    },
}

/// A minimiser.
#[derive(Debug, Clone, PartialEq)]
pub struct SpaceOptimum {
    /// The exact minimiser.
    pub point: [Rational; 3],
    /// The exact minimum.
    pub value: Rational,
    /// The proof that the point is a minimiser.
    pub certificate: SpaceCertificate,
}

/// Coefficients δ_i in [−1, 1] with linear + Σ δ_i w_i a_i = 0 and δ_i (a_i · x + b_i) = |a_i · x + b_i|: a subgradient
/// that vanishes.
#[derive(Debug, Clone, PartialEq)]
pub struct SpaceCertificate {
    /// The coefficient −1, 0 or 1 of each plane off the basis, 0 for those of the basis.
    pub signs: Vec<i8>,
    /// Planes with independent normals, at most three, in increasing order; the equation determines their coefficients.
    pub basis: Vec<u32>,
}
