//! Answers to "the zonotope of least total length Σ |g_i| that contains the points, within a ratio of 1 + ε".
//!
//! Vectors λ_j at points p_j with Σ λ_j = 0 prove that every zonotope around the points has a total length of at least
//! Σ λ_j · p_j / ρ, where ρ is the distance of the farthest vertex of Σ [−1, 1] λ_j from the origin: for if p_j = p +
//! Σ b_ij g_i with |b_ij| ≤ 1, then Σ λ_j · p_j ≤ Σ_i Σ_j |λ_j · g_i|, and Σ_j |λ_j · u| ≤ ρ for every unit vector u.

use std::cmp::Ordering;
use std::fmt::{self, Display};

use dashu_int::IBig;

use super::lower_bound::check_bound;
use crate::RELATIVE_ERROR;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::length::{root, total_length};
use crate::exact::linear::{Vector, dot};
use crate::exact::proportion::{Proportion, check_figure};
use crate::faces::containment::one_outside;
use crate::faces::dual_reach::farthest_squared;
use crate::faces::normals::TooMany;
use crate::verdict::{Stop, Verdict};

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct MinLengthAnswer {
    /// The claimed total length.
    pub length: f64,
    /// The centre.
    pub center: Vec<f64>,
    /// The generators.
    pub generators: Vec<Vec<f64>>,
    /// The claimed bound below the total length of every zonotope around the points.
    pub lower_bound: f64,
    /// The claimed `length` / `lower_bound`.
    pub ratio: f64,
    /// The claim that the length is at most 1 + ε times the lower bound, or that it is not, if there is one.
    pub within_epsilon: Option<bool>,
    /// The proof of the bound: points, from 0, and the multiplier of each, a vector.
    pub forces: Vec<(usize, Vec<f64>)>,
}

/// The amount that rounding may cost a length, relative to the sizes of the coordinates.
const ROUNDING: f64 = 1.0 / (1_u64 << 46) as f64;

/// The parts of an answer that were proved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MinLengthProof {
    /// The number of points.
    pub points: usize,
    /// The answer's total length, which agrees with the exact one.
    pub length: f64,
    /// The largest lower bound that the forces prove, rounded.
    pub proven_bound: f64,
    /// The answer's ratio, which agrees with that of its length and its lower bound.
    pub ratio: f64,
    /// The part of the proven bound by which the length exceeds it at most, rounded up.
    pub excess: f64,
    /// Whether the length is at most 1 + ε times the lower bound.
    pub is_within: bool,
}

impl Display for MinLengthProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, length, excess, .. } = self;
        let times = in_words(*excess);
        write!(f, "contains all {points} points; length {length:?}, proven to be at most {times} times the least")
    }
}

/// Proves that the zonotope contains every point, has the length it is said to have, and is within 1 + ε of the
/// shortest; or says what fails. An answer that says itself that it is not that short is left unchecked, as are bodies
/// with too many facets, or forces whose zonotope has too many vertices, to go through.
///
/// `length` and `ratio` may differ from their exact values by the relative [`RELATIVE_ERROR`]; `lower_bound` may not
/// exceed the proven bound. `length` may exceed (1 + ε) · `lower_bound` by what rounding to doubles costs bodies that
/// are thin, far from the origin or tiny: 2^-46 times the sum over the axes on which the points differ of the largest
/// coordinate there, at least the smallest normal double.
pub fn check_min_length_all(points: &[Vec<f64>], epsilon: f64, answer: &MinLengthAnswer) -> Verdict<MinLengthProof> {
    let checked = proved(points, epsilon, answer, true).and_then(|proof| {
        if proof.is_within {
            return Ok(proof);
        }
        Err(Stop::Unchecked(format!("the precision is not reached, as the answer says: {proof}")))
    });
    checked.into()
}

