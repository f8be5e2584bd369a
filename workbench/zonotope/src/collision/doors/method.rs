//! The methods of collision by name, with the dimensions that each works in.

use std::ops::RangeInclusive;

use thiserror::Error;

#[cfg(feature = "linear-programming")]
use crate::collision::by_linear_program;
use crate::collision::{Gauge, Location, Query, brute_force, by_explicit_faces, by_lad, by_slope_selection};
#[cfg(feature = "linear-programming")]
use crate::linear_program::Clarabel;
use crate::tables::methods;
use crate::tally::Tally;
use crate::zonotope::faces::FacesError;

methods! {
    /// A method that locates a displacement. The methods that need an engine exist with the feature
    /// `linear-programming` alone.
    pub enum Method;
    /// The cost of a question with n generators.
    fn cost;

    /// [`by_lad`], the default; in four dimensions it is [`by_lad_in_r4`](crate::collision::by_lad_in_r4).
    ByLad => "by_lad", "Kernel", "O(n) expected";
    /// [`by_slope_selection`], the paper's search.
    BySlopeSelection => "by_slope_selection", "Theorem 5.2: the paper's search", "O(n log² n) expected";
    /// [`by_explicit_faces`].
    ByExplicitFaces => "by_explicit_faces", "Explicit faces", "Ω(n²)";
    /// [`by_linear_program`] with the engine [`Clarabel`].
    #[cfg(feature = "linear-programming")]
    ByLinearProgram => "by_linear_program", "Linear program with a proof", "the engine's";
    /// [`brute_force`].
    BruteForce => "brute_force", "Every facet normal in rationals", "O(n^D) in rationals";
}

/// Why a method takes no question of this kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MethodError {
    /// The method does not work in this dimension.
    #[error("`{}` does not work in {dimension} dimensions", .method.id())]
    Dimension {
        /// The method.
        method: Method,
        /// The dimension of the question.
        dimension: usize,
    },
    /// The method locates displacements, but does not measure them.
    #[error("`{}` does not compute the gauge", .0.id())]
    NoGauge(Method),
    /// There are more faces than the method lists.
    #[error(transparent)]
    Faces(#[from] FacesError),
}

/// The answer of a function of some dimensions, if that of the query is one of them.
macro_rules! in_dimensions {
    ([$($dimension:literal)+], $query:ident, $answer:expr) => {
        match D {
            $($dimension => match $query.in_dimension::<$dimension>() {
                Some($query) => {
                    let $query = &$query;
                    Some($answer.lowered($query.len()))
                }
                None => None,
            },)+
            _ => None,
        }
    };
}

impl Method {
    /// The method that answers where the caller chooses none: it locates and measures in this dimension, always with a
    /// proof. Above four dimensions that is brute force, whose cost grows with the power of the dimension.
    pub fn default_in(dimension: usize) -> Self {
        if Self::ByLad.dimensions().contains(&dimension) { Self::ByLad } else { Self::BruteForce }
    }

    /// The dimensions that the method works in.
    pub fn dimensions(self) -> RangeInclusive<usize> {
        match self {
            Self::ByLad => 1..=4,
            Self::BySlopeSelection | Self::ByExplicitFaces => 1..=3,
            #[cfg(feature = "linear-programming")]
            Self::ByLinearProgram => 1..=usize::MAX,
            Self::BruteForce => 1..=usize::MAX,
        }
    }

    /// Whether every answer of the method is a location with its proof.
    pub fn always_locates(self) -> bool {
        match self {
            Self::ByLad | Self::BySlopeSelection | Self::ByExplicitFaces | Self::BruteForce => true,
            #[cfg(feature = "linear-programming")]
            Self::ByLinearProgram => false,
        }
    }

    /// Whether the method also computes the gauge.
    pub fn measures(self) -> bool {
        matches!(self, Self::ByLad | Self::ByExplicitFaces | Self::BruteForce)
    }

    /// The location of a displacement, with a proof; `None` where the method gives up. `seed` decides the time, never
    /// the answer.
    ///
    /// # Errors
    /// [`MethodError::Dimension`] outside of [`dimensions`](Self::dimensions), [`MethodError::Faces`] if there are too
    /// many.
    #[inline(never)]
    pub fn locate<const D: usize>(
        self,
        question: &Query<'_, D>,
        seed: u64,
        tally: &mut dyn Tally,
    ) -> Result<Option<Location<D>>, MethodError> {
        let located = match self {
            Self::ByLad => by_lad::located(question, tally).map(|location| location.written_for(question)),
            Self::BySlopeSelection => {
                in_dimensions!([1 2 3], question, by_slope_selection::locate(question, seed, &mut &mut *tally))
            }
            Self::ByExplicitFaces => Some(self.gauge(question, tally)?.location),
            #[cfg(feature = "linear-programming")]
            Self::ByLinearProgram => return Ok(by_linear_program::locate(question, &Clarabel).location().cloned()),
            Self::BruteForce => Some(brute_force::locate(question)),
        };
        located.map(Some).ok_or(MethodError::Dimension { method: self, dimension: D })
    }

    /// The gauge of a displacement and where it lies.
    ///
    /// # Errors
    /// [`MethodError::NoGauge`] unless the method [measures](Self::measures), [`MethodError::Dimension`] outside of
    /// [`dimensions`](Self::dimensions), [`MethodError::Faces`] if there are too many.
    #[inline(never)]
    pub fn gauge<const D: usize>(
        self,
        question: &Query<'_, D>,
        tally: &mut dyn Tally,
    ) -> Result<Gauge<D>, MethodError> {
        let gauge = match self {
            Self::ByLad => {
                by_lad::measured(question, tally).map(|gauge| gauge.map(|location| location.written_for(question)))
            }
            Self::ByExplicitFaces => {
                let counted = &mut &mut *tally;
                in_dimensions!([1 2 3], question, by_explicit_faces::gauge(question, counted)?)
            }
            Self::BruteForce => Some(brute_force::gauge(question)),
            _ => return Err(MethodError::NoGauge(self)),
        };
        gauge.ok_or(MethodError::Dimension { method: self, dimension: D })
    }

    /// [`gauge`](Self::gauge) as answers of bodies have it: within four units in the last place where the method is
    /// exact or the kernel, its proof with the doubles nearest to the coefficients of the basis
    /// ([`Witness::with_nearest_basis`](crate::collision::Witness::with_nearest_basis)).
    ///
    /// # Errors
    /// Those of [`gauge`](Self::gauge).
    #[inline(never)]
    pub fn nearest_gauge<const D: usize>(self, question: &Query<'_, D>) -> Result<Gauge<D>, MethodError> {
        let by_kernel = match self {
            Self::ByLad => by_lad::nearly_measured(question, &mut ()),
            _ => None,
        };
        let gauge = match by_kernel {
            Some(gauge) => gauge.map(|location| location.written_for(question)),
            None => self.gauge(question, &mut ())?,
        };
        Ok(gauge.with_nearest_basis(question))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique() {
        for method in Method::ALL {
            assert_eq!(Method::from_id(method.id()), Some(method));
        }
        assert_eq!(Method::from_id("by_luck"), None);
    }
}
