//! Answers to "how deep does the vector p lie in Z = { Σ δ_i g_i : |δ_i| ≤ 1 }": the least distance of p from the
//! planes of the facets, (Σ |u · g_i| − |u · p|) / |u| over the normals u. All of them are gone through where Z is
//! small.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::displaced::Displaced;
use super::location::Status;
use crate::RELATIVE_ERROR;
use crate::exact::length::{COARSENESS, Length};
use crate::exact::linear::dot;
use crate::exact::proportion::Proportion;
use crate::faces::facets::Facets;
use crate::verdict::Stop;

/// An answer as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct PenetrationAnswer {
    /// The depth is claimed to be at least this.
    pub lower: f64,
    /// The depth is claimed to be at most this.
    pub upper: f64,
    /// The direction in which it is that; of any length.
    pub direction: Vec<f64>,
}

/// By how much the bounds of a depth may differ, in terms of the upper one.
const ACCURACY: f64 = 0.01;

/// By how much rounding a direction to doubles may change the depth in it, relative to the sum of the magnitudes of all
/// components of the generators: each component of the direction is off by half an ulp.
const DIRECTION_ERROR: f64 = 4.0 * f64::EPSILON;

/// Checks the bounds, and that the direction is one in which p is that deep but for rounding.
pub(super) fn check_penetration(question: &Displaced, status: Status, answer: &PenetrationAnswer) -> Result<(), Stop> {
    let PenetrationAnswer { lower, upper, direction } = answer;
    if direction.len() != question.dimension() || direction.iter().any(|c| !c.is_finite()) {
        return Err("the direction of the depth is no vector of the question's space".into());
    }
    if status != Status::Inside {
        let is_none = *lower == 0.0 && *upper == 0.0 && direction.iter().all(|c| *c == 0.0);
        return if is_none { Ok(()) } else { Err("bodies without a common inner point do not overlap".into()) };
    }
    if !(0.0..=f64::MAX).contains(lower) {
        return Err(format!("the lower bound of the depth is {lower:?}, no finite number from 0 on").into());
    }
    if upper.is_nan() || lower > upper {
        return Err("the bounds of the depth are in no order".into());
    }
    let facets = Facets::of(question.dimension(), &question.generators, std::slice::from_ref(&question.p))
        .ok_or_else(|| Stop::Unchecked("there are too many facets to measure the depth".to_owned()))?;
    let depth = facets.depth(0).ok_or("a body without facets has no inside".to_owned())?;
    // In units of the question's numbers.
    let units = |number: f64| Proportion::of_double(number).times(&Proportion::whole(IBig::ONE, -question.exponent()));
    let told = || depth.rounded_at(question.exponent());
    if depth.compare(&units(*lower)).is_lt() {
        return Err(format!("the depth is {:?}, below its lower bound", told()).into());
    }
    let most = upper.min(f64::MAX);
    // A bound that is rounded up may leave the range of doubles where the depth nearly does.
    let reach = if upper.is_infinite() { most * (1.0 - RELATIVE_ERROR) } else { most };
    if depth.compare(&units(reach)).is_gt() != upper.is_infinite() {
        let relation = if upper.is_infinite() { "and the upper bound infinite" } else { "above its upper bound" };
        return Err(format!("the depth is {:?}, {relation}", told()).into());
    }
    check_direction(question, direction, (!upper.is_infinite()).then(|| units(most)), &depth)?;
    let narrowest = Proportion::of_double(most).times(&Proportion::of_double(1.0 - ACCURACY));
    if Proportion::of_double(*lower).plus(&Proportion::of_double(COARSENESS)).compare(&narrowest).is_lt() {
        return Err(Stop::Unchecked(format!(
            "the bounds of the depth, {lower:?} and {upper:?}, are right, but more than 1 % apart"
        )));
    }
    Ok(())
}

