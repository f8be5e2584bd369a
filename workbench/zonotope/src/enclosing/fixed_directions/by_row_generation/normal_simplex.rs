//! The program over normals in floating point: a revised simplex method on its dual, to which normals may be added.
//!
//! Minimise Σ w_i c_i with Σ c_i |u · v_i| + u · p ≥ h(u) for the normals u seen so far. The dual, maximise Σ y_u h(u) with Σ y_u u = 0 and
//! Σ y_u |u · v_i| ≤ w_i, has as many rows as there are coordinates and directions, however many normals there are; its prices are p and c. A new
//! normal is a new column that may enter the basis. The weights are nudged apart
//! until the last rounds, so that ties do not stall the method. All of it is a guess: its users prove or repair what it says.

use crate::zonotope::ray_exit::dot;

/// A normal with how far the points reach along it.
#[derive(Clone, Debug)]
pub(crate) struct NormalRow<const D: usize> {
    /// Of length 1, within rounding.
    pub(crate) normal: [f64; D],
    /// The height of `point` along the normal.
    pub(crate) height: f64,
    pub(crate) point: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Basic {
    Normal(usize),
    Slack(usize),
}

/// The method gave up: rounding errors, or more steps than any sensible program needs.
#[derive(Debug)]
pub(crate) struct Stuck;

pub(crate) struct NormalProgram<const D: usize> {
    rank: usize,
    directions: Vec<[f64; D]>,
    weights: Vec<f64>,
    nudged: bool,
    rows: Vec<NormalRow<D>>,
    /// For each normal its coordinates, then |u · v_i| for each direction.
    entries: Vec<Vec<f64>>,
    basis: Vec<Basic>,
    normal_is_basic: Vec<bool>,
    slack_is_basic: Vec<bool>,
    /// The inverse of the basis matrix: a row for each basic variable, a column for each coordinate and direction.
    inverse: Vec<Vec<f64>>,
    values: Vec<f64>,
    /// The centre p, then the coefficients c.
    prices: Vec<f64>,
    fresh: usize,
    /// Pivots so far.
    pivots: u64,
    /// A reduced gain below this, relatively, is rounding.
    pub(crate) precision: f64,
}

/// The least precision that makes sense.
const FINEST: f64 = 1e-14;

/// Pivots after which the inverse is computed anew.
const STALE: usize = 120;

/// Steps of refinement after the inverse is computed anew.
const REFINEMENTS: usize = 2;

/// Turns of dual and primal pivots with a new inverse.
const MOST_TURNS: usize = 12;

/// Columns that are priced between two looks at all of them.
const CANDIDATES: usize = 24;

/// How far a weight is nudged at most, relatively.
const NUDGE: f64 = 1e-7;

impl<const D: usize> NormalProgram<D> {
    /// The program of some directions, begun with the axes as normals: y = 0 and all slacks make the first basis.
    pub(crate) fn new(rank: usize, axes: Vec<NormalRow<D>>, directions: Vec<[f64; D]>, weights: Vec<f64>) -> Self {
        let size = rank + directions.len();
        let mut program = Self {
            rank,
            normal_is_basic: Vec::new(),
            slack_is_basic: vec![true; directions.len()],
            basis: (0..size).map(|i| if i < rank { Basic::Normal(i) } else { Basic::Slack(i - rank) }).collect(),
            inverse: Vec::new(),
            values: vec![0.0; size],
            prices: vec![0.0; size],
            directions,
            weights,
            nudged: true,
            rows: Vec::new(),
            entries: Vec::new(),
            fresh: 0,
            pivots: 0,
            precision: FINEST,
        };
        for axis in axes {
            program.add_row(axis);
        }
        program.normal_is_basic.fill(true);
        program.refactor().expect("the axes are a basis");
        program
    }

    fn size(&self) -> usize {
        self.basis.len()
    }

    pub(crate) fn center(&self) -> [f64; D] {
        std::array::from_fn(|c| if c < self.rank { self.prices[c] } else { 0.0 })
    }

    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.prices[self.rank..]
    }

    pub(crate) fn rows(&self) -> &[NormalRow<D>] {
        &self.rows
    }

    /// The normals that count at the optimum, with their multipliers y_u.
    pub(crate) fn multipliers(&self) -> impl Iterator<Item = (&NormalRow<D>, f64)> {
        self.basis.iter().zip(&self.values).filter_map(|(basic, &y)| match basic {
            Basic::Normal(j) if y > 0.0 => Some((&self.rows[*j], y)),
            _ => None,
        })
    }

