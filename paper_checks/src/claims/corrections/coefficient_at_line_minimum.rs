//! The linear coefficient at O_l.

use dashu_ratio::RBig;

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Correction, Place, Tried, Verdict};
use crate::definitions::plane::{Point, bisectors, cell_gradient, hinge_sum, least_area};
use crate::definitions::ratio::fraction;
use crate::definitions::subdifferential::{deciding_interval, least_on_vertical};
use crate::instances::polygons::{generator, polygon, polygons, random_center};

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "coefficient-at-line-minimum",
    place: Place { section: "4.1", label: "after Corollary 4.4" },
    kind: ClaimKind::Correction(Correction::Erratum),
    statement: "If we compute the linear coefficient of f at O_l, we can decide whether O_l is the global minimum, \
        and if not, whether the minimum is on the left or on the right",
    remedy: Some(
        "O_l lies on a line of the arrangement, and f has no linear coefficient there: decide by the subgradients \
            there that vanish along the vertical line",
    ),
    code: &["zonotope::lad::of_lines::by_slope_selection"],
    figures: &["search-of-theorem-4-5"],
    check: Check::Run(check),
    tried: Tried::Witness,
};

/// Shows that O_l is always on a line, and one case where the neighbouring cells disagree on the side.
fn check(context: &CheckContext) -> Verdict {
    let mut random = generator(context.seed, 17);
    let mut tried = 0;
    for instance in polygons(&mut random, 40) {
        let lines = bisectors(&instance.polygon);
        let x = random_center(&mut random, &instance.polygon).x;
        let center = least_on_vertical(&lines, &x);
        if lines.iter().all(|line| line.height(&center) != RBig::ZERO) {
            return Verdict::Inconclusive(format!("{}: O_l = {center} lies inside a cell", instance.name));
        }
        tried += 1;
    }

    let quadrilateral = polygon(&[(0, 6), (1, 3), (6, 1), (5, 2)]);
    let lines = bisectors(&quadrilateral);
    let x = fraction(11, 12);
    let center = least_on_vertical(&lines, &x);
    let near = fraction(1, 1_000_000);
    let slope_beside = |sign: i64| cell_gradient(&lines, &center.plus(&(&near * RBig::from(sign)), &Point::at(0, 1))).x;
    let (below, above) = (slope_beside(-1), slope_beside(1));
    let deciding = deciding_interval(&lines, &center);
    let least_at = |x: &RBig| hinge_sum(&lines, &least_on_vertical(&lines, x));
    let change = (least_at(&(&x + &near)) - least_at(&x)) / &near;
    let (_, minimizers) = least_area(&quadrilateral);
    let expected = fraction(-6, 5);
    let mut slopes = [below, above];
    slopes.sort();
    if slopes != [fraction(-2, 1), fraction(2, 1)]
        || deciding != Some((expected.clone(), expected.clone()))
        || change != expected
        || minimizers.iter().any(|minimizer| minimizer.x <= x)
    {
        return Verdict::Inconclusive(format!(
            "at {center} the slopes are {slopes:?} and the deciding values {deciding:?}"
        ));
    }
    Verdict::Refuted(format!(
        "O_l lay on a line in all of {tried} cases; (0,6), (1,3), (6,1), (5,2) at x = 11/12: O_l = {center}, the \
         neighbouring cells have slopes {} and {} across the line, the deciding value is {change}, and the minimum is \
         to the right, at {}",
        slopes[0], slopes[1], minimizers[0]
    ))
}
