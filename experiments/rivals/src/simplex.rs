//! The engine microlp: a revised simplex method, which ends on a basis. The dual values cost a second solution.

use microlp::{ComparisonOp, Error, OptimizationDirection, Problem, Variable};
use zonotope::linear_program::{BoundedVariable, Engine, Guess, LinearProgram, Relation, Row};
use zonotope::tally::Tally;

/// The crate `microlp`. It does not say the multipliers of its basis, so the dual program is solved as well.
#[derive(Debug, Clone, Copy, Default)]
pub struct Microlp;

impl Engine for Microlp {
    fn name(&self) -> &'static str {
        "microlp"
    }

    /// The crate does not tell of its pivots, so nothing is counted.
    fn solve_counted(&self, program: &LinearProgram, _tally: &mut dyn Tally) -> Guess {
        let primal = match optimum(program) {
            Ok(primal) => primal,
            Err(outcome) => return outcome,
        };
        match optimum(&dual(program)) {
            Ok(mut multipliers) => {
                multipliers.truncate(program.rows().len());
                Guess::Optimal { primal, multipliers }
            }
            Err(outcome) => Guess::Failed(format!("an optimum, but the dual program is {outcome:?}")),
        }
    }
}

fn optimum(program: &LinearProgram) -> Result<Vec<f64>, Guess> {
    let mut problem = Problem::new(OptimizationDirection::Minimize);
    let variables: Vec<Variable> =
        program.variables().iter().map(|v| problem.add_var(v.cost, (v.lower, v.upper))).collect();
    for row in program.rows() {
        let terms = row.terms.iter().map(|&(variable, coefficient)| (variables[variable], coefficient));
        let relation = match row.relation {
            Relation::AtMost => ComparisonOp::Le,
            Relation::Equal => ComparisonOp::Eq,
            Relation::AtLeast => ComparisonOp::Ge,
        };
        problem.add_constraint(terms, relation, row.right);
    }
    let outcome = problem.solve().map_err(|error| match error {
        Error::Infeasible => Guess::Infeasible,
        Error::Unbounded => Guess::Unbounded,
        other => Guess::Failed(other.to_string()),
    })?;
    match outcome.solution() {
        Some(solution) => Ok(variables.iter().map(|&variable| solution.var_value(variable)).collect()),
        None => Err(Guess::Failed("stopped before an optimum".to_owned())),
    }
}

/// The dual as a minimisation: a multiplier y_r for each row, then a price for each finite bound that is not 0.
///
/// Maximise Σ right_r y_r + Σ lower_j p_j − Σ upper_j q_j subject to Σ y_r a_rj + p_j − q_j = cost_j, p, q ≥ 0. The
/// price of a bound 0 is the slack of the row.
fn dual(program: &LinearProgram) -> LinearProgram {
    let mut variables: Vec<BoundedVariable> = program
        .rows()
        .iter()
        .map(|row| {
            let free = BoundedVariable::free(-row.right);
            match row.relation {
                Relation::AtMost => BoundedVariable { upper: 0.0, ..free },
                Relation::Equal => free,
                Relation::AtLeast => BoundedVariable { lower: 0.0, ..free },
            }
        })
        .collect();
    let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); program.variables().len()];
    for (position, row) in program.rows().iter().enumerate() {
        for &(variable, coefficient) in &row.terms {
            columns[variable].push((position, coefficient));
        }
    }
    let mut rows = Vec::with_capacity(columns.len());
    for (variable, mut terms) in program.variables().iter().zip(columns) {
        for (bound, sign) in [(variable.lower, 1.0), (variable.upper, -1.0)] {
            if bound.is_finite() && bound != 0.0 {
                terms.push((variables.len(), sign));
                variables.push(BoundedVariable::non_negative(-sign * bound));
            }
        }
        let relation = match (variable.lower == 0.0, variable.upper == 0.0) {
            (true, true) => continue,
            (true, false) => Relation::AtMost,
            (false, true) => Relation::AtLeast,
            (false, false) => Relation::Equal,
        };
        rows.push(Row { terms, relation, right: variable.cost });
    }
    let mut dual = LinearProgram::new(variables).expect("costs and bounds come from a valid program");
    for row in rows {
        dual.add_row(row).expect("each row names the primal's rows once and its own prices");
    }
    dual
}
