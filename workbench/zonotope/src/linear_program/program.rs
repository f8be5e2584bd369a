//! The input of the engines: variables with costs and bounds, sparse rows; validated.

use thiserror::Error;

use crate::numeric::non_finite::NonFinite;

/// Minimise Σ cost_j x_j subject to the rows and lower_j ≤ x_j ≤ upper_j.
///
/// Costs, coefficients and right sides are finite; a bound may be infinite on the side that it leaves open; a row names
/// a variable at most once.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LinearProgram {
    variables: Vec<BoundedVariable>,
    rows: Vec<Row>,
}

/// A variable with its cost and bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundedVariable {
    /// The cost of one unit.
    pub cost: f64,
    /// The least value; −∞ when there is none.
    pub lower: f64,
    /// The greatest value; ∞ when there is none.
    pub upper: f64,
}

/// How the left side of a row stands to its right side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// The left side is at most the right side.
    AtMost,
    /// The sides are equal.
    Equal,
    /// The left side is at least the right side.
    AtLeast,
}

/// A constraint Σ coefficient · x_variable (relation) right.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Variables, from 0, with their coefficients.
    pub terms: Vec<(usize, f64)>,
    /// How the sum stands to the right side.
    pub relation: Relation,
    /// The right side.
    pub right: f64,
}

/// Why variables and rows are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LinearProgramError {
    /// A cost, a coefficient or the right side of a row is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// No number lies between the bounds of a variable.
    #[error("variable {variable}: no number lies between {lower} and {upper}")]
    EmptyBounds {
        /// The variable, from 0.
        variable: usize,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// A row names a variable that does not exist.
    #[error("row {row} names variable {variable}, but there are {count}")]
    UnknownVariable {
        /// The row, from 0.
        row: usize,
        /// The variable that it names.
        variable: usize,
        /// How many variables there are.
        count: usize,
    },
    /// A row names a variable twice.
    #[error("row {row} names variable {variable} twice")]
    RepeatedVariable {
        /// The row, from 0.
        row: usize,
        /// The variable.
        variable: usize,
    },
}

impl BoundedVariable {
    /// A variable without bounds.
    pub fn free(cost: f64) -> Self {
        Self { cost, lower: f64::NEG_INFINITY, upper: f64::INFINITY }
    }

    /// A variable that is not negative.
    pub fn non_negative(cost: f64) -> Self {
        Self { cost, lower: 0.0, upper: f64::INFINITY }
    }
}

impl LinearProgram {
    /// A program of variables without rows.
    ///
    /// # Errors
    /// [`LinearProgramError`] names the first variable whose cost is not finite or whose bounds admit no number.
    pub fn new(variables: Vec<BoundedVariable>) -> Result<Self, LinearProgramError> {
        for (variable, &BoundedVariable { cost, lower, upper }) in variables.iter().enumerate() {
            NonFinite::check_fields("variable", variable, &[("the cost", cost)])?;
            if !(lower <= upper && lower < f64::INFINITY && upper > f64::NEG_INFINITY) {
                return Err(LinearProgramError::EmptyBounds { variable, lower, upper });
            }
        }
        Ok(Self { variables, rows: Vec::new() })
    }

    /// Adds a row. O(terms log terms).
    ///
    /// # Errors
    /// [`LinearProgramError`] names what is wrong with the row; the program stays as it was.
    pub fn add_row(&mut self, row: Row) -> Result<(), LinearProgramError> {
        let (position, count) = (self.rows.len(), self.variables.len());
        for &(_, coefficient) in &row.terms {
            NonFinite::check_fields("row", position, &[("a coefficient", coefficient)])?;
        }
        NonFinite::check_fields("row", position, &[("the right side", row.right)])?;
        let mut named: Vec<usize> = row.terms.iter().map(|term| term.0).collect();
        named.sort_unstable();
        if let Some(&variable) = named.last().filter(|&&variable| variable >= count) {
            return Err(LinearProgramError::UnknownVariable { row: position, variable, count });
        }
        if let Some(pair) = named.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(LinearProgramError::RepeatedVariable { row: position, variable: pair[0] });
        }
        self.rows.push(row);
        Ok(())
    }

    /// The variables.
    pub fn variables(&self) -> &[BoundedVariable] {
        &self.variables
    }

    /// The rows, in the order in which they were added.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }
}
