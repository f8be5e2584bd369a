//! The points that have a multiplier, and the sets of them whose constraints bound the multipliers.
//!
//! The multipliers λ_j with Σ λ_j = 0 must satisfy Σ_j |λ_j · v| ≤ 1 for every unit vector v. The left side is the
//! largest of 2 Σ_{j ∈ T} λ_j · v over all sets T of points. So the condition says that |w_T| ≤ 1 for every T, with
//! w_T = 2 Σ_{j ∈ T} λ_j: one second-order cone constraint for each set. The multiplier of that constraint is a
//! generator g_T, with the points of T at its one end and the others at its other end; unlike a direction of a net it
//! turns freely. Only few sets matter, those for which w_T is a vertex of Σ [−1, 1] λ_j: a plane through the origin
//! parts the multipliers of their points from the other multipliers.
//!
//! For each set the slack (τ_T, w_T) and the dual variable (t_T, −g_T) lie in the cone of [`ConeVector`]s. At the
//! optimum τ_T = 1, p_j − p_0 = Σ_{T ∋ j} 2 g_T for every point, and Σ t_T = Σ λ_j · p_j. The sets are kept in the
//! order of a reflected binary code, in which neighbours differ by few points: the Schur complement of a step is summed
//! up by these differences.

use std::collections::BTreeSet;

use super::cone::ConeVector;
use super::point_set::PointSet;
use super::scalar::{Scalar, plus, real, values, zero};
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::numeric::linear::dot;

/// A set of points, with the slack and the dual variable of its constraint.
#[derive(Debug, Clone)]
pub(super) struct VertexSet<R, const D: usize> {
    pub(super) points: PointSet,
    pub(super) slack: ConeVector<R, D>,
    pub(super) dual: ConeVector<R, D>,
    /// The length that the generator was expected to have when the set was added.
    expected_length: f64,
}

/// The dual program so far: points with their multipliers, and sets of the points with their variables.
pub(super) struct VertexSets<'a, R, const D: usize> {
    coordinates: &'a BoxCoordinates<'a, D>,
    pub(super) rank: usize,
    /// The points relative to the first one, which lies in no set.
    pub(super) points: Vec<[R; D]>,
    /// The points relative to the first one, in box coordinates.
    box_points: Vec<[f64; D]>,
    pub(super) multipliers: Vec<[R; D]>,
    pub(super) sets: Vec<VertexSet<R, D>>,
    /// The sets that have been added and not been dropped.
    known: BTreeSet<PointSet>,
    /// The parameter μ of the central path, near which a new set begins: its slack times its dual variable is μ.
    pub(super) mu: f64,
    /// Roughly the least total length of a zonotope around the points.
    pub(super) length: f64,
    /// The work of set generation so far.
    pub(super) work: f64,
}

/// At most this many sets are kept for each coordinate of a multiplier.
const SETS_PER_COORDINATE: usize = 4;

/// Up to this many sets are kept however few multipliers there are.
const SETS_ALWAYS_KEPT: usize = 1000;

/// The generator of a new set begins shorter by this factor than the body and the distances of its points allow. If it
/// began longer it would have to shrink, which takes an interior-point method more steps than growing.
const FIRST_LENGTH_DIVISOR: f64 = 15.0;

/// Points nearer to each other than this in box coordinates count as this far apart: smaller distances are rounding
/// errors.
const LEAST_BOX_DISTANCE: f64 = 1e-14;

/// A new point joins the sets of its nearest point, not those along its normal, if their generators then miss it by
/// less than the other ones by this factor.
const NEIGHBOUR_PREFERENCE: f64 = 10.0;

/// The duality gap at the beginning, relative to the expected length.
const FIRST_RELATIVE_GAP: f64 = 0.5;

impl<'a, R: Scalar, const D: usize> VertexSets<'a, R, D> {
    /// The program with the first point alone, its multiplier 0, and no sets; `length` is roughly the least total
    /// length to be expected.
    pub(super) fn new(rank: usize, coordinates: &'a BoxCoordinates<'a, D>, length: f64) -> Self {
        Self {
            coordinates,
            rank,
            points: vec![zero()],
            box_points: vec![[0.0; D]],
            multipliers: vec![zero()],
            sets: Vec::new(),
            known: BTreeSet::new(),
            mu: FIRST_RELATIVE_GAP * length / rank as f64,
            length,
            work: 0.0,
        }
    }

