use super::super::*;
use crate::Zonotope;
use crate::collision::by_lad::tests::posed::check_proof;
use crate::collision::prepared::by_direction_tree::tests::{KINDS, body};
use crate::collision::{Location, Status, by_lad};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{dot, exact};
use crate::tally::{Operation, OperationCounts};
use crate::zonotope::pose::Pose;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

fn vector(size: f64, random: &mut Pcg64Mcg) -> [f64; 3] {
    [0; 3].map(|_| size * random.random_range(-1.0..1.0))
}

/// A rotation, a matrix that distorts, one that flattens, or none.
fn pose(kind: usize, translation: [f64; 3], random: &mut Pcg64Mcg) -> Pose {
    let rows = match kind % 4 {
        0 => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        1 => [vector(1.0, random), vector(2.0, random), vector(1.0, random)],
        2 => [vector(1.0, random), vector(1.0, random), [0.0; 3]],
        _ => return Pose::from_axis_angle(vector(1.0, random), 1.7, translation).expect("an axis"),
    };
    Pose::new(rows, translation).expect("finite")
}

/// Everything that posed trees say, against a location that is right.
fn check(located: &Located<'_, Pose>, query: &Query<'_, 3, Pose>, truth: &Location<3>) {
    assert_eq!(located.status(), truth.status(), "{} generators", query.len());
    assert_eq!(located.is_member(), truth.is_member());
    let written = located.expand();
    assert_eq!(written.status(), truth.status());
    check_proof(query, &written);
}

