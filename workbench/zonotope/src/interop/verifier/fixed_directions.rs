//! Zonotopes along given directions.

use ::verifier::{Directed, DirectedAnswer, DirectedProof, Verdict};

use super::fraction;
use crate::enclosing::fixed_directions::{DirectedZonotope, Enclosure, FixedDirections};

/// Checks that a zonotope is the cheapest around the points, or that there is none.
pub fn check_min_length_dirs<const D: usize>(
    problem: &FixedDirections<'_, D>,
    answer: &Enclosure<D>,
) -> Verdict<DirectedProof> {
    ::verifier::check_min_length_dirs(&directed(problem), &directed_answer(answer))
}

/// Checks the same, however far the value is above its lower bound.
pub fn check_min_length_dirs_at_any_gap<const D: usize>(
    problem: &FixedDirections<'_, D>,
    answer: &Enclosure<D>,
) -> Verdict<DirectedProof> {
    ::verifier::check_min_length_dirs_at_any_gap(&directed(problem), &directed_answer(answer))
}

/// Checks the value and the lower bound alone, which takes no longer for more points.
pub fn check_min_length_dirs_bounds<const D: usize>(
    problem: &FixedDirections<'_, D>,
    zonotope: &DirectedZonotope<D>,
) -> Verdict<(f64, f64)> {
    ::verifier::check_min_length_dirs_bounds(&directed(problem), &optimal(zonotope))
}

fn directed<const D: usize>(problem: &FixedDirections<'_, D>) -> Directed {
    Directed {
        points: problem.points().iter().map(|point| point.to_vec()).collect(),
        directions: problem.directions().iter().map(|direction| direction.to_vec()).collect(),
        weights: problem.weights().to_vec(),
    }
}

fn directed_answer<const D: usize>(answer: &Enclosure<D>) -> DirectedAnswer {
    match answer {
        Enclosure::Optimal(zonotope) => optimal(zonotope),
        Enclosure::Infeasible(proof) => DirectedAnswer::Infeasible {
            points: proof.points,
            functional: proof.functional.iter().map(fraction).collect(),
        },
    }
}

fn optimal<const D: usize>(zonotope: &DirectedZonotope<D>) -> DirectedAnswer {
    let forces = zonotope.multipliers.iter();
    DirectedAnswer::Optimal {
        value: zonotope.value,
        center: zonotope.center.to_vec(),
        coefficients: zonotope.coefficients.clone(),
        lower_bound: zonotope.lower_bound,
        forces: forces.map(|force| (force.point, force.vector.iter().map(fraction).collect())).collect(),
    }
}
