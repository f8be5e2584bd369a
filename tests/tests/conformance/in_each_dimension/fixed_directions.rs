//! Section 4.2: row generation and the program in rationals against the twin on all normals, on generated points and
//! directions.

use proptest::prelude::*;
use tests::kernel_twin::exactly;
use zonotope::enclosing::fixed_directions::{
    FixedDirections, FixedDirectionsError, brute_force, min_length_along, rational,
};
use zonotope::interop::verifier::{check_min_length_dirs, check_min_length_dirs_at_any_gap};
use zonotope::numeric::scaling::scale_by_power_of_two;

const TIGHT: f64 = 1e-12;

/// Only what is proven is checked: doubles may not hold the best centre.
const PROVEN: f64 = f64::MAX;

/// The answer is proven, infeasible just when the truth is, and its bounds are so near to it, relatively.
fn check<const D: usize>(
    points: &[[f64; D]],
    directions: &[[f64; D]],
    weights: &[f64],
    within: f64,
) -> Result<(), TestCaseError> {
    let problem = FixedDirections::new(points, directions, weights).expect("valid");
    let truth = brute_force::least_length(&problem);
    let in_rationals = rational::min_length_in_rationals(&problem).map(|optimum| optimum.value);
    prop_assert_eq!(&in_rationals, &truth.as_ref().map(|truth| truth.value.clone()));
    let answer = match min_length_along(&problem, &mut ()) {
        Err(error) => {
            prop_assert_eq!(error, FixedDirectionsError::OutOfRange);
            return Ok(());
        }
        Ok(answer) => answer,
    };
    let verdict = check_min_length_dirs_at_any_gap(&problem, &answer);
    prop_assert!(verdict.is_right(), "{:?} {:?}", verdict, answer);
    prop_assert_eq!(answer.optimal().is_some(), truth.is_some());
    if let (Some(answer), Some(truth)) = (answer.optimal(), truth) {
        let excess = exactly(answer.value) - &truth.value;
        let allowed = &truth.value * exactly(within);
        prop_assert!(excess <= allowed, "{} of {:e} {:?}", answer.value, truth.value.to_f64_fast(), answer);
        prop_assert!(exactly(answer.lower_bound) <= truth.value);
        let short = &truth.value - exactly(answer.lower_bound);
        prop_assert!(short <= allowed, "{} of {:e} {:?}", answer.lower_bound, truth.value.to_f64_fast(), answer);
    }
    Ok(())
}

fn lattice<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform((-3i8..4).prop_map(f64::from)), count)
}

fn real<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform(-1.0..1.0f64), count)
}

/// A vector times a power of ten, and its last coordinate over another one.
fn thin<const D: usize>(v: [f64; D], scale: i32, thickness: i32) -> [f64; D] {
    let scale = 10f64.powi(scale);
    let last = scale * 10f64.powi(-thickness);
    std::array::from_fn(|c| v[c] * if c + 1 == D { last } else { scale })
}

const WEIGHTS: [f64; 8] = [1.0, 2.0, 1.0, 0.5, 1.0, 3.0, 1.0, 1.0];

