//! Answers to "what is the Hausdorff distance of two zonotopes": the lower bound in the direction that attains it, the
//! upper one at the vertices.
//!
//! The distance is the largest difference |h_a(u) − h_b(u)| over unit vectors u. One direction proves a lower bound.
//! The upper one holds if every vertex of each body is that near to the other body.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::within::Within;
use crate::exact::fraction::Fraction;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::length::{COARSENESS, Length};
use crate::exact::linear::{Vector, dot};
use crate::exact::proportion::Proportion;
use crate::exact::whole_direction;
use crate::faces::containment::contains_body;
use crate::faces::facets::reach;
use crate::verdict::{Stop, Verdict};

/// Two bodies in whole numbers of one unit.
pub(super) struct BodyPair {
    /// The vector from the first centre to the second.
    displacement: Vector,
    /// The generators of both.
    pub(super) generators: [Vec<Vector>; 2],
    /// The exponent of the unit.
    exponent: i32,
}

/// A centre and generators.
type Plain<'a> = (&'a [f64], &'a [Vec<f64>]);

impl BodyPair {
    pub(super) fn new(a: Plain<'_>, b: Plain<'_>) -> Result<Self, String> {
        let dimension = a.0.len();
        if [a, b].iter().any(|(center, list)| {
            center.len() != dimension || list.iter().any(|generator| generator.len() != dimension)
        }) {
            return Err("the dimensions do not agree".to_owned());
        }
        let all = [a, b].into_iter().flat_map(|(center, list)| center.iter().chain(list.iter().flatten()));
        check_finite("the question or the answer", all.clone())?;
        let grid = Grid::of(all.copied());
        let whole = |v: &[f64]| -> Vector { v.iter().map(|&c| grid.units(c)).collect() };
        let displacement = whole(b.0).iter().zip(whole(a.0)).map(|(to, from)| to - from).collect();
        let generators = [a, b].map(|(_, list)| list.iter().map(|g| whole(g)).collect());
        Ok(Self { displacement, generators, exponent: grid.exponent() })
    }

    pub(super) fn dimension(&self) -> usize {
        self.displacement.len()
    }

    /// A number in units of the whole ones.
    pub(super) fn units(&self, number: f64) -> Proportion {
        Proportion::of_double(number).times(&Proportion::whole(IBig::ONE, -self.exponent))
    }

    /// Proves that every point of the first body is at most so far from the second.
    pub(super) fn check_first_within(&self, distance: f64) -> Result<(), Stop> {
        let offset = self.displacement.iter().map(|c| -c).collect();
        let [first, second] = &self.generators;
        Within { offset: &offset, first, second, exponent: self.exponent }.check(distance)
    }

    /// Proves that every point of the second body is at most so far from the first.
    fn check_second_within(&self, distance: f64) -> Result<(), Stop> {
        let [second, first] = &self.generators;
        Within { offset: &self.displacement, first, second, exponent: self.exponent }.check(distance)
    }
}

/// By how much the bounds of a distance may differ, in terms of the upper one.
const ACCURACY: f64 = 0.01;

/// By how much they may differ beside that, relative to the magnitudes of all components: the distance of bodies that
/// are nearly equal is lost in what rounding leaves of their sums.
const ROUNDING: f64 = 1.0 / (1_u64 << 40) as f64;

