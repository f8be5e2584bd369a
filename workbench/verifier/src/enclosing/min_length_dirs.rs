//! Answers to "the cheapest zonotope { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } along given directions v_i that contains the
//! points".
//!
//! Forces λ_j at points p_j with Σ λ_j = 0 and Σ_j |λ_j · v_i| ≤ w_i for every direction prove Σ w_i c_i ≥ Σ λ_j ·
//! p_j: for if p_j = p + Σ b_ij v_i with |b_ij| ≤ c_i, then Σ λ_j · p_j = Σ b_ij λ_j · v_i ≤ Σ c_i Σ_j |λ_j · v_i|.
//! That there is no such zonotope is proved by a functional that vanishes on all directions and takes different values
//! at two points.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::center_rounding::{cost_of_rounding, is_beyond};
use super::lower_bound::check_bound;
use crate::RELATIVE_ERROR;
use crate::exact::fraction::{Fraction, common_denominator, whole_numbers};
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Vector, dot, is_zero};
use crate::exact::proportion::{Proportion, check_figure};
use crate::faces::containment::one_outside;
use crate::faces::normals::TooMany;
use crate::verdict::{Stop, Verdict};

/// The question as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Directed {
    /// The points, at least one, all of one dimension.
    pub points: Vec<Vec<f64>>,
    /// The directions, of the same dimension.
    pub directions: Vec<Vec<f64>>,
    /// The cost of a unit of each.
    pub weights: Vec<f64>,
}

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub enum DirectedAnswer {
    /// A zonotope that is said to contain the points, and to be the cheapest or near it.
    Optimal {
        /// The claimed Σ w_i c_i.
        value: f64,
        /// The centre p.
        center: Vec<f64>,
        /// The coefficients c_i.
        coefficients: Vec<f64>,
        /// The claimed bound below the value of every zonotope around the points.
        lower_bound: f64,
        /// The proof of the bound: points, from 0, and the multiplier of each, a vector.
        forces: Vec<(usize, Vec<Fraction>)>,
    },
    /// There is said to be none.
    Infeasible {
        /// Two points, from 0.
        points: [usize; 2],
        /// Vanishes on the directions, and not on the difference of the points.
        functional: Vec<Fraction>,
    },
}

/// A value that exceeds the proven bound by more than this part of it may not be the least.
const PROVEN_GAP: f64 = 1e-11;

/// The proof of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DirectedProof {
    /// The zonotope contains the points, and its value is this far above the proven bound, relative to the value.
    Optimal {
        /// The number of points that the zonotope contains.
        points: usize,
        /// The answer's value, which agrees with the exact one.
        value: f64,
        /// The exact gap, rounded; 0 when both are 0.
        gap: f64,
    },
    /// There is no zonotope.
    Infeasible,
}

impl Display for DirectedProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Optimal { points, value, gap } => {
                write!(f, "contains all {points} points; value {value:?} is within {gap:.1e} of the proven bound")
            }
            Self::Infeasible => f.write_str("two points differ by a vector outside the span of the directions"),
        }
    }
}

/// Proves that the zonotope contains every point and costs what it is said to cost, and that none costs less than
/// `lower_bound`, or that there is none at all; or says what fails.
///
/// `value` may differ from the exact value by the relative [`RELATIVE_ERROR`]; `lower_bound` may not exceed the proven
/// bound. A value that exceeds that bound by more than a relative 10^-11 is left unchecked, for it may not be the
/// least; so is a zonotope with too many facets to hold the points against.
pub fn check_min_length_dirs(question: &Directed, answer: &DirectedAnswer) -> Verdict<DirectedProof> {
    proved(question, answer).into()
}

/// Proves what [`check_min_length_dirs`] does; a value that may not be the least is no reason to leave an answer
/// unchecked.
pub fn check_min_length_dirs_at_any_gap(question: &Directed, answer: &DirectedAnswer) -> Verdict<DirectedProof> {
    enclosed(question, answer).into()
}

/// Proves what [`check_min_length_dirs`] does of an answer that claims no optimum: its value is above `lower_bound` by
/// more than a relative 10^-11.
pub fn check_min_length_dirs_feasible(question: &Directed, answer: &DirectedAnswer) -> Verdict<DirectedProof> {
    let checked = enclosed(question, answer).and_then(|proof| {
        if figures(answer).is_some_and(|[value, bound]| !is_apart(value, bound, 1.0 - SHARE_ERROR)) {
            return Err("the value is the least, but for rounding, and not called so".into());
        }
        check_gap_by_rounding(question, answer)?;
        Ok(proof)
    });
    checked.into()
}