macro_rules! dimensions {
    ($($name:ident: $d:literal, $least:literal, $most:literal;)*) => {$(
        mod $name {
            use super::*;

            tests::properties! {
                150;

                #[test]
                fn real_points_and_directions(points in real::<$d>(1..12), directions in real::<$d>($least..$most)) {
                    check(&points, &directions, &WEIGHTS[..directions.len()], TIGHT)?;
                }

                #[test]
                fn lattices(points in lattice::<$d>(1..9), directions in lattice::<$d>(0..$most)) {
                    check(&points, &directions, &WEIGHTS[..directions.len()], TIGHT)?;
                }

                #[test]
                fn weights_may_be_zero(
                    points in lattice::<$d>(1..5), directions in lattice::<$d>(0..5), free in any::<[bool; 5]>(),
                ) {
                    let weights: Vec<f64> =
                        free.iter().take(directions.len()).map(|f| f64::from(u8::from(!f))).collect();
                    check(&points, &directions, &weights, TIGHT)?;
                }

                #[test]
                fn scales(
                    points in real::<$d>(1..7), directions in real::<$d>($least..$most),
                    s in prop_oneof![Just(1e-200), Just(1e200), Just(1e-300), Just(1e300), Just(1e-3)],
                    t in prop_oneof![Just(1e-100), Just(1e100), Just(1.0)],
                ) {
                    let points: Vec<[f64; $d]> = points.iter().map(|p| p.map(|c| c * s)).collect();
                    let directions: Vec<[f64; $d]> = directions.iter().map(|p| p.map(|c| c * t)).collect();
                    let within = if s / t > 1e-290 { TIGHT } else { PROVEN };
                    check(&points, &directions, &WEIGHTS[..directions.len()], within)?;
                }

                #[test]
                fn thin_points_along_thin_directions(
                    points in real::<$d>(4..9), directions in real::<$d>($least..$most),
                    thickness in 2i32..10, scale in -140i32..141, length in -140i32..141,
                ) {
                    let points: Vec<[f64; $d]> = points.into_iter().map(|p| thin(p, scale, thickness)).collect();
                    let directions: Vec<[f64; $d]> =
                        directions.into_iter().map(|v| thin(v, length, thickness)).collect();
                    // the centre's rounding is as much larger as directions are nearer to a plane
                    let within = 1e-12 * 10f64.powi(thickness);
                    check(&points, &directions, &WEIGHTS[..directions.len()], within)?;
                }

                #[test]
                fn flat_spans(
                    basis in proptest::collection::vec(
                        proptest::array::uniform((-255i16..256).prop_map(f64::from)), 1..$d.max(2)
                    ),
                    points in proptest::collection::vec(
                        proptest::array::uniform::<_, 4>((-2i8..3).prop_map(f64::from)), 2..8
                    ),
                    others in proptest::collection::vec(
                        proptest::array::uniform::<_, 4>((-2i8..3).prop_map(f64::from)), 0..5
                    ),
                ) {
                    let combined = |factors: &[f64; 4], unit: f64| -> [f64; $d] {
                        std::array::from_fn(|c| basis.iter().zip(factors).map(|(b, f)| b[c] * f).sum::<f64>() * unit)
                    };
                    let points: Vec<[f64; $d]> = points.iter().map(|p| combined(p, 0.5)).collect();
                    let others = others.iter().map(|d| combined(d, 1.0));
                    let directions: Vec<[f64; $d]> = basis.iter().copied().chain(others).take(WEIGHTS.len()).collect();
                    // doubles in such a plane are that dense
                    check(&points, &directions, &WEIGHTS[..directions.len()], 1e-9)?;
                }

                #[test]
                fn the_smallest_doubles(
                    points in lattice::<$d>(1..7),
                    directions in lattice::<$d>($least..$most),
                    fine in 1i8..9,
                ) {
                    let tiny = |v: [f64; $d]| v.map(|c| c * f64::from(fine) * f64::from_bits(1));
                    let points: Vec<[f64; $d]> = points.into_iter().map(tiny).collect();
                    let directions: Vec<[f64; $d]> = directions.into_iter().map(tiny).collect();
                    check(&points, &directions, &WEIGHTS[..directions.len()], PROVEN)?;
                }

                #[test]
                fn all_scales_at_once(
                    points in lattice::<$d>(1..6), directions in lattice::<$d>($least..5),
                    s in proptest::collection::vec(prop_oneof![Just(1e-150), Just(1e150), Just(1e-9), Just(1.0)], 12),
                ) {
                    let points: Vec<[f64; $d]> = points.iter().zip(&s).map(|(p, s)| p.map(|c| c * s)).collect();
                    let directions: Vec<[f64; $d]> =
                        directions.iter().zip(&s[6..]).map(|(p, s)| p.map(|c| c * s)).collect();
                    check(&points, &directions, &WEIGHTS[..directions.len()], PROVEN)?;
                }
            }
        }
    )*};
}

dimensions! {
    on_the_line: 1, 1, 5;
    in_the_plane: 2, 2, 8;
    in_space: 3, 3, 7;
    in_four_dimensions: 4, 4, 7;
}

#[test]
fn flat_zonotopes_and_points_off_them_by_rounding() {
    let points = [[0.0, 3.0, -2.0, 3.0], [0.0, 2.0, 3.0, -3.0], [1.0, 1.0, 1.0, -2.0]];
    let directions = [[0.0, 0.0, 1.0, 0.0], [-1.0, 0.0, -1.0, 1.0], [3.0, 0.0, 0.0, 0.0], [0.0, 3.0, 1.0, 2.0]];
    check(&points, &directions, &[0.0, 1.0, 1.0, 1.0], TIGHT).expect("the three others hold a triangle");
    let points = [[3.0, -2.0, -2.0], [0.0, 0.0, 0.0], [3.0, 0.0, -2.0]];
    let directions = [[-3.0, 1.0, 2.0], [0.0, 0.0, 1.0], [3.0, 2.0, -2.0]];
    check(&points, &directions, &[1.0; 3], TIGHT).expect("two of the three hold a triangle");
}

