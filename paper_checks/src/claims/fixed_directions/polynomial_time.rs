//! Section 4.2, the cost of the program.

use experiments::fit::GrowthModel;
use families::clouds;
use zonotope::enclosing::fixed_directions::{FixedDirections, papers_program};
use zonotope::linear_program::Clarabel;
use zonotope::tally::{Operation, OperationCounts};

use crate::claim::{Check, CheckContext, Claim, ClaimKind, Place, Tried, Verdict};
use crate::growth::evidence_beside;

/// The claim.
pub static CLAIM: Claim = Claim {
    id: "program-in-polynomial-time",
    place: Place { section: "4.2", label: "after the program, quoted from [18]" },
    kind: ClaimKind::Statement,
    statement: "The linear program is solved in polynomial time by interior methods, and so in O(k^O(d)) time",
    code: &["zonotope::enclosing::fixed_directions::papers_program", "zonotope::linear_program"],
    check: Check::Run(check),
    tried: Tried::Growth(&["directions of R^2 and R^3"]),
    ..Claim::LISTED
};

/// The numbers of directions.
const DIRECTIONS: [usize; 5] = [6, 8, 10, 13, 16];

/// Sets of directions of each number.
const SETS: u64 = 3;

/// Points of each instance, on a sphere, so that most normals have an extreme point of their own.
const POINTS: usize = 800;

/// Reads of the printed program by an interior method grow no faster than k^(2d), a power that was fixed beforehand.
fn check(context: &CheckContext) -> Verdict {
    match reads::<2>(context.seed).and_then(|plane| Ok((plane, reads::<3>(context.seed)?))) {
        Ok((plane, space)) => Verdict::Holds(format!(
            "entries that the interior method reads of the printed program along {} to {} directions: {plane}; {space}",
            DIRECTIONS[0],
            DIRECTIONS[DIRECTIONS.len() - 1]
        )),
        Err(reason) => Verdict::Inconclusive(reason),
    }
}

/// The growth of the entries that are read, over k^(2d).
fn reads<const D: usize>(seed: u64) -> Result<String, String> {
    let mut samples = Vec::new();
    for (k, set) in DIRECTIONS.into_iter().flat_map(|k| (0..SETS).map(move |set| (k, set))) {
        let points = clouds::on_sphere::<D>(POINTS, seed + set);
        let directions = clouds::on_sphere::<D>(k, seed + k as u64 + 100 * set);
        let weights = vec![1.0; k];
        let problem = FixedDirections::new(&points, &directions, &weights).map_err(|error| error.to_string())?;
        let mut counts = OperationCounts::default();
        let answer = papers_program::min_length_by_papers_program(&problem, &Clarabel, &mut counts);
        answer.map_err(|error| error.to_string())?;
        let read = counts.get(Operation::EntryRead) as f64;
        samples.push((k as f64, read / (k as f64).powi(2 * D as i32)));
    }
    let power = 2 * D;
    evidence_beside(&format!("in R^{D}, over k^{power}, they"), &samples, GrowthModel::Constant)
}
