//! The answer in constant size: the facet in which the ray along the displacement leaves the body.

use std::cmp::Ordering;

use super::basis::Basis;
use super::cell::Cell;
use super::certain::Certain;
use super::exit::Exit;
use super::search::{Found, rounded_displacement, search};
use crate::collision::{Displacement, Gauge, Location, Separation, Witness};
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::tally::Tally;

/// Where the ray along a displacement leaves the zonotope: the gauge and the status at once, the full proof on demand.
#[derive(Debug)]
pub struct Facet<'q> {
    question: &'q Displacement<'q, 3>,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// The displacement is zero.
    Center,
    /// A direction that separates, found before the facet.
    Separated([f64; 3]),
    /// Proved in doubles, the status included; with the cell whose centre gives the signs that were not looked at.
    Certain(Box<Certain>, Option<Cell>, Ordering),
    /// Solved exactly.
    Exact(Box<Exit>),
}

impl<'q> Facet<'q> {
    /// Finds the facet, or, `until_separated`, a separating direction if that is found first.
    pub(super) fn find(question: &'q Displacement<'q, 3>, until_separated: bool, tally: &mut impl Tally) -> Self {
        let p = rounded_displacement(question);
        if p.iter().all(|c| c.value == 0.0) {
            return Self { question, kind: Kind::Center };
        }
        let kind = match search(question, &p, until_separated, tally) {
            Found::Separated(direction) => Kind::Separated(direction),
            Found::Certain(certain, cell) => match (certain.along - certain.reach).sign() {
                Some(sign) if is_sharp(&certain) => Kind::Certain(certain, cell, sign.cmp(&0)),
                _ => Kind::Exact(Box::new(Exit::of_certain(question, &question.exact(), &certain, cell.as_ref()))),
            },
            Found::Reduced(reduced) => {
                let exact = question.exact();
                let exit = Exit::of_reduced(question, &exact, &reduced, tally);
                Kind::Exact(Box::new(exit.unwrap_or_else(|| Exit::find(question, &exact, tally))))
            }
            Found::Nothing => Kind::Exact(Box::new(Exit::find(question, &question.exact(), tally))),
        };
        Self { question, kind }
    }

    /// The gauge within a bound of its error; infinite where no multiple of the body holds the displacement. O(1).
    pub fn value(&self) -> (f64, f64) {
        match &self.kind {
            Kind::Center => (0.0, 0.0),
            Kind::Separated(_) => (f64::INFINITY, f64::INFINITY),
            Kind::Certain(certain, ..) => quotient(certain.along, certain.reach),
            Kind::Exact(exit) => exit.value(),
        }
    }

    /// The generators, at most two, that span the facet's direction where the ray leaves. O(1).
    pub fn basis(&self) -> &[usize] {
        match &self.kind {
            Kind::Center | Kind::Separated(_) => &[],
            Kind::Certain(certain, ..) => &certain.basis,
            Kind::Exact(exit) => &exit.basis,
        }
    }

    /// Whether the displacement is in the closed body. O(1).
    pub fn is_member(&self) -> bool {
        match &self.kind {
            Kind::Center => true,
            Kind::Separated(_) => false,
            Kind::Certain(_, _, order) => order.is_le(),
            Kind::Exact(exit) => exit.along <= exit.reach,
        }
    }

    /// The gauge with where the displacement lies. O(n).
    pub fn gauge(&self) -> Gauge<3> {
        let (value, error) = self.value();
        Gauge { value, error, location: self.location() }
    }

    /// Where the displacement lies, with its proof. O(n) for a member, else O(1) nearly always.
    pub fn location(&self) -> Location<3> {
        match &self.kind {
            Kind::Center => self.center(),
            Kind::Separated(direction) => Location::Outside(Separation::Rounded(*direction)),
            Kind::Exact(exit) => exit.location(self.question, &self.question.exact()),
            Kind::Certain(certain, cell, order) => {
                let p = rounded_displacement(self.question);
                let proof = match order {
                    Ordering::Greater => separation(certain, &p).map(Location::Outside),
                    _ => self.witness(certain, cell.as_ref(), &p).map(Location::Inside),
                };
                proof.unwrap_or_else(|| {
                    let exact = self.question.exact();
                    Exit::of_certain(self.question, &exact, certain, cell.as_ref()).location(self.question, &exact)
                })
            }
        }
    }

