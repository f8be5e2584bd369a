//! A member of the zonotope as a weighted mean of a few of its vertices, and from there a proof in doubles.
//!
//! A vertex is Σ ± v, so in a mean of eight vertices the coefficient of a generator depends on its eight signs alone:
//! there are few different ones, and one exact sum of generators for each. Coefficients that are not ±1 are rounded,
//! and three independent generators among theirs make up for it exactly. Where that takes one of the three out of [−1,
//! 1], the rational coefficients are moved along dependences of the generators until all but a basis are ±1.

use super::chain::Chain;
use crate::arrangement::DualArrangement;
use crate::arrangement::dual::Upward;
use crate::collision::proof::balance::basis::Basis;
use crate::collision::proof::of_optimum::exactly::rounded;
use crate::collision::proof::to_doubles::rounded_off_a_basis;
use crate::collision::{Query, Witness};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, difference, exact, multiple};
use crate::numeric::signed_sum::signed_sum;

/// Vertices with weights.
#[derive(Debug)]
pub(super) struct Mixture {
    /// Not negative, some positive.
    weights: Vec<Dyadic>,
    /// For each generator the vertices in which its sign is −1, as bits.
    patterns: Vec<u8>,
}

/// The generators of one pattern.
struct Class {
    members: Vec<usize>,
    /// Their coefficient times the total weight.
    numerator: Dyadic,
    /// The coefficient rounded; exact where it is ±1.
    value: f64,
    is_settled: bool,
}

impl Mixture {
    pub(super) fn new(generators: usize) -> Self {
        Self { weights: Vec::new(), patterns: vec![0; generators] }
    }

    /// Adds a vertex by the signs of the generators, at most eight of them; `opposite` turns all signs.
    pub(super) fn add<'a>(&mut self, weight: Dyadic, signs: impl Iterator<Item = (&'a Upward, i8)>, opposite: bool) {
        let bit = 1 << self.weights.len();
        for (upward, sign) in signs {
            if (sign < 0) != (upward.reversed != opposite) {
                self.patterns[upward.generator as usize] |= bit;
            }
        }
        self.weights.push(weight);
    }

    /// Adds the corners of a facet, each weight multiplied by a factor.
    pub(super) fn add_corners(
        &mut self,
        corners: [(&Chain, usize, Dyadic); 4],
        factor: &Dyadic,
        opposite: bool,
        dual: &DualArrangement,
    ) {
        for (chain, corner, weight) in corners {
            self.add(weight * factor.clone(), chain.signs(corner, dual), opposite);
        }
    }

    /// The proof that the mean, which is p, is a member.
    pub(super) fn witness(&self, question: &Query<'_, 3>, p: &ExactVector) -> Witness {
        let total = self.weights.iter().fold(Dyadic::zero(), |total, weight| total + weight.clone());
        let classes = self.classes(&total);
        let mut coefficients = vec![1.0; self.patterns.len()];
        for class in &classes {
            for &member in &class.members {
                coefficients[member] = class.value;
            }
        }
        let loose: Vec<&Class> = classes.iter().filter(|class| !class.is_settled).collect();
        let basis = spanning(question, &loose);
        let rest = classes.iter().fold(p.clone(), |rest, class| {
            let others = class.members.iter().filter(|member| !basis.generators.contains(member));
            let others = signed_sum(others.map(|&member| (question.generator(member), 1)));
            difference(&rest, &multiple(&Dyadic::from_f64(class.value), &others))
        });
        let numerators = basis.numerators(&rest);
        let fits = |numerator: &Dyadic| numerator.clone().abs() <= *basis.determinant();
        if basis.misses(&rest) || !numerators.iter().all(fits) {
            return settled(question, &classes, &total);
        }
        for (&member, numerator) in basis.generators.iter().zip(&numerators) {
            coefficients[member] = rounded(numerator, basis.determinant());
        }
        Witness { coefficients, basis: basis.generators }
    }

    /// The generators by pattern, in the order of the patterns.
    fn classes(&self, total: &Dyadic) -> Vec<Class> {
        let mut members: Vec<Vec<usize>> = vec![Vec::new(); 1 << self.weights.len()];
        for (generator, &pattern) in self.patterns.iter().enumerate() {
            members[usize::from(pattern)].push(generator);
        }
        let used = (0..=u8::MAX).zip(members).filter(|(_, members)| !members.is_empty());
        used.map(|(pattern, members)| {
            let numerator = self.weights.iter().enumerate().fold(Dyadic::zero(), |sum, (vertex, weight)| {
                if pattern >> vertex & 1 == 1 { &sum - weight } else { &sum + weight }
            });
            let is_settled = numerator.clone().abs() == *total;
            // a mean of one point has no weight when the zonotope is that point
            let value = if total.is_zero() { 1.0 } else { rounded(&numerator, total) };
            Class { members, numerator, value, is_settled }
        })
        .collect()
    }
}

