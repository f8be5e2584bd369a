//! A member of the zonotope as a weighted mean of a few of its vertices, and from there a proof in doubles.
//!
//! A vertex is Σ ± v, so in a mean of eight vertices the coefficient of a generator depends on its eight signs alone: there are
//! few different ones, and one exact sum of generators for each. Coefficients that are not ±1 are rounded, and three
//! independent generators among theirs make up for it exactly. Where that takes one of the three out of [−1, 1], the
//! generators are settled one by one in exact arithmetic: each joins the basis, or moves until it or a member of the basis
//! is at ±1 and stays there. What is left in the end is a basis with all others at ±1.

use super::chain::Chain;
use crate::arrangement::DualArrangement;
use crate::arrangement::dual::Upward;
use crate::collision::by_lad::basis::Basis;
use crate::collision::by_lad::sums::signed_sum;
use crate::collision::by_lad::witness::rounded;
use crate::collision::{Displacement, Witness};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::vector::{ExactVector, difference, exact, is_zero, multiple, sum};

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
    pub(super) fn witness(&self, question: &Displacement<'_, 3>, p: &ExactVector) -> Witness {
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
            return settle_one_by_one(question, &loose, &total, coefficients);
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
fn spanning(question: &Displacement<'_, 3>, loose: &[&Class]) -> Basis {
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
        basis = basis.with(next, |member| question.generator(member));
    }
    basis
}

/// The proof with ±1 off the basis. `coefficients` holds ±1 for all but the loose generators. O(n) pivots.
fn settle_one_by_one(
    question: &Displacement<'_, 3>,
    loose: &[&Class],
    total: &Dyadic,
    mut coefficients: Vec<f64>,
) -> Witness {
    let of = |member: usize| question.generator(member);
    let mut basis = Basis::new(Vec::new());
    // total times what the basis has to make up for: p − Σ x v over all others
    let mut rest = exact([0.0; 3]);
    let members = loose.iter().flat_map(|class| class.members.iter().map(|&member| (&class.numerator, member)));
    for (numerator, member) in members {
        let v = exact(of(member));
        if is_zero(&v) {
            continue;
        }
        rest = sum(&rest, &multiple(numerator, &v));
        if basis.misses(&v) {
            basis = basis.with(member, of);
            continue;
        }
        let leaving = pivot(&basis, &difference(&rest, &multiple(numerator, &v)), &v, &(total - numerator), total);
        let (settled, side) = leaving.map_or((member, 1.0), |(position, side)| (basis.generators[position], side));
        coefficients[settled] = side;
        rest = difference(&rest, &multiple(total, &exact(of(settled).map(|c| side * c))));
        if settled != member {
            let kept = basis.generators.iter().filter(|&&b| b != settled).chain([&member]);
            let mut kept: Vec<usize> = kept.copied().collect();
            kept.sort_unstable();
            basis = Basis::new(kept.into_iter().map(|b| (b, of(b))).collect());
        }
    }
    let one = basis.determinant() * total;
    for (&member, numerator) in basis.generators.iter().zip(&basis.numerators(&rest)) {
        coefficients[member] = rounded(numerator, &one);
    }
    Witness { coefficients, basis: basis.generators }
}

/// Moves the coefficient of v, a vector of the span, towards 1, which is `room` / `total` away: the position in the basis of
/// the first member that comes to ±1 before that, and where; none if v comes to 1 first.
fn pivot(basis: &Basis, rest: &ExactVector, v: &ExactVector, room: &Dyadic, total: &Dyadic) -> Option<(usize, f64)> {
    let one = basis.determinant() * total;
    let (speeds, starts) = (basis.numerators(v), basis.numerators(rest));
    // member b has coefficient (start − t · speed) / one at time t, where v has moved by t / total
    let mut first: Option<(usize, f64, Dyadic, Dyadic)> = None;
    for (position, (speed, start)) in speeds.iter().zip(&starts).enumerate() {
        let side = match speed.sign() {
            std::cmp::Ordering::Greater => -1.0,
            std::cmp::Ordering::Less => 1.0,
            std::cmp::Ordering::Equal => continue,
        };
        let bound = if side < 0.0 { -one.clone() } else { one.clone() };
        let (way, speed) = ((start - &bound).abs(), speed.clone().abs());
        let is_sooner = match &first {
            Some((_, _, best_way, best_speed)) => &way * best_speed < best_way * &speed,
            None => way < room * &speed,
        };
        if is_sooner {
            first = Some((position, side, way, speed));
        }
    }
    first.map(|(position, side, ..)| (position, side))
}
