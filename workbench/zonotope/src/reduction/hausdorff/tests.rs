//! Bounds against the exact distance, on small bodies of every kind.

use super::brute_force::{squared_excess, squared_hausdorff};
use super::{Distance, excess, excess_with_limit, hausdorff};
use crate::numeric::Rational;
use crate::numeric::exact_linear::rational;
use crate::zonotope::Zonotope;
use proptest::prelude::*;

const WIDTH: f64 = 0.01;

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![(-3..=3i32).prop_map(f64::from), -1.0..1.0f64]
}

fn bodies<const D: usize>(most: usize) -> impl Strategy<Value = [Zonotope<D>; 2]> {
    let vector = || proptest::collection::vec(number(), D).prop_map(|v| -> [f64; D] { v.try_into().unwrap() });
    let body = move || (vector(), proptest::collection::vec(vector(), 0..most));
    (body(), body(), -1000..1000i32, any::<bool>()).prop_map(|((c, a), (d, b), exponent, same_center)| {
        let scale = crate::numeric::scaling::scale_by_power_of_two(1.0, i64::from(exponent));
        let scaled = |v: [f64; D]| v.map(|c| c * scale);
        let zonotope = |center, list: Vec<[f64; D]>| {
            Zonotope::new(scaled(center), list.into_iter().map(scaled).collect()).expect("the numbers are finite")
        };
        [zonotope(c, a), zonotope(if same_center { c } else { d }, b)]
    })
}

fn bounds<const D: usize>(distance: &Distance<D>, square: &Rational) -> Result<(), TestCaseError> {
    let squared = |v: f64| rational(v) * rational(v);
    prop_assert!(squared(distance.lower) <= *square, "{:?}, not {}", distance, square);
    prop_assert!(squared(distance.upper) >= *square, "{:?}, not {}", distance, square);
    let is_narrow = distance.upper <= (1.0 + WIDTH) * distance.lower;
    prop_assert!(is_narrow || *square == Rational::ZERO, "{:?}", distance);
    Ok(())
}

fn agrees<const D: usize>([a, b]: &[Zonotope<D>; 2]) -> Result<(), TestCaseError> {
    bounds(&hausdorff(a, b, WIDTH), &squared_hausdorff(a, b))?;
    let square = squared_excess(a, b);
    if square == Rational::ZERO {
        let distance = excess_with_limit(a, b, WIDTH, 1000);
        prop_assert_eq!(distance.lower, 0.0);
        return Ok(());
    }
    bounds(&excess(a, b, WIDTH), &square)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn bounds_agree_with_the_truth_on_a_line(pair in bodies::<1>(4)) {
        agrees(&pair)?;
    }

    #[test]
    fn bounds_agree_with_the_truth_in_the_plane(pair in bodies::<2>(4)) {
        agrees(&pair)?;
    }

    #[test]
    fn bounds_agree_with_the_truth_in_space(pair in bodies::<3>(4)) {
        agrees(&pair)?;
    }
}

#[test]
fn equal_bodies_have_no_distance() {
    let a = Zonotope::new([1.0, 2.0], vec![[1.0, 0.0], [0.5, 0.25], [0.0, 0.0]]).unwrap();
    let b = Zonotope::new([1.0, 2.0], vec![[-0.5, -0.25], [1.0, 0.0]]).unwrap();
    let distance = hausdorff(&a, &b, WIDTH);
    assert_eq!((distance.lower, distance.upper), (0.0, 0.0));
    let point = Zonotope::new([1.0, 2.0], Vec::new()).unwrap();
    // the farthest vertex is (3/2, 1/4) from the centre
    let exact = (1.5f64 * 1.5 + 0.25 * 0.25).sqrt();
    let distance = hausdorff(&a, &point, WIDTH);
    assert!(distance.lower <= exact && exact <= distance.upper && distance.upper <= 1.01 * distance.lower);
    let moved = Zonotope::new([4.0, 6.0], Vec::new()).unwrap();
    let distance = hausdorff(&point, &moved, WIDTH);
    assert!(distance.lower <= 5.0 && 5.0 <= distance.upper && distance.upper <= 1.01 * distance.lower);
}
