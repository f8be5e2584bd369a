//! Points with forces, and the sets of points that are on one side of the others.
//!
//! Σ_j |λ_j · v| is the largest of 2 Σ_{j ∈ T} λ_j · v over all sets T of points, as Σ λ_j = 0. So the forces are within their limits for every unit vector v
//! just when |w_T| ≤ 1 for every T, w_T = 2 Σ_{j ∈ T} λ_j. Each T is a generator of which T is at one end and the other points at the other; unlike a direction of
//! a net it turns freely. Those T that part the points by a plane through the origin, on the side of a vertex of Σ [−1, 1] λ_j, are all that count.
//!
//! For each set a slack (τ_T, w_T) and a load (t_T, −g_T) lie in the cone of [`Headed`] vectors. At the optimum p_j − p_0 = Σ_{T ∋ j} 2 g_T for every point, τ_T = 1, and
//! Σ t_T = Σ λ_j · p_j. Sets are kept in an order in which neighbours differ by few points: that of a reflected binary code.

use std::collections::BTreeSet;

use super::cone::Headed;
use crate::enclosing::fixed_directions::dot;

/// A set of points, one bit each, with its slack and its load.
#[derive(Debug, Clone)]
pub(super) struct Side<const D: usize> {
    pub(super) set: Vec<u64>,
    pub(super) slack: Headed<D>,
    pub(super) load: Headed<D>,
}

impl<const D: usize> Side<D> {
    pub(super) fn members(&self) -> impl Iterator<Item = usize> {
        members(&self.set)
    }
}

/// Points with their forces, and the sets of points seen so far.
pub(super) struct Sides<const D: usize> {
    pub(super) rank: usize,
    /// Relative to the first one, which lies in no set.
    pub(super) points: Vec<[f64; D]>,
    pub(super) forces: Vec<[f64; D]>,
    pub(super) sides: Vec<Side<D>>,
    known: BTreeSet<Vec<u64>>,
    /// What slack · load is to be for a new set.
    pub(super) mu: f64,
    /// Roughly the least length of a zonotope around the points.
    pub(super) length: f64,
    /// Products and sums so far, roughly.
    pub(super) work: f64,
}

/// So many times as many sets as coordinates of forces are kept.
const MOST_SETS: usize = 4;

/// The generator of a new set is shorter than the average one by this.
const SHORTER: f64 = 10.0;

/// A w_T longer than this may be the direction of a generator.
const SHARP: f64 = 0.999;

/// The gap at the beginning, as a multiple of the length.
const BEGIN: f64 = 0.5;

impl<const D: usize> Sides<D> {
    /// The first point, with no force at all; roughly the length to be expected.
    pub(super) fn new(rank: usize, length: f64) -> Self {
        Self {
            rank,
            points: vec![[0.0; D]],
            forces: vec![[0.0; D]],
            sides: Vec::new(),
            known: BTreeSet::new(),
            mu: BEGIN * length / rank as f64,
            length,
            work: 0.0,
        }
    }

    /// Points with forces, and the sets on the positive side of some directions.
    pub(super) fn begun(rank: usize, points: &[[f64; D]], forces: Vec<[f64; D]>, directions: &[[f64; D]]) -> Self {
        let first = points[0];
        let points: Vec<[f64; D]> = points.iter().map(|p| plus(p, -1.0, &first)).collect();
        let length = points.iter().zip(&forces).map(|(p, f)| dot(p, f)).sum();
        let mut sides = Self { points, forces, ..Self::new(rank, length) };
        sides.mu = BEGIN * length / (directions.len() + sides.points.len()) as f64;
        for point in 1..sides.points.len() {
            sides.add_own(point);
        }
        for direction in directions {
            sides.part(direction);
        }
        sides
    }

    /// Adds a point, relative to the first one, and a direction in which it will be pulled; its own set keeps its force within limits.
    pub(super) fn add_point(&mut self, point: [f64; D], pull: [f64; D]) {
        let place = self.points.len();
        for side in &mut self.sides {
            if place.is_multiple_of(64) {
                side.set.push(0);
            }
            if dot(&side.slack.rest, &pull) > 0.0 {
                insert(&mut side.set, place);
            }
        }
        self.points.push(point);
        self.forces.push([0.0; D]);
        self.known = self.sides.iter().map(|side| side.set.clone()).collect();
        self.add_own(place);
    }

    fn add_own(&mut self, point: usize) {
        let mut own = vec![0; self.points.len().div_ceil(64)];
        insert(&mut own, point);
        self.add_set(own);
    }

    /// Adds the set of points whose forces point to one side; whether it is new.
    pub(super) fn part(&mut self, vertex: &[f64; D]) -> bool {
        let of_first = dot(&self.forces[0], vertex) > 0.0;
        let mut set = vec![0; self.points.len().div_ceil(64)];
        let mut is_empty = true;
        for (j, force) in self.forces.iter().enumerate() {
            if (dot(force, vertex) > 0.0) != of_first {
                insert(&mut set, j);
                is_empty = false;
            }
        }
        !is_empty && self.add_set(set)
    }

