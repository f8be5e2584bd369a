//! Bounds against the exact distance, on small bodies of every kind.

use std::array;

use super::brute_force::{squared_excess, squared_hausdorff};
use super::by_branch_and_bound::{Limit, bounded};
use super::by_vertices::{excess_at_vertices, hausdorff_at_vertices};
use super::exact_difference::ExactDifference;
use super::{Distance, excess, hausdorff};
use crate::numeric::Rational;
use crate::numeric::exact_linear::root::Root;
use crate::numeric::exact_linear::{dot, rational};
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

/// The nearest double and the least one not below the distance; of the lower bound, that the direction proves it.
fn is_exact<const D: usize>(
    distance: Option<Distance<D>>,
    square: &Rational,
    [a, b]: [&Zonotope<D>; 2],
) -> Result<(), TestCaseError> {
    let distance = distance.expect("the bodies have few vertices");
    let exact = Root::of(square, 0);
    prop_assert_eq!((distance.value, distance.upper), (exact.nearest, exact.above));
    let u = distance.direction.map(rational);
    let reach = |body: &Zonotope<D>| {
        let products = body.generators().iter().map(|g| dot(&g.map(rational), &u));
        products
            .fold(Rational::ZERO, |sum, product| if product < Rational::ZERO { sum - product } else { sum + product })
    };
    let magnitude = |value: Rational| if value < Rational::ZERO { -value } else { value };
    let moved = magnitude(dot(&a.center().map(rational), &u) - dot(&b.center().map(rational), &u));
    let along = magnitude(reach(a) - reach(b)) + moved;
    let claimed = rational(distance.lower);
    prop_assert!(&claimed * &claimed * dot(&u, &u) <= &along * &along, "{:?}", distance);
    prop_assert!(rational(distance.lower) * rational(distance.lower) <= *square);
    Ok(())
}

/// Of bodies that are not nearly equal the lower bound is within some units in the last place.
fn is_tight<const D: usize>(distance: Option<Distance<D>>) -> Result<(), TestCaseError> {
    let distance = distance.expect("the bodies have few vertices");
    prop_assert!(distance.lower >= distance.value * (1.0 - 1e-12), "{:?}", distance);
    Ok(())
}

fn agrees<const D: usize>([a, b]: &[Zonotope<D>; 2]) -> Result<(), TestCaseError> {
    let difference = ExactDifference::new(a, b);
    let (both, one) = (squared_hausdorff(a, b), squared_excess(a, b));
    is_exact(hausdorff_at_vertices(a, b), &both, [a, b])?;
    is_exact(excess_at_vertices(a, b), &one, [a, b])?;
    is_tight(hausdorff_at_vertices(a, b))?;
    bounds(&bounded(&difference, &[0, 1], WIDTH, Limit::ANSWER), &both)?;
    if one == Rational::ZERO {
        prop_assert_eq!(bounded(&difference, &[0], WIDTH, Limit::COMPARISON).lower, 0.0);
        return Ok(());
    }
    bounds(&bounded(&difference, &[0], WIDTH, Limit::ANSWER), &one)
}

properties! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn bounds_agree_with_the_truth_in_the_plane(pair in bodies::<2>(4)) {
        agrees(&pair)?;
    }

    #[test]
    fn bounds_agree_with_the_truth_in_space(pair in bodies::<3>(4)) {
        agrees(&pair)?;
    }
}

properties! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn bodies_an_ulp_apart_are_told_apart(
        pair in bodies::<3>(4),
        factors in proptest::collection::vec(any::<bool>(), 4),
    ) {
        let [a, _] = pair;
        let moved = a.generators().iter().zip(factors).map(|(g, up)| g.map(|c| if up { c.next_up() } else { c }));
        let b = Zonotope::new(a.center(), moved.collect()).expect("the numbers stay finite");
        is_exact(hausdorff_at_vertices(&a, &b), &squared_hausdorff(&a, &b), [&a, &b])?;
    }
}

fn body<const D: usize>(center: [f64; D], generators: &[[f64; D]]) -> Zonotope<D> {
    Zonotope::new(center, generators.to_vec()).expect("the numbers are finite")
}

fn three_bounds<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>) -> [f64; 3] {
    let distance = hausdorff(a, b, WIDTH);
    [distance.lower, distance.value, distance.upper]
}

#[test]
fn distances_that_are_doubles_are_met_exactly() {
    // the interval from 1 to 2 reaches 1 farther than its end
    assert_eq!(three_bounds(&body([1.0], &[]), &body([1.5], &[[0.5]])), [1.0; 3]);
    assert_eq!(three_bounds(&body([0.0; 3], &[]), &body([1.0, 2.0, 2.0], &[])), [3.0; 3]);
    let least = f64::from_bits(1);
    assert_eq!(three_bounds(&body([0.0, 0.0], &[]), &body([0.0, least], &[])), [least; 3]);
    let huge = body([0.0], &[[f64::MAX]]);
    assert_eq!(three_bounds(&huge, &body([0.0], &[])), [f64::MAX; 3]);
    assert_eq!(three_bounds(&huge, &body([0.0], &[[f64::MAX], [-1.0]])), [1.0; 3]);
    assert_eq!(three_bounds(&body([f64::MAX], &[]), &body([-f64::MAX], &[])), [f64::MAX, f64::INFINITY, f64::INFINITY]);
}

