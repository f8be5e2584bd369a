//! Points with multipliers, and the sets of points that are on one side of the others.
//!
//! Σ_j |λ_j · v| is the largest of 2 Σ_{j ∈ T} λ_j · v over all sets T of points, as Σ λ_j = 0. So the multipliers are within their limits for every unit vector v
//! just when |w_T| ≤ 1 for every T, w_T = 2 Σ_{j ∈ T} λ_j. Each T is a generator of which T is at one end and the other points at the other; unlike a direction of
//! a net it turns freely. Those T that part the points by a plane through the origin, on the side of a vertex of Σ [−1, 1] λ_j, are all that count.
//!
//! For each set a slack (τ_T, w_T) and a load (t_T, −g_T) lie in the cone of [`ConeVector`] vectors. At the optimum p_j − p_0 = Σ_{T ∋ j} 2 g_T for every point, τ_T = 1, and
//! Σ t_T = Σ λ_j · p_j. Sets are kept in an order in which neighbours differ by few points: that of a reflected binary code.

use std::collections::BTreeSet;

use super::interior::cone::ConeVector;
use super::interior::scalar::{Scalar, dot, plus, real, values, zero};
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;

/// A set of points, one bit each, with its slack and its load.
#[derive(Debug, Clone)]
pub(super) struct Side<R, const D: usize> {
    pub(super) set: Vec<u64>,
    pub(super) slack: ConeVector<R, D>,
    pub(super) load: ConeVector<R, D>,
    /// How long its generator may be expected to be.
    expected: f64,
}

impl<R, const D: usize> Side<R, D> {
    pub(super) fn members(&self) -> impl Iterator<Item = usize> {
        members(&self.set)
    }
}

/// Points with their multipliers, and the sets of points seen so far.
pub(super) struct Sides<'a, R, const D: usize> {
    coordinates: &'a BoxCoordinates<'a, D>,
    pub(super) rank: usize,
    /// Relative to the first one, which lies in no set.
    pub(super) points: Vec<[R; D]>,
    /// And in box coordinates.
    spread: Vec<[f64; D]>,
    pub(super) multipliers: Vec<[R; D]>,
    pub(super) sides: Vec<Side<R, D>>,
    known: BTreeSet<Vec<u64>>,
    /// What slack · load is to be for a new set.
    pub(super) mu: f64,
    /// Roughly the least length of a zonotope around the points.
    pub(super) length: f64,
    /// Products and sums so far, roughly.
    pub(super) work: f64,
}

/// So many times as many sets as coordinates of multipliers are kept, and no fewer than so many.
const MOST_SETS: usize = 4;
const FEW_SETS: usize = 1000;

/// The generator of a new set begins shorter than what there is room for by this.
const SHORTER: f64 = 15.0;

/// Points nearer to each other than this, in box coordinates, are so far apart: the rest is rounding.
const NEAREST: f64 = 1e-14;

/// A new point joins the sets of one that is nearer by this to it than the vertex along its pull.
const MUCH_NEARER: f64 = 10.0;

/// The gap at the beginning, as a multiple of the length.
const BEGIN: f64 = 0.5;

impl<'a, R: Scalar, const D: usize> Sides<'a, R, D> {
    /// The first point, with no multiplier at all; roughly the length to be expected.
    pub(super) fn new(rank: usize, coordinates: &'a BoxCoordinates<'a, D>, length: f64) -> Self {
        Self {
            coordinates,
            rank,
            points: vec![zero()],
            spread: vec![[0.0; D]],
            multipliers: vec![zero()],
            sides: Vec::new(),
            known: BTreeSet::new(),
            mu: BEGIN * length / rank as f64,
            length,
            work: 0.0,
        }
    }