/// Checks that the support functions differ by the lower bound in the direction, and that the upper bound is not below
/// it.
pub(super) fn check_bounds(pair: &BodyPair, [lower, upper]: [f64; 2], direction: &[f64]) -> Result<(), Stop> {
    if !(0.0..=f64::MAX).contains(&lower) {
        return Err(format!("the lower bound of the distance is {lower:?}, no finite number from 0 on").into());
    }
    if upper.is_nan() || lower > upper {
        return Err("the bounds of the distance are in no order".into());
    }
    if direction.len() != pair.displacement.len() || direction.iter().any(|c| !c.is_finite()) {
        return Err("the direction of the distance is no vector of the question's space".into());
    }
    if lower == 0.0 {
        return Ok(());
    }
    let exact: Option<Vec<_>> = direction.iter().map(|&c| Fraction::of_double(c)).collect();
    let u = whole_direction(&exact.unwrap_or_default());
    let [a, b] = pair.generators.each_ref().map(|list| reach(list, &u));
    let difference = (a - b).abs() + dot(&u, &pair.displacement).abs();
    let Some(proved) = Length::along(&Proportion::whole(difference, 0), &u) else {
        return Err("the direction of the distance is zero".into());
    };
    if proved.compare(&pair.units(lower)).is_lt() {
        let proved = proved.rounded_at(pair.exponent);
        return Err(format!("in the direction of the distance the bodies differ by {proved:?}").into());
    }
    Ok(())
}

/// Leaves bounds unchecked that are true but say little: the accuracy that is stated of them is not reached.
pub(super) fn check_width(pair: &BodyPair, [lower, upper]: [f64; 2]) -> Result<(), Stop> {
    let components = pair.generators.iter().flatten().flatten().chain(&pair.displacement);
    let size: IBig = components.map(|c| c.clone().abs()).sum();
    let unit = Proportion::whole(IBig::ONE, pair.exponent);
    let rounding = Proportion::whole(size, 0).times(&unit).times(&Proportion::of_double(ROUNDING));
    let narrowest = Proportion::of_double(upper.min(f64::MAX)).times(&Proportion::of_double(1.0 - ACCURACY));
    let rounding = rounding.plus(&Proportion::of_double(COARSENESS));
    if Proportion::of_double(lower).plus(&rounding).compare(&narrowest).is_ge() {
        return Ok(());
    }
    Err(Stop::Unchecked(format!(
        "the bounds of the distance, {lower:?} and {upper:?}, are right, but more than 1 % apart"
    )))
}

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct HausdorffAnswer {
    /// The claimed distance.
    pub value: f64,
    /// The claimed bounds of the distance.
    pub bounds: [f64; 2],
    /// The direction in which the support functions differ by the lower bound.
    pub direction: Vec<f64>,
    /// Whether the second body is claimed to contain the first one.
    pub is_subset: bool,
}

/// Proves the lower bound of the distance of two bodies, each a centre and generators, and whether the second contains
/// the first; then the upper bound, of bodies without too many vertices.
pub fn check_hausdorff(a: (&[f64], &[Vec<f64>]), b: (&[f64], &[Vec<f64>]), answer: &HausdorffAnswer) -> Verdict {
    let upper = answer.bounds[1];
    let bounded = proved(a, b, answer).and_then(|pair| {
        let both = pair.check_first_within(upper).and_then(|()| pair.check_second_within(upper));
        bounded("containment", both)?;
        check_width(&pair, answer.bounds)?;
        Ok(words("containment", answer.bounds))
    });
    bounded.into()
}

/// The proof, and the bounds of the distance.
pub(super) fn words(proved: &str, [lower, upper]: [f64; 2]) -> String {
    format!("{proved}; the distance is {lower:?} to {upper:?}")
}

/// The outcome of a check of the upper bound, after that of all the rest.
pub(super) fn bounded(proved: &str, upper_bound: Result<(), Stop>) -> Result<(), Stop> {
    upper_bound.map_err(|stop| match stop {
        Stop::Unchecked(reason) => Stop::Unchecked(format!(
            "{proved} and the lower bound of the distance are proved; the upper bound is not checked: {reason}"
        )),
        wrong => wrong,
    })
}

