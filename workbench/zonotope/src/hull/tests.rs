use families::drawn::numbers::nudged;
use proptest::prelude::*;

use super::*;
use crate::interop::verifier::check_convex_hull;
use crate::numeric::non_finite::{NonFinite, Place};
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::{Operation, OperationCounts};

type Method = fn(&[[f64; 2]]) -> Result<ConvexHull, HullError>;

const METHODS: [(&str, Method); 3] = [
    ("brute_force", |points| brute_force::convex_hull(points, &mut ())),
    ("by_monotone_chain", |points| by_monotone_chain::convex_hull(points, &mut ())),
    ("by_discarding", |points| by_discarding::convex_hull(points, &mut ())),
];

fn points_of<S: Strategy<Value = f64>>(coordinate: impl Fn() -> S) -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec([coordinate(), coordinate()], 1..60)
}

/// Multiples of a direction from an origin, rounded, then moved by a few ulps.
fn nearly_collinear(ulps: i64) -> impl Strategy<Value = Vec<[f64; 2]>> {
    let steps = prop::collection::vec((-20_i32..=20, -ulps..=ulps, -ulps..=ulps), 1..40);
    ([-1.0..1.0, -1.0..1.0], [-1.0..1.0, -1.0..1.0], steps).prop_map(|(origin, direction, steps)| {
        let at = |axis: usize, along: i32| origin[axis] + f64::from(along) * direction[axis];
        steps.into_iter().map(|(k, x, y)| [nudged(at(0, k), x), nudged(at(1, k), y)]).collect()
    })
}

/// Points on a circle, in a regular pattern or not, with repetitions.
fn circular() -> impl Strategy<Value = Vec<[f64; 2]>> {
    (3_u32..40, any::<bool>(), prop::collection::vec(any::<u32>(), 3..80)).prop_map(|(sides, is_regular, picks)| {
        let angle = |pick: u32| {
            let fraction = f64::from(pick) / f64::from(if is_regular { sides } else { u32::MAX });
            fraction * std::f64::consts::TAU
        };
        let picks = picks.into_iter().map(|pick| if is_regular { pick % sides } else { pick });
        picks.map(|pick| [libm::cos(angle(pick)), libm::sin(angle(pick))]).collect()
    })
}

fn symmetric() -> impl Strategy<Value = Vec<[f64; 2]>> {
    points_of(|| -1.0..1.0).prop_map(|points| {
        let opposite: Vec<_> = points.iter().map(|&[x, y]| [-x, -y]).collect();
        [points, opposite].concat()
    })
}

fn unscaled() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop_oneof![
        points_of(|| -1.0..1.0),
        points_of(|| (-3_i32..=3).prop_map(f64::from)),
        points_of(|| prop::sample::select(vec![0.0, -0.0, 1.0])),
        (points_of(|| -1.0..1.0), -1.0..1.0).prop_map(|(points, x)| points.iter().map(|p| [x, p[1]]).collect()),
        nearly_collinear(0),
        nearly_collinear(1),
        circular(),
        symmetric(),
    ]
}

/// Instances of every family, at every scale of the double range, and with scales mixed within an instance.
pub(super) fn point_sets() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let exponent = prop::sample::select(vec![-1070_i64, -1020, -540, -400, 0, 100, 480, 512, 1015]);
    let any_finite = || any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |value| value.is_finite());
    prop_oneof![
        3 => unscaled(),
        2 => (unscaled(), exponent).prop_map(|(points, exponent)| {
            points.iter().map(|point| point.map(|value| scale_by_power_of_two(value, exponent))).collect()
        }),
        1 => (unscaled(), unscaled(), -1040_i64..1015).prop_map(|(mut points, other, exponent)| {
            points.extend(other.iter().map(|point| point.map(|value| scale_by_power_of_two(value, exponent))));
            points
        }),
        1 => (unscaled(), points_of(any_finite)).prop_map(|(points, other)| [points, other].concat()),
    ]
}

/// Repeats and shuffles an instance until it is long enough for the stages that only large inputs reach.
fn enlarged(points: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    (0..count).map(|k| points[(k * 7919 + k / points.len()) % points.len()]).collect()
}

properties! {
    #![proptest_config(crate::property_cases::config(1500))]

    #[test]
    fn methods_agree_and_verify(points in point_sets()) {
        let truth = brute_force::convex_hull(&points, &mut ()).expect("the points are finite");
        prop_assert_eq!(check_convex_hull(&points, &truth).proof().map(drop), Ok(()));
        for (vertex, index) in truth.vertices().iter().zip(truth.indices()) {
            prop_assert_eq!(points.iter().position(|point| point == vertex), Some(index.get()), "first occurrence");
        }
        for (name, method) in METHODS {
            prop_assert_eq!(method(&points), Ok(truth.clone()), "{}", name);
        }
    }
}

