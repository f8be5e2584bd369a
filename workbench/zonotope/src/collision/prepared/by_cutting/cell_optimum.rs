//! The optimum of a query in the trapezoid that holds it: the static problem of the generators whose lines cross it.
//!
//! In the trapezoid the sum s of all other generators has s · u ≥ 0, so h is there the support function of the crossing
//! generators and s as one more: a small body, which the static method answers in doubles. s is rounded for that, so
//! the answer is only a guess of the facet, and the facet is checked exactly. Where the check fails the reduced problem
//! is solved in exact arithmetic.

use std::cmp::Ordering;

use super::filtered::Vector;
use super::target::Target;
use super::vertex::{Reduced, Vertex};
use crate::collision::by_lad;
use crate::collision::prepared::by_cutting::structure::tree::{Trapezoid, Tree};
use crate::numeric::bounded::{self, Bounded};
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, dot, exact, negated, sum};
use crate::numeric::linear;
use crate::numeric::signed_sum::signed_sum;
use crate::tally::{Operation, Tally};
use crate::zonotope::query::Query;

/// The optimum of a query whose optima all lie in a trapezoid.
pub(crate) fn optimum_in(tree: &Tree, trapezoid: &Trapezoid, target: &Target<'_>, tally: &mut dyn Tally) -> Vertex {
    let first = trapezoid.first_generator;
    let places = &tree.places[first..first + trapezoid.crossing as usize];
    let members: Vec<usize> = places.iter().map(|place| place.index()).collect();
    let reduced = Reduced { members, others: tree.sums.exact(trapezoid.others) };
    let guess = guessed_direction(&reduced, target, tally);
    let checked = guess.as_ref().and_then(|direction| at_direction(&reduced, direction, target, tally));
    checked.unwrap_or_else(|| {
        let center = guess.unwrap_or_else(|| target.direction.clone());
        let optimum = reduced.solve(target, &center, tally);
        optimum.expect("the function has a minimum, because it has one in the trapezoid")
    })
}

/// The direction of the facet that doubles find with the sum of the others rounded.
fn guessed_direction(reduced: &Reduced, target: &Target<'_>, tally: &mut dyn Tally) -> Option<ExactVector> {
    let vectors = || reduced.members.iter().map(|&index| target.query.generator(index));
    let others = reduced.others.each_ref().map(Dyadic::to_f64);
    let body: Vec<[f64; 3]> = vectors().chain([others]).collect();
    tally.add(Operation::PartEvaluation, body.len() as u64);
    if !others.iter().all(|c| c.is_finite()) {
        return None;
    }
    let query = Query::of_finite(target.query.from(), target.query.to(), &body);
    let facet = by_lad::facet(&query, tally);
    let &[first, second] = facet.basis() else { return None };
    let direction = cross(&exact(body[first]), &exact(body[second]));
    match dot(&direction, &target.direction).sign() {
        Ordering::Greater => Some(direction),
        Ordering::Less => Some(negated(direction)),
        Ordering::Equal => None,
    }
}

/// The optimum if it is at a direction.
fn at_direction(
    reduced: &Reduced,
    direction: &ExactVector,
    target: &Target<'_>,
    tally: &mut dyn Tally,
) -> Option<Vertex> {
    tally.add(Operation::PartEvaluation, reduced.members.len() as u64);
    let (rounded, in_pairs) = (direction.over::<Bounded>(), DoubleDoubleDirection::of(direction));
    let mut members = Vec::new();
    let signed = reduced.members.iter().map(|&index| {
        let v = target.query.generator(index);
        let certain = linear::dot(&rounded, &bounded::exact(v)).sign().or_else(|| in_pairs.certain_sign(&v));
        let sign = certain.unwrap_or_else(|| dot(&exact(v), direction).sign() as i8);
        if sign == 0 {
            members.push(index);
        }
        (v, sign)
    });
    let others = sum(&reduced.others, &signed_sum(signed));
    Reduced { members, others }.solve_at(direction.clone(), target, tally).ok()
}
