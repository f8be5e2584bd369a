//! Whether the kernel's methods find the same exact minimum, on ordinary and on degenerate lines.

use super::REAL_INPUTS;
use super::kernel_methods::{self, KernelInput};
use crate::definition::{Case, Experiment, Measurement, PerProfile, Verdict};
use zonotope::interop::verifier::check_lad;
use zonotope::lad::{LadOutcome, LadProblem, Method};
use zonotope::tally::OperationCounts;

/// Up to this many lines the reference is the exact twin, of cost n^3.
const TWIN_LIMIT: usize = 24;

/// Whether the kernel's methods find the same exact minimum.
pub const EXPERIMENT: Experiment = Experiment {
    id: "methods-agree",
    title: "Least absolute deviations kernel: agreement of the methods",
    question: "Do the methods of the kernel agree, on ordinary and on degenerate lines? Every method's certificate \
               goes to the exact verifier, and its minimum, as a rational number, and the dimension of the set of \
               minimisers are compared with those of the exact twin (for 24 lines or fewer) or of another method \
               (beyond).",
    claims: &["theorem-4.5", "corollary-4.4", "ties-of-candidates", "minimum-at-vertex"],
    families: &[
        "random_lines",
        "lattice_lines",
        "near_parallel_lines",
        "concurrent_lines",
        "symmetric_lines",
        "circle",
        "ellipse_thin",
        "random_convex",
        "regular_polygon",
        "symmetric",
        "gaussian",
        "lattice",
    ],
    real_inputs: REAL_INPUTS,
    sizes: PerProfile { quick: &[4, 8, 15, 24, 256, 2048], full: &[4, 5, 8, 11, 15, 19, 24, 64, 256, 2048, 16384] },
    instances: PerProfile { quick: 4, full: 8 },
    variants: kernel_methods::VARIANTS,
    measure,
    ..Experiment::COUNTED
};

fn measure(case: &Case) -> Result<Measurement, String> {
    let method = kernel_methods::method(case)?;
    KernelInput::of(case)?.with_problem(|problem| {
        let mut counts = OperationCounts::default();
        let outcome = method.minimize(problem, case.seed, &mut counts);
        let (reference, agreement) = compare(method, case.seed, problem, &outcome);
        let verdict = match Verdict::of_verifier("check_lad", check_lad(problem, &outcome)) {
            Verdict::Correct(check) => Verdict::of_check(&format!("{check} and {reference}"), agreement),
            unproved => unproved,
        };
        let measurement = Measurement::new(&counts, kernel_methods::digest(problem, &outcome), verdict)
            .with_value("lines", problem.len() as f64);
        Ok(match outcome.optimum() {
            Some(optimum) => measurement.with_value("face_dimension", f64::from(optimum.face_dimension)),
            None => measurement,
        })
    })
}

/// The minimum and the dimension of the set of minimisers; `None` when the objective is unbounded.
type Minimum = Option<(zonotope::numeric::Rational, u8)>;

fn compare(method: Method, seed: u64, problem: &LadProblem, outcome: &LadOutcome) -> (String, Result<(), String>) {
    let of = |outcome: &LadOutcome| -> Minimum {
        outcome.optimum().and_then(|optimum| Some((optimum.exact_value(problem)?, optimum.face_dimension)))
    };
    let reference = if problem.len() <= TWIN_LIMIT {
        Method::BruteForce
    } else if method == Method::LineSearch {
        Method::Pruning
    } else {
        Method::LineSearch
    };
    let expected = of(&reference.minimize(problem, seed, &mut ()));
    let found = of(outcome);
    let same = if found == expected {
        Ok(())
    } else {
        Err(format!("minimum and dimension {}, expected {}", written(&found), written(&expected)))
    };
    (format!("lad::{}", reference.id()), same)
}

fn written(minimum: &Minimum) -> String {
    match minimum {
        Some((value, dimension)) => format!("({value}, {dimension})"),
        None => "(unbounded)".to_owned(),
    }
}
