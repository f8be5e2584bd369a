//! The collisions of fast boxes that the nonlinear cast of parry3d in doubles misses, on its own boxes, and the times of
//! both. The first contact by control points proves each collision by a common point and each pass by directions.
//!
//! `cargo run --release -p peers --features others --example nonlinear_cast -- 20000`

use std::hint::black_box;
use std::time::Instant;

use anyhow::{Context, ensure};
use families::motions::{BodyRow, Course, MovingPair, find};
use parry3d_f64::glamx::{DMat3, DQuat, DVec3};
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{NonlinearRigidMotion, cast_shapes_nonlinear};
use parry3d_f64::shape::Cuboid;
use zonotope::motion::Motion;
use zonotope::motion::continuous::{FirstContact, first_contact};
use zonotope::zonotope::Zonotope;

/// Motions that are asked about if no number is given.
const MOTIONS: u64 = 20_000;

/// The least of so many rounds is the time of a question.
const ROUNDS: u32 = 3;

/// A contact is told later than it is if its time is beyond ours by more than this.
const LATE: f64 = 1e-3;

/// A box with the axes of its generators, and where it is.
fn cuboid(row: &BodyRow) -> anyhow::Result<(Cuboid, Pose)> {
    let sides: Vec<DVec3> = row.generators.iter().map(|g| DVec3::from_array(*g)).collect();
    let [x, y, z] = sides[..] else { anyhow::bail!("a box has three generators") };
    let halves = [x, y, z].map(DVec3::length);
    let (first, second) = (x / halves[0], y / halves[1]);
    let third = first.cross(second);
    ensure!((third.dot(z).abs() - halves[2]).abs() < 1e-9, "the sides of a box are orthogonal");
    let rotation = DQuat::from_mat3(&DMat3::from_cols(first, second, third));
    let [cx, cy, cz] = row.center;
    Ok((Cuboid::new(Vector::from_array(halves)), Pose::from_parts(Vector::new(cx, cy, cz), rotation)))
}

fn cast_motion(course: &Course, start: Pose) -> NonlinearRigidMotion {
    let axis = DVec3::from_array(course.axis).normalize();
    let point = Vector::from_array(course.axis_point);
    let turning = Vector::from_array((axis * course.angle).to_array());
    NonlinearRigidMotion::new(start, start.inverse() * point, Vector::from_array(course.translation), turning)
}

/// An answer and the least time in microseconds in which it was given.
fn timed<T>(ask: impl Fn() -> T) -> (T, f64) {
    let once = || {
        let start = Instant::now();
        let answer = black_box(ask());
        (answer, start.elapsed().as_secs_f64() * 1e6)
    };
    (1..ROUNDS).map(|_| once()).fold(once(), |best, next| if next.1 < best.1 { next } else { best })
}

fn ours(pair: &MovingPair) -> anyhow::Result<(FirstContact, f64)> {
    let body = |row: &BodyRow| Zonotope::new(row.center, row.generators.clone());
    let bodies = [body(&pair.bodies[0])?, body(&pair.bodies[1])?];
    let motion =
        |course: &Course| Motion::constant_rate(course.axis_point, course.axis, course.angle, course.translation);
    let motions = [motion(&pair.courses[0])?, motion(&pair.courses[1])?];
    Ok(timed(|| first_contact(bodies.each_ref(), motions.each_ref())))
}

/// The time of the contact that the cast finds.
fn theirs(pair: &MovingPair) -> anyhow::Result<(Option<f64>, f64)> {
    let [(a, from), (b, to)] = [cuboid(&pair.bodies[0])?, cuboid(&pair.bodies[1])?];
    let (first, second) = (cast_motion(&pair.courses[0], from), cast_motion(&pair.courses[1], to));
    let (hit, time) = timed(|| cast_shapes_nonlinear(&first, &a, &second, &b, 0.0, 1.0, true));
    Ok((hit.map_err(|_| anyhow::anyhow!("two boxes are not cast"))?.map(|hit| hit.time_of_impact), time))
}

fn percentiles(mut times: Vec<f64>) -> [f64; 3] {
    times.sort_unstable_by(f64::total_cmp);
    [50, 90, 99].map(|percent| times.get((times.len().max(1) - 1) * percent / 100).copied().unwrap_or(f64::NAN))
}

fn main() -> anyhow::Result<()> {
    let count = std::env::args().nth(1).map_or(Ok(MOTIONS), |count| count.parse())?;
    let family = find("fast_boxes").context("the family of fast boxes")?;
    let [mut collisions, mut missed, mut late, mut invented, mut grazing] = [0_u64; 5];
    let mut times: [[Vec<f64>; 2]; 2] = Default::default();
    for seed in 0..count {
        let pair = family.generate(seed);
        let ((found, own_time), (hit, their_time)) = (ours(&pair)?, theirs(&pair)?);
        let is_contact = match &found {
            FirstContact::Contact { time, .. } => {
                collisions += 1;
                missed += u64::from(hit.is_none());
                late += u64::from(hit.is_some_and(|hit| hit > time[1] + LATE));
                true
            }
            FirstContact::Separate { .. } => {
                invented += u64::from(hit.is_some());
                false
            }
            FirstContact::Grazing { .. } => {
                grazing += 1;
                continue;
            }
        };
        let [own, others] = &mut times[usize::from(is_contact)];
        own.push(own_time);
        others.push(their_time);
    }
    println!("{count} motions of fast boxes, {collisions} collisions, {grazing} not decided");
    println!("parry3d-f64: {missed} collisions missed, {late} told late by more than {LATE}, {invented} invented");
    for (case, [own, others]) in ["passes", "collisions"].into_iter().zip(times) {
        for (name, times) in [("by_control_points", own), ("parry3d-f64", others)] {
            let [half, most, nearly_all] = percentiles(times);
            println!("{case:<10} {name:<17} p50 {half:>8.2} µs  p90 {most:>8.2} µs  p99 {nearly_all:>8.2} µs");
        }
    }
    Ok(())
}
