//! Bodies whose sparsest zonotope is known, and points of all kinds.

use super::{fewest, of_less_volume, shortest_of_few};
use crate::enclosing::min_total_length::{Method, MinLengthError, MinLengthZonotope, Outcome};
use crate::enclosing::oriented_box::small_box;

fn answered<const D: usize>(points: &[[f64; D]], epsilon: f64) -> MinLengthZonotope<D> {
    Method::default().solve(points, epsilon, &mut ()).expect("finite points")
}

fn sparse<const D: usize>(points: &[[f64; D]], epsilon: f64) -> MinLengthZonotope<D> {
    let sparse = fewest(points, answered(points, epsilon), epsilon);
    assert!(points.iter().all(|&point| sparse.body.contains(point) == Ok(true)));
    sparse
}

fn cube() -> Vec<[f64; 3]> {
    (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect()
}

/// Points on a spiral around the unit sphere, drawn out along the last axis.
fn spiral(count: usize, along: f64) -> Vec<[f64; 3]> {
    (0..count)
        .map(|i| {
            let height = (2 * i + 1) as f64 / count as f64 - 1.0;
            let (sin, cos) = libm::sincos(2.4 * i as f64);
            let width = (1.0 - height * height).sqrt();
            [width * cos, width * sin, along * height]
        })
        .collect()
}

#[test]
fn boxes_and_simplices_have_as_many_generators_as_dimensions() {
    for epsilon in [1e-2, 1e-3, 1e-6] {
        let found = sparse(&cube(), epsilon);
        assert_eq!(found.body.generators().len(), 3);
        assert!(found.value >= 1.5 && found.value < 1.5 * (1.0 + 1e-13));
        let found = sparse(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], epsilon);
        assert_eq!(found.body.generators().len(), 2);
        assert!(found.value >= 1.0 && found.value < 1.0 + 1e-13);
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(sparse(&corners, epsilon).body.generators().len(), 3);
        assert_eq!(sparse(&[[2.0], [5.0], [3.0]], epsilon).body.generators().len(), 1);
    }
}

#[test]
fn no_generator_is_shorter_than_rounding() {
    for points in [spiral(40, 1.0), spiral(60, 3.0)] {
        let found = sparse(&points, 1e-2);
        assert_eq!(found.proof.outcome, Outcome::WithinEpsilon);
        assert!(found.body.generators().len() <= 24 && found.ratio() <= 1.01);
        assert!(found.body.generators().iter().flatten().fold(0.0, |most: f64, c| most.max(c.abs())) > 0.1);
        assert!(found.body.generators().iter().all(|g| g.iter().map(|c| c * c).sum::<f64>().sqrt() > 1e-3));
    }
}

#[test]
fn a_count_is_kept_and_more_generators_are_no_longer() {
    let points = spiral(30, 2.0);
    let answer = answered(&points, 1e-3);
    let mut last = f64::INFINITY;
    for count in [3, 6, 12] {
        let found = shortest_of_few(&points, answer.clone(), 1e-3, count).expect("enough generators");
        assert!(found.body.generators().len() <= count && found.value < last);
        assert!(points.iter().all(|&point| found.body.contains(point) == Ok(true)));
        assert_eq!(found.lower_bound, answer.lower_bound);
        assert_eq!(found.proof.outcome == Outcome::WithinEpsilon, found.ratio() <= 1.001);
        last = found.value;
    }
    let refused = shortest_of_few(&points, answer, 1e-3, 2).expect_err("two generators span a plane");
    assert_eq!(refused, MinLengthError::TooFewGenerators { count: 2, needed: 3 });
    let message = "at most 2 generators are asked for, and at least 3 are needed around these points";
    assert_eq!(refused.to_string(), message);
}

/// The corners of a prism over an L, whose smallest boxes have their sides along the axes.
fn prism_over_an_l() -> Vec<[f64; 3]> {
    let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    corners.iter().flat_map(|[x, y]| [0.0, 1.0].map(|z| [*x, *y, z])).collect()
}

#[test]
fn three_generators_are_no_longer_and_hold_no_more_than_the_box_along_the_axes() {
    let points = prism_over_an_l();
    let answer = answered(&points, 1e-3);
    let found = shortest_of_few(&points, answer.clone(), 1e-3, 3).expect("a box");
    assert!(found.body.generators().len() == 3 && found.value <= 3.5 * (1.0 + 1e-12), "{}", found.value);
    let found = of_less_volume(&points, answer, 1e-3);
    assert!(found.body.exact_volume().to_f64() <= 9.0 * (1.0 + 1e-12), "{}", found.body.exact_volume().to_f64());
}

