//! Answers to "where does a vector p lie relative to the zonotope Z = { Σ δ_i g_i : |δ_i| ≤ 1 }".
//!
//! Outside: a direction u with u · p > Σ |u · g_i|. In Z: coefficients with Σ δ_i g_i = p. Whether p lies on the
//! boundary then depends on them alone: a supporting direction u ≠ 0 must be orthogonal to every g_i with |δ_i| < 1
//! and must not turn away from δ_i g_i for the others.

use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::displaced::Displaced;
use crate::verdict::Verdict;

use crate::exact::grid::Grid;
use crate::exact::linear::{Echelon, Vector, dot, reduced, solve};
use crate::exact::proportion::{Proportion, check_coefficient};
use crate::faces::cone::{combined, common_direction};

/// The place of a vector relative to a zonotope.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// In the interior; a flat zonotope has none.
    Inside,
    /// In the zonotope, but not in its interior.
    Boundary,
    /// Not in the zonotope.
    Outside,
}

impl Status {
    /// The status with a name: `inside`, `boundary` or `outside`.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Inside, Self::Boundary, Self::Outside].into_iter().find(|status| status.name() == name)
    }

    /// The name of the status.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Boundary => "boundary",
            Self::Outside => "outside",
        }
    }
}

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct LocationAnswer {
    /// The claimed status.
    pub status: Status,
    /// Its proof.
    pub certificate: LocationCertificate,
}

/// The proof of a location.
#[derive(Debug, Clone, PartialEq)]
pub enum LocationCertificate {
    /// A direction that separates: whole numbers, since its length does not matter.
    Separation(Vec<IBig>),
    /// Coefficients of the generators.
    Witness {
        /// One in [−1, 1] for each generator.
        coefficients: Vec<f64>,
        /// At most d generators, by increasing index: their coefficients are those that solve the system exactly, and
        /// the doubles given for them are nearest to these or beside the nearest.
        basis: Vec<usize>,
    },
}

/// The proof of a location.
#[derive(Debug, Clone)]
pub(crate) enum Located {
    /// p = Σ δ_i g_i, with these exact coefficients.
    Member(Coefficients),
    /// A direction that separates p from Z.
    Outside(Vector),
}

/// Exact coefficients: numerators over one positive denominator.
#[derive(Debug, Clone)]
pub(crate) struct Coefficients {
    pub(crate) numerators: Vec<IBig>,
    pub(crate) denominator: IBig,
}

/// Proves the status of an answer, or says what fails.
pub fn check_location(question: &Displaced, answer: &LocationAnswer) -> Verdict<LocationProof> {
    located(question, answer)
        .map(|found| LocationProof { status: answer.status, is_direction: matches!(found, Located::Outside(_)) })
        .into()
}

/// The status that was proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LocationProof {
    /// The status.
    pub status: Status,
    is_direction: bool,
}

impl Display for LocationProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let proof = if self.is_direction {
            "the direction separates exactly"
        } else {
            "the coefficients solve the system exactly and prove the status"
        };
        write!(f, "{}; {proof}", self.status.name())
    }
}

/// The proof of the certificate of an answer, if that is the status of the answer.
pub(super) fn located(question: &Displaced, answer: &LocationAnswer) -> Result<Located, String> {
    let found = proven(question, &answer.certificate)?;
    match (&found, answer.status) {
        (Located::Outside(_), Status::Outside) => Ok(found),
        (Located::Member(coefficients), status @ (Status::Inside | Status::Boundary)) => {
            let interior = is_interior(question, coefficients);
            if interior == (status == Status::Inside) {
                Ok(found)
            } else {
                let truth = if interior { "in the interior" } else { "on the boundary" };
                Err(format!("the status is {}, but it lies {truth}", status.name()))
            }
        }
        (_, status) => Err(format!("the certificate does not fit the status `{}`", status.name())),
    }
}

/// The proof of a certificate by itself: that the vector lies in the zonotope, or that it does not.
pub(crate) fn proven(question: &Displaced, certificate: &LocationCertificate) -> Result<Located, String> {
    match certificate {
        LocationCertificate::Separation(u) if u.len() != question.dimension() => {
            Err(format!("certificate: separating_direction has {} components", u.len()))
        }
        LocationCertificate::Separation(u) if dot(u, &question.p) > question.support(u) => {
            Ok(Located::Outside(u.clone()))
        }
        LocationCertificate::Separation(_) => Err("certificate: the direction does not separate".to_owned()),
        LocationCertificate::Witness { coefficients, basis } => {
            Ok(Located::Member(exact_coefficients(question, coefficients, basis)?))
        }
    }
}