    /// The program with given points and multipliers, the set of each point alone, and the sets of some directions
    /// ([`add_set_along`](Self::add_set_along)).
    pub(super) fn with_multipliers(
        rank: usize,
        coordinates: &'a BoxCoordinates<'a, D>,
        points: &[[f64; D]],
        multipliers: Vec<[f64; D]>,
        directions: &[[f64; D]],
    ) -> Self {
        let points: Vec<[R; D]> = points.iter().map(|p| difference(p, &points[0])).collect();
        let multipliers: Vec<[R; D]> = multipliers.iter().map(real).collect();
        let length = points.iter().zip(&multipliers).map(|(p, f)| dot(p, f).value()).sum();
        let box_points = points.iter().map(|p| coordinates.vector(&values(p))).collect();
        let mut sets = Self { points, box_points, multipliers, ..Self::new(rank, coordinates, length) };
        sets.mu = FIRST_RELATIVE_GAP * length / (directions.len() + sets.points.len()) as f64;
        for point in 1..sets.points.len() {
            sets.add_single(point);
        }
        for direction in directions {
            sets.add_set_along(direction);
        }
        sets
    }

    /// Adds a point with the multiplier 0 and the set of it alone, whose constraint bounds the multiplier. The point is
    /// given with the first point and the normal along which it is farthest.
    pub(super) fn add_point(&mut self, point: &[f64; D], first: &[f64; D], normal: &[f64; D]) {
        let place = self.points.len();
        let relative = difference(point, first);
        let joined = self.joined_sets(&relative, normal);
        for (set, is_in) in self.sets.iter_mut().zip(joined) {
            set.points.make_room(place);
            if is_in {
                set.points.insert(place);
            }
        }
        self.points.push(relative);
        self.box_points.push(self.coordinates.vector(&values(&relative)));
        self.multipliers.push(zero());
        self.known = self.sets.iter().map(|set| set.points.clone()).collect();
        self.add_single(place);
    }

    /// For each set whether a new point joins it. The point joins the sets with w_T · normal > 0, as it is farthest
    /// along the normal, unless the generators place it much better if it joins the sets of the point nearest to it.
    fn joined_sets(&self, point: &[R; D], normal: &[f64; D]) -> Vec<bool> {
        let normal = real(normal);
        let along_normal: Vec<bool> = self.sets.iter().map(|set| dot(&set.slack.rest, &normal).value() > 0.0).collect();
        let size = |v: &[R; D]| self.coordinates.size(&values(v));
        let missed = |joined: &[bool]| {
            let ends = self.sets.iter().zip(joined).filter(|(_, is_in)| **is_in);
            size(&ends.fold(*point, |rest, (set, _)| plus(&rest, R::from(2.0), &set.dual.rest)))
        };
        let distance = |other: &[R; D]| size(&plus(point, R::from(-1.0), other));
        let others = self.points.iter().map(distance).enumerate();
        let (nearest, _) = others.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there is a first point");
        let of_nearest: Vec<bool> = self.sets.iter().map(|set| set.points.contains(nearest)).collect();
        if NEIGHBOUR_PREFERENCE * missed(&of_nearest) < missed(&along_normal) { of_nearest } else { along_normal }
    }

    /// Adds the set of one point alone.
    fn add_single(&mut self, point: usize) {
        let mut own = PointSet::with_room_for(self.points.len());
        own.insert(point);
        self.add_set(own);
    }

    /// Adds the set of a direction v: the points whose λ_j · v has not the sign of that of the first point, which lies
    /// in no set. For a vertex v of Σ [−1, 1] λ_j the set's w_T is v or −v. Returns whether there was a new set to add.
    pub(super) fn add_set_along(&mut self, direction: &[f64; D]) -> bool {
        let direction = real(direction);
        let of_first = dot(&self.multipliers[0], &direction).value() > 0.0;
        let mut set = PointSet::with_room_for(self.points.len());
        let mut is_empty = true;
        for (j, multiplier) in self.multipliers.iter().enumerate() {
            if (dot(multiplier, &direction).value() > 0.0) != of_first {
                set.insert(j);
                is_empty = false;
            }
        }
        !is_empty && self.add_set(set)
    }

    /// Adds a set with its slack and dual variable on the central path, both inside the cone even if |w_T| > 1. The
    /// head of the slack is so large that the generator is no longer than expected. Returns whether the set is new.
    fn add_set(&mut self, points: PointSet) -> bool {
        if !self.known.insert(points.clone()) {
            return false;
        }
        let w = doubled_sum(&points, &self.multipliers);
        let square = dot(&w, &w);
        let along = if square.value() > 0.0 {
            self.coordinates.half_length_along(&values(&w))
        } else {
            self.length / self.rank as f64
        };
        let separation = self.separation(&points);
        let expected_length = along * separation.min(1.0 / self.points.len() as f64) / FIRST_LENGTH_DIVISOR;
        let square = square + R::from(self.mu / expected_length);
        let head = if square.value() < 1.0 { R::from(1.0) } else { square.sqrt() };
        let slack = ConeVector { head, rest: w };
        self.sets.push(VertexSet { points, slack, dual: slack.dual_at(R::from(self.mu)), expected_length });
        true
    }

