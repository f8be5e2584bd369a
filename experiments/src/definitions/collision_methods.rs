//! The methods of collision by name, and the questions of a case, for every experiment on them.

use crate::definition::{Case, Verdict};
use crate::question::{PLACEMENTS, Placement, Question};
use crate::seed::Digest;
use rivals::by_gjk::{self, GjkAnswer};
use rivals::simplex::Microlp;
use zonotope::collision::{Location, Method, Query, Separation, by_linear_program};
use zonotope::interop::verifier::check_location;
use zonotope::linear_program::{Clarabel, Engine};
use zonotope::tally::{Operation, OperationCounts, Tally};

/// Near contact on both sides, then clear cases, then exact contact.
pub(super) const ALL_PLACEMENTS: &[&str] = &[
    "outside_1e-9",
    "inside_1e-9",
    "separated",
    "overlapping",
    "outside_1e-6",
    "inside_1e-6",
    "touching",
    "outside_1e-12",
    "inside_1e-12",
    "outside_1e-3",
    "inside_1e-3",
];

/// Just inside, where no method ends early: outside, one hull is enough, or the projection.
pub(super) const JUST_INSIDE: &[&str] = &["inside_1e-9", "inside_1e-6", "inside_1e-12", "inside_1e-3"];

/// The question of a case: instance k takes entry k of a cycle of placements; the next one that the body admits, if it
/// does not admit that one.
pub(super) fn question(case: &Case, cycle: &[&str]) -> Result<Question, String> {
    let generators = case.body()?;
    (0..cycle.len())
        .filter_map(|later| Placement::find(cycle[(case.instance as usize + later) % cycle.len()]))
        .find_map(|placement| Question::about(generators.clone(), placement, case.instance_seed))
        .ok_or_else(|| format!("no question can be asked about {} with n = {}", case.family, case.n))
}

/// The placement that stands for an instance in experiments that go through all of them.
pub(super) fn placement(instance: u32) -> Placement {
    PLACEMENTS[instance as usize % PLACEMENTS.len()]
}

/// Why a reply is right: by the construction of the question, and by its proof.
pub(super) const PROVED: &str = "construction and check_location";

/// The answer of a method.
pub(super) struct Reply {
    /// The place of the displacement, with the proof.
    pub location: Location<3>,
    /// The gauge, from methods that compute it.
    pub gauge: Option<f64>,
    /// The distance that it may have from the true one, by the method's own word.
    pub error: f64,
}

/// Asks the exact method that a variant names; `by_lad_location` is the kernel without the gauge.
pub(super) fn ask(variant: &str, displacement: &Query<3>, seed: u64, tally: &mut impl Tally) -> Result<Reply, String> {
    let (id, measures) = match variant {
        "by_lad_location" => ("by_lad", false),
        other => (other, true),
    };
    let method = Method::from_id(id).ok_or_else(|| format!("no method of collision is called {variant}"))?;
    if measures && method.measures() {
        let gauge = method.gauge(displacement, tally).map_err(|error| error.to_string())?;
        return Ok(Reply { location: gauge.location, gauge: Some(gauge.value), error: gauge.error });
    }
    match method.locate(displacement, seed, tally).map_err(|error| error.to_string())? {
        Some(location) => Ok(Reply { location, gauge: None, error: 0.0 }),
        None => Err(format!("{variant} has left the location open")),
    }
}

/// The operations that count as a read of a generator.
const READS: [Operation; 3] = [Operation::GeneratorRead, Operation::LineEvaluation, Operation::PartEvaluation];

/// The number of times that the generators were read: those that were read, and the lines that were evaluated once few
/// were left, divided by their number.
pub(super) fn passes(counts: &OperationCounts, generators: usize) -> f64 {
    READS.map(|read| counts.get(read)).iter().sum::<u64>() as f64 / generators as f64
}

/// The status of an answer against the truth of the question, its proof against the independent check.
pub(super) fn checked(question: &Question, location: &Location<3>) -> Verdict {
    let status = location.status().name();
    if status != question.status {
        return Verdict::Wrong(format!("{status}, but by its construction the point is {}", question.status));
    }
    Verdict::of_verifier(PROVED, check_location(&question.displacement(), location))
}

impl Reply {
    /// The status and the gauge against the truth of the question, the proof against the independent check.
    pub fn verdict(&self, question: &Question) -> Verdict {
        let excess = self.gauge.map_or(0.0, |gauge| gauge - 1.0);
        let [low, high] = question.excess;
        let slack = self.error + 1e-14 * (1.0 + high.abs());
        if self.gauge.is_some() && !(low - slack..=high + slack).contains(&excess) {
            return Verdict::Wrong(format!("a gauge of 1 + {excess:e}, certified to lie in 1 + [{low:e}, {high:e}]"));
        }
        checked(question, &self.location)
    }

    /// A hash of the status, the gauge and a rounded direction or the coefficients.
    pub fn digest(&self) -> u64 {
        let digest = Digest::default().bytes(self.location.status().name().as_bytes()).floats(&self.gauge);
        match &self.location {
            Location::Inside(witness) | Location::Boundary(witness) => digest.floats(&witness.coefficients),
            Location::Outside(Separation::Rounded(direction)) => digest.floats(direction),
            Location::Outside(Separation::Exact(direction)) => {
                direction.iter().fold(digest, |digest, c| digest.bytes(c.to_string().as_bytes()))
            }
        }
        .finish()
    }
}

/// Whether a method computes in floating point, so that it answers by [`guess`] alone.
pub(super) fn is_rounded(variant: &str) -> bool {
    ["by_gjk", "clarabel", "microlp"].contains(&variant)
}

/// Whether a method's answers are proven, so that none may be wrong.
pub(super) fn is_exact(variant: &str) -> bool {
    variant != "by_gjk"
}

/// Whether a method takes the displacement for a member, be the method exact or not; none if it gives up.
pub(super) fn guess(
    variant: &str,
    displacement: &Query<3>,
    seed: u64,
    tally: &mut impl Tally,
) -> Result<Option<bool>, String> {
    let proven = |engine: &dyn Engine| by_linear_program::locate(displacement, engine).is_member();
    Ok(match variant {
        "by_gjk" => match by_gjk::locate(displacement, tally) {
            GjkAnswer::Intersecting => Some(true),
            GjkAnswer::Disjoint { .. } => Some(false),
            GjkAnswer::GaveUp => None,
        },
        "clarabel" => proven(&Clarabel),
        "microlp" => proven(&Microlp),
        _ => Some(ask(variant, displacement, seed, tally)?.location.is_member()),
    })
}
