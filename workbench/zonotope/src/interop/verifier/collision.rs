//! Locations.

use ::verifier::{
    Body, Displaced, DistanceAnswer, DistanceProof, Fraction, LocationAnswer, LocationCertificate, LocationProof,
    Verdict, whole_direction,
};

use super::fraction;
use crate::collision::Query;
use crate::collision::distance::Gap;
use crate::zonotope::location::{Location, Separation, Status};

/// The query as the verifier takes it.
pub fn displaced<const D: usize>(query: &Query<'_, D>) -> Displaced {
    let ([from, to], [first, second]) = ([query.from(), query.to()], query.runs());
    let body = |center, generators| Body { center, generators, pose: None };
    Displaced::between(&body(&from, first), &body(&to, second)).expect("a query is finite and of one dimension")
}

/// The location as the verifier takes it: the coefficients of a basis as the doubles nearest to their exact values, a
/// direction as whole numbers. A direction that is not finite becomes one without coordinates, which proves nothing.
pub fn location_answer<const D: usize>(query: &Query<'_, D>, location: &Location<D>) -> LocationAnswer {
    let certificate = match location {
        Location::Inside(witness) | Location::Boundary(witness) => {
            let witness = witness.clone().with_nearest_basis(query);
            LocationCertificate::Witness { coefficients: witness.coefficients, basis: witness.basis }
        }
        Location::Outside(separation) => {
            let direction: Option<Vec<Fraction>> = match separation {
                Separation::Rounded(direction) => direction.iter().map(|&c| Fraction::of_double(c)).collect(),
                Separation::Exact(direction) => Some(direction.iter().map(fraction).collect()),
            };
            LocationCertificate::Separation(whole_direction(&direction.unwrap_or_default()))
        }
    };
    let status = match location.status() {
        Status::Inside => ::verifier::Status::Inside,
        Status::Boundary => ::verifier::Status::Boundary,
        Status::Outside => ::verifier::Status::Outside,
    };
    LocationAnswer { status, certificate }
}

/// Checks a location with its proof.
pub fn check_location<const D: usize>(query: &Query<'_, D>, location: &Location<D>) -> Verdict<LocationProof> {
    ::verifier::check_location(&displaced(query), &location_answer(query, location))
}

/// The gap between disjoint bodies as the verifier takes it.
pub fn distance_answer<const D: usize>(gap: &Gap<D>) -> DistanceAnswer {
    let Gap { nearest, .. } = gap;
    DistanceAnswer {
        distance: gap.distance(),
        coefficients: nearest.coefficients.clone(),
        basis: nearest.basis.clone(),
    }
}

/// Checks the distance of disjoint bodies with its proof.
pub fn check_distance<const D: usize>(query: &Query<'_, D>, gap: &Gap<D>) -> Verdict<DistanceProof> {
    ::verifier::check_distance(&displaced(query), &distance_answer(gap))
}
