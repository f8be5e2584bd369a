//! Answers beside the twin, their proofs, and box poses that other libraries fail on.

mod boxes;
mod near_contact;

use proptest::prelude::*;

use super::*;
use crate::collision::distance::{FeatureKind, Gap, brute_force};
use crate::collision::{Status, brute_force as location_twin};
use crate::interop::verifier::check_distance;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::sum_of_products;
use crate::numeric::linear::dot;
use crate::zonotope::pose::Pose;

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0f64,
        4 => (-2i32..3).prop_map(f64::from),
        1 => (-3i32..4).prop_map(|k| 1.0 + f64::from(k) * f64::EPSILON),
        1 => (-3i32..4).prop_map(|k| f64::from(k) * f64::from_bits(1)),
        1 => prop::sample::select(vec![1e308, -1e308, f64::MAX, 1e-300, 1e150, -1e-150]),
    ]
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![
        3 => [coordinate(), coordinate(), coordinate()],
        2 => [-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64],
        2 => [-2i32..3, -2i32..3, -2i32..3].prop_map(|v| v.map(f64::from)),
    ]
}

fn moderate() -> impl Strategy<Value = [f64; 3]> {
    [-9i32..10, -9i32..10, -9i32..10].prop_map(|v| v.map(|c| f64::from(c) / 2.0))
}

/// Every promise of an answer: the status, the proof, the exact distance, the direction, the points and the faces.
fn check<const D: usize>(query: &Query<'_, D>) -> Result<(), TestCaseError> {
    let answer = proximity(query, &mut ());
    prop_assert_eq!(answer.status(), location_twin::locate(query).status());
    let truth = brute_force::nearest_point(query);
    prop_assert_eq!(&answer.exact_squared_distance(), &truth.squared_distance);
    prop_assert!(is_as_far(distance(query, &mut ()), &answer));
    let Some(gap) = answer.gap() else { return Ok(()) };
    prop_assert_eq!(check_distance(query, gap).proof().map(drop), Ok(()), "{:?}", gap);
    let p = query.exact().map(|c| c.to_rational());
    let vector: [Rational; D] = std::array::from_fn(|k| &p[k] - &truth.point[k]);
    check_direction(gap, &vector)?;
    check_points(query, gap, &truth.point)?;
    let [first, second] = query.runs();
    for (feature, run) in gap.features.iter().zip([first, second]) {
        let is_orthogonal = |i: &usize| {
            let g = run[*i].map(Dyadic::from_f64);
            sum_of_products(gap.exact_direction(), &g).is_zero() && g.iter().any(|c| !c.is_zero())
        };
        prop_assert_eq!(&feature.generators, &(0..run.len()).filter(is_orthogonal).collect::<Vec<_>>());
        prop_assert_eq!(feature.kind == FeatureKind::Vertex, feature.generators.is_empty());
    }
    Ok(())
}

/// A distance that is found alone is as near to the exact one as that of an answer: both are within two units in the
/// last place.
fn is_as_far<const D: usize>(distance: f64, answer: &Proximity<D>) -> bool {
    let apart = |distance: f64| distance.to_bits().abs_diff(answer.distance().to_bits());
    distance >= 0.0 && apart(distance) <= 4 && (distance > 0.0) == (answer.distance() > 0.0)
}

/// The direction is a positive multiple of the shortest vector.
fn check_direction<const D: usize>(gap: &Gap<D>, vector: &[Rational; D]) -> Result<(), TestCaseError> {
    let direction = gap.exact_direction().each_ref().map(Dyadic::to_rational);
    for i in 0..D {
        for k in 0..i {
            prop_assert_eq!(&direction[i] * &vector[k], &direction[k] * &vector[i]);
        }
    }
    prop_assert!(sum_of_products(&direction, vector) > Rational::ZERO);
    let squared = gap.squared_distance();
    prop_assert!(squared >= 0.0 && gap.distance() >= 0.0);
    Ok(())
}

/// The points differ by the shortest vector but for rounding, and each is off by little more than half a unit.
fn check_points<const D: usize>(
    query: &Query<'_, D>,
    gap: &Gap<D>,
    nearest: &[Rational; D],
) -> Result<(), TestCaseError> {
    let rational = |v: f64| Dyadic::from_f64(v).to_rational();
    let [a, b] = gap.points;
    if a.iter().chain(&b).any(|c| !c.is_finite()) {
        return Ok(());
    }
    for k in 0..D {
        let apart = query.exact()[k].to_rational() - &nearest[k];
        let off = rational(b[k]) - rational(a[k]) - apart;
        let unit = |v: f64| rational((v.abs() - v.abs().next_down()).max(f64::from_bits(1)) * 2.0);
        let allowed = unit(a[k]) + unit(b[k]);
        prop_assert!(off <= allowed && -off <= allowed, "{:?}", gap);
    }
    Ok(())
}