#[test]
fn a_diamond_worked_out_by_hand() {
    let cube = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let tree = DirectionTree::new(&Zonotope::new([0.0; 3], cube).expect("finite"));
    // (x, y) to (x − y, x + y): the square [−1, 1]² becomes the diamond |x| + |y| ≤ 2
    let turned = Pose::new([[1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]).expect("finite");
    let diamond = tree.at(&turned);
    for (point, status, gauge) in [
        ([0.0; 3], Status::Inside, 0.0),
        ([1.0, 0.5, 0.0], Status::Inside, 0.75),
        ([2.0, 0.0, 0.5], Status::Boundary, 1.0),
        ([3.0, 1.0, 0.0], Status::Outside, 2.0),
    ] {
        assert_eq!(diamond.locate(point, &mut ()).map(|located| located.status()), Ok(status));
        let measured = diamond.gauge(point, &mut ()).expect("finite");
        assert!((measured.value - gauge).abs() <= measured.error && measured.location.status() == status);
    }
    assert!(diamond.locate([f64::NAN; 3], &mut ()).is_err() && diamond.gauge([f64::INFINITY; 3], &mut ()).is_err());
    for (x, status) in [(2.5, Status::Inside), (3.0, Status::Boundary), (3.0f64.next_up(), Status::Outside)] {
        let moved = Pose::from_translation([x, 0.0, 0.0]).expect("finite");
        assert_eq!(diamond.intersection(&tree.at(&moved), &mut ()).status(), status);
    }
    let apart = diamond.gauge_between(&tree.at(&Pose::from_translation([6.0, 0.0, 0.0]).expect("finite")));
    assert!((apart.value - 2.0).abs() <= apart.error);
}

#[test]
fn posed_bodies_are_located_as_without_trees() {
    let random = &mut Pcg64Mcg::seed_from_u64(17);
    for kind in 0..KINDS {
        for [n, m] in [[1, 3], [9, 0], [130, 40], [700, 700], [1500, 400]] {
            let bodies = [n, m].map(|n| Zonotope::new(vector(0.5, random), body(kind, n, random)).expect("finite"));
            let trees = bodies.each_ref().map(DirectionTree::new);
            for round in 0..6 {
                let translation = vector([1.0, 1e-3, 100.0][round % 3] * (n as f64).sqrt(), random);
                let poses = [pose(round, [0.0; 3], random), pose(round / 2, translation, random)];
                let query = Query::of_placed(bodies[0].at(&poses[0]), bodies[1].at(&poses[1]));
                let truth = by_lad::locate(&query, &mut ());
                let [first, second] = [0, 1].map(|i| trees[i].at(&poses[i]));
                check(&first.intersection(&second, &mut ()), &query, &truth);
                let measured = first.gauge_between(&second);
                let gauge = by_lad::gauge(&query, &mut ());
                let is_same = measured.value == gauge.value
                    || (measured.value - gauge.value).abs() <= measured.error + gauge.error;
                assert!(is_same, "{} ± {}, not {} ± {}", measured.value, measured.error, gauge.value, gauge.error);
                check(&measured.location, &query, &truth);
            }
        }
    }
}

#[test]
fn points_near_the_boundary_of_a_turned_body() {
    let random = &mut Pcg64Mcg::seed_from_u64(19);
    for kind in 0..6 {
        let center = vector(1.0, random);
        let zonotope = Zonotope::new(center, body(kind, 900, random)).expect("finite");
        let tree = DirectionTree::new(&zonotope);
        for round in 0..6 {
            let pose = pose(1 + 2 * round, vector(1.0, random), random);
            let posed = tree.at(&pose);
            let away = vector(1.0, random);
            let middle = pose.exact_point(center).map(|c| c.to_f64());
            let far = posed.gauge([0, 1, 2].map(|k| middle[k] + away[k]), &mut ()).expect("finite").value;
            for gap in [0.3, 1e-3, 1e-9, 1e-15, 0.0, -1e-15, -1e-9, -1e-3] {
                let point = [0, 1, 2].map(|k| middle[k] + away[k] * ((1.0 + gap) / far).min(1e300));
                let query = Query::of_point_in(point, zonotope.at(&pose)).expect("finite");
                let located = posed.locate(point, &mut ()).expect("finite");
                check(&located, &query, &by_lad::locate(&query, &mut ()));
            }
        }
    }
}

#[test]
fn supports_and_sums_over_cells_are_within_their_bounds() {
    let random = &mut Pcg64Mcg::seed_from_u64(23);
    for kind in 0..KINDS {
        let bodies = [1200, 300].map(|n| Zonotope::new([0.0; 3], body(kind, n, random)).expect("finite"));
        let trees = bodies.each_ref().map(DirectionTree::new);
        for round in 0..8 {
            let poses = [pose(round, [0.0; 3], random), pose(3 - round % 4, [1.0, 0.0, 0.0], random)];
            let posed = trees[0].at(&poses[0]).query_between(&trees[1].at(&poses[1]));
            let u = vector(1.0, random);
            let exact_u = exact(u);
            let images: Vec<_> = (0..posed.len()).map(|i| posed.exact_generator(i)).collect();
            let truth = images.iter().fold(Dyadic::from_f64(0.0), |sum, v| sum + dot(v, &exact_u).abs());
            let Bounded { value, error } = posed.support(&u);
            let off = |value: f64, truth: &Dyadic| (Dyadic::from_f64(value) - truth.clone()).abs();
            let is_known = value.is_finite() && error.is_finite();
            assert!(!is_known || off(value, &truth) <= Dyadic::from_f64(error), "{kind} {round}");
            let cell = DirectionCone { center: u, axes: None, ball: [0.0, 1e-9, 0.1][round % 3] };
            let (mut crossing, mut places) = (Vec::new(), Places::new());
            let fixed = posed.split(&cell, &mut crossing, &mut places);
            assert!(places.is_sorted() && crossing.len() == places.len());
            let mut truth = exact([0.0; 3]);
            for (i, v) in images.iter().enumerate().filter(|(i, _)| places.binary_search(&(*i as u32)).is_err()) {
                let sign = if dot(v, &exact_u).sign().is_lt() { -1.0 } else { 1.0 };
                truth = [0, 1, 2].map(|k| &truth[k] + &(&v[k] * &Dyadic::from_f64(sign)));
                assert!(i < posed.len());
            }
            for (truth, sum) in truth.iter().zip(fixed.sum).filter(|_| fixed.error.is_finite()) {
                assert!(off(sum, truth) <= Dyadic::from_f64(fixed.error), "{kind} {round}");
            }
        }
    }
}

#[test]
fn turning_bodies_are_asked_without_a_pass() {
    let random = &mut Pcg64Mcg::seed_from_u64(29);
    let n = 1 << 15;
    let trees = [0; 2].map(|_| DirectionTree::new(&Zonotope::new([0.0; 3], body(0, n, random)).expect("finite")));
    for frame in 0..10 {
        let turn = |random: &mut Pcg64Mcg, t| Pose::from_axis_angle(vector(1.0, random), f64::from(frame), t);
        let from = turn(random, [0.0; 3]).expect("an axis");
        let way = vector(1.0, random);
        let to = |random: &mut Pcg64Mcg, t| turn(random, t).expect("an axis");
        let other = to(random, way);
        let gauge = trees[0].at(&from).gauge_between(&trees[1].at(&other)).value;
        for (factor, status) in [(0.5, Status::Inside), (1.0 - 1e-9, Status::Inside), (1.0 + 1e-9, Status::Outside)] {
            let moved = Pose::new(other.matrix(), way.map(|c| factor * c / gauge)).expect("finite");
            let mut counts = OperationCounts::default();
            let located = trees[0].at(&from).intersection(&trees[1].at(&moved), &mut counts);
            assert_eq!(located.status(), status);
            assert!(counts.get(Operation::GeneratorRead) < 2 * n as u64 / 6, "{counts:?}");
        }
    }
}
