//! The work of the search, counted as it goes, and the limits at which its parts end.
//!
//! Work is counted by the sizes of what is computed, never by a clock, so a question has the same answer on every
//! machine. A unit is about a multiplication and an addition of a loop over doubles, of which a processor does some
//! 10^10 in a second.

/// Limit of the work of a search. A quarter of it would leave the ratio around 200 points of a sphere above one part in
/// a thousand.
const LIMIT: u64 = 12_000_000_000;

/// The work of a program along a net to which a unit of set generation is equal: it computes roots and sorts, too.
const NET_UNITS: f64 = 2.0;

/// In space set generation ends after this share of the limit: the rest is for the programs along nets, which prove
/// some ratio around any number of points.
const SHARE_OF_SETS_IN_SPACE: f64 = 2.0 / 3.0;

/// Around more points than this the limits are greater, as the square of the number of points,
const FEWEST_POINTS: u64 = 1000;

/// but no greater than for this many points.
const MOST_POINTS: u64 = 2000;

/// The work of a search around some points so far.
#[derive(Debug)]
pub(super) struct Work {
    /// The work of set generation.
    pub(super) on_sets: f64,
    /// The entries and products of points that programs along nets have read.
    on_nets: u64,
    limit: u64,
}

impl Work {
    /// No work yet.
    pub(super) fn none() -> Self {
        Self { on_sets: 0.0, on_nets: 0, limit: LIMIT }
    }

    /// Whether set generation has used up its work in so many dimensions.
    pub(super) fn is_used_up(&self, rank: usize) -> bool {
        let share = if rank == 3 { SHARE_OF_SETS_IN_SPACE } else { 1.0 };
        self.total() as f64 > share * self.limit as f64
    }

    /// The work that is left for programs along nets.
    pub(super) fn left_for_nets(&self) -> u64 {
        self.limit.saturating_sub(self.total())
    }

    /// Allows as much work as before once more.
    pub(super) fn renew(&mut self) {
        self.limit = self.limit.saturating_add(self.total());
    }

    /// Adds the work of a program along a net.
    pub(super) fn add_on_nets(&mut self, entries: u64) {
        self.on_nets = self.on_nets.saturating_add(entries);
    }

    fn total(&self) -> u64 {
        let on_sets = NET_UNITS * self.on_sets;
        self.on_nets.saturating_add(on_sets as u64)
    }
}

/// A limit for so many points, given that for at most a thousand: it grows as the square of their number, up to four
/// times at two thousand.
pub(in crate::enclosing::min_total_length) fn limit_around(points: usize, limit: u64) -> u64 {
    let points = (points as u64).clamp(FEWEST_POINTS, MOST_POINTS);
    (limit / FEWEST_POINTS.pow(2)).saturating_mul(points.pow(2))
}

/// The work of one interior-point step for so many multipliers of a rank, sets, memberships of points in sets, and
/// points by which neighbouring sets differ: that of dense factors, and that of sums over the sets.
pub(super) fn of_step(rank: usize, points: usize, sets: usize, memberships: usize, changes: usize) -> [f64; 2] {
    let [rank, points, sets, memberships, changes] = [rank, points, sets, memberships, changes].map(|n| n as f64);
    let unknowns = rank * points;
    // the entries of a symmetric matrix of the rank, for running sums and the rows made of them
    let schur = rank * (rank + 1.0) / 2.0 * points * (sets + changes / 2.0) + unknowns * unknowns;
    let factors = (unknowns.powi(3) + points.powi(3)) / 6.0;
    let gram = memberships * memberships / sets.max(1.0) / 2.0;
    [factors + STEP_SOLUTIONS * unknowns * unknowns, schur + gram + STEP_SUMS * rank * memberships]
}

/// The number of times that a step multiplies by the inverse of its factors: twice for predictor, corrector and
/// residuals each.
const STEP_SOLUTIONS: f64 = 6.0;

/// The number of times that a step adds up vectors over the members of all sets.
const STEP_SUMS: f64 = 24.0;

/// The work of enumerating the vertices of the zonotope of so many multipliers: walks around as many circles as there
/// are subsets of rank − 2 of them, each past all multipliers.
pub(super) fn of_vertices(rank: usize, points: usize) -> f64 {
    let circles =
        (0..rank.saturating_sub(2)).fold(1.0, |count, i| count * points.saturating_sub(i) as f64 / (i + 1) as f64);
    let choices = (1u64 << rank.saturating_sub(3).min(32)) as f64;
    circles * points as f64 * (WALK_STEP + choices * rank as f64)
}

/// The work of a step of a walk, whatever the rank: sorting, a sum, a distance, and of some walks the climb from the
/// vertex that they find.
const WALK_STEP: f64 = 140.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_grow_with_the_points_beyond_a_thousand() {
        let limit = |points: usize| limit_around(points, 1 << 30);
        assert_eq!(limit(0), limit(1000));
        assert_eq!([2000, 200_000].map(limit), [4 * limit(10); 2]);
    }

    #[test]
    fn sets_in_space_leave_work_for_nets() {
        let mut work = Work::none();
        work.on_sets = 0.45 * LIMIT as f64;
        assert!(work.is_used_up(3) && !work.is_used_up(4) && work.left_for_nets() > 0);
        work.add_on_nets(work.left_for_nets() + 1);
        assert!(work.is_used_up(4) && work.left_for_nets() == 0);
        work.renew();
        assert!(!work.is_used_up(4) && work.left_for_nets().abs_diff(LIMIT) <= 1);
    }

    #[test]
    fn in_four_dimensions_a_circle_belongs_to_each_pair() {
        let per_walk = |rank: usize, circles: f64| of_vertices(rank, 10) / circles / 10.0;
        assert_eq!(per_walk(3, 10.0), WALK_STEP + 3.0);
        assert_eq!(per_walk(4, 45.0), WALK_STEP + 8.0);
    }
}
