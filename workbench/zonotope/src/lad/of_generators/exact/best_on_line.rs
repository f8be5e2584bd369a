//! The best vertex on the line of a generator, in doubles: where pivots begin if a search ended at no vertex.
//!
//! A search may end at two parallel generators, whose lines rounding has made meet far away, or it may prove nothing at
//! all.

use crate::lad::of_generators::guess::crossings::CrossingList;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::exact_linear::{ExactVector, rounded_direction};
use crate::numeric::linear::{cross, dot};

/// The generator with which another one has the best vertex on its line, as far as doubles tell. O(n).
///
/// The line of a generator a is that of all directions u with u · a = 0 and u · p = 1; its nearest point to the origin
/// is along the part of p that is orthogonal to a.
pub(super) fn best_on_line(query: &dyn KernelQuery, p: &ExactVector, line: usize) -> Option<[usize; 2]> {
    let (p, a) = (rounded_direction(p), query.generator(line));
    let part = dot(&p, &a) / dot(&a, &a);
    let start = [0, 1, 2].map(|k| p[k] - part * a[k]);
    let start = start.map(|c| c / dot(&start, &p));
    let step = cross(&a, &p);
    let terms = || query.generators().map(|v| (dot(&v, &start), dot(&v, &step)));
    let slope: f64 = terms().map(|(value, rate)| rate * 1.0f64.copysign(value)).sum();
    let side = if slope > 0.0 { -1.0 } else { 1.0 };
    let mut crossings = CrossingList::with_capacity(query.len());
    for (other, (value, rate)) in terms().enumerate() {
        let place = -value / (side * rate);
        if (0.0..f64::INFINITY).contains(&place) && other != line {
            crossings.push(place, rate.abs(), other);
        }
    }
    crossings.select(slope.abs() / 2.0).map(|crossing| [line, crossing.line])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::exact;
    use crate::zonotope::query::Query;

    #[test]
    fn no_vertex_on_the_line_has_a_smaller_support() {
        let body =
            [[3.0, 1.0, 0.5], [6.0, 2.0, 1.0], [1.0, -2.0, 0.3], [0.2, 1.0, 2.0], [-1.0, 0.7, 1.1], [0.4, 0.1, -1.0]];
        for p in [[1.0, 2.0, 3.0], [-2.0, 0.1, 0.4], [0.3, -1.0, 0.9]] {
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let support = |other: usize| {
                let u = cross(&body[0], &body[other]);
                body.iter().map(|v| dot(v, &u).abs()).sum::<f64>() / dot(&u, &p).abs()
            };
            let [line, other] = best_on_line(&query, &exact(p), 0).expect("four vertices");
            assert!(line == 0 && other > 1);
            let least = (2..6).map(support).fold(f64::INFINITY, f64::min);
            assert!(support(other) <= least * (1.0 + 1e-12), "{p:?}");
        }
    }
}