    /// The number of points in all sets together.
    pub(super) fn memberships(&self) -> usize {
        self.sets.iter().map(|set| set.points.count()).sum()
    }

    /// The number of points by which neighbouring sets differ, all neighbours together.
    pub(super) fn changes(&self) -> usize {
        self.sets.windows(2).map(|pair| pair[1].points.changes_since(&pair[0].points).count()).sum()
    }

    /// The least distance in box coordinates of a point of a set from a point that is not in it.
    fn separation(&mut self, set: &PointSet) -> f64 {
        let mut least = f64::INFINITY;
        let inside = set.count();
        self.work += (2 * self.rank * inside * (self.points.len() - inside)) as f64;
        for j in set.members() {
            for (k, other) in self.box_points.iter().enumerate() {
                if !set.contains(k) {
                    let apart = plus(&self.box_points[j], -1.0, other);
                    least = least.min(dot(&apart, &apart));
                }
            }
        }
        least.sqrt().max(LEAST_BOX_DISTANCE)
    }

    /// Sorts the sets by the reflected binary code. If there are too many, drops those whose generators are shortest
    /// relative to their expected lengths, but no set of a single point.
    pub(super) fn prune(&mut self) {
        let most = (SETS_PER_COORDINATE * self.rank * self.points.len()).max(SETS_ALWAYS_KEPT);
        if self.sets.len() > most {
            let relative_length = |set: &VertexSet<R, D>| set.dual.head.value() / set.expected_length;
            let mut lengths: Vec<f64> = self.sets.iter().map(relative_length).collect();
            let (_, least, _) = lengths.select_nth_unstable_by(most, |a, b| b.total_cmp(a));
            self.sets.retain(|set| relative_length(set) > *least || set.points.is_single());
            self.known = self.sets.iter().map(|set| set.points.clone()).collect();
        }
        self.sets.sort_by_cached_key(|set| set.points.rank_in_code());
    }

    /// Raises the heads of slacks and dual variables until the duality gap is at least `gap` and every set's slack
    /// times its dual variable is at least its share of that. The multipliers and the generators do not change.
    pub(super) fn recentre(&mut self, gap: f64) {
        let mu = gap / self.sets.len() as f64;
        if mu <= self.mu {
            return;
        }
        self.mu = mu;
        let mu = R::from(mu);
        let larger = |a: R, b: R| if a < b { b } else { a };
        for VertexSet { slack, dual, .. } in &mut self.sets {
            let square = dot(&slack.rest, &slack.rest);
            slack.head = larger(slack.head, (square + mu / dual.head).sqrt());
            let square = dot(&dual.rest, &dual.rest);
            dual.head = larger(dual.head, (square + mu * mu / slack.determinant()).sqrt());
        }
    }

    /// The multipliers after a part of a step; the multiplier of the first point is chosen so that they add up to zero.
    pub(super) fn stepped_multipliers(&self, part: R, step: &[[R; D]]) -> Vec<[R; D]> {
        let others = self.multipliers[1..].iter().zip(step).map(|(multiplier, step)| plus(multiplier, part, step));
        let mut multipliers: Vec<[R; D]> = std::iter::once(zero()).chain(others).collect();
        multipliers[0] = multipliers.iter().fold(zero(), |sum, multiplier| plus(&sum, R::from(-1.0), multiplier));
        multipliers
    }
}

/// Twice the sum of the vectors of the points in a set.
pub(super) fn doubled_sum<R: Scalar, const D: usize>(set: &PointSet, vectors: &[[R; D]]) -> [R; D] {
    set.members().fold(zero(), |sum, j| plus(&sum, R::from(2.0), &vectors[j]))
}

/// Twice the sum of the vectors of the points in a set, for vectors of all points but the first, which lies in no set.
pub(super) fn doubled_sum_after_first<R: Scalar, const D: usize>(set: &PointSet, vectors: &[[R; D]]) -> [R; D] {
    set.members().fold(zero(), |sum, j| plus(&sum, R::from(2.0), &vectors[j - 1]))
}

/// The vector from the first point to a point.
fn difference<R: Scalar, const D: usize>(p: &[f64; D], first: &[f64; D]) -> [R; D] {
    plus(&real(p), R::from(-1.0), &real(first))
}
