//! The cost of a frame against the speed of a motion, in microseconds: both trackers, a fresh query of the same
//! prepared bodies, and the GJK of parry3d in doubles from scratch and from its last direction. All methods answer each
//! frame one after the other; a fresh query writes its proof, the trackers write theirs on request.
//!
//! `cargo run --release -p peers --features others --example coherence -- 1000 100000`

use std::hint::black_box;
use std::time::Instant;

use anyhow::Context;
use families::bodies::find;
use families::source::RandomSource;
use parry3d_f64::glamx::{DMat3, DQuat, DVec3};
use parry3d_f64::math::{Pose as ParryPose, Vector};
use parry3d_f64::query::details::intersection_test_support_map_support_map_with_params;
use parry3d_f64::query::gjk::VoronoiSimplex;
use zonotope::Pose;
use zonotope::collision::tracking::{WalkingTracker, WarmTracker};
use zonotope::collision::{Query, by_lad};
use zonotope::zonotope::{PreparedBody, Zonotope};

const SIZES: [usize; 4] = [100, 1_000, 10_000, 100_000];

/// Radians a frame, or the part of the distance of the centres.
const SPEEDS: [f64; 6] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];

/// The gauge of the displacement less 1.
const EXCESSES: [f64; 6] = [0.05, 1e-3, 1e-9, -1e-9, -1e-3, -0.05];

const FRAMES: usize = 220;

/// The first frames are not timed.
const FIRST_TIMED: usize = 20;

/// A pass is one support value of both bodies.
const METHODS: [&str; 6] = ["pass", "fresh", "warm_kernel", "walking", "gjk", "gjk_warm"];

/// A motion with a gap that stays.
#[derive(Clone, Copy)]
struct Motion {
    spins: bool,
    excess: f64,
    speed: f64,
}

impl Motion {
    /// The poses of both bodies in each frame.
    fn frames(self, bodies: &[PreparedBody; 2]) -> anyhow::Result<Vec<[Pose; 2]>> {
        let mut source = RandomSource::new(7);
        let mut vector = || [0, 1, 2].map(|_| source.signed_unit());
        let (start, way, axes) = (vector(), vector(), [vector(), vector()]);
        let frame = |i: usize| {
            let time = self.speed * i as f64;
            let (turn, slide) = if self.spins { (time, 0.0) } else { (0.0, time) };
            let pose = |axis| match self.spins {
                true => Pose::from_axis_angle(axis, turn, [0.0; 3]),
                false => Ok(Pose::IDENTITY),
            };
            let (from, turned) = (pose(axes[0])?, pose(axes[1])?);
            let direction = [0, 1, 2].map(|k| start[k] + slide * way[k]);
            let at = |distance: f64| Pose::new(turned.matrix(), direction.map(|c| c * distance));
            let unit = at(1.0)?;
            let gauge = by_lad::gauge(&Query::of_placed(bodies[0].at(&from), bodies[1].at(&unit)), &mut ()).value;
            Ok([from, at((1.0 + self.excess) / gauge)?])
        };
        (0..FRAMES).map(frame).collect()
    }
}

/// The second body as the first one sees it.
fn relative([first, second]: &[Pose; 2]) -> ParryPose {
    let own = |pose: &Pose| {
        let m = pose.matrix();
        let column = |k: usize| DVec3::new(m[0][k], m[1][k], m[2][k]);
        let [x, y, z] = pose.translation();
        let rotation = DQuat::from_mat3(&DMat3::from_cols(column(0), column(1), column(2)));
        ParryPose::from_parts(Vector::new(x, y, z), rotation)
    };
    own(first).inverse() * own(second)
}

/// The times of each method, and how many answers of ours and of GJK were not those of the fresh query.
#[derive(Default)]
struct Outcome {
    times: [Vec<f64>; METHODS.len()],
    wrong: [usize; 2],
}

impl Outcome {
    fn timed<T>(&mut self, method: usize, frame: usize, run: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = black_box(run());
        let time = start.elapsed().as_nanos() as f64 / 1000.0;
        if frame >= FIRST_TIMED {
            self.times[method].push(time);
        }
        result
    }
}

fn run(bodies: &[PreparedBody; 2], motion: Motion) -> anyhow::Result<Outcome> {
    let mut outcome = Outcome::default();
    let [first, second] = bodies;
    let mut warm = WarmTracker::new(first, second);
    let mut walking = match motion.spins {
        true => None,
        false => Some(WalkingTracker::new(first.body(), second.body())?),
    };
    let mut last: Option<Vector> = None;
    for (i, [from, to]) in motion.frames(bodies)?.iter().enumerate() {
        let direction = black_box([0.1, 0.3, -0.7]);
        outcome.timed(0, i, || first.absolute_sum(&direction) + second.absolute_sum(&direction));
        let query = Query::of_placed(first.at(from), second.at(to));
        let truth = outcome.timed(1, i, || by_lad::locate(&query, &mut ()).is_member());
        let mut own = vec![outcome.timed(2, i, || warm.frame(from, to, &mut ()).is_member())];
        if let Some(walking) = &mut walking {
            let frame = outcome.timed(3, i, || walking.frame(from.translation(), to.translation()));
            own.push(frame.context("a place is not finite")?.is_member());
        }
        let pose = relative(&[*from, *to]);
        let ask = |init| {
            let simplex = &mut VoronoiSimplex::new();
            intersection_test_support_map_support_map_with_params(&pose, first, second, simplex, init)
        };
        let (cold, _) = outcome.timed(4, i, || ask(None));
        let (cached, direction) = outcome.timed(5, i, || ask(last));
        last = Some(direction);
        outcome.wrong[0] += own.iter().filter(|answer| **answer != truth).count();
        outcome.wrong[1] += [cold, cached].iter().filter(|answer| **answer != truth).count();
    }
    Ok(outcome)
}

fn main() -> anyhow::Result<()> {
    let asked: Vec<usize> = std::env::args().skip(1).map(|n| n.parse()).collect::<Result<_, _>>()?;
    let family = find("random_bodies").context("the family of random bodies")?;
    println!("      n motion  excess  speed method             p50       p99       max  wrong");
    for n in if asked.is_empty() { SIZES.to_vec() } else { asked } {
        let body = |seed| Zonotope::new([0.0; 3], family.generate(n / 2, seed)).map(PreparedBody::new);
        let bodies = [body(1)?, body(2)?];
        for spins in [false, true] {
            for excess in EXCESSES {
                for speed in SPEEDS {
                    let Outcome { times, wrong } = run(&bodies, Motion { spins, excess, speed })?;
                    for (place, (method, mut times)) in METHODS.into_iter().zip(times).enumerate() {
                        times.sort_unstable_by(f64::total_cmp);
                        let Some(longest) = times.last() else { continue };
                        let [half, most] = [50, 99].map(|percent| times[(times.len() - 1) * percent / 100]);
                        let wrong = wrong[usize::from(place > 3)];
                        let motion = if spins { "spin" } else { "slide" };
                        let case = format!("{n:>7} {motion:<6} {excess:>7.0e} {speed:>6.0e} {method:<12}");
                        println!("{case} {half:>9.2} {most:>9.2} {longest:>9.2} {wrong:>6}");
                    }
                }
            }
        }
    }
    Ok(())
}