#[test]
fn flat_tiny_and_huge_points() {
    // a plane that no axis is orthogonal to
    let turned = |p: &[f64; 3]| [0.3 * p[0] + 0.7 * p[1], 0.9 * p[0] - 0.1 * p[1], 0.2 * p[0] + 0.5 * p[1]];
    let flat: Vec<[f64; 3]> = spiral(20, 1.0).iter().map(turned).collect();
    let found = sparse(&flat, 1e-2);
    assert!(found.ratio() <= 1.01 && found.body.generators().len() <= 8);
    let few = shortest_of_few(&flat, answered(&flat, 1e-2), 1e-2, 4).expect("three and one for rounding");
    assert!(few.body.generators().len() <= 4 && flat.iter().all(|&point| few.body.contains(point) == Ok(true)));
    // points of a line, one of them twice, and a single point
    let line: Vec<[f64; 3]> = [0.0, 1.0, 1.0, -0.3].map(|t| [1.0 + 0.1 * t, 2.0 - 0.7 * t, t]).to_vec();
    assert!(sparse(&line, 1e-3).body.generators().len() <= 3);
    assert!(sparse(&[[1.0, 2.0, 3.0]; 3], 1e-3).body.generators().is_empty());
    for scale in [1e-300, 1e300] {
        let points: Vec<[f64; 3]> = spiral(12, 1.0).iter().map(|p| p.map(|c| c * scale)).collect();
        let found = sparse(&points, 1e-2);
        assert!(found.ratio() <= 1.01 && found.body.generators().len() <= 16);
    }
}

/// Whether no two generators are less than two degrees from parallel.
fn least_angle_is_wide(generators: &[[f64; 3]]) -> bool {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let is_wide = |(a, b): (&[f64; 3], &[f64; 3])| dot(a, b).abs() < 0.9994 * (dot(a, a) * dot(b, b)).sqrt();
    generators.iter().enumerate().all(|(i, a)| generators[..i].iter().all(|b| is_wide((a, b))))
}

/// Needles have few generators, none nearly parallel to another one.
#[test]
fn needles_have_few_generators() {
    for [width, height] in [[1e-3, 1e-3], [1e-5, 1e-9], [1e-8, 1e-8]] {
        let straight = |p: &[f64; 3]| [width * p[0], height * p[1], p[2]];
        let turned = |p: &[f64; 3]| {
            let [x, y, z] = straight(p);
            [0.6 * x - 0.48 * z, 0.8 * y + 0.36 * z, 0.8 * x + 0.42 * z]
        };
        for needle in [spiral(12, 1.0).iter().map(straight).collect(), spiral(12, 1.0).iter().map(turned).collect()] {
            let needle: Vec<[f64; 3]> = needle;
            let found = sparse(&needle, 1e-2);
            assert!(found.body.generators().len() <= 4 && found.ratio() <= 1.01, "{:?}", found.body);
            assert!(least_angle_is_wide(found.body.generators()), "{:?}", found.body);
            let few = shortest_of_few(&needle, answered(&needle, 1e-2), 1e-2, 8).expect("enough generators");
            assert!(few.body.generators().len() <= 5, "{width:e} {height:e}");
        }
    }
}

#[test]
fn no_two_generators_are_nearly_parallel() {
    let points = spiral(24, 4.0);
    let answer = answered(&points, 1e-2);
    for count in [8, 16, 60] {
        let found = shortest_of_few(&points, answer.clone(), 1e-2, count).expect("enough generators");
        assert!(least_angle_is_wide(found.body.generators()), "{count}: {:?}", found.body);
    }
}

/// The best oriented box is among the starts, wherever its sides point.
#[test]
fn three_generators_are_no_worse_than_the_oriented_box() {
    let turned = |p: &[f64; 3]| {
        let [x, y, z] = *p;
        [(2.0 * x - 2.0 * y + z) / 3.0, (x + 2.0 * y + 2.0 * z) / 3.0, (2.0 * x + y - 2.0 * z) / 3.0]
    };
    for points in [prism_over_an_l().iter().map(turned).collect(), spiral(30, 2.0), spiral(9, 0.5)] {
        let points: Vec<[f64; 3]> = points;
        let best = small_box(&points).expect("they span space");
        let answer = answered(&points, 1e-3);
        let found = shortest_of_few(&points, answer, 1e-3, 3).expect("three span space");
        let length: f64 = best.half_sides.iter().sum();
        assert!(found.value <= length * (1.0 + 1e-12), "{} {length}", found.value);
        let smaller = of_less_volume(&points, found, 1e-3);
        let volume = 8.0 * best.half_sides.iter().product::<f64>();
        assert!(smaller.body.exact_volume().to_f64() <= volume * (1.0 + 1e-12));
    }
}

#[test]
fn the_volume_becomes_less_and_the_points_stay_inside() {
    let points = spiral(30, 2.0);
    let start = sparse(&points, 1e-2);
    let found = of_less_volume(&points, start.clone(), 1e-2);
    assert!(points.iter().all(|&point| found.body.contains(point) == Ok(true)));
    assert!(found.body.exact_volume() < start.body.exact_volume());
    assert!(found.body.generators().len() <= start.body.generators().len());
    assert_eq!((found.lower_bound, found.value >= start.lower_bound), (start.lower_bound, true));
    // nothing is smaller than the cube, and a square of space has no volume
    let found = of_less_volume(&cube(), sparse(&cube(), 1e-3), 1e-3);
    assert!((found.body.exact_volume().to_f64() - 1.0).abs() < 1e-12);
    let square = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0]];
    assert_eq!(of_less_volume(&square, sparse(&square, 1e-3), 1e-3), sparse(&square, 1e-3));
}
