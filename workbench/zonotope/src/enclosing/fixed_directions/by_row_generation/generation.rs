//! Normals as they are needed: solve, find the points outside the zonotope so far and the facets that they see, add
//! those normals, repeat.

use std::collections::{BTreeMap, BTreeSet};

use super::normal_simplex::{NormalProgram, NormalRow, Stuck};
use crate::enclosing::fixed_directions::farthest::{Far, farthest};
use crate::tally::{Operation, Tally};
use crate::zonotope::ray_exit::{FacetMap, dot};

/// A program over normals together with the points that it is about.
pub(crate) struct Generation<'a, const D: usize> {
    rank: usize,
    points: &'a [[f64; D]],
    directions: Vec<[f64; D]>,
    pub(crate) map: FacetMap<D>,
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

/// After this many rounds rounding errors must be what keeps the search from ending.
const ROUND_LIMIT: usize = 2000;

/// A point whose ray leaves the zonotope beyond this multiple is inside whatever rounding did.
const CERTAINLY_INSIDE_REACH: f64 = 1.0 + 1e-9;

/// Of many points about this many are looked at first.
const SAMPLE_SIZE: usize = 2048;

/// The length, beside the longest generator, that directions with the coefficient 0 get, so that all of them span the
/// space.
const LEAST_RELATIVE_LENGTH: f64 = 1e-12;

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
        let ends = farthest(points, 0..points.len(), &axes);
        let (back, forward): (Vec<_>, Vec<_>) = axes
            .iter()
            .zip(ends)
            .map(|(u, [low, high])| (row_of(u.map(|c| -c), Far { height: -low.height, ..low }), row_of(*u, high)))
            .unzip();
        tally.add(Operation::PointRead, 2 * (rank * points.len()) as u64);
        let mut generation = Self {
            rank,
            points,
            map: FacetMap::new(rank, &directions),
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
        // Of many points some are looked at first, so that few passes over all of them are needed.
        let stride = points.len() / SAMPLE_SIZE;
        if stride >= 4 {
            (0..points.len()).step_by(stride).for_each(|point| generation.work_on(point));
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
            tally.add(Operation::PointRead, self.points.len() as u64);
            let normal = normal.map(|c| c / length);
            let [_, high] = farthest(self.points, 0..self.points.len(), &[normal])[0];
            self.work_on(high.point);
            self.program.add_row(row_of(normal, high));
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
        for _ in 0..ROUND_LIMIT {
            self.rounds += 1;
            tally.add(Operation::SearchStep, 1);
            self.program.optimize()?;
            let mut outside = self.outside(false, tally);
            let over_all = outside.is_empty() && self.working.len() < self.points.len();
            if over_all {
                self.passes += 1;
                outside = self.outside(true, tally);
            }
            if !self.add_facets(outside, over_all, tally) && !self.program.restore_weights() {
                return Ok(());
            }
        }
        Err(Stuck)
    }

    /// The facets that points outside see, each once, the one with the deepest first: of the points that mattered so
    /// far, or of the others.
    fn outside(&mut self, others: bool, tally: &mut impl Tally) -> Vec<Outside<D>> {
        let (center, coefficients) = (self.program.center(), self.program.coefficients());
        let longest = coefficients.iter().fold(0.0, |max: f64, c| max.max(*c));
        let least = if longest > 0.0 { LEAST_RELATIVE_LENGTH * longest } else { LEAST_RELATIVE_LENGTH };
        let coefficients: Vec<f64> = coefficients.iter().map(|c| c.max(least)).collect();
        let lengths = self.directions.iter().zip(&coefficients).map(|(v, c)| dot(v, v).sqrt() * c);
        let rounding = self.precision * (1.0 + lengths.sum::<f64>());
        self.map.set_coefficients(&coefficients);
        let (points, is_working, working) = (self.points, &self.is_working, &self.working);
        let count = if others { points.len() - working.len() } else { working.len() };
        tally.add(Operation::PointRead, count as u64);
        let unseen = (0..points.len()).filter(|&j| others && !is_working[j]);
        let seen = working.iter().copied().filter(|_| !others);
        let mut deepest: BTreeMap<([usize; D], bool), Outside<D>> = BTreeMap::new();
        for j in unseen.chain(seen) {
            let ray: [f64; D] = std::array::from_fn(|c| points[j][c] - center[c]);
            let Some(exit) = self.map.exit(&ray).filter(|exit| exit.reach < CERTAINLY_INSIDE_REACH) else { continue };
            let normal = exit.normal;
            let height: f64 = self.directions.iter().zip(&coefficients).map(|(v, c)| dot(v, &normal).abs() * c).sum();
            let depth = dot(&normal, &ray) - height;
            if depth > rounding {
                let upward = normal.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
                let key = (exit.basis, upward);
                if deepest.get(&key).is_none_or(|outside| outside.depth < depth) {
                    deepest.insert(key, Outside { depth, normal, key });
                }
            }
        }
        let mut found: Vec<Outside<D>> = deepest.into_values().collect();
        found.sort_by(|a, b| b.depth.total_cmp(&a.depth));
        found
    }

    /// Adds the normals of facets; whether any of them is new.
    fn add_facets(&mut self, outside: Vec<Outside<D>>, over_all: bool, tally: &mut impl Tally) -> bool {
        let most = 2 * (self.rank + self.directions.len()) + 20;
        let mut is_new = false;
        let outside: Vec<Outside<D>> = outside.into_iter().take(most).collect();
        let normals: Vec<[f64; D]> = outside.iter().map(|outside| outside.normal).collect();
        let count = if over_all { self.points.len() } else { self.working.len() };
        tally.add(Operation::PointRead, (count * normals.len()) as u64);
        let far = if over_all {
            farthest(self.points, 0..self.points.len(), &normals)
        } else {
            farthest(self.points, self.working.iter().copied(), &normals)
        };
        for (Outside { normal, key, .. }, [_, high]) in outside.into_iter().zip(far) {
            if self.seen.insert((key.0, key.1, high.point)) {
                self.work_on(high.point);
                self.program.add_row(row_of(normal, high));
                is_new = true;
            }
        }
        is_new
    }
}

fn row_of<const D: usize>(normal: [f64; D], far: Far) -> NormalRow<D> {
    NormalRow { normal, height: far.height, point: far.point }
}
