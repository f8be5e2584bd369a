//! Membership as a linear program in floating point, engines at their own settings: is there δ in [−1, 1]^n with Σ δ_i
//! g_i = to − from?

use super::{Answer, Contender, Work};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, ZeroConeT};
use experiments::question::Question;
use microlp::{ComparisonOp, Error, OptimizationDirection, Problem};

/// The interior-point method of the crate `clarabel`.
pub const CLARABEL: Contender = Contender { id: "clarabel", largest: 1 << 17, prepare: by_clarabel };

/// The simplex method of the crate `microlp`.
pub const MICROLP: Contender = Contender { id: "microlp", largest: 1 << 17, prepare: by_microlp };

fn offset(question: &Question) -> [f64; 3] {
    std::array::from_fn(|i| question.to[i] - question.from[i])
}

fn by_clarabel(question: &Question) -> Option<Work<'_>> {
    let n = question.generators.len();
    // Three equations, then δ_i ≤ 1 and −δ_i ≤ 1: five entries a column.
    let mut rows = Vec::with_capacity(5 * n);
    let mut values = Vec::with_capacity(5 * n);
    for (i, g) in question.generators.iter().enumerate() {
        rows.extend([0, 1, 2, 3 + i, 3 + n + i]);
        values.extend([g[0], g[1], g[2], 1.0, -1.0]);
    }
    let matrix = CscMatrix::new(3 + 2 * n, n, (0..=n).map(|i| 5 * i).collect(), rows, values);
    let right: Vec<f64> = offset(question).into_iter().chain(vec![1.0; 2 * n]).collect();
    let (nothing, costs) = (CscMatrix::zeros((n, n)), vec![0.0; n]);
    let cones = [ZeroConeT(3), NonnegativeConeT(2 * n)];
    let settings = DefaultSettingsBuilder::default().verbose(false).build().ok()?;
    Some(Box::new(move || {
        let Ok(mut solver) = DefaultSolver::new(&nothing, &costs, &matrix, &right, &cones, settings.clone()) else {
            return Answer::Failed;
        };
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Answer::Member(true),
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => Answer::Member(false),
            _ => Answer::Failed,
        }
    }))
}

fn by_microlp(question: &Question) -> Option<Work<'_>> {
    let right = offset(question);
    Some(Box::new(move || {
        let mut problem = Problem::new(OptimizationDirection::Minimize);
        let variables: Vec<_> = question.generators.iter().map(|_| problem.add_var(0.0, (-1.0, 1.0))).collect();
        for axis in 0..3 {
            let terms = variables.iter().zip(&question.generators).map(|(&variable, g)| (variable, g[axis]));
            problem.add_constraint(terms, ComparisonOp::Eq, right[axis]);
        }
        match problem.solve() {
            Ok(outcome) if outcome.solution().is_some() => Answer::Member(true),
            Err(Error::Infeasible) => Answer::Member(false),
            _ => Answer::Failed,
        }
    }))
}
