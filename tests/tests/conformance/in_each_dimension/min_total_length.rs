//! Section 4.3: the proven ratios, and the optimum where another way to it exists.

use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use tests::runner::is_long;
use zonotope::enclosing::min_length;
use zonotope::enclosing::min_total_length::{
    Method, MinLengthError, MinLengthZonotope, Net, Outcome, by_direction_net, in_the_plane,
};
use zonotope::interop::verifier::check_min_length_all;
use zonotope::tally::{Operation, OperationCounts};

fn check<const D: usize>(points: &[[f64; D]], epsilon: f64) -> Result<MinLengthZonotope<D>, TestCaseError> {
    let answer = min_length(points, epsilon).expect("finite points");
    prop_assert!(answer.ratio() <= 1.0 + epsilon, "{} of {} {:?}", answer.ratio(), epsilon, answer.effort.progress);
    prop_assert_eq!(answer.proof.outcome, Outcome::WithinEpsilon);
    prop_assert!(answer.value <= answer.ratio() * answer.lower_bound || answer.value == 0.0);
    prop_assert!(answer.lower_bound <= answer.value);
    if points.len() * answer.body.generators().len() <= 60 {
        let verdict = check_min_length_all(points, epsilon, &answer);
        prop_assert!(verdict.is_right(), "{:?} {:?}", verdict, answer);
    }
    Ok(answer)
}

fn real<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform(-1.0..1.0f64), count)
}

fn lattice<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform((-2i8..3).prop_map(f64::from)), count)
}

tests::properties! {
    24;

    #[test]
    fn in_the_plane_the_optimum_is_a_quarter_of_a_perimeter(points in real::<2>(1..12)) {
        let answer = check(&points, 1e-9)?;
        let truth = in_the_plane::least_length(&points);
        prop_assert!((answer.value - truth).abs() <= 1e-8 * truth + 1e-12, "{} {truth}", answer.value);
    }

    #[test]
    fn lattices_of_the_plane(points in lattice::<2>(1..9)) {
        let answer = check(&points, 1e-9)?;
        let truth = in_the_plane::least_length(&points);
        prop_assert!((answer.value - truth).abs() <= 1e-8 * truth + 1e-12, "{} {truth}", answer.value);
    }

    #[test]
    fn space(points in real::<3>(1..7)) {
        check(&points, 1e-4)?;
    }

    #[test]
    fn lattices_of_space(points in lattice::<3>(1..7)) {
        check(&points, 1e-3)?;
    }

    #[test]
    fn nets_keep_their_ratio(points in real::<2>(1..12)) {
        let truth = in_the_plane::least_length(&points);
        for net in [Net::Paper, Net::Cells] {
            for epsilon in [0.5, 0.1, 0.03] {
                let answer = by_direction_net::min_length_by_net(&points, epsilon, net, &mut ());
                let answer = answer.expect("finite points");
                prop_assert!(answer.value <= (1.0 + epsilon) * truth + 1e-12);
                prop_assert!(answer.lower_bound <= truth * (1.0 + 1e-11));
            }
        }
    }

    #[test]
    fn the_vertices_of_a_box_give_the_box(half in [0.1..1.0f64, 0.1..1.0, 0.1..1.0]) {
        let corner =
            |i: usize| -> [f64; 3] { std::array::from_fn(|c| if i >> c & 1 == 0 { half[c] } else { -half[c] }) };
        let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
        let answer = check(&corners, 1e-7)?;
        let truth: f64 = half.iter().sum();
        prop_assert!((answer.value - truth).abs() <= 1e-7 * truth);
    }

    #[test]
    fn scales(points in real::<3>(2..5), s in prop_oneof![Just(1e-200), Just(1e200), Just(1e-30)]) {
        let points: Vec<[f64; 3]> = points.iter().map(|p| p.map(|c| c * s)).collect();
        check(&points, 1e-4)?;
    }
}

#[test]
fn four_dimensions_and_flat_sets() {
    let simplex: Vec<[f64; 4]> = (0..4).map(|i| std::array::from_fn(|c| f64::from(u8::from(i == c)))).collect();
    check(&simplex, 1e-3).expect("a flat simplex");
    let with_origin: Vec<[f64; 4]> = simplex.iter().copied().chain([[0.0; 4]]).collect();
    check(&with_origin, 1e-2).expect("a simplex");
    let segment = check(&[[0.0; 3], [3.0, 4.0, 0.0]], 1e-9).expect("a segment");
    assert!((segment.value - 2.5).abs() < 1e-14);
    let point = check(&[[0.5, 0.25]; 3], 1e-9).expect("a point");
    assert_eq!((point.value, point.ratio(), point.body.center()), (0.0, 1.0, [0.5, 0.25]));
}