/// Leaves an answer unchecked whose value is farther above its bound than rounding the centre explains.
fn check_gap_by_rounding(question: &Directed, answer: &DirectedAnswer) -> Result<(), Stop> {
    let DirectedAnswer::Optimal { value, center, lower_bound, .. } = answer else { return Ok(()) };
    let exact = Proportion::of_double(value.min(f64::MAX));
    let gap = exact.minus(&Proportion::of_double(*lower_bound));
    let smallest = Proportion::of_double(f64::from_bits(1)).times(&Proportion::of_double(ROUNDED_PLACES));
    let of_value = exact.times(&Proportion::of_double(SHARE_ERROR)).plus(&smallest);
    if !is_beyond(&gap, cost_of_rounding(&question.directions, &question.weights, center), ROUNDED_PLACES, &of_value) {
        return Ok(());
    }
    Err(Stop::Unchecked(format!(
        "contains all {} points, but value {value:?} is farther above the proven bound {lower_bound:?} than rounding \
         the centre to doubles explains",
        question.points.len()
    )))
}

/// Units in the last place by which a centre of doubles may miss the optimal one, about.
const ROUNDED_PLACES: f64 = 8.0;

/// By how much rounding may change the share of a bound that is computed in doubles.
const SHARE_ERROR: f64 = 1e-9;

/// The value and the lower bound of an answer.
fn figures(answer: &DirectedAnswer) -> Option<[f64; 2]> {
    match answer {
        DirectedAnswer::Optimal { value, lower_bound, .. } => Some([*value, *lower_bound]),
        DirectedAnswer::Infeasible { .. } => None,
    }
}

/// The most that rounding a value and its bound costs, whatever their size: two of the smallest doubles, and nothing
/// where the bound says nothing.
fn rounding(lower_bound: f64) -> f64 {
    if lower_bound > 0.0 { f64::from_bits(2) } else { 0.0 }
}

/// Whether a value is more above a finite bound than the stated share of the bound, about.
fn is_apart(value: f64, lower_bound: f64, about: f64) -> bool {
    let [value, bound, share] = [value.min(f64::MAX), lower_bound, PROVEN_GAP * about].map(Proportion::of_double);
    value.minus(&bound).compare(&bound.times(&share)) == Ordering::Greater
}

fn proved(question: &Directed, answer: &DirectedAnswer) -> Result<DirectedProof, Stop> {
    match enclosed(question, answer)? {
        DirectedProof::Optimal { points, value, gap } if gap > PROVEN_GAP => Err(Stop::Unchecked(format!(
            "contains all {points} points, but value {value:?} is {gap:.1e} above the proven bound, so it may not be \
             the least"
        ))),
        proof
            if figures(answer)
                .is_some_and(|[value, bound]| is_apart(value - rounding(bound), bound, 1.0 + SHARE_ERROR)) =>
        {
            Err(format!("{proof}, but it is not within 1e-11 of `lower_bound`, as the least one is").into())
        }
        proof => Ok(proof),
    }
}

fn enclosed(question: &Directed, answer: &DirectedAnswer) -> Result<DirectedProof, Stop> {
    let (value, gap) = match checked_bounds(question, answer)? {
        None => return Ok(DirectedProof::Infeasible),
        Some(bounds) => bounds,
    };
    let points = question.points.len();
    if let DirectedAnswer::Optimal { center, coefficients, .. } = answer {
        match first_missed(question, center, coefficients) {
            Ok(None) => {}
            Ok(Some(outside)) => return Err(format!("point {} lies outside the zonotope", outside + 1).into()),
            Err(TooMany) => return Err(Stop::Unchecked("too many facets to hold the points against".to_owned())),
        }
    }
    Ok(DirectedProof::Optimal { points, value, gap })
}

/// Proves what [`check_min_length_dirs`] does but for the containment of the points: the value, the lower bound, that
/// there is no zonotope. O(k) exact operations for each force and k directions, however many points there are. The
/// proof says the value and the gap.
pub fn check_min_length_dirs_bounds(question: &Directed, answer: &DirectedAnswer) -> Verdict<(f64, f64)> {
    checked_bounds(question, answer).map(|bounds| bounds.unwrap_or((f64::INFINITY, 0.0))).into()
}

