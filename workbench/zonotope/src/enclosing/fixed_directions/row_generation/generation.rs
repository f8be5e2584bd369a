//! Row generation: solve the program for the normals so far, find points outside its zonotope, add the normals of the
//! facets through which their rays leave, and repeat.

use std::collections::{BTreeMap, BTreeSet};

use super::normal_simplex::{NormalProgram, NormalRow, Stuck};
use crate::enclosing::fixed_directions::farthest::{Far, farthest};
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};
use crate::zonotope::ray_exit::FacetMap;

/// A program over normals, with the points that it is for and the facets met so far.
pub(crate) struct Generation<'a, const D: usize> {
    rank: usize,
    points: &'a [[f64; D]],
    directions: Vec<[f64; D]>,
    pub(crate) map: FacetMap<D>,
    pub(crate) program: NormalProgram<D>,
    /// The working set: a sample of many points, and the points that have been farthest along a normal. All of its
    /// points are inside before the others are looked at.
    working: Vec<usize>,
    /// Whether each point is in the working set.
    is_working: Vec<bool>,
    /// The facets whose normals have been added, each with its side and the point that was farthest along the normal.
    added: BTreeSet<([usize; D], bool, usize)>,
    /// A point outside by less than this, relative to the total length of the generators, counts as inside.
    precision: f64,
    /// The products that looks at points have taken.
    looks: u64,
    /// The generation gives up after so much work.
    work_limit: u64,
    /// The number of programs solved.
    pub(crate) rounds: usize,
    /// The number of passes over all points.
    pub(crate) passes: usize,
}

/// A facet through which the ray to a point outside the zonotope leaves.
struct ViolatedFacet<const D: usize> {
    /// The height of that point above the facet; of several points, of the highest.
    depth: f64,
    /// The facet's unit normal, away from the centre.
    normal: [f64; D],
    /// The directions that span the facet, and on which of the two sides of the zonotope it is.
    key: ([usize; D], bool),
}

/// Row generation gives up after this many rounds: only rounding errors can keep it from ending then.
const ROUND_LIMIT: usize = 2000;

/// A point whose ray leaves the zonotope at a greater multiple of it than this is inside in spite of rounding errors.
const CERTAINLY_INSIDE_REACH: f64 = 1.0 + 1e-9;

/// The working set begins with about this many of the points if there are at least four times as many.
const SAMPLE_SIZE: usize = 2048;

/// A look at a point takes about so many products, where the facet that its ray meets is known or near.
const PRODUCTS_PER_LOOK: u64 = 64;

/// The least coefficient in a search for facets, relative to the largest one: directions with the coefficient 0 get
/// this one, so that the generators span the space.
const LEAST_RELATIVE_COEFFICIENT: f64 = 1e-12;

