//! Penetration depths beside the twin, and by hand.

use proptest::prelude::*;

use super::*;
use crate::collision::Query;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{cross, dot};
use crate::tally::{Operation, OperationCounts};
use by_inner_polytope::ACCURACY;

fn holds<const D: usize>(depth: &Penetration<D>, squared: &Rational) -> bool {
    let square = |v: f64| Dyadic::from_f64(v).to_rational() * Dyadic::from_f64(v).to_rational();
    square(depth.lower) <= *squared && (depth.upper == f64::INFINITY || *squared <= square(depth.upper))
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0f64,
        4 => (-2i32..3).prop_map(f64::from),
        1 => prop::sample::select(vec![1e-9, -1e-9, 1e-20, 1e20, 1e150, 1e-150, 5e-324, 1e300]),
    ]
}

fn check(query: &Query<'_, 3>) -> Result<(), TestCaseError> {
    let truth = brute_force::squared_depth(query).unwrap_or(Rational::ZERO);
    let exact = by_facet_normals::penetration(query);
    prop_assert!(holds(&exact, &truth), "{:?}", exact);
    let depth = by_inner_polytope::penetration(query, &mut ());
    prop_assert!(holds(&depth, &truth), "{:?} {:?}", depth, exact);
    let is_subnormal = exact.upper < 1e-300;
    prop_assert!(depth.is_within(ACCURACY) || is_subnormal, "{:?}", depth);
    Ok(())
}

/// A point of the zonotope that is not on the boundary unless rounding or a flat body puts it there.
fn inner_point<const D: usize>(generators: &[[f64; D]], coefficients: &[f64]) -> [f64; D] {
    let terms = generators.iter().zip(coefficients);
    terms.fold([0.0; D], |sum, (g, c)| std::array::from_fn(|k| sum[k] + 0.75 * c * g[k]))
}

properties! {
    #![proptest_config(crate::property_cases::config(300))]

    #[test]
    fn depths_are_those_of_the_twin(
        generators in proptest::collection::vec([coordinate(), coordinate(), coordinate()], 0..12),
        coefficients in proptest::collection::vec(prop_oneof![4 => -1.0..1.0f64, 1 => Just(0.0)], 12),
    ) {
        let inner = inner_point(&generators, &coefficients);
        check(&Query::new([0.0; 3], inner, &generators).expect("finite"))?;
    }

    /// Points just below facets, their edges and their corners.
    #[test]
    fn depths_near_contact_are_those_of_the_twin(
        generators in proptest::collection::vec(proptest::array::uniform3(-1.0..1.0f64), 3..14),
        own in proptest::array::uniform2(prop_oneof![2 => -1.0..1.0f64, 1 => Just(1.0), 1 => Just(-1.0)]),
        gap in prop::sample::select(vec![1e-2, 1e-6, 1e-9, 1e-12]),
    ) {
        let normal = cross(&generators[0], &generators[1]);
        let end = |c: f64, v: &[f64; 3], sum: [f64; 3]| [0, 1, 2].map(|k| sum[k] + c * v[k]);
        let facet = end(own[1], &generators[1], end(own[0], &generators[0], [0.0; 3]));
        let point = generators[2..].iter().fold(facet, |sum, v| end(1f64.copysign(dot(v, &normal)), v, sum));
        check(&Query::new([0.0; 3], point.map(|c| (1.0 - gap) * c), &generators).expect("finite"))?;
    }

    #[test]
    fn depths_of_boxes_are_those_of_the_twin(
        sides in proptest::array::uniform6(0.1..2.0f64),
        matrix in proptest::array::uniform3(proptest::array::uniform3(-1.0..1.0f64)),
        to in proptest::array::uniform3(-1.0..1.0f64),
    ) {
        let axis = |k: usize| std::array::from_fn(|i| if i == k { sides[k] } else { 0.0 });
        let turned = |k: usize| matrix[k].map(|c| c * sides[3 + k]);
        let generators: Vec<[f64; 3]> = (0..3).map(axis).chain((0..3).map(turned)).collect();
        check(&Query::new([0.0; 3], to, &generators).expect("finite"))?;
    }

    #[test]
    fn depths_in_the_plane_are_those_of_the_twin(
        generators in proptest::collection::vec([coordinate(), coordinate()], 0..8),
        coefficients in proptest::collection::vec(-1.0..1.0f64, 8),
    ) {
        let inner = inner_point(&generators, &coefficients);
        let query = Query::new([0.0; 2], inner, &generators).expect("finite");
        let truth = brute_force::squared_depth(&query).unwrap_or(Rational::ZERO);
        for depth in [by_facet_normals::penetration(&query), by_sides::penetration(&query)] {
            prop_assert!(holds(&depth, &truth), "{:?}", depth);
            prop_assert_eq!(depth.upper == 0.0, truth == Rational::ZERO);
        }
    }
}

