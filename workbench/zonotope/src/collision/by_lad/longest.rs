//! The optimum of all generators as that of the longest: where lengths are very uneven, the others decide nothing.
//!
//! Let u be the optimum of some generators, and δ = sign(v · u) for all others. If the two generators of u's basis make up for the rest with
//! coefficients in [−1, 1], then u is the optimum of all: the check does not ask why the longest were enough.

use super::exit::Exit;
use super::pair_direction::PairDirection;
use super::plane::{Plane, PlaneProblem, Vectors};
use crate::collision::Displacement;
use crate::lad::by_pruning;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::vector::{ExactVector, cross, dot, exact, rounded_direction};
use crate::tally::{Operation, Tally};

/// One generator in so many is taken for one of the longest, and no fewer than `LEAST`.
const SHARE: usize = 16;
const LEAST: usize = 64;

impl Exit {
    /// The optimum of the longest generators if it is that of all; else a direction near it.
    pub(super) fn of_longest(
        question: &Displacement<'_, 3>,
        p: &ExactVector,
        seed: u64,
        tally: &mut impl Tally,
    ) -> Result<Self, Option<[f64; 3]>> {
        let count = LEAST.max(question.len() / SHARE);
        if question.len() < 2 * count {
            return Err(None);
        }
        tally.add(Operation::GeneratorRead, 2 * question.len() as u64);
        let indices = longest(question, count);
        let vectors: Vec<[f64; 3]> = indices.iter().map(|&index| question.generator(index)).collect();
        let none = [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
        let plane = PlaneProblem::new(Vectors::Few(&vectors), &none, Plane::new(p.clone(), None));
        let outcome = by_pruning::minimize_counted(&plane.problem, seed, tally);
        let optimum = outcome.optimum().ok_or(None)?;
        let direction = plane.direction(optimum.homogeneous_point(&plane.problem));
        let pairs = PairDirection::new(&direction);
        let exact_sign = |v: &[f64; 3]| dot(&exact(*v), &direction).sign() as i8;
        let sign = |v: &[f64; 3]| pairs.certain_sign(v).unwrap_or_else(|| exact_sign(v));
        let mut signs: Vec<i8> = question.generators().map(sign).collect();
        for (&index, &sign) in indices.iter().zip(&optimum.certificate.signs) {
            signs[index] = sign;
        }
        let basis = optimum.certificate.basis.iter().map(|line| indices[line.position()]).collect();
        let exit = Self::new(question, p, direction, signs, basis);
        if exit.is_optimal(question, p) { Ok(exit) } else { Err(Some(rounded_direction(&exit.direction))) }
    }

    /// Whether two generators of the basis make up for what all others leave, with coefficients in [−1, 1].
    fn is_optimal(&self, question: &Displacement<'_, 3>, p: &ExactVector) -> bool {
        let [first, second] = self.basis[..] else { return false };
        let [a, b] = [first, second].map(|index| exact(question.generator(index)));
        let is_within = |own: &ExactVector, other: &ExactVector| {
            let dual = cross(other, p);
            dot(&self.sum, &dual).abs() <= dot(own, &dual).abs()
        };
        is_within(&a, &b) && is_within(&b, &a)
    }
}

/// The longest generators, in the order of their indices.
fn longest(question: &Displacement<'_, 3>, count: usize) -> Vec<usize> {
    let size = |v: &[f64; 3]| v.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let mut sizes: Vec<(f64, usize)> = question.generators().map(size).zip(0..).collect();
    sizes.select_nth_unstable_by(count - 1, |a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut indices: Vec<usize> = sizes[..count].iter().map(|(_, index)| *index).collect();
    indices.sort_unstable();
    indices
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::vector::is_zero;
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
                let question = Displacement::new([0.0; 3], p, &body).expect("finite");
                match Exit::of_longest(&question, &exact(p), 1, &mut ()) {
                    Ok(exit) => {
                        found += 1;
                        let reach = question
                            .generators()
                            .fold(Dyadic::zero(), |sum, v| sum + dot(&exact(*v), &exit.direction).abs());
                        assert_eq!(reach, exit.reach, "the signs are not those of the direction");
                    }
                    Err(center) => assert!(center.is_some_and(|c| !is_zero(&exact(c)))),
                }
            }
        }
        assert_eq!(found, 5);
    }
}
