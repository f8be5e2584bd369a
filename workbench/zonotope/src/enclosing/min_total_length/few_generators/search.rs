//! Stage: the search for directions, over their number.
//!
//! The search for the fewest directions first doubles the number of merged generators until the zonotope along them is
//! short enough, and bisects; nets, and differences of few points, are tried beside them. Then it merges the generators
//! of the sparsest zonotope further, a quarter at first and one by one at last, and lets the directions move after each
//! merger: they end where one generator less makes the zonotope too long.
//!
//! The search for the shortest of so many directions begins with those of boxes and nets and with merged generators,
//! and moves them. Of those that it ends with, it merges nearby ones where that costs hardly any length.

use std::cmp::Ordering;

use super::Search;
use super::along::{Along, Programs, unit};
use super::merging::Merging;
use super::moving::{Aim, moved};
use crate::enclosing::min_total_length::direction_net::cell_corners;
use crate::enclosing::min_total_length::frame::Frame;
use crate::numeric::linear::dot;

/// The nets that the search tries have at most so many cells along a side.
const NET_CELLS: usize = 6;

/// The nets that the search tries have at most so many directions.
const NET_LIMIT: usize = 120;

/// Where the number of generators is given, nets of at most this many times as many directions are tried.
const NET_SIZE_FACTOR: usize = 4;

/// Of at most so many points, the differences are directions that the search tries.
const DIFFERENCE_POINTS: usize = 14;

/// Differences of points whose angle has a cosine above this count as parallel.
const PARALLEL_COSINE: f64 = 1.0 - 1e-12;

/// No linear program has more merged generators as directions.
const MERGED_LIMIT: usize = 320;

/// The relative precision of a linear program, as a share of ε.
const PRECISION_SHARE_OF_EPSILON: f64 = 1e-3;

/// The relative precision of a linear program where the number of generators is given.
const PRECISION: f64 = 1e-7;

/// Limit of the entries and products of points that the programs of a search read.
const WORK_LIMIT: u64 = 1 << 32;

/// The directions move by so many steps after each merger.
const QUICK_STEPS: usize = 4;

/// The directions move by so many steps once the number of generators is the one that is asked for.
const LAST_STEPS: usize = 12;

impl<const D: usize> Search<D> {
    /// The sparsest zonotope found that is no longer than `length`, in units of the frame.
    pub(super) fn fewest(&self, length: f64, epsilon: f64) -> Option<Along<D>> {
        let frame = &self.frame;
        let precision = PRECISION_SHARE_OF_EPSILON * epsilon.clamp(1e-10, 1e-4);
        let programs = Programs::new(frame, precision, WORK_LIMIT);
        let along = |vectors: &[[f64; D]]| programs.along(vectors).filter(|found| found.length <= length);
        let merged = fewest_merged(&Merging::new(self.dense.clone()), frame.rank(), along);
        let best = merged.into_iter().chain(self.starts().find_map(|vectors| along(&vectors)));
        let mut best = best.chain(differences(frame).and_then(|vectors| along(&vectors))).min_by(fewer)?;
        let aim = Aim { length, steps: QUICK_STEPS };
        let mut step = (best.count() / 4).max(1);
        while best.count() > frame.rank() {
            let count = best.count();
            let less = count.saturating_sub(step).max(frame.rank());
            let merged = Merging::new(best.generators()).down_to(less);
            let found = programs.along(&merged).map(|start| moved(&programs, start, aim));
            match found.filter(|found| found.length <= length && found.count() < count) {
                Some(found) => best = found,
                None if step == 1 => break,
                None => step = step.div_ceil(2).min(step - 1),
            }
        }
        Some(best)
    }

    /// The shortest zonotope found with at most `count` generators; nearby ones are merged where that makes it longer
    /// by no more than `slack`, in units of the frame. `None` if `count` is less than the rank, or if all programs
    /// fail.
    pub(super) fn shortest_of_few(&self, count: usize, slack: f64) -> Option<Along<D>> {
        let frame = &self.frame;
        if count < frame.rank() {
            return None;
        }
        let programs = Programs::new(frame, PRECISION, WORK_LIMIT);
        let along = |vectors: &[[f64; D]]| programs.along(vectors);
        let starts = self.starts().take_while(|vectors| vectors.len() <= NET_SIZE_FACTOR * count);
        let given = starts.chain(differences(frame)).filter_map(|vectors| along(&vectors));
        let mut found: Vec<Along<D>> = given.filter(|given| given.count() <= count).collect();
        let merging = Merging::new(self.dense.clone());
        let last = Aim { length: 0.0, steps: LAST_STEPS };
        let quick = Aim { steps: QUICK_STEPS, ..last };
        if let Some(shortest) = found.iter().min_by(|a, b| a.length.total_cmp(&b.length)) {
            found.push(moved(&programs, shortest.clone(), last));
        }
        found.extend(along(&merging.down_to(count)).map(|start| moved(&programs, start, last)));
        // Half as many again, merged step by step.
        let mut current = along(&merging.down_to(count + count / 2));
        while let Some(from) = current.take() {
            if from.count() <= count {
                found.push(moved(&programs, from, last));
            } else {
                let next = (from.count() - (from.count() / 6).max(1)).max(count);
                let merged = Merging::new(from.generators()).down_to(next);
                current = along(&merged).map(|start| moved(&programs, start, quick));
            }
        }
        let found = found.into_iter().filter(|found| found.count() <= count);
        let shortest = found.min_by(|a, b| a.length.total_cmp(&b.length))?;
        let length = shortest.length + slack;
        Some(with_nearby_merged(&programs, shortest, length))
    }

