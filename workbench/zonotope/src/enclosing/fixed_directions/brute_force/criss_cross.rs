//! The criss-cross method of Terlaky (1985) with the least-index rule, in rationals.
//!
//! From any basis, feasible or not, the variable of least index that is negative or would lower the value is exchanged.
//! There are no phases, and only signs are compared; the rule of least index keeps the method from cycling.

use crate::numeric::Rational;

/// One constraint of the support form: Σ widths_i c_i + normal · p ≥ height.
pub(super) struct Constraint {
    pub(super) normal: Vec<Rational>,
    /// |u · v_i| for each direction.
    pub(super) widths: Vec<Rational>,
    /// How far the points reach along the normal.
    pub(super) height: Rational,
}

/// Σ w_i c_i and the basic variables as affine functions of the nonbasic ones.
///
/// The variables are the coordinates of p, which are free, then c, then the slack of each constraint; all but the first
/// are ≥ 0.
pub(super) struct Dictionary {
    rank: usize,
    /// The index of the variable that each row expresses, and of the one that each column but the first stands for.
    basic: Vec<usize>,
    nonbasic: Vec<usize>,
    /// The constant of each row, then its coefficients; the last row is the objective.
    rows: Vec<Vec<Rational>>,
}

/// What the dictionary says at the optimum.
pub(super) struct Solution {
    pub(super) value: Rational,
    pub(super) center: Vec<Rational>,
    pub(super) coefficients: Vec<Rational>,
    /// The cost of each constraint's slack: its multiplier in the dual program.
    pub(super) multipliers: Vec<Rational>,
}

impl Dictionary {
    pub(super) fn new(constraints: &[Constraint], weights: Vec<Rational>, rank: usize) -> Self {
        let count = rank + weights.len();
        let row = |c: &Constraint| {
            let constant = std::iter::once(-c.height.clone());
            constant.chain(c.normal.iter().cloned()).chain(c.widths.iter().cloned()).collect()
        };
        let mut rows: Vec<Vec<Rational>> = constraints.iter().map(row).collect();
        rows.push(std::iter::repeat_n(Rational::ZERO, rank + 1).chain(weights).collect());
        let basic = (0..constraints.len()).map(|i| count + i).collect();
        Self { rank, basic, nonbasic: (0..count).collect(), rows }
    }

    pub(super) fn solve(self) -> Solution {
        self.try_solve().expect("a zonotope along directions that span contains the points")
    }

    /// The optimum; `None` when nothing is feasible. The value must be bounded below, and the constraints must
    /// determine the free variables.
    pub(super) fn try_solve(mut self) -> Option<Solution> {
        for free in 0..self.rank {
            let is_slack = |row: &usize| self.basic[*row] >= self.rank && !self.rows[*row][free + 1].is_zero();
            let row = (0..self.basic.len()).find(is_slack).expect("the normals of directions that span do span");
            self.exchange(row, free + 1);
        }
        while let Some((row, column)) = self.violation() {
            self.exchange(row, column?);
        }
        Some(self.solution())
    }

    /// The row and the column of the exchange that the violation of least index asks for; no column when nothing is
    /// feasible.
    fn violation(&self) -> Option<(usize, Option<usize>)> {
        let objective = self.rows.len() - 1;
        let negative = |row: &usize| self.basic[*row] >= self.rank && self.rows[*row][0] < Rational::ZERO;
        let row = (0..objective).filter(negative).min_by_key(|&row| self.basic[row]);
        let cheaper = |column: &usize| self.rows[objective][*column] < Rational::ZERO;
        let column = (1..=self.nonbasic.len()).filter(cheaper).min_by_key(|&column| self.nonbasic[column - 1]);
        let is_primal = match (row, column) {
            (None, None) => return None,
            (Some(row), Some(column)) => self.basic[row] < self.nonbasic[column - 1],
            (row, _) => row.is_some(),
        };
        if let Some(row) = row.filter(|_| is_primal) {
            let raises = |column: &usize| self.rows[row][*column] > Rational::ZERO;
            let entering = (1..=self.nonbasic.len()).filter(raises).min_by_key(|&column| self.nonbasic[column - 1]);
            return Some((row, entering));
        }
        let column = column?;
        let falls = |row: &usize| self.basic[*row] >= self.rank && self.rows[*row][column] < Rational::ZERO;
        let leaving = (0..objective).filter(falls).min_by_key(|&row| self.basic[row]);
        Some((leaving.expect("no weight is negative, so the value is bounded below"), Some(column)))
    }

    /// Expresses the variable of a column by that of a row, and all others by it.
    fn exchange(&mut self, row: usize, column: usize) {
        let mut solved = std::mem::take(&mut self.rows[row]);
        let pivot = std::mem::replace(&mut solved[column], -Rational::ONE);
        solved.iter_mut().for_each(|entry| *entry /= -pivot.clone());
        for other in self.rows.iter_mut().filter(|other| !other.is_empty()) {
            let factor = std::mem::replace(&mut other[column], Rational::ZERO);
            if !factor.is_zero() {
                other.iter_mut().zip(&solved).for_each(|(entry, s)| *entry += &factor * s);
            }
        }
        self.rows[row] = solved;
        std::mem::swap(&mut self.basic[row], &mut self.nonbasic[column - 1]);
    }

    fn solution(mut self) -> Solution {
        let objective = self.rows.pop().expect("the objective is the last row");
        let count = self.nonbasic.len();
        let mut values = vec![Rational::ZERO; count];
        for (&variable, row) in self.basic.iter().zip(&self.rows).filter(|(variable, _)| **variable < count) {
            values[variable] = row[0].clone();
        }
        let mut multipliers = vec![Rational::ZERO; self.rows.len()];
        for (&variable, cost) in self.nonbasic.iter().zip(&objective[1..]).filter(|(variable, _)| **variable >= count) {
            multipliers[variable - count] = cost.clone();
        }
        let coefficients = values.split_off(self.rank);
        Solution { value: objective[0].clone(), center: values, coefficients, multipliers }
    }
}
