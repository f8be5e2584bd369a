//! The problem with most generators summed up: their sign is fixed throughout a cell.
//!
//! For any signs fixed on a part of the generators, (Σ sign v) · u + Σ_rest |v · u| ≤ h(u), with equality in the cell where those
//! signs are right. So an optimum of the reduced problem in the cell is an optimum of the whole, by convexity.

use super::cell::{Cell, FixedSum};
use super::certain::Certain;
use super::chart::Chart;
use super::descend::{Stop, descend};
use super::smooth::Columns;
use crate::collision::Displacement;
use crate::numeric::bounded::BoundedVector;

/// Some generators, and the sum of all others.
#[derive(Debug)]
pub(super) struct Reduced {
    pub(super) vectors: Vec<[f64; 3]>,
    /// The index of each in the question.
    pub(super) indices: Vec<u32>,
    pub(super) fixed: FixedSum,
    /// The signs of the others hold in all of these.
    pub(super) cells: Vec<Cell>,
    /// The signs of others that are not those of their dot product with the first cell's centre.
    pub(super) overrides: Vec<(u32, i8)>,
}

/// How a search on a reduced problem ends.
#[derive(Debug)]
pub(super) enum End {
    /// An optimum that bounds on all rounding errors prove.
    Certain(Box<Certain>),
    /// A vertex too near to other lines, or to a change of the basis, for doubles.
    Doubt,
    /// None, or a vertex that is perhaps outside the cells; a point to go on from.
    Astray([f64; 2]),
}

impl Reduced {
    /// All generators, none summed up.
    pub(super) fn whole(question: &Displacement<'_, 3>) -> Self {
        Self {
            vectors: question.generators().copied().collect(),
            indices: (0..question.len() as u32).collect(),
            fixed: FixedSum::default(),
            cells: Vec::new(),
            overrides: Vec::new(),
        }
    }

    /// One pass over the question.
    pub(super) fn of_question(question: &Displacement<'_, 3>, cell: Cell) -> Self {
        let [first, second] = question.runs();
        let (mut vectors, mut indices) = (Vec::new(), Vec::new());
        let mut fixed = FixedSum::default();
        for (run, offset) in [(first, 0), (second, first.len())] {
            if !run.is_empty() {
                fixed = fixed.plus(&cell.split(run, |i| {
                    vectors.push(run[i]);
                    indices.push((offset + i) as u32);
                }));
            }
        }
        Self { vectors, indices, fixed, cells: vec![cell], overrides: Vec::new() }
    }

    /// The same problem with those summed up that miss a cell.
    pub(super) fn split(&self, cell: Cell) -> Self {
        let mut crossing = Vec::with_capacity(64);
        let fixed = self.fixed.plus(&cell.split(&self.vectors, |i| crossing.push(i)));
        let mut overrides = self.overrides.clone();
        let mut kept = crossing.iter().copied().peekable();
        for (i, v) in self.vectors.iter().enumerate() {
            if kept.next_if_eq(&i).is_none() {
                overrides.push((self.indices[i], cell.sign(v)));
            }
        }
        let mut cells = self.cells.clone();
        cells.push(cell);
        Self {
            vectors: crossing.iter().map(|&i| self.vectors[i]).collect(),
            indices: crossing.iter().map(|&i| self.indices[i]).collect(),
            fixed,
            cells,
            overrides,
        }
    }

    pub(super) fn columns(&self, chart: &Chart) -> Columns {
        Columns::collect(self.vectors.iter().map(|v| chart.weighted_line(v)))
    }

    /// The gradient of the summed-up part.
    pub(super) fn linear(&self, chart: &Chart) -> [f64; 2] {
        let [x, y, _] = chart.line(&self.fixed.sum);
        [x, y]
    }

    /// Descends from a point and checks what it ends in.
    pub(super) fn solve(&self, columns: &Columns, chart: &Chart, p: &BoundedVector, start: [f64; 2]) -> End {
        match descend(columns, self.linear(chart), start) {
            Ok(basis) => Certain::at(self, columns, p, basis),
            Err(Stop::NoVertex) => End::Astray(start),
            Err(Stop::Undecided) => End::Doubt,
        }
    }
}
