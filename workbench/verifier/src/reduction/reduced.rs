//! Answers to "a zonotope of few generators around a zonotope".
//!
//! That the answer contains the body is proved by shares, or along every facet normal of the answer. Its Hausdorff
//! distance from the body is at least the difference of the support functions in a direction; that it is not larger
//! than the claimed upper bound would take a search over all directions, which is not repeated.

use super::hausdorff::{BodyPair, check_bounds};
use super::shares::{Shares, check_shares};
use crate::faces::containment::contains_body;
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

/// Proves that the answer contains the body, and the lower bound of the distance; the upper bound is left unchecked.
pub fn check_reduction(question: &Reduction, answer: &ReductionAnswer) -> Verdict {
    match proved(question, answer) {
        Ok(()) => Verdict::Unchecked(
            "the body is contained, and the lower bound of the distance holds; the upper bound is not checked"
                .to_owned(),
        ),
        Err(Stop::Wrong(reason)) => Verdict::Wrong(reason),
        Err(Stop::Unchecked(reason)) => Verdict::Unchecked(reason),
    }
}

fn proved(question: &Reduction, answer: &ReductionAnswer) -> Result<(), Stop> {
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
    check_bounds(&pair, answer.bounds, &answer.direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The octagon of four generators, and the square that contains it.
    fn octagon() -> (Reduction, ReductionAnswer) {
        let generators = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]].map(|g| g.to_vec()).to_vec();
        let question = Reduction { center: vec![5.0, 0.0], generators, count: Some(2) };
        // in the direction (1, 1) the square reaches 6, the octagon 4, for a length of √2
        let answer = ReductionAnswer {
            center: vec![5.0, 0.0],
            generators: vec![vec![3.0, 0.0], vec![0.0, 3.0]],
            bounds: [1.4, 1.42],
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
        assert!(is_wrong(|answer| answer.direction = vec![1.0, 0.0]));
        assert!(is_wrong(|answer| answer.direction = vec![0.0, 0.0]));
        assert!(is_wrong(|answer| answer.center[1] = 1.0));
        assert!(is_wrong(|answer| answer.generators.push(vec![0.0, 0.0])));
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
