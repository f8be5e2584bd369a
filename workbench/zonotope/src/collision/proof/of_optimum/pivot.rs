//! From an exact proof with rational coefficients to one with doubles off the basis.
//!
//! The state is a solution of Σ x_i v_i = p with every x_i in [−1, 1]. A generator off the basis is either rounded, its
//! coefficient a double, or waits with ±1 / λ, which is rational; the coefficients of the basis solve the equation. A
//! group of waiting generators is rounded to ±c at once if the basis stays in [−1, 1]; else the group is halved and
//! each half is tried. Where a single generator takes a basis coefficient to ±1 on its way to ±c, the basis generator
//! stays there, rounded, and the waiting generator takes its place in the basis. Every step keeps the state, so the
//! walk ends with a proof.

use std::cmp::Ordering;

use super::exactly::{Combination, rounded};
use crate::collision::Witness;
use crate::collision::proof::balance::basis::Basis;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, difference, multiple};

struct Walk<'a> {
    combination: &'a Combination<'a>,
    basis: Basis,
    coefficients: Vec<f64>,
    /// p − Σ x v over the rounded generators.
    rest: ExactVector,
    /// Σ sign · v over the generators that wait.
    waiting: ExactVector,
    factor: f64,
}

/// The proof with ±`factor`, a double near 1 / λ, for nearly all generators. Expected O(n), at most O(n log n) exact
/// additions and O(n) pivots.
pub(crate) fn walk(combination: &Combination<'_>, factor: f64) -> Witness {
    let signs = combination.optimum.signs(combination.query);
    let basis = combination.basis.clone();
    let group: Vec<usize> = (0..signs.len()).filter(|i| signs[*i] != 0 && !basis.generators.contains(i)).collect();
    let waiting = sum_of(combination, &group);
    let coefficients = vec![0.0; signs.len()];
    let mut walk = Walk { combination, basis, coefficients, rest: combination.p.clone(), waiting, factor };
    walk.assign(&group);
    let numerators = walk.basis.numerators(&walk.rest);
    for (&b, numerator) in walk.basis.generators.iter().zip(&numerators) {
        walk.coefficients[b] = rounded(numerator, walk.basis.determinant());
    }
    Witness { coefficients: walk.coefficients, basis: walk.basis.generators }
}

fn sum_of(combination: &Combination<'_>, group: &[usize]) -> ExactVector {
    let signs = combination.optimum.signs(combination.query);
    combination.query.signed_sum_of(&mut group.iter().map(|&i| (i, signs[i])))
}

impl Walk<'_> {
    /// Gives the generators of a group ±`factor` if that leaves the coefficients of the basis in [−1, 1]; else the
    /// halves of the group are tried, and a single generator is exchanged for a member of the basis.
    fn assign(&mut self, group: &[usize]) {
        if group.is_empty() {
            return;
        }
        let moved = sum_of(self.combination, group);
        let rest = difference(&self.rest, &multiple(&Dyadic::from_f64(self.factor), &moved));
        let waiting = difference(&self.waiting, &moved);
        if self.numerators(&rest, &waiting).iter().all(|n| self.is_coefficient(n)) {
            (self.rest, self.waiting) = (rest, waiting);
            for &i in group {
                self.coefficients[i] =
                    self.factor * f64::from(self.combination.optimum.signs(self.combination.query)[i]);
            }
        } else if let &[generator] = group {
            self.pivot(generator, &rest, waiting);
        } else {
            let (first, second) = group.split_at(group.len() / 2);
            self.assign(first);
            self.assign(second);
        }
    }

    /// The coefficients of the basis times λ's numerator and the determinant.
    fn numerators(&self, rest: &ExactVector, waiting: &ExactVector) -> Vec<Dyadic> {
        let optimum = self.combination.optimum;
        self.basis.numerators(&difference(&multiple(&optimum.reach, rest), &multiple(&optimum.along, waiting)))
    }

    fn is_coefficient(&self, numerator: &Dyadic) -> bool {
        numerator.clone().abs() <= self.one()
    }

    /// A coefficient of 1 in the scale of [`numerators`](Self::numerators).
    fn one(&self) -> Dyadic {
        &self.combination.optimum.reach * self.basis.determinant()
    }

    /// Leaves the basis member that reaches ±1 first on the way to `rest` and `waiting` at that value; the generator
    /// takes its place in the basis.
    fn pivot(&mut self, generator: usize, rest: &ExactVector, waiting: ExactVector) {
        let one = self.one();
        let starts = self.numerators(&self.rest, &self.waiting);
        let ends = self.numerators(rest, &waiting);
        // at time t in [0, 1] the coefficient is start + t (end − start); it leaves [−1, 1] at room / speed
        let departure = |member: usize| {
            let (start, end) = (&starts[member], &ends[member]);
            (!self.is_coefficient(end)).then(|| {
                let bound = if end.sign() == Ordering::Greater { one.clone() } else { -one.clone() };
                let side = if end.sign() == Ordering::Greater { 1.0 } else { -1.0 };
                (member, side, (&bound - start).abs(), (end - start).abs())
            })
        };
        let earlier =
            |a: &(usize, f64, Dyadic, Dyadic), b: &(usize, f64, Dyadic, Dyadic)| (&a.2 * &b.3).cmp(&(&b.2 * &a.3));
        let (member, side, ..) = (0..starts.len())
            .filter_map(departure)
            .min_by(earlier)
            .expect("the group was not assigned because a coefficient leaves [−1, 1]");
        let leaving = self.basis.generators[member];
        let query = self.combination.query;
        self.coefficients[leaving] = side;
        self.rest = difference(&self.rest, &multiple(&Dyadic::from_f64(side), &query.exact_generator(leaving)));
        self.waiting = waiting;
        let mut members = self.basis.generators.clone();
        members[member] = generator;
        members.sort_unstable();
        self.basis = Basis::new(members.into_iter().map(|i| (i, query.exact_generator(i))).collect());
    }
}