impl<'a, const D: usize> Generation<'a, D> {
    /// The generation that begins with the coordinate axes and their opposites as normals.
    pub(crate) fn new(
        rank: usize,
        points: &'a [[f64; D]],
        directions: Vec<[f64; D]>,
        weights: Vec<f64>,
        tally: &mut dyn Tally,
    ) -> Self {
        let axes: Vec<[f64; D]> = (0..rank).map(|a| std::array::from_fn(|c| f64::from(u8::from(a == c)))).collect();
        let ends = farthest(points, 0..points.len(), &axes);
        let (back, forward): (Vec<_>, Vec<_>) = axes
            .iter()
            .zip(ends)
            .map(|(u, [low, high])| (row_of(u.map(|c| -c), Far { height: -low.height, ..low }), row_of(*u, high)))
            .unzip();
        tally.add(Operation::PointRead, 2 * rank as u64 * points.len() as u64);
        let mut generation = Self {
            rank,
            points,
            map: FacetMap::new(rank, &directions),
            program: NormalProgram::new(rank, forward.clone(), directions.clone(), weights),
            directions,
            working: Vec::new(),
            is_working: vec![false; points.len()],
            added: BTreeSet::new(),
            precision: 1e-14,
            looks: 0,
            work_limit: u64::MAX,
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
        // A sample in the working set saves passes over all points.
        let stride = points.len() / SAMPLE_SIZE;
        if stride >= 4 {
            (0..points.len()).step_by(stride).for_each(|point| generation.work_on(point));
        }
        generation
    }

    /// Adds a point to the working set.
    fn work_on(&mut self, point: usize) {
        if !std::mem::replace(&mut self.is_working[point], true) {
            self.working.push(point);
        }
    }

    /// Adds a normal with the farthest of all points along it.
    #[cfg(feature = "linear-programming")]
    pub(crate) fn add_normal(&mut self, normal: [f64; D], tally: &mut dyn Tally) {
        let length = dot(&normal, &normal).sqrt();
        if length > 0.0 && length.is_finite() {
            tally.add(Operation::PointRead, self.points.len() as u64);
            let normal = normal.map(|c| c / length);
            let [_, high] = farthest(self.points, 0..self.points.len(), &[normal])[0];
            self.work_on(high.point);
            self.program.add_row(row_of(normal, high));
        }
    }

    /// Sets the relative precision to which the programs are solved from now on; it begins with the finest.
    pub(crate) fn set_precision(&mut self, precision: f64) {
        self.precision = precision;
        self.program.precision = precision;
    }

    /// Sets the work after which the generation gives up: entries that the programs read, and products of points.
    pub(crate) fn set_work_limit(&mut self, limit: u64) {
        self.work_limit = limit;
    }

    /// The work so far.
    pub(crate) fn work(&self) -> u64 {
        self.program.entries_read() + self.looks
    }

    /// The directions of the program.
    pub(crate) fn directions(&self) -> &[[f64; D]] {
        &self.directions
    }

    /// Solves and adds normals until no point is outside by more than the precision.
    pub(crate) fn run(&mut self, tally: &mut dyn Tally) -> Result<(), Stuck> {
        for _ in 0..ROUND_LIMIT {
            if self.work() > self.work_limit {
                return Err(Stuck);
            }
            self.program.set_entries_limit(self.work_limit - self.looks);
            self.rounds += 1;
            tally.add(Operation::SearchStep, 1);
            let optimized = self.program.optimize();
            tally.add(Operation::EntryRead, self.program.take_entries_read());
            optimized?;
            let mut violated = self.violated_facets(false, tally);
            let over_all = violated.is_empty() && self.working.len() < self.points.len();
            if over_all {
                self.passes += 1;
                violated = self.violated_facets(true, tally);
            }
            if !self.add_facets(violated, over_all, tally) && !self.program.restore_weights() {
                return Ok(());
            }
        }
        Err(Stuck)
    }

    /// The facets through which the rays to points outside leave, each once, in the order of decreasing depth: for the
    /// points of the working set, or for the `others`.
    fn violated_facets(&mut self, others: bool, tally: &mut dyn Tally) -> Vec<ViolatedFacet<D>> {
        let (center, coefficients) = (self.program.center(), self.program.coefficients());
        let longest = coefficients.iter().fold(0.0, |max: f64, c| max.max(*c));
        let least = if longest > 0.0 { LEAST_RELATIVE_COEFFICIENT * longest } else { LEAST_RELATIVE_COEFFICIENT };
        let coefficients: Vec<f64> = coefficients.iter().map(|c| c.max(least)).collect();
        let lengths = self.directions.iter().zip(&coefficients).map(|(v, c)| dot(v, v).sqrt() * c);
        let rounding = self.precision * (1.0 + lengths.sum::<f64>());
        self.map.set_coefficients(&coefficients);
        let (points, is_working, working) = (self.points, &self.is_working, &self.working);
        let count = if others { points.len() - working.len() } else { working.len() };
        tally.add(Operation::PointRead, count as u64);
        self.looks += count as u64 * PRODUCTS_PER_LOOK;
        let products_per_height = self.directions.len() as u64 * D as u64;
        let outside_set = (0..points.len()).filter(|&j| others && !is_working[j]);
        let of_set = working.iter().copied().filter(|_| !others);
        let mut deepest: BTreeMap<([usize; D], bool), ViolatedFacet<D>> = BTreeMap::new();
        for j in outside_set.chain(of_set) {
            let ray: [f64; D] = std::array::from_fn(|c| points[j][c] - center[c]);
            let Some(exit) = self.map.exit(&ray).filter(|exit| exit.reach < CERTAINLY_INSIDE_REACH) else { continue };
            let normal = exit.normal;
            self.looks += products_per_height;
            let height: f64 = self.directions.iter().zip(&coefficients).map(|(v, c)| dot(v, &normal).abs() * c).sum();
            let depth = dot(&normal, &ray) - height;
            if depth > rounding {
                let upward = normal.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
                let key = (exit.basis, upward);
                if deepest.get(&key).is_none_or(|facet| facet.depth < depth) {
                    deepest.insert(key, ViolatedFacet { depth, normal, key });
                }
            }
        }
        let mut found: Vec<ViolatedFacet<D>> = deepest.into_values().collect();
        found.sort_by(|a, b| b.depth.total_cmp(&a.depth));
        found
    }

    /// Adds the normals of facets with the farthest points along them: of the working set, or `over_all` points.
    /// Returns whether any of them is new.
    fn add_facets(&mut self, violated: Vec<ViolatedFacet<D>>, over_all: bool, tally: &mut dyn Tally) -> bool {
        let most = 2 * (self.rank + self.directions.len()) + 20;
        let mut is_new = false;
        let violated: Vec<ViolatedFacet<D>> = violated.into_iter().take(most).collect();
        let normals: Vec<[f64; D]> = violated.iter().map(|facet| facet.normal).collect();
        let count = if over_all { self.points.len() } else { self.working.len() };
        tally.add(Operation::PointRead, count as u64 * normals.len() as u64);
        self.looks += count as u64 * normals.len() as u64 * D as u64;
        let far = if over_all {
            farthest(self.points, 0..self.points.len(), &normals)
        } else {
            farthest(self.points, self.working.iter().copied(), &normals)
        };
        for (ViolatedFacet { normal, key, .. }, [_, high]) in violated.into_iter().zip(far) {
            if self.added.insert((key.0, key.1, high.point)) {
                self.work_on(high.point);
                self.program.add_row(row_of(normal, high));
                is_new = true;
            }
        }
        is_new
    }
}

/// The row of a normal and the farthest point along it.
fn row_of<const D: usize>(normal: [f64; D], far: Far) -> NormalRow<D> {
    NormalRow { normal, height: far.height, point: far.point }
}