/// Bodies like balls, around their centres: the depth is nearly the same in all directions.
#[test]
fn balls_need_cells_everywhere() {
    let mut state = 7u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    for count in [20, 60, 100] {
        let generators: Vec<[f64; 3]> = (0..count).map(|_| [unit(), unit(), unit()]).collect();
        for to in [[0.0; 3], [0.1 * count as f64, 0.0, 0.0]] {
            let query = Query::new([0.0; 3], to, &generators).expect("finite");
            let depth = by_inner_polytope::penetration(&query, &mut ());
            let exact = by_facet_normals::penetration(&query);
            assert!(depth.is_within(ACCURACY) && depth.lower <= exact.upper && exact.lower <= depth.upper, "{depth:?}");
        }
    }
}

#[test]
fn needles_and_plates() {
    // half-lengths 1, 2^-30 and 2^-60: the depth of the centre is the least
    let sizes = [1.0, f64::EPSILON.sqrt(), f64::EPSILON * 2.0f64.powi(-8)];
    let turned = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
    let generators: Vec<[f64; 3]> = turned.iter().zip(sizes).map(|(v, s)| v.map(|c| c * s)).collect();
    let depth = by_inner_polytope::penetration(&Query::new([0.0; 3], [0.0; 3], &generators).expect("finite"), &mut ());
    assert!(depth.lower <= sizes[2] && sizes[2] <= depth.upper && depth.is_within(ACCURACY), "{depth:?}");
    assert_eq!(depth.direction.map(f64::abs), [0.0, 0.0, 1.0]);
}

/// The smallest doubles have no places, in which a search would go on without coming nearer; the depth of a needle is
/// far below all doubles in units of its length.
#[test]
fn bodies_of_the_smallest_doubles_and_needles_take_few_steps() {
    let tiny = f64::from_bits(1);
    let smallest =
        [[-8.0, -2.0, 3.0], [-2.0, 8.0, 2.0], [-6.0, 8.0, 8.0], [-8.0, -3.0, -4.0]].map(|g| g.map(|c| c * tiny));
    let needle = |thin: f64, long: f64| [[long, 0.0, 0.0], [0.0, thin, 0.0], [long, thin, 2.0 * thin]];
    let bodies: [&[[f64; 3]]; 5] =
        [&smallest, &needle(1e-300, 1.0), &needle(1e-160, 1e160), &needle(3.0 * tiny, 1e300), &needle(tiny, 1e-200)];
    for generators in bodies {
        let query = Query::new([0.0; 3], [0.0; 3], generators).expect("finite");
        let mut counts = OperationCounts::default();
        let depth = by_inner_polytope::penetration(&query, &mut counts);
        let truth = brute_force::squared_depth(&query).expect("the centre is inside");
        assert!(holds(&depth, &truth), "{generators:?} {depth:?}");
        assert!(counts.get(Operation::SearchStep) < 50, "{generators:?} {}", counts.get(Operation::SearchStep));
        let rounding = 4.0 * tiny;
        assert!(depth.upper * (1.0 - ACCURACY) <= depth.lower + rounding, "{generators:?} {depth:?}");
    }
}

