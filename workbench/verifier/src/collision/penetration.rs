//! Answers to "how deep does the vector p lie in Z = { Σ δ_i g_i : |δ_i| ≤ 1 }": the least distance of p from the
//! planes of the facets, (Σ |u · g_i| − |u · p|) / |u| over the normals u. All of them are gone through where Z is
//! small.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::displaced::Displaced;
use super::location::Status;
use crate::RELATIVE_ERROR;
use crate::exact::length::root;
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
    if !(*lower >= 0.0 && lower <= upper) {
        return Err("the bounds of the depth are in no order".into());
    }
    let Some(facets) = Facets::of(question.dimension(), &question.generators) else {
        return Err(Stop::Unchecked("there are too many facets to measure the depth".to_owned()));
    };
    let unit = Proportion::whole(IBig::ONE, question.exponent());
    let mut depth: Option<[Proportion; 2]> = None;
    for (normal, reach) in facets.normals() {
        let along = Proportion::whole(reach - dot(normal, &question.p).abs(), 0).times(&unit);
        let [short, long] = root(&dot(normal, normal));
        let [low, high] = [along.over(&long), along.over(&short)].map(|bound| bound.expect("a normal is not zero"));
        depth = Some(match depth {
            Some([lowest, highest]) => [lesser(lowest, low), lesser(highest, high)],
            None => [low, high],
        });
    }
    let [low, high] = depth.ok_or("a body without facets has no inside".to_owned())?;
    let claims = [*lower, if upper.is_finite() { *upper } else { f64::MAX }].map(Proportion::of_double);
    if claims[0].compare(&high).is_gt() {
        return Err(format!("the depth is {:?}, below its lower bound", high.nearest()).into());
    }
    if claims[1].compare(&low).is_lt() && upper.is_finite() {
        return Err(format!("the depth is {:?}, above its upper bound", low.nearest()).into());
    }
    // a bound that is rounded up may leave the range of doubles where the depth nearly does
    let nearly = low.times(&Proportion::of_double(1.0 + RELATIVE_ERROR));
    if upper.is_infinite() && nearly.compare(&claims[1]).is_le() {
        return Err("the upper bound of the depth is infinite".into());
    }
    check_direction(question, direction, &high)
}

/// Checks that p is no deeper in a direction than it is at least, but for the accuracy of the bounds and for what
/// rounding the direction takes from sums.
fn check_direction(question: &Displaced, direction: &[f64], depth: &Proportion) -> Result<(), Stop> {
    let unit = Proportion::whole(IBig::ONE, question.exponent());
    let exact: Option<Vec<_>> = direction.iter().map(|&c| crate::Fraction::of_double(c)).collect();
    let u = crate::whole_direction(&exact.unwrap_or_default());
    let [short, _] = root(&dot(&u, &u));
    let reach = question.support(&u);
    let along = Proportion::whole(&reach - dot(&u, &question.p), 0).times(&unit);
    let Some(deep) = along.over(&short) else { return Err("the depth has no direction".into()) };
    let total = question.generators.iter().flatten().fold(IBig::ZERO, |sum, c| sum + c.clone().abs());
    let rounding = Proportion::whole(total, 0).times(&unit).times(&Proportion::of_double(RELATIVE_ERROR));
    let allowed = depth.times(&Proportion::of_double(1.0 + 2.0 * ACCURACY)).plus(&rounding);
    if deep.compare(&allowed).is_gt() {
        return Err("in the direction of the depth it is deeper".into());
    }
    Ok(())
}

fn lesser(a: Proportion, b: Proportion) -> Proportion {
    if b.compare(&a).is_lt() { b } else { a }
}