/// Proves what [`check_min_length_all`] does; a ratio above 1 + ε is no reason to leave an answer unchecked that says
/// so itself.
pub fn check_min_length_all_at_any_ratio(
    points: &[Vec<f64>],
    epsilon: f64,
    answer: &MinLengthAnswer,
) -> Verdict<MinLengthProof> {
    proved(points, epsilon, answer, true).into()
}

/// Proves what [`check_min_length_all`] does but for the containment of the points; a ratio above 1 + ε is no reason
/// to leave it unchecked.
pub fn check_min_length_all_bounds(
    points: &[Vec<f64>],
    epsilon: f64,
    answer: &MinLengthAnswer,
) -> Verdict<MinLengthProof> {
    proved(points, epsilon, answer, false).into()
}

fn proved(
    points: &[Vec<f64>],
    epsilon: f64,
    answer: &MinLengthAnswer,
    with_points: bool,
) -> Result<MinLengthProof, Stop> {
    let too_many = |TooMany| {
        let reason = "too many facets to hold the points against, or too many vertices of the forces' zonotope";
        Stop::Unchecked(reason.to_owned())
    };
    let dimension = points.first().ok_or("there is no point to enclose")?.len();
    if points.iter().any(|point| point.len() != dimension) {
        return Err("answered a question whose dimensions do not agree".into());
    }
    if !(epsilon > 0.0 && epsilon < 1.0) {
        return Err("answered a question whose epsilon is not between 0 and 1".into());
    }
    if answer.center.len() != dimension || answer.generators.iter().any(|generator| generator.len() != dimension) {
        return Err(format!("the zonotope does not have {dimension} coordinates").into());
    }
    check_finite("the question", points.iter().flatten())?;
    check_finite("the zonotope", answer.generators.iter().flatten().chain(&answer.center))?;
    if answer.forces.iter().any(|(_, vector)| vector.iter().any(|x| !x.is_finite())) {
        return Err("certificate: a force holds a number that is not finite".into());
    }
    let grid = Grid::of(points.iter().chain(&answer.generators).chain([&answer.center]).flatten().copied());
    let placed = |v: &[f64]| -> Vector { v.iter().map(|&x| grid.units(x)).collect() };
    let center = placed(&answer.center);
    let places: Vec<Vector> = points.iter().map(|point| placed(point)).collect();
    let differences: Vec<Vector> =
        places.iter().map(|place| place.iter().zip(&center).map(|(x, c)| x - c).collect()).collect();
    let generators: Vec<Vector> = answer.generators.iter().map(|generator| placed(generator)).collect();
    if with_points && let Some(outside) = one_outside(dimension, &generators, &differences).map_err(too_many)? {
        return Err(format!("point {} lies outside the zonotope", outside + 1).into());
    }
    let unit = Proportion::whole(IBig::ONE, grid.exponent());
    let [length, longest] = total_length(&generators).map(|bound| bound.times(&unit));
    let relative = Proportion::of_double(RELATIVE_ERROR);
    check_figure("length", answer.length, &length, &length.times(&relative))?;

    let bound = proven_bound(&places, &answer.forces)?.map_err(too_many)?.times(&unit);
    check_bound(answer.lower_bound, &bound)?;
    if answer.lower_bound < 0.0 {
        return Err(format!("lower_bound {:?} says nothing of a length", answer.lower_bound).into());
    }
    // A length beyond the range of doubles is measured exactly.
    let claimed = if answer.length.is_finite() { Proportion::of_double(answer.length) } else { length.clone() };
    check_ratio(answer, &claimed)?;
    let rounding = rounding_allowance(points).plus(&length.times(&relative));
    let lower_bound = Proportion::of_double(answer.lower_bound);
    let share = Proportion::of_double(1.0).plus(&Proportion::of_double(epsilon));
    let is_within = claimed.compare(&lower_bound.times(&share).plus(&rounding)) != Ordering::Greater;
    if !is_within && answer.within_epsilon != Some(false) {
        return Err(format!("the ratio {:?} is above 1 + epsilon", answer.ratio).into());
    }
    // what is said of the ratio is held to the ratio, whatever rounding may cost the length
    let precisely = lower_bound.times(&share).plus(&length.times(&relative));
    if answer.within_epsilon == Some(true) && claimed.compare(&precisely) == Ordering::Greater {
        return Err(format!("within_epsilon is true, but the ratio {:?} is above 1 + epsilon", answer.ratio).into());
    }
    let nearly = share.times(&Proportion::of_double(1.0 - RELATIVE_ERROR));
    if answer.within_epsilon == Some(false) && claimed.compare(&lower_bound.times(&nearly)) != Ordering::Greater {
        return Err(format!("within_epsilon is false, but the ratio {:?} is at most 1 + epsilon", answer.ratio).into());
    }
    let (length, ratio, excess) = (answer.length, answer.ratio, excess(&longest, &bound));
    Ok(MinLengthProof { points: points.len(), length, proven_bound: bound.nearest(), ratio, excess, is_within })
}

