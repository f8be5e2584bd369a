//! The methods against the linear program, in all special positions.

use proptest::prelude::*;

use super::{brute_force, by_planes, by_separating_planes, meet_exactly};
use crate::numeric::bounded;
use crate::numeric::exact_linear::exact;

/// Corners on a small grid, at a size from the least to the largest doubles.
fn triangle() -> impl Strategy<Value = [[f64; 3]; 3]> {
    proptest::array::uniform3(proptest::array::uniform3((-2i32..3).prop_map(f64::from)))
}

fn size() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(1.0), 1 => Just(1e300), 1 => Just(1e-300), 1 => Just(5e-324), 1 => 0.1..1.0f64]
}

properties! {
    #![proptest_config(crate::property_cases::config(6_000))]

    #[test]
    fn all_methods_agree_in_special_positions(a in triangle(), b in triangle(), size in size(), other in size()) {
        let (a, b) = (a.map(|p| p.map(|c| size * c)), b.map(|p| p.map(|c| other * c)));
        let [exact_a, exact_b] = [a.map(exact), b.map(exact)];
        let truth = brute_force::meet(&exact_a, &exact_b);
        prop_assert_eq!(by_separating_planes::meet(&exact_a, &exact_b), truth);
        prop_assert_eq!(meet_exactly(&exact_a, &exact_b), truth);
        prop_assert_eq!(meet_exactly(&exact_b, &exact_a), truth);
        let rounded = by_planes::meet(&a.map(bounded::exact), &b.map(bounded::exact));
        prop_assert!(rounded.is_none_or(|rounded| rounded == truth));
    }

    #[test]
    fn all_methods_agree_in_general_position(
        a in proptest::array::uniform3(proptest::array::uniform3(-1.0..1.0f64)),
        b in proptest::array::uniform3(proptest::array::uniform3(-1.0..1.0f64)),
    ) {
        let [exact_a, exact_b] = [a.map(exact), b.map(exact)];
        let truth = brute_force::meet(&exact_a, &exact_b);
        prop_assert_eq!(by_separating_planes::meet(&exact_a, &exact_b), truth);
        prop_assert_eq!(by_planes::meet(&a.map(bounded::exact), &b.map(bounded::exact)), Some(truth));
    }
}