    /// Points with multipliers, and the sets on the positive side of some directions.
    pub(super) fn begun(
        rank: usize,
        coordinates: &'a BoxCoordinates<'a, D>,
        points: &[[f64; D]],
        multipliers: Vec<[f64; D]>,
        directions: &[[f64; D]],
    ) -> Self {
        let points: Vec<[R; D]> = points.iter().map(|p| apart(p, &points[0])).collect();
        let multipliers: Vec<[R; D]> = multipliers.iter().map(real).collect();
        let length = points.iter().zip(&multipliers).map(|(p, f)| dot(p, f).value()).sum();
        let spread = points.iter().map(|p| coordinates.vector(&values(p))).collect();
        let mut sides = Self { points, spread, multipliers, ..Self::new(rank, coordinates, length) };
        sides.mu = BEGIN * length / (directions.len() + sides.points.len()) as f64;
        for point in 1..sides.points.len() {
            sides.add_own(point);
        }
        for direction in directions {
            sides.part(direction);
        }
        sides
    }

    /// Adds a point, where the first one is, and a direction in which it will be pulled; its own set keeps its multiplier within limits.
    pub(super) fn add_point(&mut self, point: &[f64; D], first: &[f64; D], pull: &[f64; D]) {
        let place = self.points.len();
        let apart = apart(point, first);
        let joined = self.joined(&apart, pull);
        for (side, is_in) in self.sides.iter_mut().zip(joined) {
            if place.is_multiple_of(64) {
                side.set.push(0);
            }
            if is_in {
                insert(&mut side.set, place);
            }
        }
        self.points.push(apart);
        self.spread.push(self.coordinates.vector(&values(&apart)));
        self.multipliers.push(zero());
        self.known = self.sides.iter().map(|side| side.set.clone()).collect();
        self.add_own(place);
    }

    /// The sets that a new point joins: those of the vertex along its pull, or of the point nearest to it where that is much nearer.
    fn joined(&self, point: &[R; D], pull: &[f64; D]) -> Vec<bool> {
        let pull = real(pull);
        let along_pull: Vec<bool> = self.sides.iter().map(|side| dot(&side.slack.rest, &pull).value() > 0.0).collect();
        let size = |v: &[R; D]| self.coordinates.size(&values(v));
        let missed = |joined: &[bool]| {
            let ends = self.sides.iter().zip(joined).filter(|(_, is_in)| **is_in);
            size(&ends.fold(*point, |rest, (side, _)| plus(&rest, R::from(2.0), &side.load.rest)))
        };
        let distance = |other: &[R; D]| size(&plus(point, R::from(-1.0), other));
        let others = self.points.iter().map(distance).enumerate();
        let (nearest, _) = others.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there is a first point");
        let of_nearest: Vec<bool> = self.sides.iter().map(|side| contains(&side.set, nearest)).collect();
        if MUCH_NEARER * missed(&of_nearest) < missed(&along_pull) { of_nearest } else { along_pull }
    }

    fn add_own(&mut self, point: usize) {
        let mut own = vec![0; self.points.len().div_ceil(64)];
        insert(&mut own, point);
        self.add_set(own);
    }