#[test]
fn points_that_are_as_thin_as_three_directions() {
    let points = [
        [0.9341457239005668, 0.025167906384397032, 1.3747859149938301e-08],
        [1.9970515970534222, -0.2738072501638927, 1.9175085947669797e-07],
        [0.7136745205940151, -0.874496063276953, -5.6426516017966896e-08],
        [0.8490592924692077, 1.3183575815002477, 1.9842036839898916e-07],
        [2.8021655855115952, 0.07452587395378504, 6.313787402704028e-08],
        [1.4163946769729212, 0.18874687167921994, -1.9850642553384503e-08],
    ];
    let directions = [
        [-1.3787239772860895, 0.19461420318493317, 8.868033086691614e-08],
        [1.8579963071555796, 0.28591407333651225, 4.874695394707977e-08],
        [-1.244083564188005, -0.14846532690268097, -9.387504601832642e-09],
    ];
    for scale in [0, -460, 460] {
        let points = points.map(|p| p.map(|c| scale_by_power_of_two(c, scale)));
        check(&points, &directions, &[1.0; 3], 1e-8).expect("all of the points that need more are taken up");
    }
}

#[test]
fn points_and_directions_that_are_thin_in_four_dimensions() {
    /// The exponents of thickness, size and length, points and directions.
    type Case = ([i32; 3], [[f64; 4]; 4], [[f64; 4]; 6]);
    let cases: [Case; 2] = [
        (
            [9, 60, -53],
            [
                [-0.9617061012736785, 0.0, 0.0, 0.0],
                [0.0, 0.44932409429441217, 0.0, 0.0],
                [0.0; 4],
                [-0.5618209472682056, 0.0, 0.0, 0.7634551223976159],
            ],
            [
                [0.0, 0.0, 0.88701539864551, 0.4264472789262376],
                [0.0, 0.2374869152755511, 0.0, 0.0],
                [0.2667336067846877, 0.8434187035988162, -0.7106380606099085, -0.008650893043690884],
                [-0.8868339667531944, 0.7193584925105977, 0.7365907306504242, 0.3696659064424215],
                [0.7977212098695491, -0.9028907200491267, 0.45696846175254885, -0.0507800212790523],
                [0.2288089118719063, 0.7836240655714221, 0.28116208886355926, -0.6039326733577272],
            ],
        ),
        (
            [8, 0, 28],
            [
                [0.0, 0.0, 0.8015955404994288, -0.9788206507509588],
                [0.0, 0.3654809832234513, 0.0, 0.0],
                [0.0; 4],
                [-0.676104368935486, 0.0, 0.0, 0.0],
            ],
            [
                [0.0, -0.9455153733137016, -0.3765975132137236, 0.1493520593550751],
                [0.0, 0.0, 0.5702677658919166, 0.6866942736465546],
                [0.0, -0.8104812955261785, 0.0, 0.9759538987887951],
                [-0.003113616082664433, -0.45359238544827785, 0.0, -0.2854640820436294],
                [-0.3999517894428417, 0.0, 0.0473891568890672, 0.20869447493184157],
                [0.9508472772725004, 0.0, -0.64752749605557, 0.0],
            ],
        ),
    ];
    for ([thickness, scale, length], points, directions) in cases {
        let points = points.map(|p| thin(p, scale, thickness));
        let directions = directions.map(|v| thin(v, length, thickness));
        check(&points, &directions, &WEIGHTS[..6], 1e-12 * 10f64.powi(thickness)).expect("small programs are exact");
    }
}

#[test]
fn what_free_directions_reach_costs_nothing() {
    let points = [[1.0, 3.0, -3.0], [-3.0, -3.0, 3.0]];
    check(&points, &[[2.0, 3.0, -3.0], [-3.0, 0.0, -2.0]], &[0.0, 1.0], TIGHT).expect("the first one holds both");
}

#[test]
fn the_best_centre_of_a_flat_zonotope_that_is_one_of_doubles() {
    let [v, w] =
        [[-0.6244056684030526, -0.641404531519224, -0.02250086547469543], [0.5258612540742433, 0.641404531519224, 0.0]];
    let place = |a: f64, b: f64| std::array::from_fn(|c| a * v[c] + b * w[c]);
    let points = [(2.0, 0.5), (-1.0, 1.0), (-1.0, 0.0), (1.0, 1.0), (1.0, -1.0), (1.0, 0.0)].map(|(a, b)| place(a, b));
    check(&points, &[v, w], &[1.0; 2], TIGHT).expect("half the first direction is the centre");
}

#[test]
fn a_point_is_the_centre_where_no_other_doubles_are_in_the_span() {
    let points = [[0.2, 0.6000000000000001], [0.1, 0.30000000000000004], [0.2, 0.6000000000000001]];
    let problem = FixedDirections::new(&points, &points[1..2], &[1.0]).expect("valid");
    let answer = min_length_along(&problem, &mut ()).expect("in range");
    assert_eq!(answer.optimal().map(|answer| (answer.value, answer.lower_bound)), Some((1.0, 0.5)));
    assert!(check_min_length_dirs_at_any_gap(&problem, &answer).is_right());
    assert!(!check_min_length_dirs(&problem, &answer).is_right(), "the gap is wide");
}
