//! On which side of a cut the optimum of a query lies, or that it lies on the cut.
//!
//! At the minimum of the reduced function along the cut, the gradients that have no component along the cut are
//! λ p + μ n for an interval of μ. If it contains 0, this direction is the optimum. Else the function falls from there
//! towards the optimum, which lies on the side on which u · n and μ have opposite signs.
//!
//! All minimisers of h are in the interior of the part, by the cuts before; there h is the reduced function, which is
//! nowhere above h. So the reduced function has the same minimisers as h, and no others.

use super::circle::Circle;
use super::line_minimum::{Minimum, minimum};
use crate::collision::prepared::by_cutting::filtered::{
    Filtered, Shifted, Vector, are_parallel, sign_of_determinant, sign_of_product,
};
use crate::collision::prepared::by_cutting::structure::tree::Place;
use crate::collision::prepared::by_cutting::target::Target;
use crate::collision::prepared::by_cutting::vertex::{Reduced, Vertex};
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, exact, multiple, negated, sum};
use crate::numeric::signed_sum::signed_sum;
use crate::tally::{Operation, Tally};

/// Where the optimum lies.
#[derive(Debug)]
pub(crate) enum Decision {
    /// On the side from which the normal points away.
    Before,
    /// On the side to which the normal points.
    Beyond,
    /// On the cut: it is found.
    On(Box<Vertex>),
}

/// Where the optimum of a query lies relative to a cut. O(log k) for k generators, besides those that turn at the
/// minimum.
pub(crate) fn decide(circle: &Circle<'_>, target: &Target<'_>, tally: &mut dyn Tally) -> Decision {
    tally.add(Operation::SearchStep, 1);
    let (n, p) = (Filtered::new(&circle.normal), Filtered::new(target));
    if are_parallel(&n, &p) {
        // no direction along the cut has u · p = 1
        return if sign_of_product(&n, &p).is_gt() { Decision::Beyond } else { Decision::Before };
    }
    match minimum(circle, &n, &p, tally) {
        Minimum::Constant { gap } => without_turn(circle, target, gap, tally),
        Minimum::Turn { place, gap } => at_turn(circle, target, [place, gap], tally),
    }
}

/// The decision where the function is least where a generator turns: its place, and the gap before.
fn at_turn(circle: &Circle<'_>, target: &Target<'_>, [place, gap]: [usize; 2], tally: &mut dyn Tally) -> Decision {
    let turning = circle.turning_with(place);
    let v = Filtered::new(circle.turned(place));
    let is_along = |other: usize| other == place || are_parallel(&v, &Filtered::new(circle.turned(other)));
    if turning.clone().all(is_along)
        && let Some(decision) = beside_turn(circle, target, &v, gap, tally)
    {
        return decision;
    }
    let offset = gap - place;
    let [before, behind] = [turning.start, turning.end].map(|turn| circle.gradient(offset + turn).exact());
    let others = sum(&before, &behind).map(|c| c.scaled(-1));
    let direction = cross(&circle.normal.exact(), &exact(circle.turned(place)));
    let direction = if offset > 0 { negated(direction) } else { direction };
    let members = circle.turning[turning].iter().chain(circle.along).map(|place| place.index()).collect();
    decide_at(circle, target, direction, Reduced { members, others }, tally)
}

/// The decision where all generators that turn at the minimum are parallel to one; `None` if the optimum is there. All
/// gradients there have the same product with p × v, but for the generators along the cut.
fn beside_turn(
    circle: &Circle<'_>,
    target: &Target<'_>,
    v: &Filtered<[f64; 3]>,
    gap: usize,
    tally: &mut dyn Tally,
) -> Option<Decision> {
    tally.add(Operation::LineEvaluation, circle.steps_to(gap) as u64);
    tally.add(Operation::Comparison, 2);
    let (n, p, gradient) = (Filtered::new(&circle.normal), Filtered::new(target), Filtered::new(circle.gradient(gap)));
    let scale = sign_of_determinant(&n, &p, v);
    let along = sum_along(circle, target);
    let side = |is_reversed| {
        if circle.along.is_empty() {
            return sign_of_determinant(&gradient, &p, v);
        }
        sign_of_determinant(&Filtered::new(Shifted { base: &gradient, by: &along, is_reversed }), &p, v)
    };
    if side(true) == scale {
        return Some(Decision::Before);
    }
    (side(false) == scale.reverse()).then_some(Decision::Beyond)
}

/// The sum of the generators parallel to the normal, each turned to the normal's side.
fn sum_along(circle: &Circle<'_>, target: &Target<'_>) -> ExactVector {
    let normal = Filtered::new(&circle.normal);
    let turned = |place: &Place| {
        let v = target.query.generator(place.index());
        (v, if sign_of_product(&Filtered::new(v), &normal).is_lt() { -1 } else { 1 })
    };
    signed_sum(circle.along.iter().map(turned))
}

/// The decision where the function is constant along the cut.
fn without_turn(circle: &Circle<'_>, target: &Target<'_>, gap: usize, tally: &mut dyn Tally) -> Decision {
    let (n, p) = (&circle.normal.exact(), &target.direction);
    let others = circle.gradient(gap).exact();
    let along = sum_along(circle, target);
    // the gradient is λ p + μ n
    let scale = cross(n, p);
    let side = |gradient: &ExactVector| dot(&cross(gradient, p), &scale).sign();
    if side(&difference(&others, &along)).is_gt() {
        return Decision::Before;
    }
    if side(&sum(&others, &along)).is_lt() {
        return Decision::Beyond;
    }
    // p less its component along n
    let direction = difference(&multiple(&dot(n, n), p), &multiple(&dot(n, p), n));
    let members = circle.along.iter().map(|place| place.index()).collect();
    decide_at(circle, target, direction, Reduced { members, others }, tally)
}

/// The decision by the generators that are orthogonal to a direction along the cut, where the function is least there.
fn decide_at(
    circle: &Circle<'_>,
    target: &Target<'_>,
    direction: ExactVector,
    reduced: Reduced,
    tally: &mut dyn Tally,
) -> Decision {
    match reduced.solve_at(direction, target, tally) {
        Ok(vertex) => Decision::On(Box::new(vertex)),
        // along the cut the function does not fall, and it cannot fall on both sides
        Err(descent) if dot(&descent, &circle.normal.exact()).sign().is_gt() => Decision::Beyond,
        Err(_) => Decision::Before,
    }
}
