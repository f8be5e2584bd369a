use dashu_ratio::RBig;
use families::drawn::numbers::nudged;
use proptest::prelude::*;

use super::*;
use crate::tally::OperationCounts;

/// The truth, in rationals.
fn rational_cross_sign([a, b, c, d]: [[f64; 2]; 4]) -> Turn {
    let exact = |value: f64| RBig::try_from(value).expect("tests use finite coordinates");
    let edge = |from: [f64; 2], to: [f64; 2]| [0, 1].map(|axis| exact(to[axis]) - exact(from[axis]));
    let ([x1, y1], [x2, y2]) = (edge(a, b), edge(c, d));
    Turn::from((x1 * y2).cmp(&(y1 * x2)))
}

fn assert_agrees(points: [[f64; 2]; 4]) {
    let [a, b, c, d] = points;
    let truth = rational_cross_sign(points);
    assert_eq!(cross_sign(a, b, c, d), truth, "filtered, {points:?}");
    assert_eq!(exact_cross_sign(a, b, c, d), truth, "expansions or integers, {points:?}");
    assert_eq!(dyadic_cross_sign(a, b, c, d), truth, "integers, {points:?}");
    assert_eq!(orientation(a, b, c), rational_cross_sign([a, b, a, c]), "filtered, {points:?}");
    assert_eq!(exact_cross_sign(a, b, a, c), rational_cross_sign([a, b, a, c]), "exact, {points:?}");
}

/// Any finite double, all exponents alike.
fn any_finite() -> impl Strategy<Value = f64> + Clone {
    any::<u64>()
        .prop_map(f64::from_bits as fn(u64) -> f64)
        .prop_filter("finite", (|value| value.is_finite()) as fn(&f64) -> bool)
}

/// Values whose differences and products meet the limits of the double range.
fn extreme() -> impl Strategy<Value = f64> + Clone {
    prop::sample::select(vec![
        0.0,
        -0.0,
        1.0,
        -1.0,
        5e-324,
        -5e-324,
        1.5e-323,
        f64::MIN_POSITIVE,
        -f64::MIN_POSITIVE,
        f64::MAX,
        f64::MIN,
        f64::MAX / 2.0,
        1e300,
        -1e300,
        1e-300,
        1e154,
        -1e-162,
        1.0 + f64::EPSILON,
    ])
}

fn points_of<S: Strategy<Value = f64> + Clone>(coordinate: S) -> impl Strategy<Value = [[f64; 2]; 4]> {
    let point = [coordinate.clone(), coordinate];
    prop::array::uniform4(point)
}

/// Four points within a few ulps of one line, at a scale of 2^exponent.
fn nearly_collinear() -> impl Strategy<Value = [[f64; 2]; 4]> {
    let point = (-8_i32..=8, -3_i64..=3, -3_i64..=3);
    let direction = [-1.0..1.0, -1.0..1.0];
    let exponent = prop::sample::select(vec![-1060, -1000, -600, -400, -30, 0, 30, 470, 480, 500, 1000]);
    (direction.clone(), direction, prop::array::uniform4(point), exponent).prop_map(
        |(origin, direction, steps, exponent)| {
            let scale = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
            steps.map(|(along, x_steps, y_steps)| {
                let at = |axis: usize| (origin[axis] + f64::from(along) * direction[axis]) * scale;
                [nudged(at(0), x_steps), nudged(at(1), y_steps)]
            })
        },
    )
}

properties! {
    #![proptest_config(crate::property_cases::config(2000))]

    #[test]
    fn agrees_on_any_finite_doubles(points in points_of(any_finite())) {
        assert_agrees(points);
    }

    #[test]
    fn agrees_at_the_limits_of_the_range(points in points_of(extreme())) {
        assert_agrees(points);
    }

    #[test]
    fn agrees_on_small_integers_at_every_scale(
        points in prop::array::uniform4([-4_i32..=4, -4_i32..=4]),
        exponent in -1074_i32..=1020,
    ) {
        let scale = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
        assert_agrees(points.map(|point| point.map(|value| f64::from(value) * scale)));
    }

    #[test]
    fn agrees_on_nearly_collinear_points(points in nearly_collinear()) {
        assert_agrees(points);
    }

    #[test]
    fn agrees_when_one_coordinate_is_of_another_magnitude(
        points in nearly_collinear(),
        which in 0_usize..8,
        value in any_finite(),
    ) {
        let mut points = points;
        points[which / 2][which % 2] = value;
        assert_agrees(points);
    }
}

#[test]
fn products_that_underflow_do_not_pass_the_filter() {
    let smallest = 5e-324;
    let (a, b) = ([-2.4627167275439808e-17, 0.0], [1.75, 45.0 * smallest]);
    let (c, d) = ([-6.645363818503043e-17, 0.0], [1.011111111111111, 26.0 * smallest]);
    // in doubles the products are 46 and 45 smallest units, the exact ones are 45.5 to within 10^-14, in the other
    // order
    assert!((b[0] - a[0]) * d[1] > b[1] * (d[0] - c[0]));
    assert_eq!(cross_sign(a, b, c, d), Turn::Right);
    assert_eq!(cross_sign(c, d, a, b), Turn::Left);
}

