//! The coefficients of a basis that make up for what other coefficients leave, exactly: the step that ends a search for
//! a witness.

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::zonotope::location::Witness;
use crate::zonotope::query::Query;

/// The displacement minus the generators off the basis, each with its coefficient. O(n) exact additions.
pub(in crate::collision) fn left_over<const D: usize>(
    query: &Query<'_, D>,
    displacement: &[Dyadic; D],
    coefficients: &[f64],
    basis: &[usize],
) -> [Dyadic; D] {
    let mut whole: [ExactSum; D] = std::array::from_fn(|_| ExactSum::default());
    let mut left = displacement.clone();
    for ((i, g), &c) in query.generators().enumerate().zip(coefficients) {
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
    query: &Query<'_, D>,
    basis: &[usize],
    sum: &[Dyadic; D],
) -> Option<Vec<Rational>> {
    let columns: Vec<Vec<Rational>> =
        basis.iter().map(|&b| query.generator(b).map(exact_linear::rational).to_vec()).collect();
    exact_linear::solve(&columns, &sum.each_ref().map(Dyadic::to_rational))
}

/// The witness with nearly these coefficients of [−1, 1] and a basis with much room, and whether it proves an inner
/// point: D coefficients of the basis strictly between −1 and 1. `None` if the basis leaves [−1, 1].
pub(in crate::collision) fn near_witness<const D: usize>(
    query: &Query<'_, D>,
    displacement: &[Dyadic; D],
    mut coefficients: Vec<f64>,
) -> Option<(Witness, bool)> {
    let basis = roomy_basis(query, &coefficients);
    let values = solve(query, &basis, &left_over(query, displacement, &coefficients, &basis))?;
    let mut is_strict = true;
    for (&b, value) in basis.iter().zip(&values) {
        if *value > Rational::ONE || *value < Rational::NEG_ONE {
            return None;
        }
        is_strict &= *value < Rational::ONE && *value > Rational::NEG_ONE;
        coefficients[b] = value.to_f64().value();
    }
    let is_inside = is_strict && basis.len() == D;
    Some((Witness { coefficients, basis }, is_inside))
}

/// Generators, independent in floating point, chosen in turn for the room that their coefficients have times how far
/// they lead out of the span of those before; in increasing order.
fn roomy_basis<const D: usize>(query: &Query<'_, D>, coefficients: &[f64]) -> Vec<usize> {
    let mut scales = [0i64; D];
    for (axis, scale) in scales.iter_mut().enumerate() {
        *scale = query.generators().filter_map(|g| binary_exponent(g[axis])).max().map_or(0, i64::from);
    }
    let mut left: Vec<[f64; D]> =
        query.generators().map(|g| std::array::from_fn(|axis| scale_by_power_of_two(g[axis], -scales[axis]))).collect();
    let mut basis = Vec::new();
    while basis.len() < D {
        let length = |v: &[f64; D]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let room = |i: usize| (1.0 - coefficients[i].abs()) * length(&left[i]);
        let best = (0..left.len()).max_by(|&i, &j| room(i).total_cmp(&room(j)));
        // Below this, a residual is what rounding left of a member of the span.
        let Some(best) = best.filter(|&i| room(i) > 0.0 && length(&left[i]) > 1e-13) else { break };
        basis.push(best);
        let size = length(&left[best]);
        let axis = left[best].map(|v| v / size);
        for vector in &mut left {
            let along: f64 = vector.iter().zip(&axis).map(|(a, b)| a * b).sum();
            vector.iter_mut().zip(&axis).for_each(|(a, b)| *a -= along * b);
        }
        left[best] = [0.0; D];
    }
    basis.sort_unstable();
    basis
}
