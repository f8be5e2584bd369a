//! The rungs of the kernel's ladder: which method answered a question that several methods could have answered.
//!
//! The methods of a stage are tried in the order of this list, from the cheapest to the one that always answers. Which
//! one answered says nothing about the answer, all answers being exact; it says what the answer cost and whether a
//! method earns its place.

use std::fmt;

/// The stage of a query in which a rung stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// A location that is told without an optimum: points far inside and far outside.
    Early,
    /// The minimum of the support function over the plane of directions.
    Optimum,
    /// The certificate of a location, made from an optimum.
    Proof,
}

/// A method that answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Rung {
    /// The least-squares coefficients of a small body, or the direction that they come from.
    LeastSquares,
    /// The least-squares coefficients of a body in a plane through few axes.
    LeastSquaresInPlane,
    /// A direction found from a sample, which separates.
    SampledDirection,
    /// Coefficients steered by a sample and written in one pass.
    StratifiedPass,
    /// Coefficients of the Huber dual for all generators, clipped to [−1, 1].
    ClippedCoefficients,
    /// The displacement is zero.
    ZeroDisplacement,
    /// The best of all pairs of a few generators.
    BestPair,
    /// All generators of a small body at once, in doubles.
    AllInDoubles,
    /// Two of few classes of parallel generators meet in the optimum.
    ParallelClasses,
    /// The direction at which a sample's objective is least separates.
    SeparatingGuess,
    /// The cell around a sample's optimum.
    SampledCell,
    /// A second, wider cell.
    WiderCell,
    /// The optimum of a sample whose gradient a pass over all generators corrects.
    CorrectedSample,
    /// Three pieces of the objective that close in on the optimum between them.
    CuttingPlanes,
    /// Doubles prove the vertex but not on which side of it the displacement ends: its exact coordinates do.
    ExactVertex,
    /// A flat body, without one of its coordinates.
    FlatBody,
    /// The generators that cross the search's cells, in exact arithmetic.
    ExactInCells,
    /// The longest generators alone, in exact arithmetic.
    LongestFirst,
    /// All generators in exact arithmetic.
    ExactWhole,
    /// The direction of the facet, rounded.
    RoundedDirection,
    /// A direction of doubles found near the exact one.
    DirectionOfDoubles,
    /// The exact direction: no direction of doubles near it separates.
    RationalDirection,
    /// Coefficients in doubles with a third generator beside the two of the facet.
    RoundedCoefficients,
    /// Coefficients in doubles with three generators that are not those of the facet.
    WellSpreadBasis,
    /// One factor for all generators off a basis, in exact arithmetic.
    ScaledSigns,
    /// Coefficients that are made doubles one group after the other.
    PivotedCoefficients,
}

impl Rung {
    /// All rungs, each stage's in the order in which they are tried.
    pub const ALL: [Self; 26] = [
        Self::LeastSquares,
        Self::LeastSquaresInPlane,
        Self::SampledDirection,
        Self::StratifiedPass,
        Self::ClippedCoefficients,
        Self::ZeroDisplacement,
        Self::BestPair,
        Self::AllInDoubles,
        Self::ParallelClasses,
        Self::SeparatingGuess,
        Self::SampledCell,
        Self::WiderCell,
        Self::CorrectedSample,
        Self::CuttingPlanes,
        Self::ExactVertex,
        Self::FlatBody,
        Self::ExactInCells,
        Self::LongestFirst,
        Self::ExactWhole,
        Self::RoundedDirection,
        Self::DirectionOfDoubles,
        Self::RationalDirection,
        Self::RoundedCoefficients,
        Self::WellSpreadBasis,
        Self::ScaledSigns,
        Self::PivotedCoefficients,
    ];

    /// The name used in records: lower-case words joined by underscores.
    pub fn name(self) -> &'static str {
        match self {
            Self::LeastSquares => "least_squares",
            Self::LeastSquaresInPlane => "least_squares_in_plane",
            Self::SampledDirection => "sampled_direction",
            Self::StratifiedPass => "stratified_pass",
            Self::ClippedCoefficients => "clipped_coefficients",
            Self::ZeroDisplacement => "zero_displacement",
            Self::BestPair => "best_pair",
            Self::AllInDoubles => "all_in_doubles",
            Self::ParallelClasses => "parallel_classes",
            Self::SeparatingGuess => "separating_guess",
            Self::SampledCell => "sampled_cell",
            Self::WiderCell => "wider_cell",
            Self::CorrectedSample => "corrected_sample",
            Self::CuttingPlanes => "cutting_planes",
            Self::ExactVertex => "exact_vertex",
            Self::FlatBody => "flat_body",
            Self::ExactInCells => "exact_in_cells",
            Self::LongestFirst => "longest_first",
            Self::ExactWhole => "exact_whole",
            Self::RoundedDirection => "rounded_direction",
            Self::DirectionOfDoubles => "direction_of_doubles",
            Self::RationalDirection => "rational_direction",
            Self::RoundedCoefficients => "rounded_coefficients",
            Self::WellSpreadBasis => "well_spread_basis",
            Self::ScaledSigns => "scaled_signs",
            Self::PivotedCoefficients => "pivoted_coefficients",
        }
    }

    /// The stage in which the rung stands.
    pub fn stage(self) -> Stage {
        match self {
            Self::LeastSquares
            | Self::LeastSquaresInPlane
            | Self::SampledDirection
            | Self::StratifiedPass
            | Self::ClippedCoefficients => Stage::Early,
            Self::RoundedDirection
            | Self::DirectionOfDoubles
            | Self::RationalDirection
            | Self::RoundedCoefficients
            | Self::WellSpreadBasis
            | Self::ScaledSigns
            | Self::PivotedCoefficients => Stage::Proof,
            _ => Stage::Optimum,
        }
    }
}

impl fmt::Display for Rung {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rung_has_its_place_in_the_list_and_a_name_of_its_own() {
        for (place, rung) in Rung::ALL.into_iter().enumerate() {
            assert_eq!(rung as usize, place, "{rung}");
            assert!(Rung::ALL[..place].iter().all(|other| other.name() != rung.name()), "{rung}");
        }
        assert!(Rung::ALL.is_sorted_by_key(|rung| rung.stage()));
    }
}