/// The part of the bound by which a length exceeds it, rounded up; 0 where it does not.
fn excess(length: &Proportion, bound: &Proportion) -> f64 {
    let above = length.minus(bound);
    match above.over(bound) {
        _ if above.is_zero() || above.is_negative() => 0.0,
        Some(part) => part.nearest().next_up(),
        None => f64::INFINITY,
    }
}

/// The factor of a length that exceeds another by a part of it, rounded up: `1`, `1 + 3.4e-8` or `1.0004`.
fn in_words(excess: f64) -> String {
    const DIGITS_FROM: f64 = 1e-4;
    if excess == 0.0 {
        return "1".to_owned();
    }
    if excess >= DIGITS_FROM {
        let factor = (1.0 + excess).next_up();
        let shown = (factor * 1e5).ceil() / 1e5;
        return format!("{:?}", if shown >= factor { shown } else { factor });
    }
    let nearest = format!("{excess:.1e}");
    let (digits, exponent) = nearest.split_once('e').expect("the notation has an exponent");
    let digits: f64 = digits.parse().expect("the digits are a number");
    let shown: f64 = nearest.parse().expect("the notation is that of a double");
    let digits = if shown < excess { digits + 0.1 } else { digits };
    format!("1 + {digits:.1}e{exponent}")
}

/// The amount that rounding the centre and the generators to doubles may cost: some units in the last place of the
/// largest coordinate of each axis, nothing along an axis on which all points agree.
fn rounding_allowance(points: &[Vec<f64>]) -> Proportion {
    let dimension = points.first().map_or(0, Vec::len);
    let along = |axis: usize| {
        let values = points.iter().map(|point| point[axis]);
        let is_one = values.clone().all(|x| points.first().is_some_and(|first| x == first[axis]));
        if is_one { 0.0 } else { values.fold(f64::MIN_POSITIVE, |largest, x| largest.max(x.abs())) }
    };
    let sizes = (0..dimension).map(|axis| Proportion::of_double(along(axis)));
    sizes.fold(Proportion::whole(IBig::ZERO, 0), |sum, size| sum.plus(&size)).times(&Proportion::of_double(ROUNDING))
}

/// Checks the quotient of the length and the lower bound; that of an infinite length may be infinite as well.
fn check_ratio(answer: &MinLengthAnswer, length: &Proportion) -> Result<(), String> {
    if answer.length.is_infinite() && answer.ratio == f64::INFINITY {
        return Ok(());
    }
    match length.over(&Proportion::of_double(answer.lower_bound)) {
        Some(exact) => {
            // The ratio of tiny numbers has few bits.
            let allowed = exact.times(&Proportion::of_double(RELATIVE_ERROR));
            check_figure("ratio", answer.ratio, &exact, &allowed)
        }
        None => {
            let expected = if answer.length == 0.0 { 1.0 } else { f64::INFINITY };
            if answer.ratio == expected {
                Ok(())
            } else {
                Err(format!("ratio is {:?}, not {expected:?}", answer.ratio))
            }
        }
    }
}

