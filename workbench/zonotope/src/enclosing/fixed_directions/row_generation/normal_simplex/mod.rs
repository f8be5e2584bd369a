//! The linear program over normals in doubles: a revised simplex method on its dual, to which normals may be added.
//!
//! The program is to minimise Σ w_i c_i with Σ c_i |u · v_i| + u · p ≥ h(u) for the normals u found so far, where h(u)
//! is the height of the farthest point. Its dual is solved here: maximise Σ y_u h(u) with Σ y_u u = 0
//! and Σ y_u |u · v_i| ≤ w_i. The dual has as many constraints as there are coordinates and directions, however many
//! normals there are, and its prices are p and c. A new normal is a new column, so the basis of the round before stays
//! feasible. The weights are perturbed until the last rounds, so that ties do not stall the method. The optimum is a
//! guess, which the callers prove.
//!
//! | file | what it does |
//! |---|---|
//! | `mod` | the program, its pivots, and the alternation of primal and dual pivots |
//! | `pricing` | which variable enters the basis and which leaves it |
//! | `refactor` | the inverse of the basis, computed anew |

mod pricing;
mod refactor;

use crate::numeric::lanes::product_in_fours;
use crate::numeric::linear::dot;

/// A normal with the farthest point along it: a row of the program, and a column of the dual.
#[derive(Clone, Debug)]
pub(crate) struct NormalRow<const D: usize> {
    /// The normal u, of length 1 but for rounding.
    pub(crate) normal: [f64; D],
    /// The height h(u) of `point` along the normal.
    pub(crate) height: f64,
    /// The farthest point along the normal.
    pub(crate) point: usize,
}

/// A variable of the dual.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Basic {
    /// The multiplier y_u of a normal.
    Normal(usize),
    /// The slack of the constraint of a direction.
    Slack(usize),
}

/// The method gave up, because of rounding errors, after more pivots than a program of the size should need, or at a
/// limit of its work.
#[derive(Debug)]
pub(crate) struct Stuck;

/// The dual program with a basis.
pub(crate) struct NormalProgram<const D: usize> {
    rank: usize,
    directions: Vec<[f64; D]>,
    weights: Vec<f64>,
    /// Whether the weights are perturbed.
    is_perturbed: bool,
    rows: Vec<NormalRow<D>>,
    /// The column of each normal in the dual: its coordinates, then |u · v_i| for each direction.
    entries: Vec<Vec<f64>>,
    basis: Vec<Basic>,
    normal_is_basic: Vec<bool>,
    slack_is_basic: Vec<bool>,
    /// The inverse of the basis matrix: a row for each basic variable, a column for each coordinate and direction.
    inverse: Vec<Vec<f64>>,
    /// The values of the basic variables.
    values: Vec<f64>,
    /// The prices of the dual's constraints: the centre p, then the coefficients c.
    prices: Vec<f64>,
    /// The number of pivots since the inverse was computed anew.
    pivots_since_inverse: usize,
    /// The number of pivots so far.
    pivots: u64,
    /// The entries of columns, of the inverse and of the block that is inverted that have been read so far.
    entries_read: u64,
    /// The number of these entries that the tally has been given.
    entries_told: u64,
    /// The method gives up after so many.
    entries_limit: u64,
    /// A reduced gain below this, relative to the terms that it is the sum of, counts as zero.
    pub(crate) precision: f64,
}

/// The finest relative precision that doubles allow.
const FINEST_PRECISION: f64 = 1e-14;

/// The inverse is computed anew after this many pivots.
const PIVOTS_PER_INVERSE: usize = 120;

/// Dual and primal pivots alternate, each time with a new inverse, at most this many times.
const ALTERNATION_LIMIT: usize = 12;

/// The perturbation of a weight is below this, relative to the weight.
const WEIGHT_PERTURBATION: f64 = 1e-7;

