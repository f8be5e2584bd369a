//! The coefficients of a basis that make up for what other coefficients leave, exactly: the step that ends a search for
//! a witness.

use super::choice::roomy;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear;
use crate::numeric::exact_sum::ExactSum;
use crate::zonotope::location::Witness;
use crate::zonotope::query::Query;

/// The displacement minus the generators off the basis, each with its coefficient. O(n) exact additions.
pub(in crate::collision) fn left_over<const D: usize>(
    question: &Query<'_, D>,
    displacement: &[Dyadic; D],
    coefficients: &[f64],
    basis: &[usize],
) -> [Dyadic; D] {
    let mut whole: [ExactSum; D] = std::array::from_fn(|_| ExactSum::default());
    let mut left = displacement.clone();
    for ((i, g), &c) in question.generators().enumerate().zip(coefficients) {
        if c == 0.0 || basis.contains(&i) {
            continue;
        }
        for (axis, &v) in g.iter().enumerate() {
            if c.abs() == 1.0 {
                whole[axis].add(-c * v);
            } else if v != 0.0 {
                left[axis] = &left[axis] - &(&Dyadic::from_f64(c) * &Dyadic::from_f64(v));
            }
        }
    }
    std::array::from_fn(|axis| &left[axis] + &whole[axis].value())
}

/// The coefficients with Σ δ_b g_b = `sum` over the basis; `None` if its generators are dependent or nothing solves the
/// equation.
pub(in crate::collision) fn solve<const D: usize>(
    question: &Query<'_, D>,
    basis: &[usize],
    sum: &[Dyadic; D],
) -> Option<Vec<Rational>> {
    let columns: Vec<Vec<Rational>> =
        basis.iter().map(|&b| question.generator(b).map(exact_linear::rational).to_vec()).collect();
    exact_linear::solve(&columns, &sum.each_ref().map(Dyadic::to_rational))
}

/// The witness in which the generators of a basis absorb what other coefficients leave, and whether their own are all
/// strictly between −1 and 1. `None` if one leaves [−1, 1].
pub(in crate::collision) fn absorbed<const D: usize>(
    question: &Query<'_, D>,
    displacement: &[Dyadic; D],
    mut coefficients: Vec<f64>,
    basis: Vec<usize>,
) -> Option<(Witness, bool)> {
    let values = solve(question, &basis, &left_over(question, displacement, &coefficients, &basis))?;
    let mut is_strict = true;
    for (&b, value) in basis.iter().zip(&values) {
        if *value > Rational::ONE || *value < Rational::NEG_ONE {
            return None;
        }
        is_strict &= *value < Rational::ONE && *value > Rational::NEG_ONE;
        coefficients[b] = value.to_f64().value();
    }
    Some((Witness { coefficients, basis }, is_strict))
}

/// The witness with nearly these coefficients of [−1, 1] and a basis with much room, and whether it proves an inner
/// point: D coefficients of the basis strictly between −1 and 1. `None` if the basis leaves [−1, 1].
pub(in crate::collision) fn near_witness<const D: usize>(
    question: &Query<'_, D>,
    displacement: &[Dyadic; D],
    coefficients: Vec<f64>,
) -> Option<(Witness, bool)> {
    let mut basis = roomy(question.generators().copied().collect(), |i| 1.0 - coefficients[i].abs());
    basis.sort_unstable();
    let is_whole = basis.len() == D;
    let (witness, is_strict) = absorbed(question, displacement, coefficients, basis)?;
    Some((witness, is_strict && is_whole))
}
