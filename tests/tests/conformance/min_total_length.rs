//! Section 4.3: every answer is within 1 + ε of the optimum, by proofs that the verifier checks; in the
//! plane the optimum is known.

use dashu_ratio::RBig;
use families::drawn::numbers::{lattice, plain, power_of_two};
use families::drawn::points::{self, Point};
use proptest::array::uniform;
use proptest::collection::vec;
use proptest::prelude::*;
use tests::kernel_twin::exactly;
use tests::runner::for_all;
use zonotope::enclosing::min_length;
use zonotope::enclosing::min_total_length::direction_net::{cell_corners, cell_middles};
use zonotope::enclosing::min_total_length::{MinLengthZonotope, Net, by_direction_net, in_the_plane};
use zonotope::interop::verifier::{check_min_length_all, check_min_length_all_at_any_ratio};

fn proven<const D: usize>(
    points: &[[f64; D]],
    answer: &MinLengthZonotope<D>,
    epsilon: f64,
) -> Result<(), TestCaseError> {
    // A centre and generators in doubles may cost a few units in the last place of the largest coordinate.
    let largest = points.iter().flatten().fold(0.0, |max: f64, c| max.max(c.abs()));
    let rounding = if answer.value > 0.0 { 16.0 * f64::EPSILON * (largest / answer.value) } else { 0.0 };
    prop_assert!(answer.ratio() <= 1.0 + epsilon + rounding, "{} of {}: {:?}", answer.ratio(), epsilon, answer);
    let verdict = check_min_length_all(points, epsilon, answer);
    prop_assert!(verdict.is_right(), "{:?}: {:?}", verdict, answer);
    Ok(())
}

/// The multipliers of a net prove less than what is known of the net.
fn proven_at_its_ratio<const D: usize>(
    points: &[[f64; D]],
    answer: &MinLengthZonotope<D>,
    epsilon: f64,
) -> Result<(), TestCaseError> {
    let verdict = check_min_length_all_at_any_ratio(points, epsilon, answer);
    prop_assert!(verdict.is_right(), "{:?}: {:?}", verdict, answer);
    Ok(())
}

fn solved<const D: usize>(points: &[[f64; D]], epsilon: f64) -> Result<MinLengthZonotope<D>, TestCaseError> {
    let answer = min_length(points, epsilon).map_err(|error| TestCaseError::fail(error.to_string()))?;
    proven(points, &answer, epsilon)?;
    Ok(answer)
}

fn optimal_in_the_plane(points: Vec<Point>) -> Result<(), TestCaseError> {
    let answer = solved(&points, 1e-9)?;
    let truth = in_the_plane::least_length(&points);
    let largest = points.iter().flatten().fold(0.0, |max: f64, c| max.max(c.abs()));
    let allowed = 2e-9 * truth + 1e-12 * largest;
    prop_assert!((answer.value - truth).abs() <= allowed, "{} {}", answer.value, truth);
    Ok(())
}

tests::test_on_point_families!(|points| points, 40, optimal_in_the_plane; generic lattice_points duplicates symmetric);

#[test]
fn regular_polygons_are_optimal_too() {
    for_all(&points::regular_polygons(), 40, optimal_in_the_plane);
}

fn sets<const D: usize>(number: fn() -> BoxedStrategy<f64>, most: usize) -> BoxedStrategy<Vec<[f64; D]>> {
    vec(uniform::<_, D>(number()), 1..=most).boxed()
}

#[test]
fn on_the_line_the_optimum_is_half_the_extent() {
    for_all(&sets::<1>(plain, 9), 60, |points| {
        let answer = solved(&points, 1e-9)?;
        let values = || points.iter().map(|p| p[0]);
        let extent = exactly(values().fold(f64::MIN, f64::max)) - exactly(values().fold(f64::MAX, f64::min));
        let half = extent / RBig::from(2);
        prop_assert!(exactly(answer.lower_bound) <= half && half <= exactly(answer.value), "{:?}", answer);
        Ok(())
    });
}

#[test]
fn in_space() {
    for_all(&sets::<3>(plain, 9), 60, |points| solved(&points, 1e-6).map(|_| ()));
    for_all(&sets::<3>(lattice, 9), 60, |points| solved(&points, 1e-6).map(|_| ()));
    for_all(&sets::<3>(plain, 40), 12, |points| solved(&points, 1e-7).map(|_| ()));
}

