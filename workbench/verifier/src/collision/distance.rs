//! Answers to "how far is the vector p from the zonotope Z = { Σ δ_i g_i : |δ_i| ≤ 1 }": the Euclidean distance of two
//! disjoint bodies, or of a point and a body.
//!
//! The certificate is coefficients of the point x of Z that is claimed to be nearest. With r = p − x, every point of Z
//! has a product with r that is at most that of x just when r · g_i is 0 for |δ_i| < 1, not negative for δ_i = 1 and
//! not positive for δ_i = −1. Then no point of Z is nearer, and the distance is |r|. Coefficients of a basis are solved
//! for: they are those for which r is orthogonal to the basis.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::displaced::Displaced;
use super::location::{Certified, Coefficients, certified_coefficients};
use crate::exact::length::root;
use crate::exact::linear::{Vector, dot, is_zero, solve};
use crate::exact::proportion::{Proportion, check_coefficient, check_figure};
use crate::verdict::Verdict;

/// By how many roundings, of half a unit in the last place each, a claimed distance may be off.
const ROUNDINGS: f64 = 4.0;

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct DistanceAnswer {
    /// The claimed distance, positive.
    pub distance: f64,
    /// One coefficient in [−1, 1] for each generator.
    pub coefficients: Vec<f64>,
    /// At most d independent generators, by increasing index: their coefficients are those for which the point is
    /// nearest, and the doubles given for them are nearest to these or beside the nearest.
    pub basis: Vec<usize>,
}

/// The distance that was proved, up to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistanceProof {
    /// The distance as it was written.
    pub distance: f64,
}

impl Display for DistanceProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "distance {:?} is the exact distance, rounded: no point is nearer", self.distance)
    }
}

/// Proves the distance of a vector that is not in the zonotope, or says what fails.
pub fn check_distance(question: &Displaced, answer: &DistanceAnswer) -> Verdict<DistanceProof> {
    proved(question, answer).into()
}

fn proved(question: &Displaced, answer: &DistanceAnswer) -> Result<DistanceProof, String> {
    nearest(question, answer)?;
    Ok(DistanceProof { distance: answer.distance })
}

/// The nearest point of a zonotope, as it was proved.
pub(super) struct Nearest {
    /// Its exact coefficients.
    pub(super) coefficients: Coefficients,
    /// A positive multiple of the vector that leads from it to p.
    pub(super) residual: Vector,
}

/// The nearest point that the certificate proves, whose distance is the claimed one.
pub(super) fn nearest(question: &Displaced, answer: &DistanceAnswer) -> Result<Nearest, String> {
    let Certified { mut numerators, mut rest, one } =
        certified_coefficients(question, &answer.coefficients, &answer.basis)?;
    let columns: Vec<&Vector> = answer.basis.iter().map(|&generator| &question.generators[generator]).collect();
    let products = |v: &Vector| -> Vector { columns.iter().map(|column| dot(column, v)).collect() };
    let gram: Vec<Vector> = columns.iter().map(|column| products(column)).collect();
    let (solved, denominator) =
        solve(&gram.iter().collect::<Vec<_>>(), &products(&rest)).ok_or("certificate: the basis is dependent")?;
    let whole = &one * &denominator;
    rest.iter_mut().chain(&mut numerators).for_each(|number| *number *= &denominator);
    for ((&generator, column), solved) in answer.basis.iter().zip(&columns).zip(solved) {
        if solved.clone().abs() > whole {
            let value = Proportion::new(solved, whole, 0).nearest();
            return Err(format!("certificate: the coefficient of basis generator {generator} is {value}"));
        }
        let name = format!("certificate: coefficient {generator}, of the basis,");
        let exact = Proportion::new(solved.clone(), whole.clone(), 0);
        check_coefficient(&name, answer.coefficients[generator], &exact)?;
        for (rest, component) in rest.iter_mut().zip(*column) {
            *rest -= &solved * component;
        }
        numerators[generator] = solved;
    }
    if is_zero(&rest) {
        return Err("certificate: the vector is in the zonotope".to_owned());
    }
    for (index, (generator, numerator)) in question.generators.iter().zip(&numerators).enumerate() {
        let along = dot(&rest, generator).cmp(&IBig::ZERO);
        let is_extreme = match along {
            Ordering::Equal => true,
            Ordering::Greater => *numerator == whole,
            Ordering::Less => *numerator == -whole.clone(),
        };
        if !is_extreme {
            return Err(format!("certificate: generator {index} leads nearer to the vector"));
        }
    }
    let [low, high] = root(&dot(&rest, &rest));
    let unit = Proportion::new(IBig::ONE, whole.clone(), question.exponent());
    let (low, high) = (low.times(&unit), high.times(&unit));
    let allowed = high.times(&Proportion::of_double(ROUNDINGS * f64::EPSILON / 2.0));
    check_figure("distance", answer.distance, &low, &allowed)?;
    Ok(Nearest { coefficients: Coefficients { numerators, denominator: whole }, residual: rest })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(p: &[f64], distance: f64, coefficients: &[f64], basis: &[usize]) -> Result<(), String> {
        let question = Displaced::new(&vec![0.0; p.len()], p, &[[1.0, 0.0], [0.0, 1.0]]).expect("one dimension");
        let answer = DistanceAnswer { distance, coefficients: coefficients.to_vec(), basis: basis.to_vec() };
        check_distance(&question, &answer).proof().map(drop)
    }

    #[test]
    fn a_square_by_hand() {
        // the corner (1, 1) is nearest to (4, 5), the point (1, 1/4) of a side to (3, 1/4)
        assert_eq!(check(&[4.0, 5.0], 5.0, &[1.0, 1.0], &[]), Ok(()));
        assert_eq!(check(&[4.0, -5.0], 5.0, &[1.0, -1.0], &[]), Ok(()));
        assert_eq!(check(&[3.0, 0.25], 2.0, &[1.0, 0.25], &[1]), Ok(()));
        assert_eq!(check(&[3.0, 0.25], 2.0, &[1.0, 0.25], &[]), Ok(()));
        assert_eq!(check(&[3.0, -1.0], 2.0, &[1.0, -1.0], &[1]), Ok(()));
        assert_eq!(check(&[2.0, 2.0], 2.0_f64.sqrt(), &[1.0, 1.0], &[]), Ok(()));
    }

    #[test]
    fn what_is_wrong_is_told() {
        for distance in [5.0 + 16.0 * f64::EPSILON, 4.0, 0.0, -5.0, f64::NAN, f64::INFINITY] {
            assert!(check(&[4.0, 5.0], distance, &[1.0, 1.0], &[]).is_err(), "{distance}");
        }
        assert!(check(&[4.0, 5.0], 5.0, &[1.0, 0.5], &[]).is_err(), "not the nearest point");
        assert!(check(&[3.0, 0.25], 2.0, &[1.0, 0.5], &[1]).is_err(), "the coefficient is another");
        assert!(check(&[3.0, 2.0], 5.0_f64.sqrt(), &[1.0, 1.0], &[1]).is_err(), "the basis leaves the square");
        assert!(check(&[0.5, 0.25], 1.0, &[0.5, 0.25], &[0, 1]).is_err(), "inside");
        assert!(check(&[4.0, 5.0], 5.0, &[1.0], &[]).is_err() && check(&[4.0, 5.0], 5.0, &[1.0; 2], &[2]).is_err());
    }
}