#[test]
fn points_on_a_sphere_to_the_last_digits() {
    let mut rng = rand_pcg::Pcg64::seed_from_u64(4);
    let points: Vec<[f64; 3]> = (0..60)
        .map(|_| {
            let p: [f64; 3] = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
            let length = p.iter().map(|c| c * c).sum::<f64>().sqrt();
            p.map(|c| c / length)
        })
        .collect();
    let answer = min_length(&points, 1e-9).expect("finite");
    assert!(answer.ratio() <= 1.0 + 1e-9, "{}", answer.ratio());
    for [upper, lower] in answer.effort.progress {
        assert!(lower <= answer.value && upper >= answer.lower_bound);
    }
}

/// The 24 points with coordinates ±1, ±1, ±3 in any order.
fn truncated() -> Vec<[f64; 3]> {
    let signs = |p: [f64; 3]| (0..8).map(move |s| std::array::from_fn(|c| if s >> c & 1 == 0 { p[c] } else { -p[c] }));
    [[1.0, 1.0, 3.0], [1.0, 3.0, 1.0], [3.0, 1.0, 1.0]].into_iter().flat_map(signs).collect()
}

#[test]
fn needles_and_plates_to_the_last_digits() {
    for thin in [1e-5, 1e-7, 1e-9] {
        let needle: Vec<[f64; 3]> = truncated().iter().map(|p| [p[0] * thin, p[1] * thin, p[2]]).collect();
        check(&needle, 1e-9).expect("a needle");
        let plate: Vec<[f64; 3]> = truncated().iter().map(|p| [p[0], p[1] * thin, p[2]]).collect();
        check(&plate, 1e-9).expect("a plate");
    }
}

#[test]
fn points_near_each_other_to_the_last_digits() {
    let mut rng = rand_pcg::Pcg64::seed_from_u64(9);
    for near in [1e-3, 1e-6, 1e-8] {
        let mut points = truncated();
        for j in 0..6 {
            let other = points[j].map(|c| c + near * rng.random_range(-1.0..1.0));
            points.push(other);
        }
        check(&points, 1e-9).expect("a cloud with clusters");
    }
}

#[test]
fn points_that_are_nearly_equal_beside_the_others() {
    let half = f64::MAX / 4.0;
    let points = [
        [1.0, 0.0, -1e300, 0.0],
        [0.0, -1e300, -half, -1e300],
        [1e300, 0.0, -half, 0.0],
        [0.0, 1.0, -1e300, 0.0],
        [-1e300, 0.0, 1e300, half],
    ];
    check(&points, 1e-6).expect("all within range");
}

#[test]
fn a_best_center_on_the_edge_of_the_box() {
    // the hull of the points and their reflections in (0, -2): a rhombus with diagonals 4 and 2
    let answer = min_length(&[[-2.0, -2.0], [2.0, -2.0], [0.0, -1.0]], 1e-9).expect("finite");
    assert!((answer.value - 5f64.sqrt()).abs() < 1e-8 && answer.ratio() <= 1.0 + 1e-9, "{answer:?}");
}

#[test]
fn a_square_with_rounded_corners_is_its_own_zonogon() {
    // slopes on both sides of the centre are nearly parallel
    let one = 1.0f64.next_up();
    let square =
        [[one, 0.0], [6.123233995736767e-17, one], [-one, 1.2246467991473534e-16], [-1.83697019872103e-16, -one]];
    let answer = check(&square, 1e-9).expect("a square");
    assert!((answer.value - 2f64.sqrt()).abs() < 1e-9);
}

#[test]
fn what_is_refused() {
    assert_eq!(min_length::<2>(&[], 0.1), Err(MinLengthError::Empty));
    assert_eq!(min_length(&[[0.0]], 1.0), Err(MinLengthError::BadEpsilon(1.0)));
    assert!(matches!(min_length(&[[f64::NAN]], 0.1), Err(MinLengthError::NonFinite { .. })));
    let far = by_direction_net::min_length_by_net(&[[0.0; 3], [1.0; 3]], 1e-3, Net::Paper, &mut ());
    assert!(matches!(far, Err(MinLengthError::TooManyDirections(_))));
}

