//! Stretches of time and support values that prove a motion free, against the clearance.

use crate::definition::{Bound, Case, Experiment, FitPlan, Measurement, PerProfile, Quantity, Variant, Verdict};
use crate::fit::GrowthModel;
use crate::moving::MovingBodies;
use crate::seed::Digest;
use zonotope::motion::continuous::{FirstContact, Method};
use zonotope::tally::{Operation, OperationCounts};

/// Two times between which a contact would be.
const RESOLUTION: f64 = 1e-9;

/// The clearance at which methods are compared, as one over it.
const COMPARED: usize = 1000;

const PASSING: &[&str] =
    &["links", "two_turning_links", "both_spinning", "swing_180", "swing_360", "thin_bars", "orbit", "ring"];

const BESIDE: &[&str] = &["spinning_prism"];

const ALL: &[&str] = &[
    "links",
    "two_turning_links",
    "both_spinning",
    "swing_180",
    "swing_360",
    "thin_bars",
    "orbit",
    "ring",
    "spinning_prism",
];

const SIZES: &[usize] = &[10, 32, 100, 178, 316, 562, 1000, 1778, 3162, 5623, 10_000];

/// The methods; the volumes of the paper take a stretch for each part of the clearance.
const METHODS: &[Variant] = &[
    Variant::at_all_sizes("by_control_points", "Control points"),
    Variant::at_all_sizes("by_chord", "Chord and second derivative"),
    Variant::at_all_sizes("by_conservative_advancement", "Conservative advancement"),
    Variant {
        id: "by_space_time_volumes",
        title: "Theorem 6.1 and bisection",
        largest: PerProfile { quick: COMPARED, full: usize::MAX },
    },
];

const POWERS: &[GrowthModel] =
    &[GrowthModel::Constant, GrowthModel::FourthRoot, GrowthModel::SquareRoot, GrowthModel::Linear];

const STRETCHES: Quantity = Quantity::Value("intervals");
const SUPPORTS: Quantity = Quantity::Count("support_evaluation");

/// The growth with one over the clearance.
pub const GROWTH: Experiment = Experiment {
    id: "motion-clearance",
    title: "Motion: stretches of time against the clearance",
    question: "How many stretches of time prove that two moving bodies stay apart, and how many support values do they \
               take, when the bodies come as near as a clearance? n is one over the clearance. `intervals` are the \
               stretches of the proof, `tried` those that were looked at. Every answer must be that the bodies stay \
               apart; the proofs by control points are given to the verifier.",
    claims: &["interval-bisection"],
    families: ALL,
    sizes: PerProfile::both(SIZES),
    instances: PerProfile { quick: 3, full: 12 },
    variants: METHODS,
    measure,
    fits: &[
        FitPlan::new(STRETCHES, "by_control_points", PASSING, POWERS).within(Bound::own(GrowthModel::FourthRoot)),
        FitPlan::new(STRETCHES, "by_control_points", BESIDE, POWERS).within(Bound::own(GrowthModel::SquareRoot)),
        FitPlan::new(SUPPORTS, "by_control_points", ALL, POWERS),
        FitPlan::new(STRETCHES, "by_chord", ALL, POWERS),
        FitPlan::new(STRETCHES, "by_conservative_advancement", ALL, POWERS),
        FitPlan::new(SUPPORTS, "by_conservative_advancement", ALL, POWERS),
        FitPlan::new(STRETCHES, "by_space_time_volumes", ALL, POWERS),
    ],
    ..Experiment::COUNTED
};

/// The methods beside each other at one clearance.
pub const STRENGTH: Experiment = Experiment {
    id: "motion-strength",
    title: "Motion: the methods at one clearance",
    question: "How many stretches of time and support values do the methods take at a clearance of one thousandth? The \
               scenes are as large as a few units. `intervals` are the stretches of the proof, `tried` those that were \
               looked at, `supports` the support values of either body.",
    claims: &["interval-bisection"],
    families: ALL,
    sizes: PerProfile::both(&[COMPARED]),
    instances: PerProfile { quick: 21, full: 41 },
    variants: METHODS,
    measure,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let family = case.motion_family()?;
    let moving = MovingBodies::at_clearance(family, case.instance_seed, 1.0 / case.n as f64)?;
    let method = Method::from_id(case.variant).ok_or_else(|| format!("no method is called {}", case.variant))?;
    let mut counts = OperationCounts::default();
    let (bodies, motions) = (moving.bodies.each_ref(), moving.motions.each_ref());
    let found = method.first_contact(bodies, motions, RESOLUTION, &mut counts);
    let verdict = match (&found, method) {
        (_, Method::ByControlPoints) => moving.verdict_on_separate(RESOLUTION, &found),
        (FirstContact::Separate { .. }, _) => Verdict::Correct("least distance of samples".to_owned()),
        (other, _) => Verdict::Wrong(format!("the bodies are apart, and the answer is {}", other.name())),
    };
    let digest = Digest::default().floats(found.free().iter().map(|stretch| &stretch.until)).finish();
    let [tried, supports] =
        [Operation::Stretch, Operation::SupportEvaluation].map(|operation| counts.get(operation) as f64);
    Ok(Measurement::new(&counts, digest, verdict)
        .with_value("intervals", found.free().len() as f64)
        .with_value("tried", tried)
        .with_value("supports", supports))
}