/// A set of points of space with many ties.
fn tied(choice: usize, at: i32, half: [f64; 3]) -> Vec<[f64; 3]> {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let signs = |p: [f64; 3]| (0..8).map(move |s| std::array::from_fn(|c| if s >> c & 1 == 0 { p[c] } else { -p[c] }));
    let turned = |p: [f64; 3]| [p, [p[1], p[2], p[0]], [p[2], p[0], p[1]]];
    let all = |p: [f64; 3]| -> Vec<[f64; 3]> { turned(p).into_iter().flat_map(signs).collect() };
    match choice {
        0 => signs(half).collect(),
        1 => all([half[0], 0.0, 0.0]),
        2 => all([0.0, 1.0, golden]),
        3 => [signs([1.0; 3]).collect(), all([0.0, 1.0 / golden, golden])].concat(),
        4 => all([1.0, 1.0, 0.0]),
        5 => [all([0.0, 1.0, 2.0]), all([0.0, 2.0, 1.0])].concat(),
        6 => all([1.0, 1.0, 3.0]),
        // half a lattice of three points each way, by a rule that looks arbitrary
        7 => (0..27)
            .filter(|i| (i * 7919 + at).rem_euclid(11) < 7)
            .map(|i| [i % 3, i / 3 % 3, i / 9].map(f64::from))
            .collect(),
        // prisms over regular polygons with corners in doubles
        8 => (3..9)
            .flat_map(|k| {
                let angle = std::f64::consts::TAU / f64::from(at.rem_euclid(6) + 3);
                let t = angle * f64::from(k);
                [half[0], -half[0]].map(|z| [libm::cos(t), libm::sin(t), z])
            })
            .collect(),
        // a lattice in a plane, with a step off it
        _ => (0..12).map(|i| [f64::from(i % 4), f64::from(i / 4), f64::from((i + at).rem_euclid(5) / 4)]).collect(),
    }
}

#[test]
fn sets_with_many_ties_to_the_last_digits() {
    let sizes = uniform::<_, 3>(proptest::sample::select(vec![0.125, 0.3, 0.5, 0.7, 1.0, 1.5]));
    for_all(&(0..10usize, 0..1000i32, sizes, -900..=900i32), 120, |(choice, at, half, exponent)| {
        let power = if exponent % 3 == 0 { power_of_two(exponent) } else { 1.0 };
        let points: Vec<[f64; 3]> = tied(choice, at, half).iter().map(|p| p.map(|c| c * power)).collect();
        solved(&points, 1e-9).map(|_| ())
    });
    for_all(&sets::<3>(lattice, 12), 120, |points| solved(&points, 1e-9).map(|_| ()));
    for_all(&sets::<3>(plain, 9), 60, |points| solved(&points, 1e-9).map(|_| ()));
    for_all(&sets::<3>(lattice, 6), 60, |points| {
        let both = points.iter().flat_map(|p| [*p, p.map(|c| -c)]).collect::<Vec<_>>();
        solved(&both, 1e-9).map(|_| ())
    });
}

/// Some of the points with others near them.
fn clustered<const D: usize>(most: usize) -> BoxedStrategy<Vec<[f64; D]>> {
    let points = prop_oneof![sets::<D>(plain, most), sets::<D>(lattice, most)];
    let off = prop_oneof![Just(Vec::new()), vec(uniform::<_, D>(-1.0..1.0f64), 1..4)];
    let with_others = |(mut points, digits, off): (Vec<[f64; D]>, f64, Vec<[f64; D]>)| {
        let near = libm::pow(10.0, -digits);
        for (place, off) in off.into_iter().enumerate() {
            let p = points[place % points.len()];
            points.push(std::array::from_fn(|c| p[c] + near * off[c]));
        }
        points
    };
    (points, 2.0..12.0f64, off).prop_map(with_others).boxed()
}

/// Points whose extents along some axes are up to 10^8 times those along others, reflected in a plane or not: as good
/// as turned.
fn uneven<const D: usize>(most: usize) -> BoxedStrategy<Vec<[f64; D]>> {
    let mirror = prop_oneof![Just(None), uniform::<_, D>(-1.0..1.0f64).prop_map(Some)];
    let uneven = |(points, thin, mirror): (Vec<[f64; D]>, [f64; D], Option<[f64; D]>)| {
        let widths = thin.map(|digits| libm::pow(10.0, -digits));
        let along = |a: &[f64; D], b: &[f64; D]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let reflected = |p: [f64; D]| -> [f64; D] {
            let Some(normal) = mirror else { return p };
            let factor = 2.0 * along(&normal, &p) / along(&normal, &normal);
            std::array::from_fn(|c| p[c] - factor * normal[c])
        };
        points.iter().map(|p| reflected(std::array::from_fn(|c| p[c] * widths[c]))).collect()
    };
    (clustered(most), uniform::<_, D>(0.0..8.0f64), mirror).prop_map(uneven).boxed()
}

#[test]
fn needles_plates_and_clusters_to_the_last_digits() {
    for_all(&uneven::<2>(12), 120, |points| solved(&points, 1e-9).map(|_| ()));
    for_all(&uneven::<3>(16), 240, |points| solved(&points, 1e-9).map(|_| ()));
    for_all(&uneven::<4>(8), 40, |points| solved(&points, 1e-6).map(|_| ()));
}

#[test]
fn in_four_dimensions() {
    for_all(&sets::<4>(plain, 8), 24, |points| solved(&points, 1e-4).map(|_| ()));
    for_all(&sets::<4>(lattice, 8), 24, |points| solved(&points, 1e-4).map(|_| ()));
}