properties! {
    #![proptest_config(crate::property_cases::config(200))]

    #[test]
    fn methods_agree_on_many_points(points in point_sets(), count in 500_usize..4000) {
        let points = enlarged(&points, count);
        let truth = brute_force::convex_hull(&points, &mut ()).expect("the points are finite");
        prop_assert_eq!(convex_hull(&points, &mut ()), Ok(truth));
    }
}

fn check_vertices(points: &[[f64; 2]], vertices: &[[f64; 2]], indices: &[usize]) {
    for (name, method) in METHODS {
        let hull = method(points).expect("the points are finite");
        assert_eq!(hull.vertices(), vertices, "{name}");
        assert_eq!(hull.indices().iter().map(|index| index.get()).collect::<Vec<_>>(), indices, "{name}");
    }
}

#[test]
fn one_point() {
    check_vertices(&[[3.0, 4.0]], &[[3.0, 4.0]], &[0]);
    check_vertices(&[[3.0, 4.0]; 5], &[[3.0, 4.0]], &[0]);
    check_vertices(&[[0.0, -0.0], [-0.0, 0.0]], &[[0.0, 0.0]], &[0]);
}

#[test]
fn segments() {
    check_vertices(&[[3.0, 4.0], [1.0, 2.0]], &[[1.0, 2.0], [3.0, 4.0]], &[1, 0]);
    check_vertices(&[[1.0, 5.0], [1.0, 2.0], [1.0, 2.0], [1.0, 4.0]], &[[1.0, 2.0], [1.0, 5.0]], &[1, 0]);
    check_vertices(&[[1.0, 1.0], [0.0, 0.0], [2.0, 2.0], [1.0, 1.0], [2.0, 2.0]], &[[0.0, 0.0], [2.0, 2.0]], &[1, 2]);
}

#[test]
fn a_square_with_all_its_lattice_points_twice() {
    let points: Vec<[f64; 2]> = (0..50).map(|k| [f64::from(k % 5), f64::from(k / 5 % 5)]).collect();
    check_vertices(&points, &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], &[0, 4, 24, 20]);
}

#[test]
fn the_largest_coordinates_and_the_smallest() {
    let (big, small) = (f64::MAX, 5e-324);
    let points = [[0.0, small], [big, big], [-big, big], [0.0, 0.0], [small, 0.0], [-big, -big], [big, -big]];
    check_vertices(&points, &[[-big, -big], [big, -big], [big, big], [-big, big]], &[5, 6, 1, 2]);
}

#[test]
fn bad_input_is_refused() {
    for (name, method) in METHODS {
        assert_eq!(method(&[]), Err(HullError::Empty), "{name}");
        for value in [f64::INFINITY, f64::NEG_INFINITY] {
            let mut points = vec![[0.0; 2]; 3000];
            points[2001][1] = value;
            points[2500][0] = f64::NAN;
            let place = Place::Listed { noun: "point", index: 2001, coordinate: 1 };
            assert_eq!(method(&points), Err(HullError::NonFinite(NonFinite { place, value })), "{name}");
        }
        let refused = method(&[[1.0, 2.0], [f64::NAN, f64::NAN]]).expect_err("NaN is no coordinate");
        assert_eq!(refused.to_string(), "point 1, coordinate 0 is NaN, not a finite number", "{name}");
    }
    assert_eq!(error::check_count(MAX_POINTS), Ok(()));
    assert_eq!(error::check_count(MAX_POINTS + 1), Err(HullError::TooMany { count: MAX_POINTS + 1 }));
}

#[test]
fn counting_changes_nothing_and_counts() {
    let points: Vec<[f64; 2]> = (0..2000).map(|k| f64::from(k) - 1000.0).map(|x| [x, x * x]).collect();
    let mut counts = OperationCounts::default();
    assert_eq!(convex_hull(&points, &mut counts), convex_hull(&points, &mut ()));
    assert!((2000..8000).contains(&counts.get(Operation::Turn)));
    // the first and the last point against the line through them
    assert_eq!(counts.get(Operation::ExactFallback), 2);
}

#[test]
fn vertices_that_are_not_the_points_they_name_are_noticed() {
    let points = [[0.0, 0.0], [-0.0, 0.0], [2.0, 0.0]];
    let segment = |vertices: &[[f64; 2]], indices: &[usize]| {
        ConvexHull::from_parts(vertices.to_vec(), indices.iter().map(|&at| PointIndex::new(at)).collect())
    };
    assert!(check_convex_hull(&points, &segment(&[[0.0, 0.0], [2.0, 0.0]], &[0, 2])).is_right());
    for (vertex, index) in [([0.5, 0.0], 0), ([0.0, 0.0], 1), ([0.0, 0.0], 3)] {
        assert!(check_convex_hull(&points, &segment(&[vertex, [2.0, 0.0]], &[index, 2])).is_wrong());
    }
}
