//! Problem: how high the upper hull of a zonotope in space is over a point of the plane (Section 5.1).
//!
//! Z = { Σ δ_i v_i : |δ_i| ≤ 1 } projects to the zonogon Q along the z axis. Over a point p_0 of Q, its boundary
//! included, the upper hull is at max { z : (p_0, z) ∈ Z }; by the support function that is the least h(x, y, 1) − (x,
//! y) · p_0. Where p_0 is not in Q, a direction of the plane separates the two.
//!
//! # Statement
//! Input: generators of R^3 and a point p_0 of the plane. Output: the z of the upper hull over p_0, exactly, or a
//! direction that separates p_0 from Q. The boundary of Q belongs to Q. Any finite generators are ordinary input, flat,
//! vertical and empty bodies included, for which Q may be a segment or the origin.
//!
//! # Shapes
//! `generators`: n × 3, any order, duplicates allowed; `p0`: x first.
//!
//! # Errors
//! [`HeightError`] ⇔ a coordinate is not finite, or n exceeds 32 bits.
//!
//! # Methods
//! | method | cost for n generators | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n³), exact rationals | the truth |
//! | [`by_slope_selection`] | O(n log² n) expected | the paper's search for the tile of p_0 |
//! | [`by_kernel`] | O(n) expected | the default: the least of that sum of absolute values |

pub mod brute_force;
pub mod by_kernel;
pub mod by_slope_selection;
mod method;
mod near_one_plane;

use thiserror::Error;

pub use by_kernel::height;
pub use method::Method;

use crate::arrangement::GeneratorError;
use crate::numeric::Rational;
use crate::numeric::non_finite::NonFinite;

/// What is over a point of the plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Height {
    /// The point is in Q, and the upper hull is at this z over it, exactly.
    OverQ(Rational),
    /// The point is not in Q: a direction u of the plane with u · p_0 > Σ |u · v'_i|, exactly.
    BesideQ([Rational; 2]),
}

/// Why a question is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum HeightError {
    /// A coordinate of a generator or of the point is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There are more generators than a 32-bit index can name.
    #[error("{count} generators are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// How many generators there are.
        count: usize,
    },
}

impl From<GeneratorError> for HeightError {
    fn from(error: GeneratorError) -> Self {
        match error {
            GeneratorError::NonFinite(number) => Self::NonFinite(number),
            GeneratorError::TooMany { count } => Self::TooMany { count },
        }
    }
}

fn validate(generators: &[[f64; 3]], p0: [f64; 2]) -> Result<(), HeightError> {
    GeneratorError::check(generators)?;
    Ok(NonFinite::check_vector("p0", &p0)?)
}

#[cfg(test)]
mod tests;
