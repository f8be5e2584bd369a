//! Two copies of a mesh that move fast: the first contact by this library and by the nonlinear cast of parry3d-f64.
//!
//! Motions of this library are rational, those of parry turn at constant rate; they have the same end poses and differ
//! a little between. The cast is therefore judged by its own motion alone: a contact is missed, or told late, where the
//! meshes overlap, exactly, at a sampled time of that motion before; it is invented where they are clearly apart at the
//! time that is told.

use std::time::Instant;

use anyhow::{Context, Error};
use experiments::hierarchies::{Course, MovedMesh, mesh, middles_apart};
use families::source::RandomSource;
use parry3d_f64::query::{NonlinearRigidMotion, cast_shapes_nonlinear, intersection_test};
use zonotope::Pose;
use zonotope::bvh::{Aabb, OrientedBox, Zonotope4};
use zonotope::motion::Motion;

use super::our_motions::{Tallied, closest, race as race_ours};
use super::parry;

/// The small meshes.
const MESHES: [&str; 6] = ["teapot", "torus", "knot", "bumps", "spring", "needles"];

/// The greatest turns of a body in a step, in degrees.
const TURNS: [u32; 2] = [60, 180];

/// Sampled times of the motion of a cast.
const SAMPLES: usize = 200;

/// A contact is told late if its time is beyond an overlap by more than this.
const LATE: f64 = 1e-3;

/// A contact is invented if the meshes are farther apart than this share of the diagonal when it is told.
const APART: f64 = 1e-3;

/// No cast begins when those of a mesh and greatest turn have taken so many seconds.
const LONGEST: f64 = 45.0;

/// The columns of the table; those after `p90_us` are of motions without a contact alone.
const COLUMNS: &str = "mesh,turn,method,case,motions,p50_us,p90_us,nodes_p50,static_nodes_p50,nodes_ratio_p50,\
    nodes_ratio_p90,time_ratio_p50,time_ratio_p90";

/// The findings of the casts of a mesh and greatest turn.
#[derive(Default)]
struct Casts {
    /// Microseconds of those without a contact and with one.
    times: [Vec<f64>; 2],
    overlaps: usize,
    missed: usize,
    /// Those missed where the static test of parry says that the meshes meet at the sampled time.
    confirmed: usize,
    late: usize,
    invented: usize,
    /// Casts that are not answered.
    refused: usize,
}

/// Prints the race over all small meshes, `count` motions without an overlap and as many that come nearer.
pub fn race(count: usize) -> anyhow::Result<()> {
    println!(
        "moving meshes: {count} motions 1 % apart and {count} nearer of each mesh and greatest turn, seed 1; casts: {}",
        format_args!("no more of a mesh and greatest turn after {LONGEST} s")
    );
    println!("{COLUMNS}");
    for name in MESHES {
        let body = MovedMesh::of(&mesh(name).map_err(Error::msg)?).map_err(Error::msg)?;
        for turn in TURNS {
            let mut source = RandomSource::new(1);
            let pairs = (0..count).map(|_| body.courses(&mut source, f64::from(turn).to_radians()));
            let pairs = pairs.collect::<Result<Vec<_>, String>>().map_err(Error::msg)?.into_flattened();
            let motions = pairs.iter().map(|[a, b]| Ok([a.rational()?, b.rational()?]));
            let motions = motions.collect::<Result<Vec<[Motion; 2]>, String>>().map_err(Error::msg)?;
            let times = closest(&body, &motions)?;
            for tallied in [
                race_ours::<Aabb>(&body, &motions, &times)?,
                race_ours::<OrientedBox>(&body, &motions, &times)?,
                race_ours::<Zonotope4>(&body, &motions, &times)?,
            ] {
                print_ours(name, turn, &tallied);
            }
            print_theirs(name, turn, &casts(&body, &pairs)?);
        }
    }
    Ok(())
}

