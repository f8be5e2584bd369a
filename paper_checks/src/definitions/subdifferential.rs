//! First-order facts about f at a point of the arrangement, from the hinge sum.

use std::cmp::Ordering;

use dashu_ratio::RBig;

use crate::definitions::plane::{Bisector, Point, hinge_sum};
use crate::definitions::ratio::integer;

/// Twice the gradients of the lines that pass strictly to the right of `center`, summed, and those of the lines
/// through it, listed: the subdifferential of f is the sum plus every combination of the list with factors in [0, 1].
fn hinges(lines: &[Bisector], center: &Point) -> (Point, Vec<Point>) {
    let two = integer(2);
    let mut fixed = Point::at(0, 0);
    let mut active = Vec::new();
    for line in lines {
        match line.height(center).cmp(&RBig::ZERO) {
            Ordering::Greater => fixed = fixed.plus(&two, &line.gradient()),
            Ordering::Equal => active.push(Point::at(0, 0).plus(&two, &line.gradient())),
            Ordering::Less => {}
        }
    }
    (fixed, active)
}

/// The derivative of f at `center` in a direction.
pub(crate) fn directional_derivative(lines: &[Bisector], center: &Point, direction: &Point) -> RBig {
    let dot = |vector: &Point| &vector.x * &direction.x + &vector.y * &direction.y;
    let (fixed, active) = hinges(lines, center);
    let mut slope = dot(&fixed);
    for gradient in &active {
        slope += dot(gradient).max(RBig::ZERO);
    }
    slope
}

/// Whether f, being convex and affine between the lines through `center`, has its least value there.
///
/// Between consecutive directions of lines through the point the directional derivative is linear, so it is nowhere
/// negative if it is not negative along those lines; this needs two lines that are not parallel.
pub(crate) fn is_minimizer(lines: &[Bisector], center: &Point) -> bool {
    lines.iter().filter(|line| line.height(center) == RBig::ZERO).all(|line| {
        [1, -1].into_iter().all(|sign| {
            let direction = Point::at(0, 0).plus(&integer(sign), &line.edge);
            directional_derivative(lines, center, &direction) >= RBig::ZERO
        })
    })
}

/// A point of the vertical line through `x` where f is least on that line: among the crossings with the lines.
pub(crate) fn least_on_vertical(lines: &[Bisector], x: &RBig) -> Point {
    let height = |line: &Bisector| {
        let along = (x - &line.start.x) / &line.edge.x;
        &line.start.y + along * &line.edge.y
    };
    lines
        .iter()
        .filter(|line| line.edge.x != RBig::ZERO)
        .map(|line| Point::new(x.clone(), height(line)))
        .min_by_key(|point| hinge_sum(lines, point))
        .expect("a polygon with area has edges that are not vertical")
}

/// The first coordinates of the subgradients at `center` whose second coordinate is zero: an interval that is wholly
/// positive when every minimum lies to the left, wholly negative when to the right, and holds zero at a minimum.
///
/// `center` must be least on its vertical line, or there is no such subgradient and the answer is `None`.
pub(crate) fn deciding_interval(lines: &[Bisector], center: &Point) -> Option<(RBig, RBig)> {
    let (fixed, active) = hinges(lines, center);
    let (mut low, mut high) = (fixed.x.clone(), fixed.x);
    let mut needed = -fixed.y;
    let mut sloped: Vec<Point> = Vec::new();
    for gradient in active {
        match gradient.y.cmp(&RBig::ZERO) {
            Ordering::Equal if gradient.x > RBig::ZERO => high += &gradient.x,
            Ordering::Equal => low += &gradient.x,
            Ordering::Greater => sloped.push(gradient),
            Ordering::Less => {
                low += &gradient.x;
                high += &gradient.x;
                needed -= &gradient.y;
                sloped.push(Point::at(0, 0).plus(&integer(-1), &gradient));
            }
        }
    }
    sloped.sort_by_key(|gradient| &gradient.x / &gradient.y);
    low += filled(sloped.iter(), needed.clone())?;
    high += filled(sloped.iter().rev(), needed)?;
    Some((low, high))
}

/// Σ λ_i x_i with λ_i in [0, 1] spent in the given order until Σ λ_i y_i reaches `needed`.
fn filled<'a>(gradients: impl Iterator<Item = &'a Point>, mut needed: RBig) -> Option<RBig> {
    let mut sum = RBig::ZERO;
    if needed < RBig::ZERO {
        return None;
    }
    for gradient in gradients {
        let share = (&needed / &gradient.y).min(RBig::ONE);
        sum += &share * &gradient.x;
        needed -= share * &gradient.y;
    }
    (needed == RBig::ZERO).then_some(sum)
}