/// Checks that p is no deeper in a direction than the upper bound, but for what rounding the direction takes from sums;
/// where there is no bound in doubles, than the depth and the accuracy of bounds.
fn check_direction(
    question: &Displaced,
    direction: &[f64],
    upper: Option<Proportion>,
    depth: &Length,
) -> Result<(), Stop> {
    let exact: Option<Vec<_>> = direction.iter().map(|&c| crate::Fraction::of_double(c)).collect();
    let u = crate::whole_direction(&exact.unwrap_or_default());
    let reach = question.support(&u);
    let along = Proportion::whole(&reach - dot(&u, &question.p), 0);
    let Some(deep) = Length::along(&along, &u) else { return Err("the depth has no direction".into()) };
    let total = question.generators.iter().flatten().fold(IBig::ZERO, |sum, c| sum + c.clone().abs());
    let rounding = Proportion::whole(total, 0).times(&Proportion::of_double(DIRECTION_ERROR));
    let Some(upper) = upper else {
        let shortened = Length::along(&along.times(&Proportion::of_double(1.0 - ACCURACY)), &u);
        let is_deeper = shortened.is_none_or(|shortened| shortened.compare_length(depth).is_gt());
        let is_rounding = deep.compare(&rounding).is_le();
        let complaint = "in the direction of the depth it is deeper";
        return if is_deeper && !is_rounding { Err(complaint.into()) } else { Ok(()) };
    };
    if deep.compare(&upper.plus(&rounding)).is_gt() {
        return Err("in the direction of the depth it is deeper".into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A point that is `x` to the right of the middle of a box of half-lengths `half`.
    fn in_a_box(half: [f64; 2], x: f64) -> Displaced {
        let generators = [[0.5 * half[0], 0.0], [0.0, half[1]], [-0.5 * half[0], 0.0]];
        Displaced::new(&[0.0, 0.0], &[x, 0.0], &generators).expect("finite")
    }

    fn verdict(question: &Displaced, lower: f64, upper: f64, direction: &[f64]) -> Result<(), Stop> {
        let answer = PenetrationAnswer { lower, upper, direction: direction.to_vec() };
        check_penetration(question, Status::Inside, &answer)
    }

    fn is_wrong(found: Result<(), Stop>) -> bool {
        matches!(found, Err(Stop::Wrong(_)))
    }

    #[test]
    fn the_depth_in_a_box() {
        // the nearest side is the right one, one away
        let question = in_a_box([1.5, 4.0], 0.5);
        for direction in [[1.0, 0.0], [3.0, 0.0], [1.0, 1e-17]] {
            assert!(verdict(&question, 1.0, 1.0, &direction).is_ok(), "{direction:?}");
            assert!(verdict(&question, 0.995, 1.0, &direction).is_ok());
        }
        for bounds in [[1.25, 1.25], [0.5, 0.75], [1.0, 0.995], [-1.0, 1.0], [f64::NAN, 1.0], [1.0, f64::NAN]] {
            assert!(is_wrong(verdict(&question, bounds[0], bounds[1], &[1.0, 0.0])), "{bounds:?}");
        }
        for bounds in [[f64::INFINITY; 2], [1.0, f64::INFINITY]] {
            assert!(is_wrong(verdict(&question, bounds[0], bounds[1], &[1.0, 0.0])), "{bounds:?}");
        }
        // bounds that hold and are too far apart prove too little
        for bounds in [[0.98, 1.0], [1.0, 1.02], [0.0, 1.0]] {
            let found = verdict(&question, bounds[0], bounds[1], &[1.0, 0.0]);
            assert!(matches!(found, Err(Stop::Unchecked(_))), "{bounds:?}");
        }
        // the point is two deep to the left and four upwards, and more than one in a direction that is turned
        let wrong: [&[f64]; 7] =
            [&[-1.0, 0.0], &[0.0, 1.0], &[1.0, 0.25], &[0.0, 0.0], &[1.0], &[1.0, 0.0, 0.0], &[1.0, f64::NAN]];
        for direction in wrong {
            assert!(is_wrong(verdict(&question, 1.0, 1.0, direction)), "{direction:?}");
        }
    }

    #[test]
    fn bodies_without_a_common_inner_point_have_no_depth() {
        let question = in_a_box([1.0, 1.0], 1.0);
        let found = |lower, upper, direction: [f64; 2]| {
            let answer = PenetrationAnswer { lower, upper, direction: direction.to_vec() };
            check_penetration(&question, Status::Boundary, &answer)
        };
        assert!(found(0.0, 0.0, [0.0, 0.0]).is_ok() && found(-0.0, 0.0, [0.0, -0.0]).is_ok());
        for (lower, upper, direction) in [(0.25, 0.0, [0.0; 2]), (0.0, 0.25, [0.0; 2]), (0.0, 0.0, [1.0, 0.0])] {
            assert!(is_wrong(found(lower, upper, direction)), "{lower} {upper} {direction:?}");
        }
    }

    /// The sides of the box are about as far away as the largest double, or farther.
    #[test]
    fn a_depth_beyond_the_doubles_has_an_infinite_bound() {
        let (infinite, unit) = (f64::INFINITY, 2.0f64.powi(1022));
        // in quarters of 2^1024: how far the box reaches to the right, and how far the point is there
        let beyond = |reach: f64, x: f64| {
            let generators = [[0.5 * reach * unit, 0.0], [0.5 * reach * unit, 0.0], [0.0, f64::MAX], [0.0, f64::MAX]];
            Displaced::new(&[0.0, 0.0], &[x * unit, 0.0], &generators).expect("finite")
        };
        let deep = beyond(6.0, 0.5);
        assert!(verdict(&deep, f64::MAX, infinite, &[1.0, 0.0]).is_ok());
        assert!(verdict(&deep, f64::MAX, infinite, &[1.0, 0.001]).is_ok());
        assert!(is_wrong(verdict(&deep, f64::MAX, f64::MAX, &[1.0, 0.0])));
        for direction in [[-1.0, 0.0], [0.0, 1.0], [1.0, 0.1], [0.0, 0.0]] {
            assert!(is_wrong(verdict(&deep, f64::MAX, infinite, &direction)), "{direction:?}");
        }
        // as deep as the largest double: the bound may have been rounded up
        let largest = beyond(4.0, 2.0f64.powi(-51));
        for upper in [f64::MAX, infinite] {
            assert!(verdict(&largest, f64::MAX, upper, &[1.0, 0.0]).is_ok());
        }
        let below = beyond(4.0, 1.0);
        assert!(verdict(&below, 3.0 * unit, 3.0 * unit, &[1.0, 0.0]).is_ok());
        assert!(is_wrong(verdict(&below, 3.0 * unit, infinite, &[1.0, 0.0])));
    }
}
