//! The cost of a frame of a motion, against its speed.

use super::collision_methods::PROVED;
use crate::definition::{
    Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, TimedWork, Timing, Variant, Verdict,
};
use crate::fit::GrowthModel;
use crate::seed::{self, Digest};
use crate::stopwatch::Stopwatch;
use std::f64::consts::TAU;
use zonotope::Pose;
use zonotope::collision::prepared::DirectionTree;
use zonotope::collision::tracking::{WalkingTracker, WarmTracker};
use zonotope::collision::{Location, Query, Status, by_lad};
use zonotope::interop::verifier::check_location;
use zonotope::tally::{Operation, OperationCounts, Tally};
use zonotope::zonotope::{PreparedBody, Zonotope};

/// Generators of each of the two bodies.
const GENERATORS: usize = 1024;

/// Frames of each motion.
const FRAMES: usize = 100;

/// By how much the gauge is above 1, and then below it, while one body goes around the other.
const GAP: f64 = 1e-3;

/// The operations that count as a read.
const READ: [Operation; 3] = [Operation::GeneratorRead, Operation::LineEvaluation, Operation::PartEvaluation];

/// Of one in so many frames the proof is checked.
const PROVED_FRAMES: usize = 10;

const FAMILIES: &[&str] = &["random_bodies", "heavy_tailed_bodies"];

const SIZES: PerProfile<&[usize]> = PerProfile {
    quick: &[1 << 3, 1 << 5, 1 << 7, 1 << 9, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15],
    full: &[1 << 3, 1 << 5, 1 << 7, 1 << 9, 1 << 11, 1 << 13, 1 << 15, 1 << 16, 1 << 17, 1 << 18, 1 << 19],
};

/// The cost of a frame of a motion, against its speed.
pub const EXPERIMENT: Experiment = Experiment {
    id: "coherence",
    title: "Tracking: a frame against the speed of motion",
    question: "What does a frame of a motion cost, against its speed? A body of 1,024 generators goes around another \
               one, apart from it by the part 1e-3 of the distance of touching and then as deep in it; n is the \
               number of frames that a whole turn would take, so that the speed is one over n, and each run has 100 \
               frames. `reads` a frame are generators and lines that are read: by a fresh query, by one to trees \
               over directions that are built once, and by the kernel that begins with the last frame's optimum. \
               `steps` a frame are the edges that walking crosses. The status of each frame is compared with the \
               construction, and of one frame in 10 the proof is checked.",
    claims: &["local-walk", "summary-repeated-tests"],
    families: FAMILIES,
    sizes: SIZES,
    instances: PerProfile { quick: 1, full: 2 },
    variants: &[
        Variant::at_all_sizes("warm", "Kernel with the last frame's optimum"),
        Variant::at_all_sizes("fresh", "Fresh query"),
        Variant::at_all_sizes("trees", "Fresh query to trees over directions"),
        Variant::at_all_sizes("walking", "Walk to the closest feature"),
    ],
    measure,
    timing: Some(Timing { sizes: SIZES, repetitions: PerProfile::both(3), prepare }),
    fits: &[
        FitPlan::new(Quantity::Value("reads"), "warm", FAMILIES, GrowthModel::FALLING),
        FitPlan::new(Quantity::Value("steps"), "walking", FAMILIES, GrowthModel::FALLING),
    ],
    ..Experiment::COUNTED
};

/// Two bodies, and where the second one's centre is in each frame: first apart from the other body, then in it.
struct Motion {
    bodies: [PreparedBody; 2],
    /// For the variant that asks trees.
    trees: Option<[DirectionTree; 2]>,
    places: Vec<[f64; 3]>,
}

/// The answer of a frame: its status, and the proof when it is asked for.
struct Frame {
    status: Status,
    location: Option<Location<3>>,
    steps: u64,
    counts: OperationCounts,
}

impl Motion {
    fn of(case: &Case) -> Result<Self, String> {
        let body = |part: &str| {
            let generators = case.body_family()?.generate(GENERATORS, seed::seed_of(case.instance_seed, part));
            Zonotope::new([0.0; 3], generators).map_err(|error| error.to_string())
        };
        let (fixed, moving) = (body("fixed")?, body("moving")?);
        let sum = fixed.minkowski_sum_with_reflection(&moving).map_err(|error| error.to_string())?;
        let place = |frame: usize| {
            let (sine, cosine) = libm::sincos(TAU * frame as f64 / case.n as f64);
            let direction = [cosine, sine, 0.3];
            let gauge = sum.gauge(direction).map_err(|error| error.to_string())?.value;
            let factor = if Self::is_apart(frame) { 1.0 + GAP } else { 1.0 - GAP };
            Ok(direction.map(|c| c / gauge * factor))
        };
        let places = (0..FRAMES).map(place).collect::<Result<_, String>>()?;
        let trees = (case.variant == "trees").then(|| [&fixed, &moving].map(DirectionTree::new));
        Ok(Self { bodies: [fixed, moving].map(PreparedBody::new), trees, places })
    }

