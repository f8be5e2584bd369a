//! Distances by every method against the exact truth, on all families of questions in one to three dimensions, and of
//! boxes in near contact; every gap is proved by the verifier, every status is that of the location's own twin.

use dashu_ratio::RBig;
use families::drawn::bodies::families;
use families::drawn::numbers::moved_by_ulps;
use proptest::array::{uniform3, uniform4, uniform6};
use proptest::prelude::*;
use tests::body_questions::{Asked, asked};
use tests::runner::for_all;
use zonotope::collision::distance::penetration::{self, Penetration, by_facet_normals, by_inner_polytope};
use zonotope::collision::distance::{FeatureKind, Method, brute_force, by_support_simplex};
use zonotope::collision::{Query, Status, brute_force as location_twin, by_lad};
use zonotope::interop::verifier::check_distance;
use zonotope::numeric::dyadic::Dyadic;
use zonotope::{Pose, Zonotope};

/// The questions of a long run for each of the fourteen families, by dimension.
const CASES: [u32; 3] = [100, 200, 300];

/// The poses of a long run in near contact.
const POSES: u32 = 100_000;

/// The fast method answers as the truth does, with a proof.
fn agrees<const D: usize>(asked: &Asked<D>) -> Result<(), TestCaseError> {
    let query = asked.displacement();
    let truth = brute_force::nearest_point(&query);
    let answer = by_support_simplex::proximity(&query, &mut ());
    prop_assert_eq!(answer.status(), location_twin::locate(&query).status());
    prop_assert_eq!(answer.exact_squared_distance(), truth.squared_distance);
    let Some(gap) = answer.gap() else { return Ok(()) };
    prop_assert_eq!(check_distance(&query, gap).proof().map(drop), Ok(()), "{:?}", gap);
    let [first, second] = gap.features.each_ref().map(|feature| feature.kind);
    prop_assert_eq!(second, FeatureKind::Vertex, "the second body is a point");
    prop_assert!(D == 3 || first != FeatureKind::Facet);
    Ok(())
}

/// Every family of a dimension, with at most `most` generators.
fn conform<const D: usize>(most: usize, cases: u32) {
    for (family, generators) in families::<D>(most) {
        for_all(&asked(generators), cases, |asked| {
            agrees(&asked).map_err(|error| TestCaseError::fail(format!("{family}: {error}")))
        });
    }
}

#[test]
fn on_the_line() {
    conform::<1>(6, CASES[0]);
}

#[test]
fn in_the_plane() {
    conform::<2>(6, CASES[1]);
}

#[test]
fn in_space() {
    conform::<3>(6, CASES[2]);
}

/// Beyond what the truth finishes: the proofs alone.
#[test]
fn in_space_with_many_generators() {
    for (family, generators) in families::<3>(40) {
        for_all(&asked(generators), 60, |asked| {
            let query = asked.displacement();
            let answer = by_support_simplex::proximity(&query, &mut ());
            prop_assert_eq!(answer.status(), by_lad::locate(&query, &mut ()).status());
            let proof = answer.gap().map_or(Ok(()), |gap| check_distance(&query, gap).proof().map(drop));
            prop_assert_eq!(proof, Ok(()), "{}", family);
            Ok(())
        });
    }
}

#[test]
fn methods_are_named_and_agree() {
    let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let query = Query::new([0.0; 3], [3.0, 3.0, 0.5], &cube).expect("finite");
    for method in Method::ALL {
        assert_eq!(Method::from_id(method.id()), Some(method));
        assert!(method.dimensions().contains(&3));
        assert_eq!(method.exact_squared_distance(&query, &mut ()), 8.into(), "{}", method.title());
    }
}

/// Whether the exact depth lies between the bounds: its square is rational, the depth itself seldom is.
fn holds<const D: usize>(depth: &Penetration<D>, squared: &RBig) -> bool {
    let square = |v: f64| Dyadic::from_f64(v).to_rational() * Dyadic::from_f64(v).to_rational();
    square(depth.lower) <= *squared && (depth.upper == f64::INFINITY || *squared <= square(depth.upper))
}