#[test]
fn differences_that_overflow_are_decided() {
    let (low, high) = ([f64::MIN, f64::MIN], [f64::MAX, f64::MAX]);
    assert_eq!(orientation(low, high, [0.0, 0.0]), Turn::Straight);
    assert_eq!(orientation(low, high, [0.0, 5e-324]), Turn::Left);
    assert_eq!(orientation(low, high, [5e-324, 0.0]), Turn::Right);
}

#[test]
fn exact_fallbacks_are_counted() {
    let mut counts = OperationCounts::default();
    orientation_counted([0.0, 0.0], [1.0, 0.0], [0.0, 1.0], &mut counts);
    orientation_counted([0.0, 0.0], [1.0, 1.0], [2.0, 2.0], &mut counts);
    assert_eq!((counts.get(Operation::Turn), counts.get(Operation::ExactFallback)), (2, 1));
}

#[test]
fn products_that_overflow_only_when_split_are_decided() {
    assert_agrees([
        [1.8788684799150824e150, -4.945124973992828e150],
        [-1390837868567.5408, -2.360618843321091e149],
        [-8.738336637278723e149, -3.061499738128541e150],
        [-8.738336637278712e149, -3.0614997381285394e150],
    ]);
}

#[test]
fn turns_are_signs_and_are_reversed_by_a_reflection() {
    let turns = [Turn::Right, Turn::Straight, Turn::Left];
    assert_eq!(turns.map(Turn::sign), [Ordering::Less, Ordering::Equal, Ordering::Greater]);
    assert_eq!(turns.map(|turn| Turn::from(turn.sign())), turns);
    assert_eq!(turns.map(Turn::reverse), [Turn::Left, Turn::Straight, Turn::Right]);
}

/// Points a few units in the last place from the diagonal, seen against two points of it far away.
#[test]
fn points_beside_the_diagonal_are_on_their_side_at_every_size() {
    for size in [-300, -40, 0, 40, 300].map(|exponent| 2f64.powi(exponent)) {
        let [b, c] = [12.1, 24.3].map(|t| [t * size; 2]);
        let mut turned = 0;
        for (x, y) in (0..48).flat_map(|x| (0..48).map(move |y| (x, y))) {
            let a = [x, y].map(|steps| (0.5 + f64::from(steps) * UNIT) * size);
            let truth = Turn::from(y.cmp(&x));
            assert_eq!(orientation(a, b, c), truth, "{x}, {y}");
            let rounded = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            turned += usize::from(rounded != 0.0 && Turn::from_sign_of(rounded) != truth);
        }
        assert!(turned > 100, "doubles alone tell {turned} wrong sides");
    }
}

#[test]
fn what_an_edge_leaves_behind_its_doubles_decides_a_tie_of_these() {
    let (a, b) = ([2f64.powi(-60), 0.0], [1.0, 1.0]);
    let (c, d) = ([0.0, 0.0], [1.0, 1.0]);
    assert_eq!((cross_sign(a, b, c, d), cross_sign(c, d, a, b)), (Turn::Right, Turn::Left));
}

#[test]
fn a_scale_is_found_where_sizes_differ_by_less_than_the_range_of_expansions() {
    let power = |exponent: i32| 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2);
    let range = power(LOWEST_EXPONENT)..power(HIGHEST_EXPONENT);
    let spans = [0, 1, 2, 30, 500, 878, 879, 880, 881, 1500];
    for low in [-1074, -1022, -1000, -880, -402, -401, -400, -399, -200, -1, 0, 100, 479, 480, 481, 900, 1023] {
        for high in spans.map(|span| low + span).into_iter().filter(|high| *high < 1024) {
            let points = [[power(low), -power(high)], [0.0, 0.0], [-power(low), 0.0], [0.0, power(high)]];
            let scale = exact_scale(&points);
            assert_eq!(scale.is_some(), high - low < 880, "2^{low} and 2^{high}");
            if let Some(scale) = scale {
                let scaled = [low, high].map(|exponent| power(exponent) * scale);
                assert!(scaled.iter().all(|size| range.contains(size)), "2^{low} and 2^{high}");
                assert!(scale == 1.0 || !(range.contains(&power(low)) && range.contains(&power(high))));
            }
        }
    }
    assert_eq!(exact_scale(&[[0.0; 2]; 4]), Some(1.0));
}

#[test]
fn edges_are_equal_or_opposite_to_their_translates_and_reflections_alone() {
    let edge = ExactEdge::new([1.0, 2f64.powi(-60)], [4.0, 7.0]);
    let is_parallel = |from, to| edge.is_equal_or_opposite_to(&ExactEdge::new(from, to));
    assert!(is_parallel([1.0, 2f64.powi(-60)], [4.0, 7.0]) && is_parallel([4.0, 7.0], [1.0, 2f64.powi(-60)]));
    assert!(is_parallel([0.0, -2f64.powi(-60)], [-3.0, -7.0]) && is_parallel([-3.0, -7.0], [0.0, -2f64.powi(-60)]));
    assert!(!is_parallel([1.0, 0.0], [4.0, 7.0]) && !is_parallel([4.0, 7.0], [1.0, 0.0]));
    assert!(!is_parallel([0.0, 0.0], [-3.0, 7.0]) && !is_parallel([0.0, 0.0], [3.0, -7.0]));
}