    fn is_apart(frame: usize) -> bool {
        frame < FRAMES / 2
    }

    /// Follows the motion by a variant; of one frame in `proved` the proof is asked for.
    fn follow(&self, variant: &str, proved: usize, is_counted: bool) -> Result<Vec<Frame>, String> {
        let [fixed, moving] = &self.bodies;
        let still = Pose::IDENTITY;
        let pose = |place: &[f64; 3]| Pose::from_translation(*place).map_err(|error| error.to_string());
        let mut frames = Vec::with_capacity(self.places.len());
        let mut warm = WarmTracker::new(fixed, moving);
        let mut walking = match variant {
            "walking" => Some(WalkingTracker::new(fixed.body(), moving.body()).map_err(|error| error.to_string())?),
            _ => None,
        };
        for (frame, place) in self.places.iter().enumerate() {
            let is_proved = frame % proved == 0;
            let mut counts = OperationCounts::default();
            let tally: &mut dyn Tally = if is_counted { &mut counts } else { &mut () };
            let (status, location, steps) = match (&mut walking, &self.trees) {
                (Some(tracker), _) => {
                    let walked = tracker.frame([0.0; 3], *place).map_err(|error| error.to_string())?;
                    let location = is_proved.then(|| walked.location());
                    (walked.status(), location, walked.steps())
                }
                (None, Some([fixed, moving])) => {
                    let located = fixed.at(&still).intersection(&moving.at(&pose(place)?), tally);
                    (located.status(), is_proved.then(|| located.expand()), 0)
                }
                (None, None) if variant == "warm" => {
                    let tracked = warm.frame(&still, &pose(place)?, tally);
                    let location = is_proved.then(|| tracked.location());
                    (tracked.status(), location, 0)
                }
                (None, None) => {
                    let query = Query::of_placed(fixed.at(&still), moving.at(&pose(place)?));
                    let location = by_lad::locate(&query, tally);
                    (location.status(), is_proved.then_some(location), 0)
                }
            };
            frames.push(Frame { status, location, steps, counts });
        }
        Ok(frames)
    }

    /// Whether a frame has the status of the construction, and its proof holds if there is one.
    fn verdict(&self, index: usize, frame: &Frame) -> Result<Verdict, String> {
        let expected = if Self::is_apart(index) { Status::Outside } else { Status::Inside };
        if frame.status != expected {
            return Ok(Verdict::Wrong(format!("frame {index} is {}", frame.status)));
        }
        let Some(location) = &frame.location else { return Ok(Verdict::Correct(PROVED.to_owned())) };
        let [fixed, moving] = self.bodies.each_ref().map(PreparedBody::body);
        let moved = moving.translated(self.places[index]).map_err(|error| error.to_string())?;
        Ok(Verdict::of_verifier(PROVED, check_location(&Query::between(fixed, &moved), location)))
    }
}

fn digest(frames: &[Frame]) -> u64 {
    frames.iter().fold(Digest::default(), |digest, frame| digest.bytes(frame.status.name().as_bytes())).finish()
}

fn measure(case: &Case) -> Result<Measurement, String> {
    let motion = Motion::of(case)?;
    let frames = motion.follow(case.variant, PROVED_FRAMES, true)?;
    let mut verdict = Verdict::Correct(PROVED.to_owned());
    for (index, frame) in frames.iter().enumerate() {
        verdict = verdict.and(motion.verdict(index, frame)?);
    }
    let mut counts = OperationCounts::default();
    for (operation, count) in frames.iter().flat_map(|frame| frame.counts.iter()) {
        counts.add(operation, count);
    }
    // the first frame of either half has none before it
    let followed = frames.iter().enumerate().filter(|(index, _)| index % (FRAMES / 2) != 0).map(|(_, frame)| frame);
    let reads = |frame: &Frame| READ.map(|operation| frame.counts.get(operation)).iter().sum::<u64>();
    let (name, work): (&str, Vec<u64>) = match case.variant {
        "walking" => ("steps", followed.map(|frame| frame.steps).collect()),
        _ => ("reads", followed.map(reads).collect()),
    };
    let mean = work.iter().sum::<u64>() as f64 / work.len() as f64;
    Ok(Measurement::new(&counts, digest(&frames), verdict).with_value(name, mean))
}

fn prepare(case: &Case) -> Result<TimedWork, String> {
    let motion = Motion::of(case)?;
    let variant = case.variant;
    Ok(Box::new(move |stopwatch: &mut Stopwatch| {
        let frames = stopwatch.lap("frames", || motion.follow(variant, usize::MAX, false))?;
        Ok(digest(&frames))
    }))
}