#[test]
fn any_scale() {
    for_all(&(sets::<3>(plain, 6), -900..=900i32), 30, |(points, exponent)| {
        let points: Vec<[f64; 3]> = points.iter().map(|p| p.map(|c| c * power_of_two(exponent))).collect();
        solved(&points, 1e-6).map(|_| ())
    });
}

/// A zonotope around its own vertices: nothing is shorter than itself.
#[test]
fn the_vertices_of_a_zonotope_give_the_zonotope() {
    for_all(&vec(uniform::<_, 3>(plain()), 3..=4), 24, |generators| {
        let vertices: Vec<[f64; 3]> = (0..1usize << generators.len())
            .map(|signs| {
                generators.iter().enumerate().fold([0.0; 3], |sum: [f64; 3], (i, g)| {
                    let sign = if signs >> i & 1 == 0 { 1.0 } else { -1.0 };
                    std::array::from_fn(|c| sum[c] + sign * g[c])
                })
            })
            .collect();
        let answer = solved(&vertices, 1e-7)?;
        let own: f64 = generators.iter().map(|g| g.iter().map(|c| c * c).sum::<f64>().sqrt()).sum();
        prop_assert!((answer.value - own).abs() <= 2e-7 * own, "{} {}", answer.value, own);
        Ok(())
    });
}

#[test]
fn nets_keep_their_ratio() {
    for net in [Net::Paper, Net::Cells] {
        let solve = |epsilon: f64| {
            move |points: Vec<[f64; 3]>| {
                let answer = by_direction_net::min_length_by_net(&points, epsilon, net, &mut ())
                    .map_err(|error| TestCaseError::fail(error.to_string()))?;
                let best = solved(&points, 1e-6)?;
                prop_assert!(answer.value <= (1.0 + epsilon) * best.value, "{} {}", answer.value, best.value);
                proven_at_its_ratio(&points, &answer, epsilon)
            }
        };
        for_all(&sets::<3>(plain, 8), 12, solve(0.5));
        for_all(&sets::<3>(plain, 8), 4, solve(if net == Net::Paper { 0.4 } else { 0.1 }));
        for_all(&sets::<2>(plain, 12), 24, |points| {
            let answer = by_direction_net::min_length_by_net(&points, 0.05, net, &mut ())
                .map_err(|error| TestCaseError::fail(error.to_string()))?;
            prop_assert!(answer.value <= 1.05 * in_the_plane::least_length(&points) * (1.0 + 1e-12));
            proven_at_its_ratio(&points, &answer, 0.05)
        });
    }
}

/// Whether every unit vector is within `mesh` of the net, up to sign, by a search over the faces of the cube: a square
/// whose middle is nearer to a vector of the net than the mesh by its own half-diagonal is covered, else it is
/// quartered.
fn covers<const D: usize>(net: &[[f64; D]], mesh: f64) -> bool {
    let distance = |u: &[f64; D]| {
        let squares = net.iter().map(|v| {
            let square = |sign: f64| u.iter().zip(v).map(|(a, b)| (a - sign * b) * (a - sign * b)).sum::<f64>();
            square(1.0).min(square(-1.0))
        });
        squares.fold(f64::INFINITY, f64::min).sqrt()
    };
    let mut open: Vec<([f64; D], f64, usize)> =
        (0..D).map(|face| (std::array::from_fn(|c| if c == face { 1.0 } else { 0.0 }), 1.0, face)).collect();
    while let Some((middle, half, face)) = open.pop() {
        let length = middle.iter().map(|c| c * c).sum::<f64>().sqrt();
        // Outside the unit ball, making vectors unit vectors brings none of them farther apart.
        if distance(&middle.map(|c| c / length)) + half * (D as f64 - 1.0).sqrt() <= mesh * (1.0 + 1e-9) {
            continue;
        }
        if half < 1e-4 {
            return false;
        }
        for corner in 0..1usize << (D - 1) {
            let mut next = middle;
            for (bit, c) in (0..D).filter(|&c| c != face).enumerate() {
                next[c] += if corner >> bit & 1 == 0 { half / 2.0 } else { -half / 2.0 };
            }
            open.push((next, half / 2.0, face));
        }
    }
    true
}

#[test]
fn nets_have_the_mesh_that_is_claimed() {
    for cells in [1, 2, 3, 5] {
        let mesh = |dimension: f64| (dimension - 1.0).sqrt() / cells as f64;
        assert!(covers(&cell_middles::<2>(cells), mesh(2.0)) && covers(&cell_corners::<2>(cells), 2.0 * mesh(2.0)));
        assert!(covers(&cell_middles::<3>(cells), mesh(3.0)) && covers(&cell_corners::<3>(cells), 2.0 * mesh(3.0)));
    }
    assert!(covers(&cell_middles::<4>(2), 3f64.sqrt() / 2.0) && covers(&cell_middles::<4>(3), 3f64.sqrt() / 3.0));
    assert!(!covers(&cell_middles::<3>(3), 0.5 * 2f64.sqrt() / 3.0), "the search can fail");
}
