//! Answers to "where does a vector p lie relative to the zonotope Z = { Σ δ_i g_i : |δ_i| ≤ 1 }".
//!
//! Outside: a direction u with u · p > Σ |u · g_i|. In Z: coefficients with Σ δ_i g_i = p. Whether p lies on the boundary
//! then depends on them alone: a supporting direction u ≠ 0 must be orthogonal to every g_i with |δ_i| < 1 and must not
//! turn away from δ_i g_i for the others.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::grid::Grid;
use crate::exact::linear::{Echelon, Vector, dot, reduced, solve};
use crate::exact::proportion::Proportion;
use crate::faces::cone::{combined, common_direction};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct LocationAnswer {
    /// `inside`, `boundary` or `outside`.
    pub status: String,
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
        /// One in [−1, 1] for each generator; what stands at the basis is not read.
        coefficients: Vec<f64>,
        /// At most d generators whose coefficients are solved for.
        basis: Vec<usize>,
    },
}

/// The question: the exact vector from one point to another, and generators, all of one dimension.
#[derive(Debug, Clone)]
pub struct Displaced {
    pub(crate) p: Vector,
    pub(crate) generators: Vec<Vector>,
}

/// What was proved of a location.
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

impl Displaced {
    /// The vector `to` − `from` and the generators.
    pub fn new(from: &[f64], to: &[f64], generators: &[Vec<f64>]) -> Result<Self, String> {
        let dimension = from.len();
        if to.len() != dimension || generators.iter().any(|generator| generator.len() != dimension) {
            return Err("answered a question whose dimensions do not agree".to_owned());
        }
        let grid = Grid::of(from.iter().chain(to).chain(generators.iter().flatten()).copied());
        let placed = |v: &[f64]| -> Vector { v.iter().map(|&component| grid.units(component)).collect() };
        let p = placed(to).iter().zip(placed(from)).map(|(to, from)| to - from).collect();
        Ok(Self { p, generators: generators.iter().map(|generator| placed(generator)).collect() })
    }

    pub(crate) fn dimension(&self) -> usize {
        self.p.len()
    }

    /// The exact support function Σ |u · g_i|.
    pub(crate) fn support(&self, u: &[IBig]) -> IBig {
        self.generators.iter().map(|generator| dot(u, generator).abs()).sum()
    }
}

/// Proves the status of an answer, or says what fails.
pub fn check_location(question: &Displaced, answer: &LocationAnswer) -> Result<(), String> {
    located(question, answer).map(|_| ())
}

pub(crate) fn located(question: &Displaced, answer: &LocationAnswer) -> Result<Located, String> {
    match (&answer.certificate, answer.status.as_str()) {
        (LocationCertificate::Separation(u), "outside") => {
            if u.len() != question.dimension() {
                return Err(format!("separating_direction has {} components", u.len()));
            }
            if dot(u, &question.p) > question.support(u) {
                Ok(Located::Outside(u.clone()))
            } else {
                Err("the direction does not separate".to_owned())
            }
        }
        (LocationCertificate::Witness { coefficients, basis }, status @ ("inside" | "boundary")) => {
            let coefficients = exact_coefficients(question, coefficients, basis)?;
            let interior = is_interior(question, &coefficients);
            if interior == (status == "inside") {
                Ok(Located::Member(coefficients))
            } else {
                let truth = if interior { "in the interior" } else { "on the boundary" };
                Err(format!("the status is {status}, but it lies {truth}"))
            }
        }
        (_, status) => Err(format!("the certificate does not fit the status `{status}`")),
    }
}

/// The coefficients, those of the basis solved for.
fn exact_coefficients(question: &Displaced, coefficients: &[f64], basis: &[usize]) -> Result<Coefficients, String> {
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
    let columns: Vec<&Vector> = basis.iter().map(|&generator| &question.generators[generator]).collect();
    let (solved, denominator) = solve(&columns, &rest)
        .ok_or("certificate: the basis is dependent, or its generators do not lead to the point")?;
    let whole = &one * &denominator;
    for numerator in numerators.iter_mut() {
        *numerator *= &denominator;
    }
    for (&generator, solved) in basis.iter().zip(solved) {
        if solved.clone().abs() > whole {
            let value = Proportion::new(solved, whole, 0).near();
            return Err(format!("certificate: the coefficient of basis generator {generator} is {value}"));
        }
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
            debug_assert_eq!(dot(&u, &question.p), question.support(&u), "the direction supports Z in p");
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
        check_location(&question, &LocationAnswer { status: status.to_owned(), certificate })
    }

    fn separates(p: &[f64], generators: &[&[f64]], u: &[i64]) -> bool {
        let generators: Vec<Vec<f64>> = generators.iter().map(|generator| generator.to_vec()).collect();
        let question = Displaced::new(&vec![0.0; p.len()], p, &generators).expect("one dimension");
        let certificate = LocationCertificate::Separation(u.iter().copied().map(IBig::from).collect());
        check_location(&question, &LocationAnswer { status: "outside".to_owned(), certificate }).is_ok()
    }

    const SQUARE: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];

    #[test]
    fn a_square_by_hand() {
        assert_eq!(check(&[0.5, 0.25], &SQUARE, "inside", &[0.0, 0.0], &[0, 1]), Ok(()));
        assert_eq!(check(&[0.5, 0.25], &SQUARE, "inside", &[0.5, 0.25], &[]), Ok(()));
        assert_eq!(check(&[1.0, 0.25], &SQUARE, "boundary", &[1.0, 9.0], &[1]), Ok(()));
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
    fn coefficients_of_one_do_not_make_a_boundary() {
        let star: [&[f64]; 3] = [&[1.0, 0.0], &[0.0, 1.0], &[-1.0, -1.0]];
        assert_eq!(check(&[0.0, 0.0], &star, "inside", &[1.0, 1.0, 1.0], &[]), Ok(()));
        assert_eq!(check(&[0.0, 0.0], &star[..1], "boundary", &[0.0], &[]), Ok(()), "a segment has no inside");
        assert_eq!(check(&[0.0], &[], "boundary", &[], &[]), Ok(()), "a point has none either");
    }
}
