//! The walk to the facet through which a ray leaves.

use super::classes::Classes;
use super::edge_cycle::EdgeCycle;
use super::error::WalkError;
use super::interface::FacetWalk;
use crate::numeric::bounded;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, exact, sum};
use crate::numeric::linear::{cross, dot, max_norm};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::signed_sum::signed_sum;

/// A walk that knows the edges of its facet and where the facet is.
pub(super) trait LocatedWalk: FacetWalk {
    fn classes(&self) -> &Classes;

    fn cycle(&self) -> &EdgeCycle;

    /// The centre of the facet, relative to that of the body.
    fn located(&mut self) -> &ExactVector;
}

/// The centre of a facet, relative to that of the body: the sum of the generators that are not along it, turned
/// outward. O(n).
pub(super) fn facet_center(classes: &Classes, cycle: &EdgeCycle) -> ExactVector {
    let signs = cycle.signs(classes);
    signed_sum(classes.generators().iter().enumerate().map(|(index, &generator)| {
        let outward = classes.class_of(index).map_or(0, |class| signs[class as usize] as i8);
        (generator, if classes.points_up(index) { outward } else { -outward })
    }))
}

/// The centre of the next facet across an edge, from the centre of the facet before.
pub(super) fn next_center(
    classes: &Classes,
    center: &ExactVector,
    [from, to]: [&EdgeCycle; 2],
    edge: usize,
) -> Option<ExactVector> {
    let against = to.edge_against(from.edge(edge).ok()?)?;
    // the middle of the edge is on both sides; the facet beyond has its centre on the other side of it
    let back = to.to_edge(classes, against).map(|coordinate| -coordinate);
    Some(sum(&sum(center, &from.to_edge(classes, edge)), &back))
}

/// [`FacetWalk::walk_to`].
///
/// Across an edge with direction w and middle x, (u · p) / h(u) grows just if det(w, x, p) > 0; see the module.
pub(super) fn walk_to(walk: &mut impl LocatedWalk, direction: [f64; 3]) -> Result<u64, WalkError> {
    NonFinite::check_vector("the direction", &direction)?;
    if direction == [0.0; 3] {
        return Err(WalkError::NoDirection);
    }
    walk_along(walk, &exact(direction))
}

/// [`walk_to`] along the ray to an exact point; a walk to the centre itself stays where it is.
pub(super) fn walk_along(walk: &mut impl LocatedWalk, point: &ExactVector) -> Result<u64, WalkError> {
    let rounded = bounded::leading(point);
    let mut steps = 0;
    while let Some(edge) = best_edge(walk, point, &rounded) {
        walk.step(edge)?;
        steps += 1;
    }
    Ok(steps)
}

/// The edge across which the ray lies, of several the one across which (u · p) / h(u) grows fastest, as doubles say.
fn best_edge(walk: &mut impl LocatedWalk, point: &ExactVector, rounded: &BoundedVector) -> Option<usize> {
    let center = walk.located().clone();
    let (classes, cycle) = (walk.classes(), walk.cycle());
    let mut best: Option<(f64, usize)> = None;
    for edge in 0..cycle.len() {
        let along = cycle.edge(edge).ok()?.vector(classes);
        let middle = sum(&center, &cycle.to_edge(classes, edge));
        if let Some(growth) = growth(along, &middle, point, rounded)
            && best.is_none_or(|(other, _)| growth > other)
        {
            best = Some((growth, edge));
        }
    }
    best.map(|(_, edge)| edge)
}

/// det(w, x, p) / |w| in doubles if the exact determinant is positive.
fn growth(along: [f64; 3], middle: &ExactVector, point: &ExactVector, rounded: &BoundedVector) -> Option<f64> {
    let of_rounded = dot(&bounded::exact(along), &cross(&bounded::leading(middle), rounded));
    let is_positive = match of_rounded.sign() {
        Some(sign) => sign > 0,
        None => dot(&exact(along), &cross(middle, point)).sign().is_gt(),
    };
    let growth = of_rounded.value / max_norm(&along);
    is_positive.then_some(if growth.is_nan() { 0.0 } else { growth })
}

/// The vertex at which an edge begins, relative to the centre of the body, exactly.
pub(super) fn edge_start(
    classes: &Classes,
    cycle: &EdgeCycle,
    center: &ExactVector,
    edge: usize,
) -> Option<[Dyadic; 3]> {
    let back = cycle.edge(edge).ok()?.reversed().half_edge(classes);
    Some(sum(&sum(center, &cycle.to_edge(classes, edge)), &back))
}
