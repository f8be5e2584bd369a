//! Answers to "a zonotope of few generators around a zonotope".
//!
//! That the answer contains the body is proved by shares, or along every facet normal of the answer. Its Hausdorff
//! distance from the body is at least the difference of the support functions in a direction, and at most the distance
//! of its farthest vertex.

use dashu_int::IBig;

use super::hausdorff::{BodyPair, bounded, check_bounds, check_width, words};
use super::shares::{Shares, check_shares};
use crate::exact::length::Length;
use crate::exact::proportion::Proportion;
use crate::faces::containment::contains_body;
use crate::faces::dual_reach::{far_vertex_squared, farthest_squared};
use crate::verdict::{Stop, Verdict};

/// The question: a body, and at most how many generators the answer may have.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// The centre of the body.
    pub center: Vec<f64>,
    /// Its generators.
    pub generators: Vec<Vec<f64>>,
    /// The most generators of the answer, if that was asked for.
    pub count: Option<usize>,
    /// The largest distance in diameters of the body, if that was asked for.
    pub epsilon: Option<f64>,
}

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct ReductionAnswer {
    /// The centre of the enclosing body.
    pub center: Vec<f64>,
    /// Its generators.
    pub generators: Vec<Vec<f64>>,
    /// The claimed bounds of the Hausdorff distance.
    pub bounds: [f64; 2],
    /// The direction in which the support functions differ by the lower bound.
    pub direction: Vec<f64>,
    /// Shares; without them, every facet normal is tried.
    pub shares: Option<Shares>,
}

/// Proves that the answer contains the body, and the lower bound of the distance; then the upper bound, of answers
/// without too many vertices.
pub fn check_reduction(question: &Reduction, answer: &ReductionAnswer) -> Verdict {
    let bounded = proved(question, answer).and_then(|pair| {
        let upper_bound = pair.check_first_within(answer.bounds[1]);
        let precise = upper_bound.and_then(|()| match question.epsilon {
            Some(epsilon) => check_precision(&pair, epsilon, answer.bounds),
            None => Ok(()),
        });
        bounded("containment", precise)?;
        check_width(&pair, answer.bounds)?;
        Ok(words("containment", answer.bounds))
    });
    bounded.into()
}

/// Proves that the bounds of the distance are at most ε times the diameter, the distance of two opposite vertices.
fn check_precision(pair: &BodyPair, epsilon: f64, [lower, upper]: [f64; 2]) -> Result<(), Stop> {
    if !epsilon.is_finite() {
        return Err("epsilon is not finite".into());
    }
    let [_, body] = &pair.generators;
    let share = Proportion::of_double(2.0).times(&Proportion::of_double(epsilon));
    let is_within = |bound: f64, squared: IBig| {
        let square = Proportion::whole(squared, 0).times(&share).times(&share);
        bound.is_finite() && Length::of_square(square).compare(&pair.units(bound)).is_ge()
    };
    // Some vertex that is far away shows it for most answers.
    if is_within(upper, far_vertex_squared(pair.dimension(), body)) {
        return Ok(());
    }
    let farthest = farthest_squared(pair.dimension(), body)
        .map_err(|_| Stop::Unchecked("the body has too many vertices for its diameter".to_owned()))?;
    if is_within(upper, farthest.clone()) {
        return Ok(());
    }
    if !is_within(lower, farthest) {
        return Err("the distance is more than epsilon times the diameter".into());
    }
    Err(Stop::Unchecked("it is more than epsilon times the diameter".to_owned()))
}

