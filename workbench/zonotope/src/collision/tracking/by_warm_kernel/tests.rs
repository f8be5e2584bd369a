//! What a tracker reads, and the sums near a direction.

use super::WarmTracker;
use super::local_sums::LocalSums;
use crate::collision::by_lad::locate;
use crate::collision::{Query, Status, by_lad};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::dot;
use crate::tally::{Operation, OperationCounts};
use crate::zonotope::pose::Pose;
use crate::zonotope::{PreparedBody, Zonotope};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const GENERATORS: usize = 4000;

fn vector(random: &mut Pcg64Mcg) -> [f64; 3] {
    [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64))
}

fn body(random: &mut Pcg64Mcg, count: usize) -> PreparedBody {
    PreparedBody::new(Zonotope::new([0.0; 3], (0..count).map(|_| vector(random)).collect()).expect("finite"))
}

/// The poses of frames in which both bodies turn by an angle about axes of their own, and the gauge of their
/// displacement along a direction is as given.
fn spinning(bodies: &[PreparedBody; 2], angle: f64, gauges: impl Iterator<Item = f64>) -> Vec<[Pose; 2]> {
    let direction = [1.0, 0.4, -0.2];
    let frame = |(i, gauge): (usize, f64)| {
        let turned =
            |axis, times: f64| Pose::from_axis_angle(axis, times * i as f64 * angle, [0.0; 3]).expect("an axis");
        let [from, to] = [turned([1.0, 2.0, 3.0], 1.0), turned([0.0, 1.0, -1.0], -0.7)];
        let at = |distance: f64| Pose::new(to.matrix(), direction.map(|c| c * distance)).expect("finite");
        let unit = by_lad::gauge(&Query::of_placed(bodies[0].at(&from), bodies[1].at(&at(1.0))), &mut ()).value;
        [from, at(gauge / unit)]
    };
    gauges.enumerate().map(frame).collect()
}

/// The generators read by a tracker and by fresh queries, after some frames to warm up.
fn reads(bodies: &[PreparedBody; 2], frames: &[[Pose; 2]], warm_up: usize) -> [u64; 2] {
    let mut tracker = WarmTracker::new(&bodies[0], &bodies[1]);
    let mut totals = [0; 2];
    for (i, [from, to]) in frames.iter().enumerate() {
        let mut counts = [OperationCounts::default(); 2];
        let tracked = tracker.frame(from, to, &mut counts[0]);
        let query = Query::of_placed(bodies[0].at(from), bodies[1].at(to));
        assert_eq!(tracked.status(), locate(&query, &mut counts[1]).status());
        if i >= warm_up {
            [0, 1].into_iter().for_each(|k| totals[k] += counts[k].get(Operation::GeneratorRead));
        }
    }
    totals
}

#[test]
fn near_contact_a_slow_motion_reads_few_generators() {
    let random = &mut Pcg64Mcg::seed_from_u64(1);
    let bodies = [body(random, GENERATORS), body(random, GENERATORS)];
    let gauges = (0..80).map(|i| 1.0 + if i % 2 == 0 { 1e-9 } else { -1e-9 });
    let [own, fresh] = reads(&bodies, &spinning(&bodies, 1e-5, gauges), 16);
    assert!(16 * own < fresh, "{own} {fresh}");
}

#[test]
fn what_is_clear_stays_clear_without_a_read() {
    let random = &mut Pcg64Mcg::seed_from_u64(2);
    let bodies = [body(random, GENERATORS), body(random, GENERATORS)];
    for gauge in [0.5, 2.0] {
        let frames = spinning(&bodies, 1e-5, (0..80).map(|i| gauge + 1e-5 * f64::from(i)));
        assert_eq!(reads(&bodies, &frames, 8)[0], 0, "{gauge}");
    }
}

#[test]
fn frames_that_have_nothing_in_common_cost_hardly_more_than_fresh_queries() {
    let random = &mut Pcg64Mcg::seed_from_u64(3);
    let bodies = [body(random, GENERATORS), body(random, GENERATORS)];
    let gauges: Vec<f64> = (0..300).map(|_| random.random_range(0.2..2.0)).collect();
    let [own, fresh] = reads(&bodies, &spinning(&bodies, 1.0, gauges.into_iter()), 0);
    assert!(10 * own < 12 * fresh, "{own} {fresh}");
}

#[test]
fn proofs_of_all_kinds_of_frames_are_written() {
    let random = &mut Pcg64Mcg::seed_from_u64(4);
    let bodies = [body(random, 90), body(random, 100)];
    let mut tracker = WarmTracker::new(&bodies[0], &bodies[1]);
    let gauges = (0..60).map(|i| [0.5, 0.51, 0.999, 1.0 - 1e-9, 1.001, 1.7, 1.69][i / 9]);
    let mut seen = [0; 2];
    for [from, to] in spinning(&bodies, 1e-4, gauges) {
        let tracked = tracker.frame(&from, &to, &mut ());
        let location = tracked.location();
        assert_eq!(location.status(), tracked.status());
        assert_eq!(location.status(), locate(tracked.query(), &mut ()).status());
        seen[usize::from(tracked.status() == Status::Inside)] += 1;
    }
    assert!(seen.iter().all(|&count| count > 10), "{seen:?}");
}

#[test]
fn local_sums_are_those_of_a_pass() {
    let random = &mut Pcg64Mcg::seed_from_u64(5);
    let list: Vec<[f64; 3]> = (0..3000).map(|_| vector(random)).collect();
    let rows = Rows::new(&list);
    let mut sums = LocalSums::default();
    let mut direction = [0.3, -0.8, 0.5];
    let mut least_read = usize::MAX;
    for i in 0..200 {
        let step = vector(random);
        let size = if i % 50 == 49 { 1.0 } else { 1e-4 };
        direction = [0, 1, 2].map(|k| direction[k] + size * step[k]);
        sums.center_on(rows, direction, 1e-3);
        let radius = [1e-4, 5e-4, 0.05, 0.5][i % 4];
        let off = vector(random);
        let center = [0, 1, 2].map(|k| 7.0 * (direction[k] + 1e-4 * off[k]));
        let axes = (i % 3 == 0).then_some([[radius, 0.0, 0.0], [0.0, 0.1 * radius, radius]]);
        let cell = DirectionCone { center, axes, ball: radius };
        let (mut places, mut all) = (Places::new(), Places::new());
        let (own, whole) = (sums.split(rows, &cell, &mut places), cell.split(rows, &mut all));
        // a pass allows for an ellipse generously, and the cell of the sums may tell that a generator misses it
        assert!(places.iter().all(|place| all.contains(place)) && (axes.is_some() || places == all));
        let is_near = |k: usize| (own.sum[k] - whole.sum[k]).abs() <= own.error + whole.error;
        assert!(places != all || (0..3).all(is_near));
        least_read = least_read.min(own.read);
        let sign = |v: &[f64; 3]| f64::copysign(1.0, dot(v, &cell.center));
        let sum = (0..list.len() as u32).filter(|i| !places.contains(i)).fold([0.0; 3], |sum, i| {
            let v = &list[i as usize];
            [0, 1, 2].map(|k| sum[k] + sign(v) * v[k])
        });
        assert!((0..3).all(|k| (own.sum[k] - sum[k]).abs() < 1e-9));
    }
    assert!(least_read < 100, "{least_read}");
}
