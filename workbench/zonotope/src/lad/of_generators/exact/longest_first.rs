//! The optimum of all generators as that of the longest: where lengths are very uneven, the others decide nothing.
//!
//! Let u be the optimum of some generators, and δ = sign(v · u) for all others. If the two generators of u's basis
//! balance the sum of the others with coefficients in [−1, 1], then u is the optimum of all generators: the check
//! does not ask why the longest generators were enough.

use crate::lad::by_pruning;
use crate::lad::of_generators::exact::bundle::Bundle;
use crate::lad::of_generators::exact::pivot::Balance;
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::plane::exact_chart::{ChartProblem, ExactChart, Vectors};
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, rounded_direction};
use crate::numeric::linear::max_norm;
use crate::numeric::tolerance::NEGLIGIBLE_LENGTH;
use crate::seed::EXACT_STAGE_SEED;
use crate::tally::{Operation, Tally};

/// At most one generator in this number is among the longest.
const LONGEST_SHARE: usize = 4;

/// If lengths are even, one generator in this number is taken instead: the optimum of this part is near that of all.
const EVEN_SHARE: usize = 16;

/// A generator is nearly orthogonal to a direction of size 1 if their product is at most this part of the generator's
/// size.
const NEARLY_ORTHOGONAL: f64 = 1e-9;

/// Fewer generators are all solved for at once.
pub(crate) const LEAST_COUNT: usize = 128;

/// The optimum of the longest generators, if it is that of all; else a direction to which most generators are nearly
/// orthogonal, if the optimum found is such a direction.
pub(crate) fn optimum(
    query: &dyn KernelQuery,
    p: &ExactVector,
    tally: &mut dyn Tally,
) -> Result<ExactOptimum, Option<[f64; 3]>> {
    if query.len() < LEAST_COUNT {
        return Err(None);
    }
    tally.add(Operation::GeneratorRead, 2 * query.len() as u64);
    let indices = longest(query);
    let none = [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
    let plane = ChartProblem::new(Vectors::some(query, indices.clone()), &none, ExactChart::new(p.clone(), None));
    let outcome = by_pruning::minimize(&plane.problem, EXACT_STAGE_SEED, &mut &mut *tally);
    let optimum = outcome.optimum().ok_or(None)?;
    let direction = plane.direction(optimum.point_in(&plane.problem));
    let mut signs = DirectionSigns::new(query, &direction).all(&direction);
    for (&index, &sign) in indices.iter().zip(&optimum.certificate.signs) {
        signs[index] = sign;
    }
    let basis = optimum.certificate.basis.iter().map(|line| indices[line.position()]).collect();
    let optimum = ExactOptimum::new(query, p, direction, signs, basis);
    if let [first, second] = optimum.basis[..] {
        let bundles = [first, second].map(|index| Bundle::of(index, query.exact_generator(index)));
        if Balance::of(bundles, optimum.sum.clone(), p).is_optimal() {
            return Ok(optimum);
        }
    }
    let center = rounded_direction(&optimum.direction);
    Err(Some(center).filter(|center| is_meeting(query, center)))
}

/// Whether most generators are nearly orthogonal to a direction of size 1. Around such a direction doubles tell signs
/// that they do not tell in other coordinates.
fn is_meeting(query: &dyn KernelQuery, center: &[f64; 3]) -> bool {
    let is_near = |v: &[f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|k| v[k] * center[k]);
        (x + y + z).abs() <= NEARLY_ORTHOGONAL * max_norm(v)
    };
    2 * query.generators().filter(is_near).count() > query.len()
}

/// The longest generators; where these are not few, a part from all over the list.
fn longest(query: &dyn KernelQuery) -> Vec<usize> {
    let least = NEGLIGIBLE_LENGTH * query.generators().map(|v| max_norm(&v)).fold(0.0, f64::max);
    let long: Vec<usize> = query.generators().zip(0..).filter(|(v, _)| max_norm(v) > least).map(|(_, i)| i).collect();
    if LONGEST_SHARE * long.len() <= query.len() { long } else { (0..query.len()).step_by(EVEN_SHARE).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::{dot, exact};
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn the_longest_decide_where_lengths_are_uneven_and_do_not_where_they_are_even() {
        let random = &mut Pcg64Mcg::seed_from_u64(5);
        let mut found = 0;
        for exponents in [280, 0] {
            let body: Vec<[f64; 3]> = (0..1500)
                .map(|_| {
                    let size = libm::exp10(f64::from(random.random_range(-exponents..=exponents)));
                    [0, 1, 2].map(|_| size * random.random_range(-1.0..1.0))
                })
                .collect();
            for _ in 0..5 {
                let p = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                let query = Query::new([0.0; 3], p, &body).expect("finite");
                match optimum(&query, &exact(p), &mut ()) {
                    Ok(answer) => {
                        found += 1;
                        let reach = query
                            .generators()
                            .fold(Dyadic::zero(), |sum, v| sum + dot(&exact(*v), &answer.direction).abs());
                        assert_eq!(reach, answer.reach, "the signs are not those of the direction");
                    }
                    Err(center) => assert_eq!(center, None),
                }
            }
        }
        assert_eq!(found, 5);
    }

    #[test]
    fn where_all_nearly_meet_the_direction_is_told() {
        let random = &mut Pcg64Mcg::seed_from_u64(7);
        let body: Vec<[f64; 3]> = (0..1500)
            .map(|_| {
                let [x, y, z] = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                [x, y, x + y + 1e-14 * z]
            })
            .collect();
        let query = Query::new([0.0; 3], [0.0, 0.0, 1.0], &body).expect("finite");
        let center = optimum(&query, &exact([0.0, 0.0, 1.0]), &mut ()).map(|_| ()).expect_err("a part");
        let [x, y, z] = center.expect("all nearly meet");
        assert!((x + z).abs() + (y + z).abs() < 1e-12, "{x} {y} {z}");
    }
}