fn proved(a: Plain<'_>, b: Plain<'_>, answer: &HausdorffAnswer) -> Result<BodyPair, Stop> {
    let pair = BodyPair::new(a, b)?;
    let [lower, upper] = answer.bounds;
    check_bounds(&pair, answer.bounds, &answer.direction)?;
    if !(lower <= answer.value && answer.value <= upper) {
        return Err("the distance is not between its bounds".into());
    }
    let [own, others] = &pair.generators;
    let moved: Vec<Vector> = own.iter().cloned().chain([pair.displacement.clone()]).collect();
    match contains_body(pair.displacement.len(), others, &moved) {
        Ok(is_subset) if is_subset == answer.is_subset => Ok(pair),
        Ok(true) => Err("a lies in b".into()),
        Ok(false) => Err("a does not lie in b".into()),
        Err(_) => Err(Stop::Unchecked("b has too many facets to try".to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_wrong(x: f64, side: f64, answer: &HausdorffAnswer) -> bool {
        let square = |side: f64| vec![vec![side, 0.0], vec![0.0, side]];
        check_hausdorff((&[x, 0.0], &square(1.0)), (&[0.0, 0.0], &square(side)), answer).is_wrong()
    }

    #[test]
    fn squares_by_hand() {
        let answer = |value: f64, direction: [f64; 2], is_subset| HausdorffAnswer {
            value,
            bounds: [value, value * (1.0 + 1e-13)],
            direction: direction.to_vec(),
            is_subset,
        };
        // side 2 around side 1: the corners are √2 apart; moved by 1 it still is in it
        let root = 2.0_f64.sqrt().next_down();
        assert!(!is_wrong(0.0, 2.0, &answer(root, [1.0, 1.0], true)));
        assert!(is_wrong(0.0, 2.0, &answer(root.next_up(), [1.0, 1.0], true)), "not so far, by less than an ulp");
        assert!(is_wrong(0.0, 2.0, &answer(root, [1.0, 0.0], true)), "not in this direction");
        assert!(is_wrong(0.0, 2.0, &answer(root, [1.0, 1.0], false)), "it is contained");
        let tight = HausdorffAnswer { bounds: [root, root], ..answer(root, [1.0, 1.0], true) };
        assert!(is_wrong(0.0, 2.0, &tight), "the root is above the double");
        // moved by 1 as well: the corner (-2, 2) is √5 from the nearest one, (0, 1)
        let moved = HausdorffAnswer { bounds: [2.0, 2.2361], ..answer(2.0, [-1.0, 0.0], true) };
        assert!(!is_wrong(1.0, 2.0, &moved));
        assert!(is_wrong(1.0, 2.0, &HausdorffAnswer { bounds: [2.0, 2.236], ..moved }));
        assert!(is_wrong(1.5, 2.0, &answer(2.0, [-1.0, 0.0], true)), "it is not contained");
        assert!(is_wrong(0.0, 2.0, &HausdorffAnswer { value: 9.0, ..answer(root, [1.0, 1.0], true) }));
        // in the direction (1, 0) they differ by 1, and the corners by more than that
        let low = HausdorffAnswer { bounds: [1.0, 1.4], ..answer(1.0, [1.0, 0.0], true) };
        assert!(is_wrong(0.0, 2.0, &low), "a corner is farther away");
    }

    #[test]
    fn true_bounds_that_say_little_are_left_unchecked() {
        let square = vec![vec![1.0, 0.0], vec![0.0, 1.0]];
        let verdict = |bounds: [f64; 2], value: f64| {
            let answer = HausdorffAnswer { value, bounds, direction: vec![1.0, 0.0], is_subset: false };
            check_hausdorff((&[0.0, 0.0], &square), (&[5.0, 0.0], &square), &answer)
        };
        assert!(verdict([5.0, 5.0], 5.0).is_right() && verdict([4.96, 5.0], 5.0).is_right());
        let infinite = f64::INFINITY;
        for (bounds, value) in [([4.9, 5.0], 5.0), ([5.0, 5.1], 5.0), ([0.0, infinite], 5.0), ([5.0, infinite], 7.0)] {
            assert!(matches!(verdict(bounds, value), Verdict::Unchecked(_)), "{bounds:?}");
        }
        for bounds in [[5.0, 4.0], [infinite, infinite], [f64::NAN, 5.0], [5.0, f64::NAN], [-1.0, 5.0]] {
            assert!(verdict(bounds, 5.0).is_wrong(), "{bounds:?}");
        }
        let huge = vec![vec![f64::MAX, 0.0]];
        let answer = HausdorffAnswer {
            value: infinite,
            bounds: [f64::MAX, infinite],
            direction: vec![1.0, 0.0],
            is_subset: false,
        };
        assert!(
            check_hausdorff((&[f64::MAX, 0.0], &huge), (&[0.0, 0.0], &[]), &answer).is_right(),
            "beyond all doubles"
        );
    }

    #[test]
    fn bodies_of_one_space_have_its_dimension_and_others_are_refused() {
        let pair = |a: [&[f64]; 2], b: [&[f64]; 2]| {
            BodyPair::new((a[0], &[a[1].to_vec()]), (b[0], &[b[1].to_vec()])).map(|pair| pair.dimension())
        };
        let [line, plane, space]: [&[f64]; 3] = [&[1.0], &[1.0, 2.0], &[1.0, 2.0, 3.0]];
        assert_eq!(pair([plane, plane], [plane, plane]), Ok(2));
        assert_eq!(pair([space, space], [space, space]), Ok(3));
        for (a, b) in [([plane, space], [plane, plane]), ([plane, plane], [plane, line])] {
            assert!(pair(a, b).is_err(), "a generator of another length: {a:?} {b:?}");
        }
        assert!(pair([plane, plane], [line, plane]).is_err(), "a centre of another length");
        assert!(BodyPair::new((plane, &[]), (space, &[])).is_err(), "centres alone");
    }

    #[test]
    fn bounds_and_directions_are_refused_for_their_own_reasons() {
        let square = vec![vec![1.0, 0.0], vec![0.0, 1.0]];
        let pair = BodyPair::new((&[0.0, 0.0], &square), (&[5.0, 0.0], &square)).expect("both are in the plane");
        let refused_for = |bounds: [f64; 2], direction: &[f64], reason: &str| {
            let outcome = check_bounds(&pair, bounds, direction);
            matches!(outcome, Err(Stop::Wrong(text)) if text.contains(reason))
        };
        assert!(check_bounds(&pair, [5.0, 5.0], &[1.0, 0.0]).is_ok());
        for bounds in [[5.0, 4.0], [5.0, f64::NAN], [0.0, f64::NAN]] {
            assert!(refused_for(bounds, &[1.0, 0.0], "in no order"), "{bounds:?}");
        }
        let directions: [&[f64]; 6] =
            [&[], &[1.0], &[1.0, 0.0, 0.0], &[1.0, f64::NAN], &[f64::INFINITY, 0.0], &[f64::NAN, 0.0, 0.0]];
        for direction in directions {
            assert!(refused_for([5.0, 5.0], direction, "no vector of the question's space"), "{direction:?}");
        }
        assert!(refused_for([5.0, 5.0], &[0.0, 0.0], "is zero"));
        assert!(refused_for([5.0, 5.0], &[0.0, 1.0], "differ by 0.0"));
    }

    /// A rhombus that is 4e-170 wide, and its long diagonal.
    #[test]
    fn a_distance_far_below_the_size_of_the_bodies_is_not_nothing() {
        let (rhombus, diagonal) = (vec![vec![0.5, 1e-170], vec![0.5, -1e-170]], vec![vec![1.0, 0.0]]);
        let verdict = |value: f64, bounds: [f64; 2]| {
            let answer = HausdorffAnswer { value, bounds, direction: vec![0.0, 1.0], is_subset: false };
            check_hausdorff((&[0.0, 0.0], &rhombus), (&[0.0, 0.0], &diagonal), &answer)
        };
        for upper in [0.0, 1e-300, 1e-180, 1e-171, 1.9e-170] {
            assert!(verdict(0.0, [0.0, upper]).is_wrong(), "{upper}");
        }
        assert!(verdict(2e-170, [2e-170, 2e-170]).is_right());
    }
}
