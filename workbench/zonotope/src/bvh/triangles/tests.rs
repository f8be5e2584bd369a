//! The methods against the linear program, in all special positions.

use proptest::prelude::*;

use super::plane::Corners;
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

/// Whether the plane of one triangle is proved to have the other one beside it.
fn one_has_the_other_beside(a: [[f64; 3]; 3], b: [[f64; 3]; 3], error: f64) -> bool {
    let [a, b] = [a, b].map(|values| Corners { values, error }.with_plane());
    a.has_beside(&b.corners) || b.has_beside(&a.corners)
}

/// Of triangles that are somewhat apart most are told apart by a plane of theirs.
#[test]
fn a_plane_of_one_of_two_triangles_mostly_separates_them() {
    let corner = |seed: f64| [libm::sin(seed), libm::sin(1.7 * seed), libm::sin(2.9 * seed)];
    let triangle = |seed: f64, away: f64| {
        [0.0, 1.0, 2.0].map(|k| {
            let [x, y, z] = corner(seed + k);
            [x + away, y, z]
        })
    };
    let separated =
        |i: &i32| one_has_the_other_beside(triangle(f64::from(*i), 0.0), triangle(-f64::from(*i), 1.5), 1e-14);
    let count = (0..200).filter(separated).count();
    assert!(count > 100, "{count} of 200");
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
        prop_assert!(!(truth && one_has_the_other_beside(a, b, 0.0)));
    }

    /// Corners that are off by an error are proved to lie beside a plane only if the corners that they stand for do.
    #[test]
    fn triangles_beside_a_plane_do_not_meet(
        a in triangle(),
        b in triangle(),
        off in proptest::array::uniform6(proptest::array::uniform3(-1.0..1.0f64)),
        places in 1..40i32,
    ) {
        let truth = brute_force::meet(&a.map(exact), &b.map(exact));
        let error = 2f64.powi(-places);
        let moved = |t: [[f64; 3]; 3], from: usize| -> [[f64; 3]; 3] {
            // the sum is rounded, by less than the part of the error that is left
            std::array::from_fn(|i| std::array::from_fn(|k| t[i][k] + 0.99 * error * off[from + i][k]))
        };
        prop_assert!(!(truth && one_has_the_other_beside(moved(a, 0), moved(b, 3), error)));
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