/// The bounds hold the depth of the truth, which is 0 unless the displacement is inside, and are near to each other.
fn is_as_deep<const D: usize>(asked: &Asked<D>) -> Result<(), TestCaseError> {
    let query = asked.displacement();
    let is_inside = location_twin::locate(&query).status() == Status::Inside;
    let truth = penetration::brute_force::squared_depth(&query).filter(|_| is_inside).unwrap_or(RBig::ZERO);
    let exact = by_facet_normals::penetration(&query);
    prop_assert!(holds(&exact, &truth), "{:?}", exact);
    let depth = penetration::of_query(&query);
    prop_assert!(holds(&depth, &truth), "{:?}, exactly {:?}", depth, exact);
    // a hundredth of the least doubles is none
    prop_assert!(depth.is_within(by_inner_polytope::ACCURACY) || depth.upper < 1e-320, "{:?}", depth);
    prop_assert_eq!(depth.upper > 0.0, is_inside);
    Ok(())
}

#[test]
fn depths_hold_the_truth() {
    for (family, generators) in families::<3>(14) {
        for_all(&asked(generators), 120, |asked| {
            is_as_deep(&asked).map_err(|error| TestCaseError::fail(format!("{family}: {error}")))
        });
    }
    for (_, generators) in families::<2>(8) {
        for_all(&asked(generators), 60, |asked| is_as_deep(&asked));
    }
}

/// Half sides of two boxes, the second one's rotation, coefficients of the point of contact, a direction that says
/// which generators span the face in contact, and units in the last place by which the centre is moved off.
type Contact = ([f64; 6], [f64; 4], [f64; 6], [f64; 3], [i32; 3]);

fn contacts() -> impl Strategy<Value = Contact> {
    let half_side = prop_oneof![0.1..2.0f64, Just(1.0), Just(0.5)];
    let quaternion = prop_oneof![uniform4(-1.0..1.0f64), uniform4((-2i32..3).prop_map(f64::from))];
    let coefficient = prop_oneof![3 => Just(1.0), 3 => Just(-1.0), 2 => -1.0..1.0f64];
    (uniform6(half_side), quaternion, uniform6(coefficient), uniform3(-1.0..1.0f64), uniform3(-4i32..5))
}

/// The centre of the second box at a vertex, an edge or a facet of the sum of both but for four units in the last place
/// of each coordinate: the status is the kernel's, whose own twin it is crossed with elsewhere, and there is a distance
/// just when they are apart, with a proof.
fn keeps_its_sign((sides, quaternion, coefficients, direction, steps): Contact) -> Result<(), TestCaseError> {
    let turned = Pose::from_quaternion(quaternion, [0.0; 3]).unwrap_or(Pose::IDENTITY).matrix();
    let axis = |k: usize| std::array::from_fn(|i| if i == k { sides[k] } else { 0.0 });
    let column = |k: usize| turned.map(|row| row[k] * sides[3 + k]);
    let boxes: [Vec<[f64; 3]>; 2] = [(0..3).map(axis).collect(), (0..3).map(column).collect()];
    let along = |g: &[f64; 3]| g.iter().zip(direction).map(|(a, b)| a * b).sum::<f64>();
    let all = boxes.concat();
    let mut order: Vec<usize> = (0..6).collect();
    order.sort_by(|&i, &j| along(&all[i]).abs().total_cmp(&along(&all[j]).abs()));
    let mut contact = [0.0; 3];
    for (rank, &i) in order.iter().enumerate() {
        let coefficient = if rank < 2 { coefficients[i] } else { along(&all[i]).signum() };
        contact = std::array::from_fn(|k| contact[k] + coefficient * all[i][k]);
    }
    let center = std::array::from_fn(|k| moved_by_ulps(contact[k], steps[k]));
    let [first, second] = boxes;
    let a = Zonotope::new([0.0; 3], first).expect("finite");
    let b = Zonotope::new(center, second).expect("finite");
    let query = Query::between(&a, &b);
    let answer = by_support_simplex::proximity(&query, &mut ());
    prop_assert_eq!(answer.status(), by_lad::locate(&query, &mut ()).status());
    let distance = answer.distance();
    prop_assert!(distance.is_finite() && (distance > 0.0) == (answer.status() == Status::Outside));
    let Some(gap) = answer.gap() else { return Ok(()) };
    prop_assert_eq!(check_distance(&query, gap).proof().map(drop), Ok(()), "{:?}", gap);
    prop_assert!(gap.points.iter().flatten().chain(&gap.nearest.coefficients).all(|c| c.is_finite()));
    Ok(())
}

#[test]
fn no_sign_is_wrong_near_contact() {
    for_all(&contacts(), POSES, keeps_its_sign);
}
