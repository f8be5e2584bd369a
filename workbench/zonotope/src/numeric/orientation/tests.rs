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