    /// Adds a normal; it may enter the basis from now on.
    pub(crate) fn add_row(&mut self, row: NormalRow<D>) {
        let coordinates = row.normal[..self.rank].iter().copied();
        self.entries.push(coordinates.chain(self.directions.iter().map(|v| dot(&row.normal, v).abs())).collect());
        self.rows.push(row);
        self.normal_is_basic.push(false);
    }

    /// The true weights from now on; whether they had been nudged.
    pub(crate) fn settle_weights(&mut self) -> bool {
        let nudged = std::mem::replace(&mut self.nudged, false);
        if self.refactor().is_err() {
            self.values = self.solve_values();
        }
        nudged
    }

    fn bound(&self, constraint: usize) -> f64 {
        let Some(i) = constraint.checked_sub(self.rank) else { return 0.0 };
        // Multiples of the golden ratio are spread evenly over [0, 1).
        let spread = (i as f64 + 1.0) * 0.618_033_988_749_894_9;
        let nudge = if self.nudged { NUDGE * (spread - spread.floor()) } else { 0.0 };
        self.weights[i] * (1.0 + nudge)
    }

    fn solve_values(&self) -> Vec<f64> {
        let bounds: Vec<f64> = (0..self.size()).map(|i| self.bound(i)).collect();
        self.inverse.iter().map(|row| product(row, &bounds)).collect()
    }

    /// The optimum for the normals and directions seen so far.
    pub(crate) fn optimize(&mut self) -> Result<(), Stuck> {
        let most = 12 * (self.size() + self.rows.len()) as u64 + 2000;
        let end = self.pivots + most;
        if self.fresh >= STALE {
            self.refactor()?;
        }
        // Rounding may undo one step with the other: what is left after some turns is within it.
        for _ in 0..MOST_TURNS {
            self.make_feasible(end)?;
            self.improve(end)?;
            if self.fresh == 0 {
                break;
            }
            self.refactor()?;
        }
        Ok(())
    }

    /// Primal pivots: while a normal or slack has a positive reduced gain, it enters.
    fn improve(&mut self, end: u64) -> Result<(), Stuck> {
        let mut candidates: Vec<Basic> = Vec::new();
        loop {
            let mut best = self.best_of(&candidates);
            if best.is_none() {
                candidates = self.promising();
                best = self.best_of(&candidates);
            }
            let Some((entering, gain)) = best else { return Ok(()) };
            let column = self.column(entering);
            let Some(leaving) = self.leaving(&column) else { return Err(Stuck) };
            let step = gain / column[leaving];
            for (price, v) in self.prices.iter_mut().zip(&self.inverse[leaving]) {
                *price += step * v;
            }
            self.pivot(leaving, entering, &column);
            if self.pivots > end {
                return Err(Stuck);
            }
            if self.fresh >= STALE {
                self.refactor()?;
            }
        }
    }

    /// Dual pivots: while a basic value is negative, it leaves.
    fn make_feasible(&mut self, end: u64) -> Result<(), Stuck> {
        loop {
            let scale = self.values.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
            let worst = (0..self.size()).min_by(|&a, &b| self.values[a].total_cmp(&self.values[b])).ok_or(Stuck)?;
            if self.values[worst] >= -10.0 * self.precision * scale {
                return Ok(());
            }
            let row = &self.inverse[worst];
            let normals = (0..self.rows.len()).filter(|&j| !self.normal_is_basic[j]);
            let slacks = (0..self.directions.len()).filter(|&i| !self.slack_is_basic[i]);
            let normals = normals.map(|j| {
                let entries = &self.entries[j];
                (Basic::Normal(j), product(row, entries), product(entries, &self.prices) - self.rows[j].height)
            });
            let slacks = slacks.map(|i| (Basic::Slack(i), row[self.rank + i], self.prices[self.rank + i]));
            let falling: Vec<(Basic, f64, f64)> = normals
                .chain(slacks)
                .filter(|(_, rate, _)| *rate < -1e-11)
                .map(|(b, r, cost)| (b, -r, cost.max(0.0)))
                .collect();
            let bound = falling.iter().map(|(_, rate, cost)| (cost + 1e-14) / rate).fold(f64::INFINITY, f64::min);
            let near = falling.iter().filter(|(_, rate, cost)| cost / rate <= bound);
            let Some(&(entering, rate, cost)) = near.max_by(|a, b| a.1.total_cmp(&b.1)) else { return Err(Stuck) };
            let step = cost / rate;
            for (price, v) in self.prices.iter_mut().zip(&self.inverse[worst]) {
                *price += step * v;
            }
            let column = self.column(entering);
            self.pivot(worst, entering, &column);
            if self.pivots > end {
                return Err(Stuck);
            }
            if self.fresh >= STALE {
                self.refactor()?;
            }
        }
    }

