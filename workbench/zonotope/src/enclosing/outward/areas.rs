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

/// The area of the zonogon of generators in counter-clockwise order, all within half a turn from the first one, and of a
/// box of given half-widths: 4 Σ |g × h| over all pairs. `None` if they are not in such an order, or sums overflow.
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