/// The value, which agrees with the exact one, and the exact gap, rounded; `None` for a proof that there is no
/// zonotope.
fn checked_bounds(question: &Directed, answer: &DirectedAnswer) -> Result<Option<(f64, f64)>, String> {
    let dimension = question.points.first().ok_or("there is no point to enclose")?.len();
    let is_even = |v: &Vec<f64>| v.len() == dimension;
    if !question.points.iter().chain(&question.directions).all(is_even) {
        return Err("answered a question whose dimensions do not agree".to_owned());
    }
    check_finite(
        "the question",
        question.points.iter().chain(&question.directions).flatten().chain(&question.weights),
    )?;
    if question.weights.len() != question.directions.len() || question.weights.iter().any(|weight| *weight < 0.0) {
        return Err("answered a question whose weights are not one number ≥ 0 for each direction".to_owned());
    }
    match answer {
        DirectedAnswer::Infeasible { points, functional } => {
            check_infeasible(question, *points, functional).map(|()| None)
        }
        DirectedAnswer::Optimal { value, center, coefficients, lower_bound, forces } => {
            if center.len() != dimension {
                return Err(format!("center has {} coordinates, not {dimension}", center.len()));
            }
            if coefficients.len() != question.directions.len() {
                return Err(format!(
                    "{} coefficients for {} directions",
                    coefficients.len(),
                    question.directions.len()
                ));
            }
            check_finite("the zonotope", center.iter().chain(coefficients))?;
            if let Some(wrong) = coefficients.iter().find(|c| **c < 0.0) {
                return Err(format!("the coefficient {wrong} is negative"));
            }
            let cost = cost(&question.weights, coefficients);
            check_figure("value", *value, &cost, &cost.times(&Proportion::of_double(RELATIVE_ERROR)))?;
            let bound = proven_bound(question, forces)?;
            check_bound(*lower_bound, &bound)?;
            let gap = cost.minus(&bound).over(&cost).map_or(0.0, |gap| gap.nearest());
            Ok(Some((*value, gap)))
        }
    }
}

fn first_missed(question: &Directed, center: &[f64], coefficients: &[f64]) -> Result<Option<usize>, TooMany> {
    let lengths = Grid::of(coefficients.iter().copied());
    let directions = Grid::of(question.directions.iter().flatten().copied());
    let places = Grid::of(question.points.iter().flatten().chain(center).copied());
    // Both the products c_i v_i and the differences p_j − p on one grid.
    let products = lengths.exponent() + directions.exponent();
    let unit = products.min(places.exponent());
    let up = |exponent: i32| usize::try_from(exponent - unit).expect("the unit is the smaller one");
    let generators: Vec<Vector> = question
        .directions
        .iter()
        .zip(coefficients)
        .filter(|(_, c)| **c > 0.0)
        .map(|(v, &c)| {
            let c = lengths.units(c);
            v.iter().map(|&x| (directions.units(x) * &c) << up(products)).collect()
        })
        .collect();
    let center: Vector = center.iter().map(|&x| places.units(x)).collect();
    let differences: Vec<Vector> = question
        .points
        .iter()
        .map(|p| p.iter().zip(&center).map(|(&x, c)| (places.units(x) - c) << up(places.exponent())).collect())
        .collect();
    one_outside(center.len(), &generators, &differences)
}

fn cost(weights: &[f64], coefficients: &[f64]) -> Proportion {
    let [w, c] = [weights, coefficients].map(|numbers| Grid::of(numbers.iter().copied()));
    let sum: IBig = weights.iter().zip(coefficients).map(|(&weight, &length)| w.units(weight) * c.units(length)).sum();
    Proportion::whole(sum, w.exponent() + c.exponent())
}

/// Σ λ_j · p_j, if the forces balance and load no direction beyond its weight.
fn proven_bound(question: &Directed, forces: &[(usize, Vec<Fraction>)]) -> Result<Proportion, String> {
    let dimension = question.points[0].len();
    if let Some((wrong, _)) = forces.iter().find(|(point, _)| *point >= question.points.len()) {
        return Err(format!("certificate: a force pulls at point {wrong}, which does not exist"));
    }
    if forces.iter().any(|(_, vector)| vector.len() != dimension) {
        return Err(format!("certificate: a force does not have {dimension} components"));
    }
    let common = common_denominator(forces.iter().flat_map(|(_, vector)| vector));
    let whole: Vec<Vector> = forces.iter().map(|(_, vector)| whole_numbers(vector, &common)).collect();
    let balance = (0..dimension).all(|axis| whole.iter().map(|force| &force[axis]).sum::<IBig>() == IBig::ZERO);
    if !balance {
        return Err("certificate: the forces do not add up to zero".to_owned());
    }
    let directions = Grid::of(question.directions.iter().flatten().copied());
    for (index, (direction, &weight)) in question.directions.iter().zip(&question.weights).enumerate() {
        let direction: Vector = direction.iter().map(|&x| directions.units(x)).collect();
        let load: IBig = whole.iter().map(|force| dot(force, &direction).abs()).sum();
        let load = Proportion::new(load, common.clone(), directions.exponent());
        if load.compare(&Proportion::of_double(weight)) == Ordering::Greater {
            return Err(format!("certificate: the forces load direction {} with {}", index + 1, load.nearest()));
        }
    }
    let places = Grid::of(question.points.iter().flatten().copied());
    let pulled = |point: usize| -> Vector { question.points[point].iter().map(|&x| places.units(x)).collect() };
    let gain: IBig = forces.iter().zip(&whole).map(|((point, _), force)| dot(force, &pulled(*point))).sum();
    Ok(Proportion::new(gain, common, places.exponent()))
}