/// A grid of points on a torus, half of which are corners of its hull.
fn torus(around: usize, across: usize) -> Vec<[f64; 3]> {
    let turn = |i: usize, count: usize| libm::sincos(std::f64::consts::TAU * i as f64 / count as f64);
    let grid = (0..around).flat_map(|i| (0..across).map(move |j| (turn(i, around), turn(j, across))));
    grid.map(|((sin, cos), (up, out))| [(5.0 + out) * cos, (5.0 + out) * sin, up]).collect()
}

#[test]
fn a_net_around_many_corners_ends_within_its_work() {
    let points = torus(64, 32);
    let mut counts = OperationCounts::default();
    let answer = Method::DirectionNet.solve(&points, 0.01, &mut counts).expect("finite points");
    let read = counts.get(Operation::EntryRead);
    assert!(read < 9 << 28, "{read} entries of programs");
    // the work ends before the whole net is looked at, and the answer says so
    assert_eq!(answer.proof.outcome, Outcome::EndedBefore);
    assert!(answer.ratio() > 1.01 && answer.ratio() < 1.035, "{}", answer.ratio());
    assert!(answer.body.generators().len() < 200, "{}", answer.body.generators().len());
    let coarse = Method::DirectionNet.solve(&points, 0.2, &mut ()).expect("finite points");
    assert_eq!(coarse.proof.outcome, Outcome::WithinEpsilon);
}

/// The default method and the front door around a torus: the ratio 1.01 is proven after so many entries of programs
/// at most, by few generators, which contain every point as the verifier checks it.
fn torus_by_default(around: usize, across: usize, most_entries: u64, of_the_method: usize, in_the_end: usize) {
    let points = torus(around, across);
    let epsilon = 0.01;
    let mut counts = OperationCounts::default();
    let dense = Method::default().solve(&points, epsilon, &mut counts).expect("finite points");
    let read = counts.get(Operation::EntryRead);
    assert!(read > 0 && read < most_entries, "{around} x {across}: {read} entries of programs");
    let sparse = min_length(&points, epsilon).expect("finite points");
    for (answer, most) in [(&dense, of_the_method), (&sparse, in_the_end)] {
        assert_eq!(answer.proof.outcome == Outcome::WithinEpsilon, answer.ratio() <= 1.0 + epsilon);
        assert!(answer.ratio() <= 1.01, "{}", answer.ratio());
        assert!(answer.body.generators().len() <= most, "{} generators", answer.body.generators().len());
    }
    let verdict = check_min_length_all(&points, epsilon, &sparse);
    assert!(verdict.is_right(), "{verdict:?}");
}

#[test]
fn many_corners_take_few_generators_by_default() {
    torus_by_default(20, 10, 1 << 29, 250, 60);
}

#[test]
fn two_thousand_corners_take_few_generators_by_default() {
    if is_long() {
        torus_by_default(32, 16, 1 << 31, 250, 60);
        torus_by_default(64, 32, 1 << 33, 250, 60);
    }
}

#[test]
fn an_answer_that_is_not_near_enough_says_so() {
    // far from the origin no centre in doubles is as good as that of the least one
    let triangle = [[1e9, 0.0, 3.0], [1e9 + 1.0, 0.5, 3.0], [1e9, 1.0, 2.7]];
    let answer = min_length(&triangle, 1e-12).expect("finite");
    let mut within_more = answer.clone();
    within_more.proof.outcome = Outcome::WithinEpsilon;
    assert!(check_min_length_all(&triangle, 1e-4, &within_more).is_right());
    assert!(answer.ratio() > 1.0 + 1e-12 && answer.ratio() < 1.0 + 1e-5, "{}", answer.ratio());
    assert_eq!(answer.proof.outcome, Outcome::EndedBefore);
    let coarse = min_length(&triangle, 1e-4).expect("finite");
    assert_eq!(coarse.proof.outcome, Outcome::WithinEpsilon);
}

#[test]
fn where_no_bound_is_a_double_the_ratio_is_infinite() {
    // half the least positive double rounds down to none
    let points = [[0.0], [f64::from_bits(1)]];
    let answer = min_length(&points, 1e-9).expect("finite");
    assert_eq!((answer.lower_bound, answer.ratio()), (0.0, f64::INFINITY));
    assert!(check_min_length_all(&points, 1e-9, &answer).is_right());
}