/// A point of the facet of the first two generators, moved toward the centre by a part of its distance.
fn beneath_a_facet(generators: &[[f64; 3]], part: f64) -> [f64; 3] {
    let normal = cross(&generators[0], &generators[1]);
    let on_facet = generators[2..].iter().fold([0.0; 3], |sum, g| {
        let sign = f64::copysign(1.0, dot(&normal, g));
        std::array::from_fn(|k| sum[k] + sign * g[k])
    });
    on_facet.map(|c| c * (1.0 - part))
}

fn random_generators(count: usize, seed: u64) -> Vec<[f64; 3]> {
    let mut state = seed;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    (0..count).map(|_| [unit(), unit(), unit()]).collect()
}

#[test]
fn overlaps_far_smaller_than_the_bodies_are_within_a_hundredth() {
    for count in [20, 300, 1000] {
        let generators = random_generators(count, count as u64);
        for part in [1e-3, 1e-9, 1e-13, 1e-15] {
            let to = beneath_a_facet(&generators, part);
            let query = Query::new([0.0; 3], to, &generators).expect("finite");
            let depth = by_inner_polytope::penetration(&query, &mut ());
            assert!(depth.is_within(ACCURACY), "{count} {part} {depth:?}");
            if count == 20 {
                let exact = by_facet_normals::penetration(&query);
                assert!(depth.lower <= exact.upper && exact.lower <= depth.upper, "{depth:?} {exact:?}");
            }
        }
    }
}

/// Bodies whose facets have many generators, so that many vertices of the polytope lie in one plane.
#[test]
fn prisms_lattices_and_sums_of_boxes() {
    let disc = |count: usize| (0..count).map(move |i| [libm::cos(i as f64 * 0.37), libm::sin(i as f64 * 0.37), 0.0]);
    let prism: Vec<[f64; 3]> = disc(40).chain([[0.0, 0.0, 3.0]]).collect();
    let lattice: Vec<[f64; 3]> =
        (0..60).map(|i| [f64::from(i % 3 - 1), f64::from(i / 3 % 5 - 2), f64::from(i % 4 - 1)]).collect();
    let boxes: Vec<[f64; 3]> =
        (0..30).map(|i| std::array::from_fn(|k| if i % 3 == k { 1.0 + i as f64 } else { 0.0 })).collect();
    for generators in [prism, lattice, boxes] {
        for to in [[0.0; 3], [0.5, 0.25, 0.125], [3.0, 0.0, 0.0], [0.0, 0.0, 2.5]] {
            let query = Query::new([0.0; 3], to, &generators).expect("finite");
            let (depth, exact) =
                (by_inner_polytope::penetration(&query, &mut ()), by_facet_normals::penetration(&query));
            assert!(depth.is_within(ACCURACY) && depth.lower <= exact.upper && exact.lower <= depth.upper, "{depth:?}");
        }
    }
}

/// Coordinates that no two doubles hold together: the exact polytope decides.
#[test]
fn lengths_that_differ_by_all_exponents() {
    let generators =
        [[1e300, 0.0, 1.0], [0.0, 1e-300, 1e-300], [1.0, 0.0, 5e-324], [0.0, 1.0, 1e150], [1e-200, 1e10, 0.0]];
    for scale in [0.0, 0.5, 0.999] {
        let to = inner_point(&generators, &[scale; 5]);
        let query = Query::new([0.0; 3], to, &generators).expect("finite");
        let (depth, exact) = (by_inner_polytope::penetration(&query, &mut ()), by_facet_normals::penetration(&query));
        assert!(depth.lower <= exact.upper && exact.lower <= depth.upper, "{depth:?} {exact:?}");
        assert!(depth.is_within(ACCURACY) || exact.upper < 1e-300, "{depth:?} {exact:?}");
    }
}
