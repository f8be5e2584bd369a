//! What an engine is asked and what it answers.

use super::program::LinearProgram;
use crate::tally::Tally;

/// A solver of linear programs in floating point.
pub trait Engine {
    /// The name used in records and messages.
    fn name(&self) -> &'static str;

    /// What the engine believes to be the answer. Every number in it is only a guess, the kind of the answer included.
    fn solve(&self, program: &LinearProgram) -> Guess {
        self.solve_counted(program, &mut ())
    }

    /// The same, counting the entries that are read, if the engine tells of them.
    fn solve_counted(&self, program: &LinearProgram, tally: &mut dyn Tally) -> Guess;
}

/// What an engine believes.
#[derive(Debug, Clone, PartialEq)]
pub enum Guess {
    /// An optimum.
    Optimal {
        /// A value for each variable.
        primal: Vec<f64>,
        /// A multiplier y_r for each row: at most 0 for [`AtMost`](super::Relation::AtMost), at least 0 for
        /// [`AtLeast`](super::Relation::AtLeast). Where all were exact, cost_j − Σ y_r a_rj would be 0 for a variable
        /// strictly between its bounds, not negative at its lower and not positive at its upper bound, and raising the
        /// right side of row r by one would cost y_r.
        multipliers: Vec<f64>,
    },
    /// No assignment satisfies all rows and bounds.
    Infeasible,
    /// The cost has no least value.
    Unbounded,
    /// The engine gave up, and why.
    Failed(String),
}
