//! The areas of Z(O) and of a zonogon by pairs of doubles, with bounds on their errors.
//!
//! For few edges the bounds are so small that the area rounded up or down is known, but where it is a double or very
//! near one.

use crate::enclosing::centered_zonogon::{BoundaryVertex, CenteredZonogon};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::orientation::{Turn, cross_sign};

type Pair = BoundedDoubleDouble;

/// The area of Z(O): Σ arm × next arm over half of the boundary, the arms from the centre to the vertices. `None` where
/// sums of coordinates overflow.
pub(super) fn area_of_centered(zonogon: &CenteredZonogon) -> Option<Pair> {
    let (hull, center) = (zonogon.hull(), zonogon.center());
    let arm = |BoundaryVertex { vertex, reflected }: BoundaryVertex| {
        let point = hull.vertex(vertex);
        let [from, to] = if reflected { [point, center] } else { [center, point] };
        [0, 1].map(|axis| Pair::of_parts(to[axis], -from[axis], 0.0))
    };
    let half = zonogon.half_boundary();
    let mut before = arm(half[0]);
    let area = half[1..].iter().fold(Pair::exact(0.0), |area, &vertex| {
        let next = arm(vertex);
        let term = before[0] * next[1] - before[1] * next[0];
        before = next;
        area + term
    });
    area.is_known().then_some(area)
}

/// The area of the zonogon of generators in counter-clockwise order, all within half a turn from the first one, and of
/// a box of given half-widths: 4 Σ |g × h| over all pairs. `None` if they are not in such an order, or sums overflow.
pub(super) fn area_of_ordered(generators: &[[f64; 2]], [width, height]: [f64; 2]) -> Option<Pair> {
    const ORIGIN: [f64; 2] = [0.0; 2];
    let turns_left = |a: [f64; 2], b: [f64; 2]| cross_sign(ORIGIN, a, ORIGIN, b) == Turn::Left;
    let (&first, others) = generators.split_first()?;
    let is_ordered = generators.windows(2).all(|pair| turns_left(pair[0], pair[1]))
        && others.iter().all(|&other| turns_left(first, other));
    if !is_ordered {
        return None;
    }
    let mut sum = [Pair::exact(0.0); 2];
    let mut extent = [Pair::exact(0.0); 2];
    let mut quarter = Pair::exact(0.0);
    for generator in generators {
        let [x, y] = generator.map(Pair::exact);
        quarter = quarter + (sum[0] * y - sum[1] * x);
        sum = [sum[0] + x, sum[1] + y];
        extent = [extent[0] + x.abs(), extent[1] + y.abs()];
    }
    let [width, height] = [width, height].map(Pair::exact);
    let beside = width * extent[1] + height * extent[0] + width * height;
    let area = (quarter + beside).scaled(2);
    area.is_known().then_some(area)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::hull::antipodal::farthest_vertices;
    use crate::hull::convex_hull;
    use crate::numeric::dyadic::Dyadic;
    use crate::zonotope::Zonotope;

    fn is_near(area: Option<Pair>, exact: &Dyadic) -> bool {
        area.is_none_or(|area| (area.to_dyadic() - exact.clone()).abs() <= Dyadic::from_f64(area.parts().1))
    }

    properties! {
        #[test]
        fn areas_are_within_their_bounds(
            points in proptest::collection::vec([-1.0..1.0f64, -1.0..1.0], 3..12),
            center in [-1.0..1.0f64, -1.0..1.0],
            scale in prop_oneof![Just(1.0), Just(1e-160), Just(1e-310), Just(1e150), Just(1e307)],
        ) {
            let points: Vec<_> = points.iter().map(|point| point.map(|v| v * scale)).collect();
            let hull = convex_hull(&points, &mut ()).expect("the points are finite");
            let farthest = farthest_vertices(&hull, &mut ());
            let zonogon = CenteredZonogon::new(&hull, &farthest, center.map(|v| v * scale), &mut ());
            prop_assert!(is_near(area_of_centered(&zonogon), &zonogon.exact_area()));
        }

        #[test]
        fn areas_of_ordered_generators_are_within_their_bounds(
            turns in proptest::collection::vec((0.01..3.1f64, 0.1..1.0f64), 1..9),
            slack in [0.0..1e-15f64, 0.0..1e-15f64],
        ) {
            let generator = |&(angle, length): &(f64, f64)| [length * libm::cos(angle), length * libm::sin(angle)];
            let mut turns = turns;
            turns.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
            let generators: Vec<[f64; 2]> = turns.iter().map(generator).collect();
            let widened = [&generators[..], &[[slack[0], 0.0], [0.0, slack[1]]]].concat();
            let exact = Zonotope::new([0.0; 2], widened).expect("finite").exact_area();
            prop_assert!(is_near(area_of_ordered(&generators, slack), &exact));
            let backwards: Vec<[f64; 2]> = generators.iter().rev().copied().collect();
            prop_assert!(backwards.len() < 2 || area_of_ordered(&backwards, slack).is_none());
        }
    }
}