    /// Adds the set of points whose multipliers point to one side; whether it is new.
    pub(super) fn part(&mut self, vertex: &[f64; D]) -> bool {
        let vertex = real(vertex);
        let of_first = dot(&self.multipliers[0], &vertex).value() > 0.0;
        let mut set = vec![0; self.points.len().div_ceil(64)];
        let mut is_empty = true;
        for (j, multiplier) in self.multipliers.iter().enumerate() {
            if (dot(multiplier, &vertex).value() > 0.0) != of_first {
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
        let w = sum_over(&set, &self.multipliers);
        let square = dot(&w, &w);
        let along =
            if square.value() > 0.0 { self.coordinates.segment(&values(&w)) } else { self.length / self.rank as f64 };
        let expected = along * self.parted(&set).min(1.0 / self.points.len() as f64) / SHORTER;
        let square = square + R::from(self.mu / expected);
        let head = if square.value() < 1.0 { R::from(1.0) } else { square.sqrt() };
        let slack = ConeVector { head, rest: w };
        self.sides.push(Side { set, slack, load: slack.load(R::from(self.mu)), expected });
        true
    }

    /// How near a point of a set comes to one that is not in it, in box coordinates.
    fn parted(&self, set: &[u64]) -> f64 {
        let mut least = f64::INFINITY;
        for j in members(set) {
            for (k, other) in self.spread.iter().enumerate() {
                if !contains(set, k) {
                    let apart = plus(&self.spread[j], -1.0, other);
                    least = least.min(dot(&apart, &apart));
                }
            }
        }
        least.sqrt().max(NEAREST)
    }

    /// Brings the sets into their order, and forgets those that bear least if there are too many.
    pub(super) fn tidy(&mut self) {
        let most = (MOST_SETS * self.rank * self.points.len()).max(FEW_SETS);
        if self.sides.len() > most {
            let load = |side: &Side<R, D>| side.load.head.value() / side.expected;
            let mut loads: Vec<f64> = self.sides.iter().map(load).collect();
            let (_, least, _) = loads.select_nth_unstable_by(most, |a, b| b.total_cmp(a));
            let is_single = |side: &Side<R, D>| side.set.iter().map(|word| word.count_ones()).sum::<u32>() == 1;
            self.sides.retain(|side| load(side) > *least || is_single(side));
            self.known = self.sides.iter().map(|side| side.set.clone()).collect();
        }
        self.sides.sort_by_cached_key(|side| place_in_code(&side.set));
    }

    /// Moves slacks and loads inward until the gap is no less than this; multipliers and generators stay.
    pub(super) fn widen(&mut self, gap: f64) {
        let mu = gap / self.sides.len() as f64;
        if mu <= self.mu {
            return;
        }
        self.mu = mu;
        let mu = R::from(mu);
        let larger = |a: R, b: R| if a < b { b } else { a };
        for Side { slack, load, .. } in &mut self.sides {
            let square = dot(&slack.rest, &slack.rest);
            slack.head = larger(slack.head, (square + mu / load.head).sqrt());
            let square = dot(&load.rest, &load.rest);
            load.head = larger(load.head, (square + mu * mu / slack.room()).sqrt());
        }
    }

    /// The multipliers, turned; the first one makes up for the others.
    pub(super) fn turned(&self, factor: R, step: &[[R; D]]) -> Vec<[R; D]> {
        let others = self.multipliers[1..].iter().zip(step).map(|(multiplier, step)| plus(multiplier, factor, step));
        let mut multipliers: Vec<[R; D]> = std::iter::once(zero()).chain(others).collect();
        multipliers[0] = multipliers.iter().fold(zero(), |sum, multiplier| plus(&sum, R::from(-1.0), multiplier));
        multipliers
    }
}

/// 2 Σ over a set.
pub(super) fn sum_over<R: Scalar, const D: usize>(set: &[u64], vectors: &[[R; D]]) -> [R; D] {
    members(set).fold(zero(), |sum, j| plus(&sum, R::from(2.0), &vectors[j]))
}

pub(super) fn members(set: &[u64]) -> impl Iterator<Item = usize> {
    set.iter().enumerate().flat_map(|(word, &bits)| {
        let next = |&left: &u64| (left & (left - 1) != 0).then_some(left & left.wrapping_sub(1));
        let first = (bits != 0).then_some(bits);
        std::iter::successors(first, next).map(move |left| 64 * word + left.trailing_zeros() as usize)
    })
}

fn contains(set: &[u64], point: usize) -> bool {
    set[point / 64] >> (point % 64) & 1 == 1
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

/// p − first.
fn apart<R: Scalar, const D: usize>(p: &[f64; D], first: &[f64; D]) -> [R; D] {
    plus(&real(p), R::from(-1.0), &real(first))
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