/// Independent generators, as many as there are among the loose ones, with room on both sides where there is a choice.
fn spanning(question: &Query<'_, 3>, loose: &[&Class]) -> Basis {
    let mut basis = Basis::new(Vec::new());
    let members = || loose.iter().flat_map(|class| class.members.iter().map(|&member| (class.value, member)));
    while basis.rank() < 3 {
        let normals = basis.rounded_normals();
        let key = |(value, member): (f64, usize)| {
            let v = question.generator(member);
            let distance = normals.iter().map(|n| (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]).abs()).sum::<f64>();
            let key = distance * (1.0 - value.abs());
            if key.is_finite() { key } else { 0.0 }
        };
        let is_missed = |member: &usize| basis.misses(&exact(question.generator(*member)));
        let best = members().max_by(|&a, &b| key(a).total_cmp(&key(b)).then(b.1.cmp(&a.1)));
        let best = best.map(|(_, member)| member).filter(is_missed);
        let Some(next) = best.or_else(|| members().map(|(_, member)| member).find(is_missed)) else { break };
        basis = basis.with(next, |member| exact(question.generator(member)));
    }
    basis
}

/// The proof with doubles off the basis that needs no room. O(n) eliminations.
fn settled(question: &Query<'_, 3>, classes: &[Class], total: &Dyadic) -> Witness {
    let mut coefficients = vec![Rational::ONE; question.len()];
    for class in classes {
        let value = class.numerator.to_rational() / total.to_rational();
        for &member in &class.members {
            coefficients[member] = value.clone();
        }
    }
    rounded_off_a_basis(coefficients, |member| {
        exact(question.generator(member)).iter().map(Dyadic::to_rational).collect()
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::collision::Location;
    use crate::interop::verifier::check_location;
    use ::verifier::Verdict;

    properties! {
        #[test]
        fn both_proofs_of_a_mean_hold(
            generators in proptest::collection::vec([-3i32..4, -3..4, -3..4], 1..9),
            weights in proptest::collection::vec(1i32..9, 1..9),
            signs in proptest::collection::vec(any::<bool>(), 72),
        ) {
            let generators: Vec<[f64; 3]> = generators.iter().map(|v| v.map(f64::from)).collect();
            let upward: Vec<Upward> =
                (0..)
                    .zip(&generators)
                    .map(|(generator, &vector)| Upward { generator, reversed: false, vector })
                    .collect();
            let mut mixture = Mixture::new(generators.len());
            let mut sum = [0.0; 3];
            for (vertex, &weight) in weights.iter().enumerate() {
                let sign = |i: usize| if signs[vertex * generators.len() + i] { 1i8 } else { -1 };
                let signed = upward.iter().enumerate().map(|(i, v)| (v, sign(i)));
                mixture.add(Dyadic::from_f64(weight.into()), signed, false);
                for (i, v) in generators.iter().enumerate() {
                    sum = [0, 1, 2].map(|axis| sum[axis] + f64::from(weight) * f64::from(sign(i)) * v[axis]);
                }
            }
            // the mean, with every generator multiplied by the total so that it is a point of doubles
            let total: i32 = weights.iter().sum();
            let scaled: Vec<[f64; 3]> = generators.iter().map(|v| v.map(|c| c * f64::from(total))).collect();
            let question = Query::new([0.0; 3], sum, &scaled).expect("finite");
            let total = Dyadic::from_f64(total.into());
            let proofs =
                [mixture.witness(&question, &question.exact()), settled(&question, &mixture.classes(&total), &total)];
            for proof in proofs {
                let verdicts =
                    [Location::Inside(proof.clone()), Location::Boundary(proof)].map(|l| check_location(&question, &l));
                prop_assert!(verdicts.iter().any(Verdict::is_right), "{:?}", verdicts);
            }
        }
    }
}
