//! What the numbers of an optimum prove, exactly.

use super::answer::Answer;
use crate::collision::proof::balance::solve::near_witness;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::zonotope::location::{Location, Separation};
use crate::zonotope::query::Query;

/// The separation that a direction or its opposite is.
pub(super) fn separation<const D: usize>(
    question: &Query<'_, D>,
    displacement: &[Dyadic; D],
    direction: &[Dyadic; D],
) -> Option<Separation<D>> {
    let along = dot(direction, displacement);
    let direction = if along.sign().is_lt() { direction.clone().map(|v| -v) } else { direction.clone() };
    (along.abs() > reach(question, &direction)).then(|| Separation::near(question, &direction))
}

/// What coefficients near `times` · p prove about p.
pub(super) fn membership<const D: usize>(
    question: &Query<'_, D>,
    displacement: &[Dyadic; D],
    coefficients: &[f64],
    times: f64,
    direction: Option<&[Dyadic; D]>,
) -> Option<Answer<D>> {
    let factor = if times > 1.0 { 1.0 / times } else { 1.0 };
    let shrunk = |c: &f64| if c.is_nan() { 0.0 } else { (c * factor).clamp(-1.0, 1.0) };
    let (witness, is_inside) = near_witness(question, displacement, coefficients.iter().map(shrunk).collect())?;
    if is_inside {
        return Some(Answer::Located(Location::Inside(witness)));
    }
    let supports = |u: &[Dyadic; D]| u.iter().any(|v| !v.is_zero()) && dot(u, displacement).abs() == reach(question, u);
    Some(match direction.is_some_and(supports) {
        true => Answer::Located(Location::Boundary(witness)),
        false => Answer::Member(witness),
    })
}

fn reach<const D: usize>(question: &Query<'_, D>, direction: &[Dyadic; D]) -> Dyadic {
    question.generators().fold(Dyadic::zero(), |sum, g| sum + dot(direction, &g.map(Dyadic::from_f64)).abs())
}
