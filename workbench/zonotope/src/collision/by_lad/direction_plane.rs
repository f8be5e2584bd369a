//! The kernel's plane of directions as plain numbers: the lines of the generators in it, and the optimum. For pictures.

use super::facet;
use crate::collision::Query;
use crate::lad::of_generators::plane::in_doubles::RoundedChart;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{cross, dot, exact};

/// The plane of directions u with u · p = 1, in the coordinates of the kernel.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionPlane {
    /// The displacement p, rounded.
    pub displacement: [f64; 3],
    /// The direction at (0, 0), rounded.
    pub origin: [f64; 3],
    /// The directions to add for a step along each coordinate, rounded.
    pub axes: [[f64; 3]; 2],
    /// For each generator v the line a x + b y + c = v · u, rounded; (0, 0, c) for one that is parallel to p.
    pub lines: Vec<[f64; 3]>,
    /// The point at which Σ |v · u| is least, each coordinate within a relative 2^-50: a normal of the facet through
    /// which the ray along p leaves the body. None where no such vertex is known, as for generators on a line.
    pub optimum: Option<[f64; 2]>,
    /// The gauge of p, 1 over the minimum, within a few units in the last place.
    pub gauge: f64,
}

/// The plane of directions of a query; `None` if its displacement is zero or beyond the doubles.
pub fn direction_plane(query: &Query<'_, 3>) -> Option<DirectionPlane> {
    let exact_displacement = query.exact();
    let displacement = exact_displacement.each_ref().map(Dyadic::to_f64);
    if displacement == [0.0; 3] || displacement.iter().any(|c| !c.is_finite()) {
        return None;
    }
    let chart = RoundedChart::new(displacement);
    let origin = chart.point([0.0, 0.0]);
    let axes = [[1.0, 0.0], [0.0, 1.0]].map(|step| {
        let along = chart.point(step);
        [0, 1, 2].map(|axis| along[axis] - origin[axis])
    });
    let optimal = facet(query, &mut ());
    let optimum = match *optimal.basis() {
        [first, second] => {
            let normal = cross(&exact(query.generator(first)), &exact(query.generator(second)));
            let along = dot(&normal, &exact_displacement);
            let axes = chart.axes();
            (!along.is_zero()).then(|| [0, 1].map(|axis| normal[axes[axis]].ratio(&along)))
        }
        _ => None,
    };
    let lines = query.generators().map(|generator| chart.line(generator)).collect();
    Some(DirectionPlane { displacement, origin, axes, lines, optimum, gauge: optimal.value().0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::Zonotope;

    const GENERATORS: [[f64; 3]; 5] =
        [[1.0, 0.5, 0.0], [0.0, 2.0, 1.0], [0.25, 0.0, 1.0], [-1.0, 1.0, 0.5], [0.5, 0.5, -2.0]];

    #[test]
    fn lines_are_values_of_generators_and_the_optimum_is_least() {
        for point in [[1.0, 2.0, 0.5], [-3.0, 0.25, 1.0], [0.5, -0.5, -4.0]] {
            let body = Zonotope::new([0.0; 3], GENERATORS.to_vec()).expect("the generators are finite");
            let plane = direction_plane(&Query::of_point(point, &body).expect("a point")).expect("no centre");
            let at =
                |[x, y]: [f64; 2]| [0, 1, 2].map(|i| plane.origin[i] + x * plane.axes[0][i] + y * plane.axes[1][i]);
            let times = |v: [f64; 3], u: [f64; 3]| v[0] * u[0] + v[1] * u[1] + v[2] * u[2];
            for place in [[0.5, -2.0], [3.0, 1.0]] {
                let direction = at(place);
                assert!((times(point, direction) - 1.0).abs() < 1e-12);
                for (generator, [a, b, c]) in GENERATORS.iter().zip(&plane.lines) {
                    assert!((times(*generator, direction) - (a * place[0] + b * place[1] + c)).abs() < 1e-12);
                }
            }
            let support = |[x, y]: [f64; 2]| plane.lines.iter().map(|[a, b, c]| (a * x + b * y + c).abs()).sum::<f64>();
            let optimum = plane.optimum.expect("the body spans space");
            assert!((support(optimum) * plane.gauge - 1.0).abs() < 1e-12);
            let nearby = [[0.01, 0.0], [-0.01, 0.0], [0.0, 0.01], [0.0, -0.01]];
            assert!(nearby.iter().all(|d| support([optimum[0] + d[0], optimum[1] + d[1]]) > support(optimum)));
        }
    }

    #[test]
    fn a_centre_has_no_plane_and_beside_a_flat_body_the_minimum_is_zero() {
        let square = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let of = |point, generators: Vec<[f64; 3]>| {
            let body = Zonotope::new([0.0; 3], generators).expect("finite");
            direction_plane(&Query::of_point(point, &body).expect("a point"))
        };
        assert_eq!(of([0.0; 3], square.clone()), None);
        let beside = of([0.0, 0.0, 2.0], square).expect("no centre");
        assert_eq!((beside.optimum, beside.gauge), (Some([0.0, 0.0]), f64::INFINITY));
        assert_eq!(of([1.0, 0.0, 0.0], Vec::new()).expect("no centre").optimum, None);
    }
}