#[test]
fn cubes_an_ulp_apart_differ_by_the_diagonal_of_the_ulp() {
    let cube = |side: f64| body([0.0; 3], &[[side, 0.0, 0.0], [0.0, side, 0.0], [0.0, 0.0, side]]);
    let [lower, value, upper] = three_bounds(&cube(1.0), &cube(1.0f64.next_up()));
    let exact = f64::EPSILON * 3f64.sqrt();
    assert_eq!([lower, value, upper], [exact, exact, exact.next_up()]);
}

#[test]
fn nearly_equal_bodies_of_parallel_generators_take_no_search() {
    // all generators are parallel to those of the other body: (2, −2, 0) and (2, −2, 2) differ in their lengths alone
    let a = body([0.0; 3], &[[-2.0, 2.0, -2.0], [-1.0, 1.0, 0.0], [1.0, -1.0, 0.0]]);
    let b = a.generators().iter().map(|g| g.map(|c| c * 1.0f64.next_down())).collect();
    let b = Zonotope::new([0.0; 3], b).expect("finite");
    let ulp = f64::EPSILON / 2.0;
    // the farthest vertex of the two differences is ulp (4, −4, 2) away
    assert_eq!(three_bounds(&a, &b), [6.0 * ulp; 3]);
}

#[test]
fn equal_bodies_have_no_distance() {
    let a = body([1.0, 2.0], &[[1.0, 0.0], [0.5, 0.25], [0.0, 0.0]]);
    assert_eq!(three_bounds(&a, &body([1.0, 2.0], &[[-0.5, -0.25], [1.0, 0.0]])), [0.0; 3]);
    // the farthest vertex is (3/2, 1/4) from the centre
    let exact = (1.5f64 * 1.5 + 0.25 * 0.25).sqrt();
    assert_eq!(three_bounds(&a, &body([1.0, 2.0], &[]))[1], exact);
    assert_eq!(three_bounds(&body([1.0, 2.0], &[]), &body([4.0, 6.0], &[])), [5.0; 3]);
}

#[test]
fn a_width_of_0_ends() {
    let many = |shift: f64| -> Zonotope<3> {
        let generator = |i: i32| {
            let t = f64::from(i) + shift;
            [libm::sin(t * 0.7), libm::cos(t * 1.3), libm::sin(t * 0.37)]
        };
        Zonotope::new([0.0; 3], (0..60).map(generator).collect()).expect("finite")
    };
    let (a, b) = (many(0.0), many(0.25));
    assert!(hausdorff_at_vertices(&a, &b).is_none(), "there are thousands of vertices");
    let (narrow, wide) = (hausdorff(&a, &b, 0.0), hausdorff(&a, &b, WIDTH));
    assert!(narrow.lower <= wide.upper && wide.lower <= narrow.upper && narrow.upper.is_finite());
    assert!(excess(&a, &b, 0.0).upper <= narrow.upper * (1.0 + WIDTH));
}

/// Generators whose lengths spread over some orders of magnitude, and the same times 1 + 2^-52.
fn scaled_by_an_ulp<const D: usize>(count: usize, orders: f64) -> [Zonotope<D>; 2] {
    let generator = |i: usize| -> [f64; D] {
        let length = libm::pow(10.0, orders * i as f64 / count as f64);
        array::from_fn(|k| length * libm::sin((i * (2 * k + 3) + 7 * k) as f64 * 0.7))
    };
    let generators: Vec<[f64; D]> = (0..count).map(generator).collect();
    let longer = generators.iter().map(|g| g.map(|c| c * (1.0 + f64::EPSILON))).collect();
    [generators, longer].map(|list| Zonotope::new([0.0; D], list).expect("finite"))
}

fn is_about_what_the_generators_differ_by<const D: usize>([a, b]: [Zonotope<D>; 2]) {
    let far = |g: &[f64; D], h: &[f64; D]| g.iter().zip(h).map(|(g, h)| (g - h) * (g - h)).sum::<f64>().sqrt();
    let sum: f64 = a.generators().iter().zip(b.generators()).map(|(g, h)| far(g, h)).sum();
    let distance = hausdorff(&a, &b, WIDTH);
    assert!(distance.upper <= sum * (1.0 + WIDTH), "{distance:?} {sum}");
    assert!(distance.lower >= distance.upper / 2.0, "{distance:?} {sum}");
}

#[test]
fn nearly_equal_bodies_of_many_generators_are_as_near_as_their_generators() {
    for orders in [0.0, 9.0, 18.0] {
        is_about_what_the_generators_differ_by(scaled_by_an_ulp::<2>(120, orders));
        is_about_what_the_generators_differ_by(scaled_by_an_ulp::<3>(40, orders));
        is_about_what_the_generators_differ_by(scaled_by_an_ulp::<3>(300, orders));
    }
}

#[test]
fn bodies_of_some_hundred_edges_have_their_distance() {
    let wheel = |count: usize, shift: f64| -> Zonotope<2> {
        let generator = |i: usize| {
            let t = i as f64 * 0.61 + shift;
            [libm::sin(t * 1.7) * (1.0 + libm::cos(t)), libm::cos(t * 2.3)]
        };
        Zonotope::new([0.0; 2], (0..count).map(generator).collect()).expect("finite")
    };
    for shift in [0.1, 0.2, 0.3, 0.4, 0.5] {
        let distance = hausdorff_at_vertices(&wheel(50, 0.0), &wheel(50, shift)).expect("there are few vertices");
        assert!(distance.upper <= distance.value.next_up(), "{distance:?}");
    }
}