fn proved(question: &Reduction, answer: &ReductionAnswer) -> Result<BodyPair, Stop> {
    if answer.center != question.center {
        return Err("the centre is not that of the body".into());
    }
    if question.count.is_some_and(|count| answer.generators.len() > count) {
        return Err(format!("the answer has {} generators", answer.generators.len()).into());
    }
    let pair = BodyPair::new((&answer.center, &answer.generators), (&question.center, &question.generators))?;
    match &answer.shares {
        Some(shares) => check_shares(&pair.generators[0], &pair.generators[1], shares)?,
        None => match contains_body(question.center.len(), &pair.generators[0], &pair.generators[1]) {
            Ok(true) => {}
            Ok(false) => return Err("the answer does not contain the body".into()),
            Err(_) => return Err(Stop::Unchecked("the answer has too many facets to try".to_owned())),
        },
    }
    check_bounds(&pair, answer.bounds, &answer.direction)?;
    Ok(pair)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The octagon of four generators, and the square that contains it.
    fn octagon() -> (Reduction, ReductionAnswer) {
        let generators = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]].map(|g| g.to_vec()).to_vec();
        let question = Reduction { center: vec![5.0, 0.0], generators, count: Some(2), epsilon: None };
        // in the direction (1, 1) the square reaches 6, the octagon 4, for a length of √2: the corner is that far away
        let answer = ReductionAnswer {
            center: vec![5.0, 0.0],
            generators: vec![vec![3.0, 0.0], vec![0.0, 3.0]],
            bounds: [1.41, 1.42],
            direction: vec![1.0, 1.0],
            shares: Some(Shares { shares: vec![Some((0, 0.25)), None, None, Some((1, -0.25))], frame: vec![0, 1] }),
        };
        (question, answer)
    }

    fn is_wrong(spoil: impl Fn(&mut ReductionAnswer)) -> bool {
        let (question, mut answer) = octagon();
        spoil(&mut answer);
        check_reduction(&question, &answer).is_wrong()
    }

    #[test]
    fn a_square_around_an_octagon() {
        assert!(!is_wrong(|_| ()));
        assert!(!is_wrong(|answer| answer.shares = None));
        let smaller = |answer: &mut ReductionAnswer| answer.generators[0][0] = 3.0_f64.next_down();
        assert!(is_wrong(smaller));
        assert!(is_wrong(|answer| {
            smaller(answer);
            answer.shares = None;
        }));
        assert!(is_wrong(|answer| answer.bounds = [1.42, 1.43]));
        assert!(is_wrong(|answer| answer.bounds = [1.4, 1.3]));
        assert!(is_wrong(|answer| answer.bounds = [1.4, 1.41]), "the corner is farther away");
        assert!(is_wrong(|answer| answer.direction = vec![1.0, 0.0]));
        assert!(is_wrong(|answer| answer.direction = vec![0.0, 0.0]));
        assert!(is_wrong(|answer| answer.center[1] = 1.0));
        assert!(is_wrong(|answer| answer.generators.push(vec![0.0, 0.0])));
    }

    #[test]
    fn a_distance_in_diameters() {
        let (mut question, answer) = octagon();
        question.count = None;
        // the farthest vertices of the octagon are (3, 1) and (-3, -1): the diameter is 2 √10, 1.42 of it 0.2245
        let verdict = |question: &Reduction, epsilon| {
            check_reduction(&Reduction { epsilon: Some(epsilon), ..question.clone() }, &answer)
        };
        assert!(verdict(&question, 0.2246).is_right());
        assert!(matches!(verdict(&question, 0.2244), Verdict::Unchecked(_)), "the lower bound is less");
        assert!(verdict(&question, 0.22).is_wrong());
        assert!(verdict(&question, f64::NAN).is_wrong());
    }

    #[test]
    fn shares_that_prove_nothing() {
        let with = |change: fn(&mut Shares)| is_wrong(|answer| answer.shares.iter_mut().for_each(change));
        assert!(with(|shares| shares.shares[0] = Some((0, 1.5))), "used too much");
        assert!(with(|shares| shares.frame = vec![0]), "off the frame");
        assert!(with(|shares| shares.frame = vec![0, 0]), "dependent");
        assert!(with(|shares| shares.frame = vec![0, 2]), "not there");
        assert!(with(|shares| shares.shares[3] = Some((2, 0.0))), "not there");
        assert!(with(|shares| shares.shares[3] = Some((0, f64::NAN))), "no number");
        assert!(with(|shares| shares.shares.truncate(3)), "one is missing");
        assert!(!with(|shares| shares.shares[0] = None), "the frame takes all");
    }
}