    /// Directions that know nothing of a zonotope: those of boxes, then the corners of nets of more and more cells.
    fn starts(&self) -> impl Iterator<Item = Vec<[f64; D]>> {
        let rank = self.frame.rank();
        let nets = (2..=NET_CELLS).map(move |cells| net(rank, cells)).take_while(|net| net.len() <= NET_LIMIT);
        self.boxes.iter().cloned().chain(nets)
    }
}

/// The zonotope with its nearest generators merged, one pair after the other, while it is no longer than `length` then.
fn with_nearby_merged<const D: usize>(programs: &Programs<'_, D>, start: Along<D>, length: f64) -> Along<D> {
    let mut best = start;
    while best.count() > programs.frame.rank() {
        let merging = Merging::new(best.generators());
        // What two generators lose when they are merged, the others have to make up for.
        if best.length + merging.least_loss() > length {
            break;
        }
        let aim = Aim { length: best.length, steps: QUICK_STEPS };
        let merged = programs.along(&merging.down_to(best.count() - 1)).map(|start| moved(programs, start, aim));
        match merged.filter(|merged| merged.length <= length && merged.count() < best.count()) {
            Some(merged) => best = merged,
            None => break,
        }
    }
    best
}

/// The zonotope along the fewest merged generators that `along` accepts, their number doubled from the rank on and then
/// bisected.
fn fewest_merged<const D: usize>(
    merging: &Merging<D>,
    rank: usize,
    along: impl Fn(&[[f64; D]]) -> Option<Along<D>>,
) -> Option<Along<D>> {
    let most = merging.len().min(MERGED_LIMIT);
    let (mut low, mut high) = (rank, rank);
    let mut best = loop {
        match along(&merging.down_to(high)) {
            Some(found) => break found,
            None if high >= most => return None,
            None => (low, high) = (high + 1, (2 * high).min(most)),
        }
    };
    high = high.min(best.count());
    while low < high {
        let middle = low.midpoint(high);
        match along(&merging.down_to(middle)) {
            Some(found) => (high, best) = (middle.min(found.count()), found),
            None => low = middle + 1,
        }
    }
    Some(best)
}

/// The differences of points, each line once; `None` where there are too many.
fn differences<const D: usize>(frame: &Frame<D>) -> Option<Vec<[f64; D]>> {
    let points = &frame.points;
    if points.len() > DIFFERENCE_POINTS {
        return None;
    }
    let mut found: Vec<[f64; D]> = Vec::new();
    for (p, q) in points.iter().enumerate().flat_map(|(i, p)| points[..i].iter().map(move |q| (p, q))) {
        let Some(v) = unit(&std::array::from_fn(|c| p[c] - q[c])) else { continue };
        if !found.iter().any(|u| dot(u, &v).abs() > PARALLEL_COSINE) {
            found.push(v);
        }
    }
    Some(found)
}

/// The corners of a net of cells in the first `rank` coordinates; in a plane four times as many cells.
fn net<const D: usize>(rank: usize, cells: usize) -> Vec<[f64; D]> {
    fn embedded<const R: usize, const D: usize>(cells: usize) -> Vec<[f64; D]> {
        let corners = cell_corners::<R>(cells);
        corners.iter().map(|v| std::array::from_fn(|c| if c < R { v[c] } else { 0.0 })).collect()
    }
    match rank {
        1 => embedded::<1, D>(1),
        2 => embedded::<2, D>(4 * cells),
        3 => embedded::<3, D>(cells),
        _ => embedded::<D, D>(cells),
    }
}

/// The order of zonotopes by the number of generators, then by length.
fn fewer<const D: usize>(a: &Along<D>, b: &Along<D>) -> Ordering {
    a.count().cmp(&b.count()).then(a.length.total_cmp(&b.length))
}
