//! The rungs of the kernel's ladder: which method answered a question that several methods could have answered.
//!
//! The methods of a stage are tried in the order of this list, from the cheapest to the one that always answers. Which
//! one answered says nothing about the answer, all answers being exact; it says what the answer cost and whether a
//! method earns its place.

use crate::tables::named_variants;

/// The stage of a query in which a rung stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// A location that is found without an optimum: points far inside and far outside.
    Early,
    /// The minimum of the support function over the plane of directions.
    Optimum,
    /// The certificate of a location, made from an optimum.
    Proof,
}

named_variants! {
    /// A method that answered; those of a stage in the order in which they are tried.
    pub enum Rung;
    /// The least-squares coefficients of a small body, or the direction that they come from.
    LeastSquares => "least_squares";
    /// The least-squares coefficients of a body in a plane through few axes.
    LeastSquaresInPlane => "least_squares_in_plane";
    /// A direction found from a sample, which separates.
    SampledDirection => "sampled_direction";
    /// Coefficients steered by a sample and written in one pass.
    StratifiedPass => "stratified_pass";
    /// Coefficients of the Huber dual for all generators, clipped to [−1, 1].
    ClippedCoefficients => "clipped_coefficients";
    /// The displacement is zero.
    ZeroDisplacement => "zero_displacement";
    /// The best of all pairs of a few generators.
    BestPair => "best_pair";
    /// All generators of a small body at once, in doubles.
    AllInDoubles => "all_in_doubles";
    /// Two of few classes of parallel generators meet in the optimum.
    ParallelClasses => "parallel_classes";
    /// The direction at which a sample's objective is least separates.
    SeparatingGuess => "separating_guess";
    /// The cell around a sample's optimum.
    SampledCell => "sampled_cell";
    /// A second, wider cell.
    WiderCell => "wider_cell";
    /// The optimum of a sample whose gradient a pass over all generators corrects.
    CorrectedSample => "corrected_sample";
    /// Three pieces of the objective that close in on the optimum between them.
    CuttingPlanes => "cutting_planes";
    /// Doubles prove the vertex but not on which side of it the displacement ends: its exact coordinates do.
    ExactVertex => "exact_vertex";
    /// A flat body, without one of its coordinates.
    FlatBody => "flat_body";
    /// The generators that cross the search's cells, in exact arithmetic.
    ExactInCells => "exact_in_cells";
    /// The longest generators alone, in exact arithmetic.
    LongestFirst => "longest_first";
    /// All generators in exact arithmetic.
    ExactWhole => "exact_whole";
    /// The direction of the facet, rounded.
    RoundedDirection => "rounded_direction";
    /// A direction of doubles found near the exact one.
    DirectionOfDoubles => "direction_of_doubles";
    /// The exact direction: no direction of doubles near it separates.
    RationalDirection => "rational_direction";
    /// Coefficients in doubles with a third generator beside the two of the facet.
    RoundedCoefficients => "rounded_coefficients";
    /// Coefficients in doubles with three generators that are not those of the facet.
    WellSpreadBasis => "well_spread_basis";
    /// One factor for all generators off a basis, in exact arithmetic.
    ScaledSigns => "scaled_signs";
    /// Coefficients that are made doubles one group after the other.
    PivotedCoefficients => "pivoted_coefficients";
}

impl Rung {
    /// The stage in which the rung stands.
    pub fn stage(self) -> Stage {
        if self <= Self::ClippedCoefficients {
            Stage::Early
        } else if self < Self::RoundedDirection {
            Stage::Optimum
        } else {
            Stage::Proof
        }
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