    /// The centre is a member with all coefficients 0, inside just when the generators span space.
    fn center(&self) -> Location<3> {
        let witness = Witness { coefficients: vec![0.0; self.question.len()], basis: Vec::new() };
        if Basis::spanning(self.question, Basis::new(Vec::new())).0.rank() == 3 {
            Location::Inside(witness)
        } else {
            Location::Boundary(witness)
        }
    }

    /// The proof of a member whose three basis coefficients are certainly within (−1, 1).
    fn witness(&self, certain: &Certain, cell: Option<&Cell>, p: &BoundedVector) -> Option<Witness> {
        let (third, sign) = self.third(certain, cell)?;
        let [a, b] = certain.vectors.map(bounded::exact);
        let c = bounded::exact(self.question.generator(third));
        let off = [0, 1, 2].map(|k| certain.sum[k] - c[k] * Bounded::exact(f64::from(sign)));
        let normals = [bounded::cross(&b, &c), bounded::cross(&c, &a), bounded::cross(&a, &b)];
        let determinant = bounded::dot(&c, &normals[2]);
        let negative = determinant.sign()? < 0;
        let determinant = if negative { determinant.negated() } else { determinant };
        let inverse = (certain.along.value / certain.reach.value).min(1.0);
        let (factor, numerators) = [inverse, 1.0].into_iter().find_map(|factor| {
            let rest = [0, 1, 2].map(|k| p[k] - off[k] * Bounded::exact(factor));
            let numerators = [0, 1, 2].map(|i| bounded::dot(&rest, &normals[i]));
            numerators.iter().all(|n| n.is_within(determinant)).then_some((factor, numerators))
        })?;
        let mut coefficients = match cell {
            Some(cell) => self.question.generators().map(|v| f64::from(cell.sign(v)) * factor).collect(),
            None => vec![0.0; self.question.len()],
        };
        for &(index, sign) in &certain.overrides {
            coefficients[index as usize] = f64::from(sign) * factor;
        }
        let mut basis = vec![certain.basis[0], certain.basis[1], third];
        for (&index, numerator) in basis.iter().zip(numerators) {
            let value = numerator.value / determinant.value;
            coefficients[index] = if negative { -value } else { value };
        }
        basis.sort_unstable();
        Some(Witness { coefficients, basis })
    }

    /// The generator that is farthest from the facet's plane, among a few, and its sign.
    fn third(&self, certain: &Certain, cell: Option<&Cell>) -> Option<(usize, i8)> {
        const FEW: usize = 32;
        let [x, y, z] = certain.direction.map(|c| c.value);
        let n = self.question.len();
        let picks = (0..n).step_by(n.div_ceil(FEW).max(1));
        let farthest = picks
            .map(|i| {
                let v = self.question.generator(i);
                (v[0] * x + v[1] * y + v[2] * z, i)
            })
            .filter(|(_, i)| !certain.basis.contains(i))
            .max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
        let (_, index) = farthest;
        let own = certain.overrides.iter().find(|(i, _)| *i as usize == index).map(|(_, sign)| *sign);
        Some((index, own.or_else(|| cell.map(|cell| cell.sign(&self.question.generator(index))))?))
    }
}

/// The direction of the facet in doubles: rounding it by e takes at most e · (Σ |v|_1 + |p|_1) off the gap.
fn separation(certain: &Certain, p: &BoundedVector) -> Option<Separation<3>> {
    let error = certain.direction.iter().fold(0.0f64, |m, c| m.max(c.error));
    let size: f64 = p.iter().map(|c| c.magnitude()).sum();
    let gap = certain.along - certain.reach;
    let lost = Bounded::exact(error) * (Bounded::exact(2.0 * certain.magnitude) + Bounded::exact(2.0 * size));
    let direction = certain.direction.map(|c| c.value);
    (gap - lost).is_positive().then_some(Separation::Rounded(direction))
}

/// Whether the gauge is known to one part in 2^44; where terms of the reach cancel, the exact one is taken instead.
fn is_sharp(certain: &Certain) -> bool {
    let (value, error) = quotient(certain.along, certain.reach);
    error <= value * SHARP
}

/// 2^-44.
const SHARP: f64 = 256.0 * f64::EPSILON;

/// a / b for a and b positive, with a bound for its error.
fn quotient(a: Bounded, b: Bounded) -> (f64, f64) {
    let value = a.value / b.value;
    let error = (a.error + value * b.error) / (b.value - b.error) + value * f64::EPSILON;
    (value, error * (1.0 + 8.0 * f64::EPSILON) + f64::MIN_POSITIVE)
}