fn check_infeasible(question: &Directed, points: [usize; 2], functional: &[Fraction]) -> Result<(), String> {
    let [Some(a), Some(b)] = points.map(|point| question.points.get(point)) else {
        return Err("certificate: names a point that does not exist".to_owned());
    };
    if functional.len() != a.len() {
        return Err(format!("certificate: the functional has {} components", functional.len()));
    }
    let common = common_denominator(functional);
    let functional = whole_numbers(functional, &common);
    let directions = Grid::of(question.directions.iter().flatten().copied());
    for (index, direction) in question.directions.iter().enumerate() {
        let direction: Vector = direction.iter().map(|&x| directions.units(x)).collect();
        if dot(&functional, &direction) != IBig::ZERO {
            return Err(format!("certificate: the functional does not vanish on direction {}", index + 1));
        }
    }
    let places = Grid::of(a.iter().chain(b).copied());
    let difference: Vector = a.iter().zip(b).map(|(&a, &b)| places.units(a) - places.units(b)).collect();
    if is_zero(&difference) || dot(&functional, &difference) == IBig::ZERO {
        return Err("certificate: the functional does not tell the two points apart".to_owned());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle with legs of 2 along the axes.
    fn triangle(directions: &[[f64; 2]]) -> Directed {
        Directed {
            points: vec![vec![0.0, 0.0], vec![2.0, 0.0], vec![0.0, 2.0]],
            directions: directions.iter().map(|v| v.to_vec()).collect(),
            weights: vec![1.0; directions.len()],
        }
    }

    fn halves(vector: [i64; 2]) -> Vec<Fraction> {
        vector.into_iter().filter_map(|x| Fraction::new(x, 2)).collect()
    }

    fn square(lower_bound: f64, scale: i64) -> DirectedAnswer {
        let forces = vec![(0, halves([-scale, -scale])), (1, halves([scale, 0])), (2, halves([0, scale]))];
        DirectedAnswer::Optimal {
            value: 2.0,
            center: vec![1.0, 1.0],
            coefficients: vec![1.0, 1.0],
            lower_bound,
            forces,
        }
    }

    #[test]
    fn a_square_around_a_triangle_by_hand() {
        let question = triangle(&[[1.0, 0.0], [0.0, 1.0]]);
        let proof = check_min_length_dirs(&question, &square(2.0, 1));
        assert_eq!(proof, Verdict::Right(DirectedProof::Optimal { points: 3, value: 2.0, gap: 0.0 }));
        let complaint = |answer: &DirectedAnswer| check_min_length_dirs(&question, answer).proof().expect_err("wrong");
        assert!(complaint(&square(2.0_f64.next_up(), 1)).contains("lower_bound"));
        assert!(complaint(&square(2.0, 2)).contains("load direction 1"));
        let DirectedAnswer::Optimal { value, center, lower_bound, forces, .. } = square(2.0, 1) else { unreachable!() };
        let with = |coefficients: Vec<f64>, value: f64, forces: Vec<(usize, Vec<Fraction>)>| DirectedAnswer::Optimal {
            value,
            center: center.clone(),
            coefficients,
            lower_bound,
            forces,
        };
        assert!(
            complaint(&with(vec![1.0, 1.0_f64.next_down()], value, forces.clone())).contains("point 1 lies outside")
        );
        assert!(complaint(&with(vec![1.0, 1.0], 2.0 + 1e-9, forces.clone())).contains("value"));
        assert!(complaint(&with(vec![1.0, 1.0], value, forces[..2].to_vec())).contains("add up"));
        assert!(complaint(&with(vec![1.0, f64::NAN], value, forces.clone())).contains("not finite"));
        assert!(complaint(&with(vec![1.0], value, forces)).contains("1 coefficients for 2"));
    }

    #[test]
    fn points_out_of_reach_by_hand() {
        let question = triangle(&[[1.0, 1.0]]);
        let answer = |points, functional| DirectedAnswer::Infeasible { points, functional: halves(functional) };
        assert_eq!(
            check_min_length_dirs(&question, &answer([0, 1], [1, -1])),
            Verdict::Right(DirectedProof::Infeasible)
        );
        assert!(check_min_length_dirs(&question, &answer([0, 0], [1, -1])).is_wrong());
        assert!(check_min_length_dirs(&question, &answer([0, 1], [1, 1])).is_wrong());
        assert!(check_min_length_dirs(&question, &answer([0, 9], [1, -1])).is_wrong());
        assert!(check_min_length_dirs(&question, &answer([0, 1], [0, 0])).is_wrong());
    }
}