    fn add_set(&mut self, set: Vec<u64>) -> bool {
        if !self.known.insert(set.clone()) {
            return false;
        }
        let w = sum_over(&set, &self.forces);
        let average = self.length / (self.rank * self.points.len()) as f64;
        let square = dot(&w, &w);
        let slack = Headed { head: (square + SHORTER * self.mu / average).max(1.0).sqrt(), rest: w };
        self.sides.push(Side { set, slack, load: slack.load(self.mu) });
        true
    }

    /// Brings the sets into their order, and forgets those that bear least if there are too many.
    pub(super) fn tidy(&mut self) {
        let most = MOST_SETS * self.rank * self.points.len();
        if self.sides.len() > most {
            let mut loads: Vec<f64> = self.sides.iter().map(|side| side.load.head).collect();
            let (_, least, _) = loads.select_nth_unstable_by(most, |a, b| b.total_cmp(a));
            let is_single = |side: &Side<D>| side.set.iter().map(|word| word.count_ones()).sum::<u32>() == 1;
            self.sides.retain(|side| side.load.head > *least || is_single(side));
            self.known = self.sides.iter().map(|side| side.set.clone()).collect();
        }
        self.sides.sort_by_cached_key(|side| place_in_code(&side.set));
    }

    /// Moves slacks and loads inward until the gap is no less than this; forces and generators stay.
    pub(super) fn widen(&mut self, gap: f64) {
        let mu = gap / self.sides.len() as f64;
        if mu <= self.mu {
            return;
        }
        self.mu = mu;
        for Side { slack, load, .. } in &mut self.sides {
            let square = dot(&slack.rest, &slack.rest);
            slack.head = slack.head.max((square + mu / load.head).sqrt());
            let square = dot(&load.rest, &load.rest);
            load.head = load.head.max((square + mu * mu / slack.room()).sqrt());
        }
    }

    /// The directions of w_T near the unit sphere, those that bear most first.
    pub(super) fn sharp(&self) -> Vec<[f64; D]> {
        let length = |side: &Side<D>| dot(&side.slack.rest, &side.slack.rest).sqrt();
        let mut near: Vec<&Side<D>> = self.sides.iter().filter(|side| length(side) > SHARP).collect();
        near.sort_by(|a, b| b.load.head.total_cmp(&a.load.head));
        near.into_iter().map(|side| side.slack.rest.map(|c| c / length(side))).collect()
    }

    /// The forces, turned; the first one makes up for the others.
    pub(super) fn turned(&self, factor: f64, step: &[[f64; D]]) -> Vec<[f64; D]> {
        let others = self.forces[1..].iter().zip(step).map(|(force, step)| plus(force, factor, step));
        let mut forces: Vec<[f64; D]> = std::iter::once([0.0; D]).chain(others).collect();
        forces[0] = forces.iter().fold([0.0; D], |sum, force| plus(&sum, -1.0, force));
        forces
    }
}

/// 2 Σ over a set.
pub(super) fn sum_over<const D: usize>(set: &[u64], vectors: &[[f64; D]]) -> [f64; D] {
    members(set).fold([0.0; D], |sum, j| plus(&sum, 2.0, &vectors[j]))
}

pub(super) fn members(set: &[u64]) -> impl Iterator<Item = usize> {
    set.iter().enumerate().flat_map(|(word, &bits)| {
        let next = |&left: &u64| (left & (left - 1) != 0).then_some(left & left.wrapping_sub(1));
        let first = (bits != 0).then_some(bits);
        std::iter::successors(first, next).map(move |left| 64 * word + left.trailing_zeros() as usize)
    })
}

fn insert(set: &mut [u64], point: usize) {
    set[point / 64] |= 1 << (point % 64);
}

/// Where a set comes in the reflected binary code, in which neighbours differ by one point.
fn place_in_code(set: &[u64]) -> Vec<u64> {
    let mut is_reflected = false;
    let decoded = set.iter().map(|&word| {
        let mut place = word;
        for shift in [1, 2, 4, 8, 16, 32] {
            place ^= place >> shift;
        }
        if is_reflected {
            place = !place;
        }
        is_reflected = place & 1 == 1;
        place
    });
    decoded.collect()
}

pub(super) fn plus<const D: usize>(a: &[f64; D], factor: f64, b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|c| a[c] + factor * b[c])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_code_passes_all_sets_one_point_at_a_time() {
        // of points 0, 63 and 64: the highest bit of the first word counts most
        let points = [0, 63, 64];
        let mut sets: Vec<Vec<u64>> = (0..8)
            .map(|choice| {
                let mut set = vec![0; 2];
                points.iter().enumerate().filter(|(i, _)| choice >> i & 1 == 1).for_each(|(_, &p)| insert(&mut set, p));
                set
            })
            .collect();
        sets.sort_by_cached_key(|set| place_in_code(set));
        for pair in sets.windows(2) {
            let changed: u32 = pair[0].iter().zip(&pair[1]).map(|(a, b)| (a ^ b).count_ones()).sum();
            assert_eq!(changed, 1);
        }
        assert_eq!(members(&[1 << 63 | 1, 1]).collect::<Vec<_>>(), points);
    }
}