impl<const D: usize> NormalProgram<D> {
    /// The program for directions and their weights. The first basis is the normals along the axes, at y = 0, and all
    /// slacks.
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
            is_perturbed: true,
            rows: Vec::new(),
            entries: Vec::new(),
            pivots_since_inverse: 0,
            pivots: 0,
            entries_read: 0,
            entries_told: 0,
            entries_limit: u64::MAX,
            precision: FINEST_PRECISION,
        };
        for axis in axes {
            program.add_row(axis);
        }
        program.normal_is_basic.fill(true);
        program.refactor().expect("the axes are a basis");
        program
    }

    /// The number of constraints of the dual, and of basic variables.
    fn size(&self) -> usize {
        self.basis.len()
    }

    /// The centre p.
    pub(crate) fn center(&self) -> [f64; D] {
        std::array::from_fn(|c| if c < self.rank { self.prices[c] } else { 0.0 })
    }

    /// The coefficients c.
    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.prices[self.rank..]
    }

    /// The normals that have been added, in their order.
    pub(crate) fn rows(&self) -> &[NormalRow<D>] {
        &self.rows
    }

    /// The normals with positive multipliers y_u, and these.
    pub(crate) fn multipliers(&self) -> impl Iterator<Item = (&NormalRow<D>, f64)> {
        self.basis.iter().zip(&self.values).filter_map(|(basic, &y)| match basic {
            Basic::Normal(j) if y > 0.0 => Some((&self.rows[*j], y)),
            _ => None,
        })
    }

    /// Adds a normal, which may enter the basis from now on.
    pub(crate) fn add_row(&mut self, row: NormalRow<D>) {
        let coordinates = row.normal[..self.rank].iter().copied();
        self.entries.push(coordinates.chain(self.directions.iter().map(|v| dot(&row.normal, v).abs())).collect());
        self.rows.push(row);
        self.normal_is_basic.push(false);
    }

    /// Replaces perturbed weights by the true ones, and returns whether the weights were perturbed.
    pub(crate) fn restore_weights(&mut self) -> bool {
        let was_perturbed = std::mem::replace(&mut self.is_perturbed, false);
        if self.refactor().is_err() {
            self.values = self.solve_values();
        }
        was_perturbed
    }

    /// The right side of a constraint of the dual: zero for a coordinate, the weight of a direction.
    fn bound(&self, constraint: usize) -> f64 {
        let Some(i) = constraint.checked_sub(self.rank) else { return 0.0 };
        // The fractional parts of multiples of the golden ratio are spread evenly over [0, 1).
        let spread = (i as f64 + 1.0) * 0.618_033_988_749_894_9;
        let perturbation = if self.is_perturbed { WEIGHT_PERTURBATION * (spread - spread.floor()) } else { 0.0 };
        self.weights[i] * (1.0 + perturbation)
    }

    /// The values of the basic variables, by the inverse.
    fn solve_values(&self) -> Vec<f64> {
        let bounds: Vec<f64> = (0..self.size()).map(|i| self.bound(i)).collect();
        self.inverse.iter().map(|row| product_in_fours(row, &bounds)).collect()
    }

    /// The entries that have been read so far.
    pub(crate) fn entries_read(&self) -> u64 {
        self.entries_read
    }

    /// Sets the number of entries after which the method gives up.
    pub(crate) fn set_entries_limit(&mut self, limit: u64) {
        self.entries_limit = limit;
    }

    /// The entries that have been read since this was asked the last time.
    pub(crate) fn take_entries_read(&mut self) -> u64 {
        self.entries_read - std::mem::replace(&mut self.entries_told, self.entries_read)
    }

    /// The number of entries of some vectors that are as long as a column.
    fn entries_of(&self, vectors: usize) -> u64 {
        vectors as u64 * self.size() as u64
    }

    /// Moves to the optimal basis for the normals so far.
    pub(crate) fn optimize(&mut self) -> Result<(), Stuck> {
        let most = 12 * (self.size() + self.rows.len()) as u64 + 2000;
        let end = self.pivots + most;
        if self.pivots_since_inverse >= PIVOTS_PER_INVERSE {
            self.refactor()?;
        }
        // Rounding may let primal pivots undo dual ones and the other way round; what is left after some alternations
        // is within rounding.
        for _ in 0..ALTERNATION_LIMIT {
            self.make_feasible(end)?;
            self.improve(end)?;
            if self.pivots_since_inverse == 0 {
                break;
            }
            self.refactor()?;
        }
        Ok(())
    }

    /// Primal pivots: a variable enters the basis while one has a positive reduced gain.
    fn improve(&mut self, end: u64) -> Result<(), Stuck> {
        let mut candidates: Vec<Basic> = Vec::new();
        loop {
            let mut best = self.best_of(&candidates);
            if best.is_none() {
                candidates = self.promising();
                self.entries_read += self.entries_of(self.rows.len());
                best = self.best_of(&candidates);
            }
            self.entries_read += self.entries_of(candidates.len());
            let Some((entering, gain)) = best else { return Ok(()) };
            let column = self.column(entering);
            let Some(leaving) = self.leaving(&column) else { return Err(Stuck) };
            let step = gain / column[leaving];
            for (price, v) in self.prices.iter_mut().zip(&self.inverse[leaving]) {
                *price += step * v;
            }
            self.pivot(leaving, entering, &column);
            if self.pivots > end || self.entries_read > self.entries_limit {
                return Err(Stuck);
            }
            if self.pivots_since_inverse >= PIVOTS_PER_INVERSE {
                self.refactor()?;
            }
        }
    }

    /// Dual pivots: a variable leaves the basis while one has a negative value.
    fn make_feasible(&mut self, end: u64) -> Result<(), Stuck> {
        loop {
            let scale = self.values.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
            let worst = (0..self.size()).min_by(|&a, &b| self.values[a].total_cmp(&self.values[b])).ok_or(Stuck)?;
            if self.values[worst] >= -10.0 * self.precision * scale {
                return Ok(());
            }
            self.entries_read += 2 * self.entries_of(self.rows.len());
            let row = &self.inverse[worst];
            let normals = (0..self.rows.len()).filter(|&j| !self.normal_is_basic[j]);
            let slacks = (0..self.directions.len()).filter(|&i| !self.slack_is_basic[i]);
            let normals = normals.map(|j| {
                let entries = &self.entries[j];
                (
                    Basic::Normal(j),
                    product_in_fours(row, entries),
                    product_in_fours(entries, &self.prices) - self.rows[j].height,
                )
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
            if self.pivots > end || self.entries_read > self.entries_limit {
                return Err(Stuck);
            }
            if self.pivots_since_inverse >= PIVOTS_PER_INVERSE {
                self.refactor()?;
            }
        }
    }

    /// Replaces a basic variable by an entering one, whose column is given, and updates inverse and values.
    fn pivot(&mut self, leaving: usize, entering: Basic, column: &[f64]) {
        // The column of the entering variable was read with the inverse, and the inverse is written.
        self.entries_read += 2 * self.entries_of(self.size());
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
        self.pivots_since_inverse += 1;
        self.pivots += 1;
    }
}
