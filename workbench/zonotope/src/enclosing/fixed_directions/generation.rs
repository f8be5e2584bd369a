//! Normals as they are needed: solve, find the points outside the zonotope so far and the facets that they see, add those normals, repeat.

use std::collections::BTreeSet;

use super::facet_descent::{FacetDescent, dot};
use super::normal_program::{NormalProgram, NormalRow, Stuck};
use crate::tally::{Operation, Tally};

/// A program over normals together with the points that it is about.
pub(crate) struct Generation<'a, const D: usize> {
    rank: usize,
    points: &'a [[f64; D]],
    directions: Vec<[f64; D]>,
    pub(crate) program: NormalProgram<D>,
    /// The points that have been far along some normal: they are looked at first.
    working: Vec<usize>,
    is_working: Vec<bool>,
    /// The facets whose normals are there, with the point that was farthest.
    seen: BTreeSet<([usize; D], bool, usize)>,
    /// A point outside by less than this, relatively, is inside.
    precision: f64,
    pub(crate) rounds: usize,
    pub(crate) passes: usize,
}

/// A point outside the zonotope, and the facet that it sees.
struct Outside<const D: usize> {
    depth: f64,
    normal: [f64; D],
    key: ([usize; D], bool),
}

/// Rounds after which rounding errors must be what keeps the search from ending.
const MOST_ROUNDS: usize = 2000;

/// A length that counts as nothing beside the longest generator: it makes generators that are not used yet span the space.
const NOTHING: f64 = 1e-12;

impl<'a, const D: usize> Generation<'a, D> {
    /// Begins with the coordinate axes as normals, both ways.
    pub(crate) fn new(
        rank: usize,
        points: &'a [[f64; D]],
        directions: Vec<[f64; D]>,
        weights: Vec<f64>,
        tally: &mut impl Tally,
    ) -> Self {
        let axes: Vec<[f64; D]> = (0..rank).map(|a| std::array::from_fn(|c| f64::from(u8::from(a == c)))).collect();
        let opposite = axes.iter().map(|u| u.map(|c| -c));
        let all: Vec<usize> = (0..points.len()).collect();
        let (forward, back): (Vec<_>, Vec<_>) = (
            axes.iter().map(|u| farthest(points, &all, *u)).collect(),
            opposite.map(|u| farthest(points, &all, u)).collect(),
        );
        tally.add(Operation::PointRead, 2 * (rank * points.len()) as u64);
        let mut generation = Self {
            rank,
            points,
            program: NormalProgram::new(rank, forward.clone(), directions.clone(), weights),
            directions,
            working: Vec::new(),
            is_working: vec![false; points.len()],
            seen: BTreeSet::new(),
            precision: 1e-14,
            rounds: 0,
            passes: 1,
        };
        for row in &forward {
            generation.work_on(row.point);
        }
        for row in back {
            generation.work_on(row.point);
            generation.program.add_row(row);
        }
        generation
    }

    fn work_on(&mut self, point: usize) {
        if !std::mem::replace(&mut self.is_working[point], true) {
            self.working.push(point);
        }
    }

    /// Adds a normal with the farthest of all points along it.
    #[cfg(feature = "linear-programming")]
    pub(crate) fn add_normal(&mut self, normal: [f64; D], tally: &mut impl Tally) {
        let length = dot(&normal, &normal).sqrt();
        if length > 0.0 && length.is_finite() {
            let all: Vec<usize> = (0..self.points.len()).collect();
            tally.add(Operation::PointRead, self.points.len() as u64);
            let row = farthest(self.points, &all, normal.map(|c| c / length));
            self.work_on(row.point);
            self.program.add_row(row);
        }
    }

    /// How precisely the programs are solved from now on, relatively; finest at first.
    pub(crate) fn set_precision(&mut self, precision: f64) {
        self.precision = precision;
        self.program.precision = precision;
    }

    pub(crate) fn directions(&self) -> &[[f64; D]] {
        &self.directions
    }

    /// Solves until no point is outside by more than rounding.
    pub(crate) fn run(&mut self, tally: &mut impl Tally) -> Result<(), Stuck> {
        for _ in 0..MOST_ROUNDS {
            self.rounds += 1;
            tally.add(Operation::SearchStep, 1);
            self.program.optimize()?;
            let working = std::mem::take(&mut self.working);
            let mut outside = self.outside(&working, tally);
            self.working = working;
            let mut over_all = false;
            if outside.is_empty() && self.working.len() < self.points.len() {
                let others: Vec<usize> = (0..self.points.len()).filter(|&j| !self.is_working[j]).collect();
                self.passes += 1;
                over_all = true;
                outside = self.outside(&others, tally);
            }
            if !self.add_facets(outside, over_all, tally) && !self.program.settle_weights() {
                return Ok(());
            }
        }
        Err(Stuck)
    }

    /// The facets that points outside see, the deepest first, each once.
    fn outside(&self, among: &[usize], tally: &mut impl Tally) -> Vec<Outside<D>> {
        let (center, coefficients) = (self.program.center(), self.program.coefficients());
        let longest = coefficients.iter().fold(0.0, |max: f64, c| max.max(*c));
        let least = if longest > 0.0 { NOTHING * longest } else { NOTHING };
        let generators: Vec<[f64; D]> =
            self.directions.iter().zip(coefficients).map(|(v, c)| v.map(|v| v * c.max(least))).collect();
        let rounding = self.precision * (1.0 + generators.iter().map(|g| dot(g, g).sqrt()).sum::<f64>());
        let mut descent = FacetDescent::new(self.rank, &generators);
        let mut found: Vec<Outside<D>> = Vec::new();
        tally.add(Operation::PointRead, among.len() as u64);
        for &j in among {
            let point: [f64; D] = std::array::from_fn(|c| self.points[j][c] - center[c]);
            let Some(facet) = descent.facet(&point) else { continue };
            let length = dot(&facet.normal, &facet.normal).sqrt();
            let depth = (1.0 - facet.gauge) / length;
            if depth > rounding {
                let mut basis = facet.basis;
                basis[..self.rank - 1].sort_unstable();
                let normal = facet.normal.map(|c| c / length);
                let upward = normal.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
                found.push(Outside { depth, normal, key: (basis, upward) });
            }
        }
        found.sort_by(|a, b| b.depth.total_cmp(&a.depth));
        let mut keys = BTreeSet::new();
        found.retain(|o| keys.insert(o.key));
        found
    }

    /// Adds the normals of facets; whether any of them is new.
    fn add_facets(&mut self, outside: Vec<Outside<D>>, over_all: bool, tally: &mut impl Tally) -> bool {
        let most = 2 * (self.rank + self.directions.len()) + 20;
        let mut is_new = false;
        let all: Vec<usize> = if over_all { (0..self.points.len()).collect() } else { self.working.clone() };
        for Outside { normal, key, .. } in outside.into_iter().take(most) {
            tally.add(Operation::PointRead, all.len() as u64);
            let row = farthest(self.points, &all, normal);
            if self.seen.insert((key.0, key.1, row.point)) {
                self.work_on(row.point);
                self.program.add_row(row);
                is_new = true;
            }
        }
        is_new
    }
}

/// A normal with the farthest of some points along it.
fn farthest<const D: usize>(points: &[[f64; D]], among: &[usize], normal: [f64; D]) -> NormalRow<D> {
    let (mut point, mut height) = (among[0], f64::NEG_INFINITY);
    for &j in among {
        let h = dot(&normal, &points[j]);
        if h > height {
            (point, height) = (j, h);
        }
    }
    NormalRow { normal, height, point }
}