/// The coefficients of a certificate off its basis, and what they leave of the vector, in units of 1 / `one`.
pub(crate) struct Certified {
    /// A numerator for each generator; 0 for those of the basis.
    pub(crate) numerators: Vec<IBig>,
    /// p − Σ δ_i g_i over the generators off the basis.
    pub(crate) rest: Vector,
    /// The denominator of both.
    pub(crate) one: IBig,
}

/// The coefficients off the basis, or what is wrong with them or with the basis.
pub(crate) fn certified_coefficients(
    question: &Displaced,
    coefficients: &[f64],
    basis: &[usize],
) -> Result<Certified, String> {
    let count = question.generators.len();
    if coefficients.len() != count {
        return Err(format!("certificate: {} coefficients for {count} generators", coefficients.len()));
    }
    if let Some(wrong) = basis.iter().find(|&&generator| generator >= count) {
        return Err(format!("certificate: basis names generator {wrong}, which does not exist"));
    }
    if basis.len() > question.dimension() {
        return Err(format!("certificate: the basis has {} generators", basis.len()));
    }
    let mut in_basis = vec![false; count];
    for &generator in basis {
        in_basis[generator] = true;
    }
    let taken = || (0..count).filter(|&index| !in_basis[index]);
    if let Some(wrong) = taken().map(|index| coefficients[index]).find(|delta| !(-1.0..=1.0).contains(delta)) {
        return Err(format!("certificate: the coefficient {wrong} is outside [-1, 1]"));
    }
    let exponent = Grid::of(taken().map(|index| coefficients[index])).exponent().min(0);
    let fractions = Grid::at(exponent);
    let one = IBig::ONE << exponent.unsigned_abs() as usize;
    let mut numerators = vec![IBig::ZERO; count];
    let mut rest: Vector = question.p.iter().map(|component| component * &one).collect();
    for index in taken() {
        numerators[index] = fractions.units(coefficients[index]);
        for (rest, component) in rest.iter_mut().zip(&question.generators[index]) {
            *rest -= &numerators[index] * component;
        }
    }
    Ok(Certified { numerators, rest, one })
}

/// The coefficients, those of the basis solved for.
fn exact_coefficients(question: &Displaced, coefficients: &[f64], basis: &[usize]) -> Result<Coefficients, String> {
    let Certified { mut numerators, rest, one } = certified_coefficients(question, coefficients, basis)?;
    let columns: Vec<&Vector> = basis.iter().map(|&generator| &question.generators[generator]).collect();
    let (solved, denominator) = solve(&columns, &rest)
        .ok_or("certificate: the basis is dependent, or its generators do not lead to the point")?;
    let whole = &one * &denominator;
    for numerator in numerators.iter_mut() {
        *numerator *= &denominator;
    }
    for (&generator, solved) in basis.iter().zip(solved) {
        if solved.clone().abs() > whole {
            let value = Proportion::new(solved, whole, 0).nearest();
            return Err(format!("certificate: the coefficient of basis generator {generator} is {value}"));
        }
        let exact = Proportion::new(solved.clone(), whole.clone(), 0);
        let name = format!("certificate: coefficient {generator}, of the basis,");
        check_coefficient(&name, coefficients[generator], &exact)?;
        numerators[generator] = solved;
    }
    Ok(Coefficients { numerators, denominator: whole })
}

fn is_interior(question: &Displaced, coefficients: &Coefficients) -> bool {
    let dimension = question.dimension();
    let is_free = |numerator: &IBig| numerator.clone().abs() < coefficients.denominator;
    let pairs = || question.generators.iter().zip(&coefficients.numerators);
    let free = pairs().filter(|(_, numerator)| is_free(numerator)).map(|(generator, _)| generator);
    let span = Echelon::spanned(dimension, free);
    let axes = span.complement(dimension);
    if axes.is_empty() {
        return true;
    }
    // Seen along the free generators, where does a direction have all the others on its side?
    let mut seen: Vec<Vector> = pairs()
        .filter(|(_, numerator)| !is_free(numerator))
        .map(|(generator, numerator)| {
            let along = axes.iter().map(|axis| dot(axis, generator));
            reduced(if *numerator < IBig::ZERO { along.map(|x| -x).collect() } else { along.collect() })
        })
        .collect();
    seen.sort_unstable();
    seen.dedup();
    shuffle(&mut seen);
    match common_direction(axes.len(), &seen) {
        Some(coordinates) => {
            let u = combined(&axes, &coordinates);
            assert_eq!(dot(&u, &question.p), question.support(&u), "the direction supports Z in p");
            false
        }
        None => true,
    }
}

