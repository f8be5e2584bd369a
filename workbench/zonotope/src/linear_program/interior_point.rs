//! The engine Clarabel: a primal-dual interior-point method for cones.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, ZeroConeT,
};

use super::engine::{Engine, Guess};
use super::program::{LinearProgram, Relation};
use crate::tally::{Operation, Tally};

/// The accuracy that is asked for: relative residuals and gap.
const ASKED: f64 = 1e-12;
/// The accuracy below which the engine's stalling counts as failure.
const LEAST: f64 = 1e-8;

/// The crate `clarabel`. The answer is near an optimal face, in general near its middle, not on a vertex.
#[derive(Debug, Clone, Copy, Default)]
pub struct Clarabel;

/// A constraint terms · x + slack = right, slack = 0 or slack ≥ 0.
struct ConeRow<'a> {
    sign: f64,
    terms: &'a [(usize, f64)],
    right: f64,
}

impl Engine for Clarabel {
    fn name(&self) -> &'static str {
        "clarabel"
    }

    /// Each step reads the equations of the step and their factors once at least; what it takes to make the factors is
    /// not told, and not counted.
    fn solve_counted(&self, program: &LinearProgram, tally: &mut dyn Tally) -> Guess {
        let count = program.variables().len();
        let units: Vec<[(usize, f64); 1]> = (0..count).map(|variable| [(variable, 1.0)]).collect();
        let (mut equal, mut less) = (Vec::new(), Vec::new());
        let mut places = Vec::with_capacity(program.rows().len());
        for row in program.rows() {
            let (cone, sign) = match row.relation {
                Relation::Equal => (&mut equal, 1.0),
                Relation::AtMost => (&mut less, 1.0),
                Relation::AtLeast => (&mut less, -1.0),
            };
            places.push((row.relation == Relation::Equal, cone.len(), sign));
            cone.push(ConeRow { sign, terms: &row.terms, right: row.right });
        }
        for (variable, terms) in program.variables().iter().zip(&units) {
            if variable.lower == variable.upper {
                equal.push(ConeRow { sign: 1.0, terms, right: variable.lower });
                continue;
            }
            for (sign, right) in [(1.0, variable.upper), (-1.0, variable.lower)] {
                if right.is_finite() {
                    less.push(ConeRow { sign, terms, right });
                }
            }
        }
        let equalities = equal.len();
        let cones = [ZeroConeT(equalities), NonnegativeConeT(less.len())];
        equal.append(&mut less);
        let matrix = columns(&equal, count);
        let right: Vec<f64> = equal.iter().map(|row| row.sign * row.right).collect();
        let costs: Vec<f64> = program.variables().iter().map(|variable| variable.cost).collect();
        let nothing = CscMatrix::zeros((count, count));
        let mut solver = match DefaultSolver::new(&nothing, &costs, &matrix, &right, &cones, settings()) {
            Ok(solver) => solver,
            Err(error) => return Guess::Failed(error.to_string()),
        };
        solver.solve();
        let system = &solver.info.linsolver;
        tally.add(Operation::EntryRead, u64::from(solver.info.iterations) * (system.nnzA + system.nnzL) as u64);
        let multiplier = |(is_equality, position, sign): &(bool, usize, f64)| {
            let position = if *is_equality { *position } else { equalities + position };
            -sign * solver.solution.z[position]
        };
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => {
                Guess::Optimal { multipliers: places.iter().map(multiplier).collect(), primal: solver.solution.x }
            }
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => Guess::Infeasible,
            SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => Guess::Unbounded,
            status => Guess::Failed(status.to_string()),
        }
    }
}

fn settings() -> DefaultSettings<f64> {
    DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(ASKED)
        .tol_gap_rel(ASKED)
        .tol_feas(ASKED)
        .reduced_tol_gap_abs(LEAST)
        .reduced_tol_gap_rel(LEAST)
        .reduced_tol_feas(LEAST)
        .build()
        .expect("the settings named here are within their ranges")
}

/// The rows by columns, as the engine wants them.
fn columns(rows: &[ConeRow], count: usize) -> CscMatrix<f64> {
    let mut starts = vec![0; count + 1];
    for &(variable, _) in rows.iter().flat_map(|row| row.terms) {
        starts[variable + 1] += 1;
    }
    for column in 0..count {
        starts[column + 1] += starts[column];
    }
    let (mut next, entries) = (starts.clone(), starts[count]);
    let (mut places, mut values) = (vec![0; entries], vec![0.0; entries]);
    for (position, row) in rows.iter().enumerate() {
        for &(variable, coefficient) in row.terms {
            places[next[variable]] = position;
            values[next[variable]] = row.sign * coefficient;
            next[variable] += 1;
        }
    }
    CscMatrix::new(rows.len(), count, starts, places, values)
}