/// The bound that the forces prove, in units of the grid of the points; 0 if that is more.
fn proven_bound(points: &[Vector], forces: &[(usize, Vec<f64>)]) -> Result<Result<Proportion, TooMany>, String> {
    let dimension = points[0].len();
    let zero = Proportion::whole(IBig::ZERO, 0);
    if let Some((wrong, _)) = forces.iter().find(|(point, _)| *point >= points.len()) {
        return Err(format!("certificate: a force pulls at point {wrong}, which does not exist"));
    }
    if forces.iter().any(|(_, vector)| vector.len() != dimension) {
        return Err(format!("certificate: a force does not have {dimension} components"));
    }
    // Their common factor says nothing, so neither does their unit.
    let grid = Grid::of(forces.iter().flat_map(|(_, vector)| vector).copied());
    let vectors: Vec<Vector> =
        forces.iter().map(|(_, vector)| vector.iter().map(|&x| grid.units(x)).collect()).collect();
    if (0..dimension).any(|axis| vectors.iter().map(|vector| &vector[axis]).sum::<IBig>() != IBig::ZERO) {
        return Err("certificate: the forces do not add up to zero".to_owned());
    }
    let gain: IBig = forces.iter().zip(&vectors).map(|((point, _), vector)| dot(vector, &points[*point])).sum();
    if gain <= IBig::ZERO {
        return Ok(Ok(zero));
    }
    Ok(farthest_squared(dimension, &vectors).map(|squared| {
        let [_, reach] = root(&squared);
        Proportion::whole(gain, 0).over(&reach).unwrap_or(zero)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diamond() -> Vec<Vec<f64>> {
        [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(|point| point.to_vec()).to_vec()
    }

    /// A diamond is a zonogon; multipliers along the axes prove that nothing around it is shorter: the vertices of
    /// their zonotope are (±2, ±2).
    fn answer() -> MinLengthAnswer {
        MinLengthAnswer {
            length: 2.0_f64.sqrt(),
            center: vec![0.0, 0.0],
            generators: vec![vec![0.5, 0.5], vec![0.5, -0.5]],
            lower_bound: 2.0_f64.sqrt().next_down(),
            ratio: 1.0,
            within_epsilon: Some(true),
            forces: diamond().into_iter().enumerate().collect(),
        }
    }

    #[test]
    fn a_diamond_by_hand() {
        let proof = check_min_length_all(&diamond(), 1e-9, &answer()).proof().expect("right");
        assert!((proof.ratio - 1.0).abs() < 1e-15 && (proof.proven_bound - 2.0_f64.sqrt()).abs() < 1e-15);
        let complaint = |answer: MinLengthAnswer| {
            check_min_length_all(&diamond(), 1e-9, &answer).proof().expect_err("something is wrong")
        };
        assert!(complaint(MinLengthAnswer { lower_bound: 1.414_213_563, ..answer() }).contains("lower_bound"));
        assert!(complaint(MinLengthAnswer { lower_bound: 1.4, ..answer() }).contains("says less"));
        assert!(complaint(MinLengthAnswer { ratio: 1.0 + 1e-9, ..answer() }).contains("ratio is"));
        // Pulls that are not the best prove less.
        let mut weak = answer();
        weak.forces.truncate(2);
        weak.lower_bound = 1.0;
        weak.ratio = weak.length;
        assert!(complaint(weak.clone()).contains("above 1 + epsilon"));
        assert!(complaint(MinLengthAnswer { within_epsilon: None, ..weak.clone() }).contains("above 1 + epsilon"));
        let honest = MinLengthAnswer { within_epsilon: Some(false), ..weak };
        assert!(matches!(check_min_length_all(&diamond(), 1e-9, &honest), Verdict::Unchecked(_)));
        assert!(check_min_length_all_at_any_ratio(&diamond(), 1e-9, &honest).is_right());
        let proof = check_min_length_all_bounds(&diamond(), 1e-9, &honest).proof().expect("right");
        assert!(proof.to_string().ends_with("at most 1.41422 times the least"), "{proof}");
        assert!(!proof.is_within && proof.ratio > 1.4);
        assert!(complaint(MinLengthAnswer { within_epsilon: Some(false), ..answer() }).contains("within_epsilon"));
        assert!(complaint(MinLengthAnswer { length: 1.414_213_563, ..answer() }).contains("length"));
        assert!(complaint(MinLengthAnswer { center: vec![1e-9, 0.0], ..answer() }).contains("outside"));
        let mut unbalanced = answer();
        unbalanced.forces[0].1[0] = 1.5;
        assert!(complaint(unbalanced).contains("add up"));
        let mut elsewhere = answer();
        elsewhere.forces[0].0 = 7;
        assert!(complaint(elsewhere).contains("does not exist"));
    }

    /// The factor that a proof states is not below the one that is proved.
    #[test]
    fn factors_are_rounded_up() {
        for (excess, expected) in [
            (0.0, "1"),
            (f64::EPSILON, "1 + 2.3e-16"),
            (3.325e-8, "1 + 3.4e-8"),
            (9.96e-9, "1 + 1.0e-8"),
            (9.91e-9, "1 + 10.0e-9"),
            (1e-8, "1 + 1.0e-8"),
            (1e-4, "1.00011"),
            (0.000_329_242_163, "1.00033"),
            (0.414_213_562_4, "1.41422"),
            (2.0, "3.00001"),
        ] {
            assert_eq!(in_words(excess), expected, "{excess}");
        }
        assert_eq!(in_words(f64::INFINITY), "inf");
    }

    /// Two points whose distance is the smallest double: rounding may double the length, but the ratio is 2 then.
    #[test]
    fn a_ratio_that_rounding_excuses_is_not_called_within_epsilon() {
        let tiny = f64::from_bits(1);
        let points = [vec![1.0, 0.0], vec![1.0, 2.0 * tiny]];
        let claims = |within_epsilon| MinLengthAnswer {
            length: 2.0 * tiny,
            center: vec![1.0, tiny],
            generators: vec![vec![0.0, 2.0 * tiny]],
            lower_bound: tiny,
            ratio: 2.0,
            within_epsilon,
            forces: vec![(0, vec![0.0, -1.0]), (1, vec![0.0, 1.0])],
        };
        let verdict = |within_epsilon| check_min_length_all(&points, 0.5, &claims(within_epsilon));
        assert!(verdict(Some(true)).proof().is_err_and(|complaint| complaint.contains("within_epsilon is true")));
        assert!(verdict(None).is_right());
    }

    #[test]
    fn a_single_point() {
        let nothing = MinLengthAnswer {
            length: 0.0,
            center: vec![3.0],
            generators: vec![],
            lower_bound: 0.0,
            ratio: 1.0,
            within_epsilon: Some(true),
            forces: vec![],
        };
        assert!(check_min_length_all(&[vec![3.0]], 0.5, &nothing).is_right());
        assert!(check_min_length_all(&[vec![4.0]], 0.5, &nothing).is_wrong());
        // what is longer than nothing by however little is not the shortest, whatever rounding costs elsewhere
        let tiny = f64::from_bits(1);
        let longer = MinLengthAnswer {
            length: tiny,
            generators: vec![vec![tiny]],
            ratio: f64::INFINITY,
            within_epsilon: None,
            ..nothing
        };
        assert!(check_min_length_all(&[vec![3.0], vec![3.0]], 0.5, &longer).is_wrong());
    }

    #[test]
    fn epsilon_lies_between_nothing_and_one() {
        for epsilon in [0.0, 1.0, 2.0, -0.5] {
            assert!(check_min_length_all(&diamond(), epsilon, &answer()).is_wrong(), "{epsilon}");
        }
        assert!(check_min_length_all(&diamond(), 1.0_f64.next_down(), &answer()).is_right());
    }
}