/// A fixed order without any pattern, in which the search for a direction is fast.
fn shuffle(vectors: &mut [Vector]) {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for end in (1..vectors.len()).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        vectors.swap(end, (state >> 33) as usize % (end + 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(
        p: &[f64],
        generators: &[&[f64]],
        status: &str,
        coefficients: &[f64],
        basis: &[usize],
    ) -> Result<(), String> {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let question = Displaced::new(&vec![0.0; p.len()], p, &generators).expect("one dimension");
        let certificate = LocationCertificate::Witness { coefficients: coefficients.to_vec(), basis: basis.to_vec() };
        let status = Status::named(status).expect("a status");
        check_location(&question, &LocationAnswer { status, certificate }).proof().map(|_| ())
    }

    fn separates(p: &[f64], generators: &[&[f64]], u: &[i64]) -> bool {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let question = Displaced::new(&vec![0.0; p.len()], p, &generators).expect("one dimension");
        let certificate = LocationCertificate::Separation(u.iter().copied().map(IBig::from).collect());
        check_location(&question, &LocationAnswer { status: Status::Outside, certificate }).is_right()
    }

    const SQUARE: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];

    #[test]
    fn a_square_by_hand() {
        assert_eq!(check(&[0.5, 0.25], &SQUARE, "inside", &[0.5, 0.25], &[0, 1]), Ok(()));
        assert_eq!(check(&[0.5, 0.25], &SQUARE, "inside", &[0.5, 0.25], &[]), Ok(()));
        assert_eq!(check(&[1.0, 0.25], &SQUARE, "boundary", &[1.0, 0.25], &[1]), Ok(()));
        assert_eq!(check(&[1.0, -1.0], &SQUARE, "boundary", &[1.0, -1.0], &[]), Ok(()));
        assert!(check(&[1.0, -1.0], &SQUARE, "inside", &[1.0, -1.0], &[]).is_err());
        assert!(check(&[0.5, 0.25], &SQUARE, "boundary", &[0.5, 0.25], &[]).is_err());
        assert!(check(&[0.5, 0.25], &SQUARE, "inside", &[0.5, 0.5], &[]).is_err());
        assert!(check(&[1.5, 0.0], &SQUARE, "boundary", &[0.0, 0.0], &[0, 1]).is_err());
        assert!(check(&[0.5, 0.0], &SQUARE, "inside", &[0.0, f64::NAN], &[0]).is_err());
        assert!(separates(&[1.5, 0.0], &SQUARE, &[1, 0]));
        assert!(!separates(&[1.0, 0.0], &SQUARE, &[1, 0]), "touching is no gap");
        assert!(!separates(&[1.5, 0.0], &SQUARE, &[-1, 0]));
    }

    #[test]
    fn coefficients_of_the_basis_are_those_that_solve_the_system() {
        let around = |second: f64| check(&[0.5, 0.3], &SQUARE, "inside", &[0.5, second], &[1]);
        for right in [0.3, 0.3_f64.next_up(), 0.3_f64.next_down()] {
            assert_eq!(around(right), Ok(()), "{right}");
        }
        for wrong in [0.3_f64.next_up().next_up(), -0.3, 0.0, 1.0, 9.0, f64::NAN, f64::INFINITY] {
            assert!(around(wrong).is_err(), "{wrong}");
        }
        assert_eq!(check(&[1.0, 0.0], &SQUARE, "boundary", &[1.0, 0.0], &[0]), Ok(()));
        assert!(check(&[1.0, 0.0], &SQUARE, "boundary", &[1.0_f64.next_up(), 0.0], &[0]).is_err());
    }

    #[test]
    fn coefficients_of_one_do_not_make_a_boundary() {
        let star: [&[f64]; 3] = [&[1.0, 0.0], &[0.0, 1.0], &[-1.0, -1.0]];
        assert_eq!(check(&[0.0, 0.0], &star, "inside", &[1.0, 1.0, 1.0], &[]), Ok(()));
        assert_eq!(check(&[0.0, 0.0], &star[..1], "boundary", &[0.0], &[]), Ok(()), "a segment has no inside");
        assert_eq!(check(&[0.0], &[], "boundary", &[], &[]), Ok(()), "a point has none either");
    }
}