    /// The reduced gain, if it is more than rounding.
    fn reduced_gain(&self, basic: Basic) -> Option<f64> {
        let (gain, doubt) = match basic {
            Basic::Slack(i) => {
                let price = self.prices[self.rank + i];
                (-price, 0.1 * self.precision)
            }
            Basic::Normal(j) => {
                let entries = &self.entries[j];
                let gain = self.rows[j].height - product(entries, &self.prices);
                if gain <= 0.01 * self.precision {
                    return None;
                }
                let size = entries.iter().zip(&self.prices).map(|(e, p)| (e * p).abs()).sum::<f64>();
                (gain, self.precision * (size + 0.01))
            }
        };
        (gain > doubt).then_some(gain)
    }

    fn is_basic(&self, basic: Basic) -> bool {
        match basic {
            Basic::Normal(j) => self.normal_is_basic[j],
            Basic::Slack(i) => self.slack_is_basic[i],
        }
    }

    fn best_of(&self, candidates: &[Basic]) -> Option<(Basic, f64)> {
        let gains = candidates.iter().filter(|b| !self.is_basic(**b)).filter_map(|&b| Some((b, self.reduced_gain(b)?)));
        gains.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn promising(&self) -> Vec<Basic> {
        let all = (0..self.rows.len()).map(Basic::Normal).chain((0..self.directions.len()).map(Basic::Slack));
        let mut gains: Vec<(Basic, f64)> =
            all.filter(|b| !self.is_basic(*b)).filter_map(|b| Some((b, self.reduced_gain(b)?))).collect();
        gains.sort_by(|a, b| b.1.total_cmp(&a.1));
        gains.truncate(CANDIDATES);
        gains.into_iter().map(|(b, _)| b).collect()
    }

    /// The inverse times the column of a variable.
    fn column(&self, entering: Basic) -> Vec<f64> {
        match entering {
            Basic::Slack(i) => self.inverse.iter().map(|row| row[self.rank + i]).collect(),
            Basic::Normal(j) => self.inverse.iter().map(|row| product(row, &self.entries[j])).collect(),
        }
    }

    /// The ratio test in two passes: of the rows that are nearly the first to reach zero, the one with the largest pivot.
    fn leaving(&self, column: &[f64]) -> Option<usize> {
        let largest = column.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
        let scale = self.values.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
        let rising = || (0..column.len()).filter(|&i| column[i] > 1e-10 * largest);
        let bound =
            rising().map(|i| (self.values[i].max(0.0) + 1e-13 * scale) / column[i]).fold(f64::INFINITY, f64::min);
        rising()
            .filter(|&i| self.values[i].max(0.0) / column[i] <= bound)
            .max_by(|&a, &b| column[a].total_cmp(&column[b]))
    }

    fn pivot(&mut self, leaving: usize, entering: Basic, column: &[f64]) {
        let head = column[leaving];
        let mut row = std::mem::take(&mut self.inverse[leaving]);
        for v in &mut row {
            *v /= head;
        }
        let step = self.values[leaving] / head;
        for (i, &factor) in column.iter().enumerate() {
            if i != leaving && factor != 0.0 {
                for (v, p) in self.inverse[i].iter_mut().zip(&row) {
                    *v -= factor * p;
                }
                self.values[i] -= factor * step;
            }
        }
        self.inverse[leaving] = row;
        self.values[leaving] = step;
        match std::mem::replace(&mut self.basis[leaving], entering) {
            Basic::Normal(j) => self.normal_is_basic[j] = false,
            Basic::Slack(i) => self.slack_is_basic[i] = false,
        }
        match entering {
            Basic::Normal(j) => self.normal_is_basic[j] = true,
            Basic::Slack(i) => self.slack_is_basic[i] = true,
        }
        self.fresh += 1;
        self.pivots += 1;
    }

    /// Computes the inverse anew: only the block of basic normals and tight directions is dense.
    fn refactor(&mut self) -> Result<(), Stuck> {
        let size = self.size();
        let normals: Vec<(usize, usize)> = self
            .basis
            .iter()
            .enumerate()
            .filter_map(|(at, b)| if let Basic::Normal(j) = b { Some((at, *j)) } else { None })
            .collect();
        let tight: Vec<usize> =
            (0..size).filter(|&i| i.checked_sub(self.rank).is_none_or(|i| !self.slack_is_basic[i])).collect();
        if tight.len() != normals.len() {
            return Err(Stuck);
        }
        // Row t: constraint t over the basic normals.
        let block: Vec<Vec<f64>> =
            tight.iter().map(|&t| normals.iter().map(|&(_, j)| self.entries[j][t]).collect()).collect();
        let block = dense_inverse(block).ok_or(Stuck)?;
        let mut inverse = vec![vec![0.0; size]; size];
        for (&(at, _), row) in normals.iter().zip(&block) {
            for (&t, &v) in tight.iter().zip(row) {
                inverse[at][t] = v;
            }
        }
        for (at, basic) in self.basis.iter().enumerate() {
            let Basic::Slack(i) = basic else { continue };
            let constraint = self.rank + i;
            let mut row = vec![0.0; tight.len()];
            for (&(_, j), inverse_row) in normals.iter().zip(&block) {
                let entry = self.entries[j][constraint];
                for (sum, v) in row.iter_mut().zip(inverse_row) {
                    *sum -= entry * v;
                }
            }
            for (&t, v) in tight.iter().zip(row) {
                inverse[at][t] = v;
            }
            inverse[at][constraint] = 1.0;
        }
        self.inverse = inverse;
        self.values = self.solve_values();
        let mut prices = vec![0.0; size];
        for &(at, j) in &normals {
            add_multiple(&mut prices, self.rows[j].height, &self.inverse[at]);
        }
        // What the tight directions and the tight normals still miss.
        for _ in 0..REFINEMENTS {
            let missing = |&t: &usize| {
                self.bound(t) - normals.iter().map(|&(at, j)| self.values[at] * self.entries[j][t]).sum::<f64>()
            };
            let missing: Vec<f64> = tight.iter().map(missing).collect();
            for (&(at, _), row) in normals.iter().zip(&block) {
                self.values[at] += product(row, &missing);
            }
            let missing = |&(_, j): &(usize, usize)| self.rows[j].height - product(&self.entries[j], &prices);
            let missing: Vec<f64> = normals.iter().map(missing).collect();
            for (&(at, _), miss) in normals.iter().zip(missing) {
                add_multiple(&mut prices, miss, &self.inverse[at]);
            }
        }
        self.prices = prices;
        self.fresh = 0;
        if self.prices.iter().chain(&self.values).all(|v| v.is_finite()) { Ok(()) } else { Err(Stuck) }
    }
}

fn add_multiple(sum: &mut [f64], factor: f64, vector: &[f64]) {
    for (s, v) in sum.iter_mut().zip(vector) {
        *s += factor * v;
    }
}

/// The sum of products, in four partial sums.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let (mut a, mut b) = (a.chunks_exact(4), b.chunks_exact(4));
    let mut sums = [0.0; 4];
    for (x, y) in a.by_ref().zip(b.by_ref()) {
        for i in 0..4 {
            sums[i] += x[i] * y[i];
        }
    }
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(x, y)| x * y).sum();
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}

/// Gauss–Jordan elimination with row pivoting; `None` for a singular matrix.
fn dense_inverse(mut left: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let size = left.len();
    let mut right: Vec<Vec<f64>> =
        (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for column in 0..size {
        let pivot = (column..size).max_by(|&a, &b| left[a][column].abs().total_cmp(&left[b][column].abs()))?;
        let head = left[pivot][column];
        if head == 0.0 || !head.is_finite() {
            return None;
        }
        left.swap(column, pivot);
        right.swap(column, pivot);
        let mut pivot_left = std::mem::take(&mut left[column]);
        let mut pivot_right = std::mem::take(&mut right[column]);
        for v in pivot_left.iter_mut().chain(&mut pivot_right) {
            *v /= head;
        }
        for row in (0..size).filter(|&row| row != column) {
            let factor = left[row][column];
            if factor != 0.0 {
                add_multiple(&mut left[row][column..], -factor, &pivot_left[column..]);
                add_multiple(&mut right[row], -factor, &pivot_right);
            }
        }
        left[column] = pivot_left;
        right[column] = pivot_right;
    }
    Some(right)
}
