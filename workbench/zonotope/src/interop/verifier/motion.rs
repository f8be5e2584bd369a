//! First contacts of moving bodies.

use ::verifier::{
    Encounter, FirstContactAnswer, FirstContactProof, FreeInterval, Motion, MovingBody, MovingDirection, Verdict,
};

use crate::motion::continuous::{FirstContact, FreeStretch, SeparatingDirection};
use crate::zonotope::Zonotope;

/// A first contact as the verifier takes it.
pub fn first_contact_answer(found: &FirstContact) -> FirstContactAnswer {
    let encounter = match found {
        FirstContact::Separate { .. } => Encounter::Separate,
        FirstContact::Contact { time, witness, .. } => {
            Encounter::Contact { time: *time, coefficients: witness.coefficients.clone(), basis: witness.basis.clone() }
        }
        FirstContact::Grazing { time, distance_at_most, .. } => {
            Encounter::Grazing { time: *time, distance_at_most: *distance_at_most }
        }
    };
    FirstContactAnswer { encounter, intervals: found.free().iter().map(interval).collect() }
}

fn interval(stretch: &FreeStretch) -> FreeInterval {
    let direction = match stretch.direction {
        SeparatingDirection::Space(u) => MovingDirection::Space(u),
        SeparatingDirection::First(u) => MovingDirection::A(u),
        SeparatingDirection::Second(u) => MovingDirection::B(u),
        SeparatingDirection::Edges(edges) => MovingDirection::Edges(edges),
    };
    FreeInterval { from: stretch.from, to: stretch.until, direction }
}

/// Checks a first contact of two bodies with its proof; the motions are those of the question, as the verifier takes
/// them.
pub fn check_first_contact(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    found: &FirstContact,
) -> Verdict<FirstContactProof> {
    let centers = bodies.map(Zonotope::center);
    let generators = bodies.map(|body| body.generators().iter().map(|g| g.to_vec()).collect::<Vec<_>>());
    let body = |i: usize| MovingBody { center: &centers[i], generators: &generators[i], motion: motions[i] };
    ::verifier::check_first_contact([body(0), body(1)], resolution, &first_contact_answer(found))
}