properties! {
    #![proptest_config(crate::property_cases::config(400))]

    #[test]
    fn answers_are_those_of_the_twin(
        generators in proptest::collection::vec(vector(), 0..6),
        from in vector(),
        to in prop_oneof![vector(), moderate()],
        split in 0usize..6,
    ) {
        let (first, second) = generators.split_at(split.min(generators.len()));
        let body = |center, generators: &[[f64; 3]]| Zonotope::new(center, generators.to_vec()).expect("finite");
        let (a, b) = (body(from, first), body(to, second));
        check(&Query::between(&a, &b))?;
    }

    #[test]
    fn answers_in_the_plane_are_those_of_the_twin(
        generators in proptest::collection::vec([coordinate(), coordinate()], 0..6),
        to in [-9i32..10, -9i32..10].prop_map(|v| v.map(f64::from)),
    ) {
        check(&Query::new([0.25, 0.0], to, &generators).expect("finite"))?;
    }

    #[test]
    fn posed_bodies_are_as_far_apart_as_their_images(
        generators in proptest::collection::vec([-4i32..5, -4i32..5, -4i32..5].prop_map(|v| v.map(f64::from)), 1..6),
        entries in proptest::array::uniform9((-2i32..3).prop_map(f64::from)),
        to in moderate(),
    ) {
        // small whole numbers, so that doubles hold the images
        let [a, b, c, d, e, f, g, h, i] = entries;
        let matrix = [[a, b, c], [d, e, f], [g, h, i]];
        let pose = Pose::new(matrix, [1.0, -2.0, 0.5]).expect("finite");
        let body = Zonotope::new([0.0; 3], generators.clone()).expect("finite");
        let images: Vec<[f64; 3]> = generators.iter().map(|v| matrix.map(|row| dot(&row, v))).collect();
        let image = Zonotope::new([1.0, -2.0, 0.5], images).expect("finite");
        let other = Zonotope::new(to, generators).expect("finite");
        let (posed, plain) = (body.at(&pose).proximity(&other), image.proximity(&other));
        prop_assert_eq!(posed.status(), plain.status());
        prop_assert_eq!(posed.exact_squared_distance(), plain.exact_squared_distance());
        prop_assert!(is_as_far(body.at(&pose).distance(&other), &posed));
        if let (Some(gap), Some(expected)) = (posed.gap(), plain.gap()) {
            prop_assert_eq!(gap.direction().map(f64::signum), expected.direction().map(f64::signum));
            prop_assert_eq!(&gap.features, &expected.features);
        }
    }
}

/// As many generators as doubles are needed for: the proof, and a lower bound of the distance by the direction.
#[test]
fn many_generators() {
    let mut state = 1u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    for count in [100, 1000, 5000] {
        for factor in [1.0 + 1e-9, 1.001, 1.5, 20.0] {
            let generators: Vec<[f64; 3]> = (0..count).map(|_| [unit(), unit(), unit()]).collect();
            let direction = [unit(), unit(), unit()];
            let body = Zonotope::new([0.0; 3], generators).expect("finite");
            let extreme = body.support(direction).point();
            let other = Zonotope::new(extreme.map(|c| factor * c), Vec::new()).expect("finite");
            let query = Query::between(&body, &other);
            let answer = proximity(&query, &mut ());
            let gap = answer.gap().expect("beyond an extreme point");
            assert!(is_as_far(distance(&query, &mut ()), &answer), "{count} {factor}");
            assert_eq!(check_distance(&query, gap).proof().map(drop), Ok(()));
        }
    }
}

#[test]
fn faces_of_cubes_by_hand() {
    let cube = |center| Zonotope::new(center, vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
    let cases = [
        ([5.0, 0.5, 0.0], 3.0, FeatureKind::Facet),
        ([5.0, 6.0, 0.0], 5.0, FeatureKind::Edge),
        ([4.0, 4.0, 3.0], 3.0, FeatureKind::Vertex),
    ];
    for (center, distance, kind) in cases {
        let answer = cube([0.0; 3]).proximity(&cube(center));
        let gap = answer.gap().expect("they are apart");
        assert_eq!((answer.distance(), gap.features.each_ref().map(|feature| feature.kind)), (distance, [kind; 2]));
        let [a, b] = gap.points;
        assert!((0..3).all(|k| a[k].abs() <= 1.0 && (b[k] - center[k]).abs() <= 1.0));
    }
    for (x, status) in [(1.5, Status::Inside), (2.0, Status::Boundary), (2.0f64.next_up(), Status::Outside)] {
        let answer = cube([0.0; 3]).proximity(&cube([x, 0.5, 0.5]));
        assert_eq!((answer.status(), answer.distance()), (status, (x - 2.0).max(0.0)));
    }
}

#[test]
fn distances_at_the_ends_of_the_range() {
    let point = |center| Zonotope::new(center, Vec::new()).expect("finite");
    let tiny = f64::from_bits(1);
    assert_eq!(point([0.0; 3]).proximity(&point([tiny, 0.0, 0.0])).distance(), tiny);
    assert_eq!(point([0.0; 3]).proximity(&point([3.0 * tiny, 4.0 * tiny, 0.0])).distance(), 5.0 * tiny);
    // the plane x + 2 y + 2 z = tiny passes the origin at a third of the least double, which would be rounded to 0
    let plane = [[-2.0 * tiny, tiny, 0.0], [-2.0 * tiny, 0.0, tiny]];
    let face = Zonotope::new([tiny, 0.0, 0.0], plane.to_vec()).expect("finite");
    assert_eq!(face.proximity(&point([0.0; 3])).distance(), tiny);
    assert_eq!(point([0.0; 3]).proximity(&point([3e307, 4e307, 0.0])).distance(), 5e307);
    assert_eq!(point([f64::MIN; 3]).proximity(&point([f64::MAX; 3])).distance(), f64::INFINITY);
}