fn casts(body: &MovedMesh, pairs: &[[Course; 2]]) -> anyhow::Result<Casts> {
    let shape = parry::mesh(&body.mesh)?;
    let mut casts = Casts::default();
    let mut spent = 0.0;
    for pair in pairs {
        if spent > LONGEST {
            break;
        }
        let [a, b] = pair.each_ref().map(parry::at_constant_rate);
        let start = Instant::now();
        let cast = cast_shapes_nonlinear(&a, &shape, &b, &shape, 0.0, 1.0, true);
        let time = start.elapsed().as_secs_f64();
        spent += time;
        let Ok(hit) = cast else {
            casts.refused += 1;
            continue;
        };
        let hit = hit.map(|hit| hit.time_of_impact);
        casts.times[usize::from(hit.is_some())].push(1e6 * time);
        let poses = |time: f64| Some([placed(&a, time)?, placed(&b, time)?]);
        let overlap = first_overlap(body, poses)?;
        casts.overlaps += usize::from(overlap.is_some());
        match (hit, overlap) {
            (None, Some(overlap)) => {
                casts.missed += 1;
                let [a, b] = [&a, &b].map(|motion| motion.position_at_time(overlap));
                let meets = intersection_test(&a, &shape, &b, &shape);
                casts.confirmed += usize::from(meets.is_ok_and(|test| test.intersecting));
            }
            (Some(hit), Some(overlap)) if hit > overlap + LATE => casts.late += 1,
            (Some(hit), _) => {
                let [a, b] = poses(hit).context("a pose leaves the range of doubles")?;
                let distance = body.boxes.at(&a).distance(body.boxes.at(&b)).lower;
                casts.invented += usize::from(distance > APART * body.diagonal);
            }
            (None, None) => {}
        }
    }
    Ok(casts)
}

/// The pose of a motion of parry at a time.
fn placed(motion: &NonlinearRigidMotion, time: f64) -> Option<Pose> {
    let pose = motion.position_at_time(time);
    let q = pose.rotation;
    Pose::from_quaternion([q.w, q.x, q.y, q.z], pose.translation.to_array()).ok()
}

/// The first sampled time at which the meshes overlap.
fn first_overlap(body: &MovedMesh, poses: impl Fn(f64) -> Option<[Pose; 2]>) -> anyhow::Result<Option<f64>> {
    for i in 0..=SAMPLES {
        let time = i as f64 / SAMPLES as f64;
        let [a, b] = poses(time).context("a pose leaves the range of doubles")?;
        if middles_apart(&[a, b]) <= body.diagonal && body.boxes.at(&a).intersects(body.boxes.at(&b)) {
            return Ok(Some(time));
        }
    }
    Ok(None)
}

fn percentile(values: &[f64], percent: usize) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted.get((sorted.len().max(1) - 1) * percent / 100).copied().unwrap_or(f64::NAN)
}

fn print_ours(name: &str, turn: u32, tallied: &Tallied) {
    for (case, times) in ["separate", "contact", "grazing"].into_iter().zip(&tallied.times) {
        if times.is_empty() {
            continue;
        }
        let [p50, p90] = [50, 90].map(|percent| percentile(times, percent));
        print!("{name},{turn},{},{case},{},{p50:.0},{p90:.0}", tallied.name, times.len());
        if case == "separate" {
            let [nodes, of_static] = [&tallied.nodes, &tallied.static_nodes].map(|nodes| percentile(nodes, 50));
            print!(",{nodes:.0},{of_static:.0}");
            for ratios in &tallied.ratios {
                let [p50, p90] = [50, 90].map(|percent| percentile(ratios, percent));
                print!(",{p50:.2},{p90:.2}");
            }
        }
        println!();
    }
}

fn print_theirs(name: &str, turn: u32, casts: &Casts) {
    for (case, times) in ["no hit", "hit"].into_iter().zip(&casts.times) {
        let [p50, p90] = [50, 90].map(|percent| percentile(times, percent));
        println!("{name},{turn},parry3d-f64,{case},{},{p50:.0},{p90:.0}", times.len());
    }
    let asked = casts.times.iter().map(Vec::len).sum::<usize>();
    println!(
        "# {name} {turn}: of {asked} casts {} overlap when sampled; {} missed ({} by its static test), {} late{}",
        casts.overlaps,
        casts.missed,
        casts.confirmed,
        casts.late,
        format_args!(", {} invented, {} refused", casts.invented, casts.refused),
    );
}
