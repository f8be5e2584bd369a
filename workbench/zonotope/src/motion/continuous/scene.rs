//! Two moving bodies, and the questions that every method asks about them: a stretch of time, and a moment.

use super::SeparatingDirection;
use super::gap::Stretch;
use super::meeting;
use super::parts::body::Body;
use super::parts::margin::{self, Margin};
use super::simplex_search::{Lowest, Search, search};
use crate::collision::by_lad::locate;
use crate::collision::distance::Proximity;
use crate::collision::distance::by_support_simplex::proximity;
use crate::collision::{Location, Query, Separation, Witness};
use crate::motion::Motion;
use crate::motion::constant_rate::Clock;
use crate::motion::quaternion::{image, transposed_image};
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::extreme_sum;
use crate::numeric::linear::dot;
use crate::tally::{Operation, OperationCounts, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;

/// The share of the distance that the gap along a direction has at least, if it is to tell when the bodies meet.
const NEAR_THE_SHORTEST: f64 = 0.9;

/// Two bodies and their motions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scene<'a> {
    pub(super) bodies: [Body<'a>; 2],
    pub(super) motions: [&'a Motion; 2],
    /// Bounds of how far from the axes the bodies reach, for rotations at constant rate.
    reaches: [f64; 2],
    /// Whether a free stretch is about the set of the placements alone: one body turns and the other rests.
    clock: Clock,
}

/// How two bodies stand at a time that they are not proved to meet at.
pub(super) type Apart = Option<SeparatingDirection>;

impl<'a> Scene<'a> {
    pub(super) fn new(bodies: [&'a Zonotope<3>; 2], motions: [&'a Motion; 2]) -> Self {
        let reaches = [0, 1].map(|i| motions[i].reach(bodies[i]));
        let [first, second] = motions;
        let is_one_turn = (first.only_turns() && second.is_rest()) || (first.is_rest() && second.only_turns());
        let clock = if is_one_turn { Clock::Free } else { Clock::Kept };
        Self { bodies: bodies.map(Body::of), motions, reaches, clock }
    }

    fn zonotopes(&self) -> [&'a Zonotope<3>; 2] {
        self.bodies.map(|body| body.zonotope)
    }

    /// A proof that the bodies meet at a time with the coefficients of its basis rounded from what they are for the
    /// exact placements.
    pub(super) fn with_nearest_basis(&self, time: f64, witness: Witness) -> Witness {
        let arcs = self.motions.map(|motion| motion.exact_arc([time; 2], Clock::Kept));
        meeting::with_nearest_basis(self.zonotopes(), arcs.each_ref(), witness)
    }

    /// The times between which no part of a motion ends.
    pub(super) fn parts(&self) -> Vec<[f64; 2]> {
        let mut times: Vec<f64> = self.motions.iter().flat_map(|motion| motion.breaks()).chain([0.0, 1.0]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        times.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    /// Whether the motion of each body between two times is one stretch.
    pub(super) fn is_whole(&self, times: [f64; 2]) -> bool {
        self.motions.iter().all(|motion| motion.is_one_stretch(times))
    }

    /// The stretch between two times, in doubles without bounds.
    pub(super) fn rounded_stretch(&self, times: [f64; 2]) -> Stretch<'a, f64> {
        Stretch::new(self.bodies, self.motions.map(|motion| motion.rounded_arc(times, self.clock)), self.margins(times))
    }

    /// The same with bounds.
    pub(super) fn stretch(&self, times: [f64; 2]) -> Stretch<'a, Bounded> {
        Stretch::new(self.bodies, self.motions.map(|motion| motion.arc(times, self.clock)), self.margins(times))
    }

    /// Whether a direction proves a stretch: in doubles with one bound, where these leave a doubt with a bound for each
    /// operation, and exactly where no coefficient is negative for certain.
    pub(super) fn is_proved(
        &self,
        stretch: &Stretch<'_, f64>,
        times: [f64; 2],
        direction: &SeparatingDirection,
        tally: &mut dyn Tally,
    ) -> bool {
        tally.add(Operation::SupportEvaluation, stretch.support_evaluations(direction));
        let gap = stretch.gap_along(direction);
        stretch.is_positive(&gap, direction).unwrap_or_else(|| self.is_proved_with_bounds(times, direction, tally))
    }

    /// The same where one bound for all leaves a doubt.
    pub(super) fn is_proved_with_bounds(
        &self,
        times: [f64; 2],
        direction: &SeparatingDirection,
        tally: &mut dyn Tally,
    ) -> bool {
        let bound = self.stretch(times).gap_along(direction);
        if bound.iter().all(|c| c.is_positive()) {
            return true;
        }
        // a bound that is infinite or NaN says nothing, and neither do numbers beyond the doubles
        let is_refuted = |c: &Bounded| c.sign() == Some(-1) || (c.value, c.error) == (0.0, 0.0);
        let margins = self.margins(times);
        let are_finite = direction.is_finite()
            && margins.iter().all(Margin::is_finite)
            && margin::along(&margins, direction).is_finite();
        if bound.iter().any(is_refuted) || !are_finite {
            return false;
        }
        tally.add(Operation::ExactFallback, 1);
        let arcs = self.motions.map(|motion| motion.exact_arc(times, self.clock));
        let exact = Stretch::<Dyadic>::new(self.bodies, arcs, margins);
        exact.gap_along(direction).iter().all(|c| c.sign().is_gt())
    }

    /// How far points of each body may be off their places on a stretch, where these have their time.
    fn margins(&self, times: [f64; 2]) -> [Margin; 2] {
        [0, 1].map(|i| match self.motions[i].angle_off(times) {
            angle if angle == 0.0 || (angle.is_finite() && self.clock == Clock::Free) => Margin::NONE,
            angle => Margin { distance: (angle * self.reaches[i]).next_up(), axis: self.motions[i].unit_axis() },
        })
    }

    /// A bound of how far points of both bodies together are off their places on a stretch.
    pub(super) fn margin(&self, times: [f64; 2]) -> f64 {
        let off = [0, 1].map(|i| match self.motions[i].angle_off(times) {
            0.0 => 0.0,
            angle => (angle * self.reaches[i]).next_up(),
        });
        if off == [0.0; 2] { 0.0 } else { (off[0] + off[1]).next_up() }
    }

    /// A direction that separates the bodies at a time, as they are rounded then, by a search in doubles from a first
    /// one, or from the path between the centres. It proves nothing, and [`Search::Inside`] as little.
    pub(super) fn looked_at(&self, time: f64, first: Option<[f64; 3]>, tally: &mut dyn Tally) -> Search {
        let [Some(p), Some(q)] = self.motions.map(|motion| motion.pose_at(time)) else { return Search::Undecided };
        let centers = [(0, &p), (1, &q)].map(|(i, pose): (usize, &Pose)| {
            let (turned, moved) = (image(pose.rows(), &self.bodies[i].center()), pose.translation());
            [0, 1, 2].map(|k| turned[k] + moved[k])
        });
        let apart = [0, 1, 2].map(|k| centers[1][k] - centers[0][k]);
        search(&[first.unwrap_or(apart)], NEAR_THE_SHORTEST, |u| {
            tally.add(Operation::SupportEvaluation, 2);
            let [from, to] = [(0, &p), (1, &q)].map(|(i, pose)| {
                let own = transposed_image(pose.rows(), u);
                image(pose.rows(), &extreme_sum(self.bodies[i].generators(), &own))
            });
            let point = [0, 1, 2].map(|k| apart[k] - from[k] - to[k]);
            Lowest { point, is_found: dot(u, &point) > 0.0 }
        })
    }

    /// The proof that the bodies meet at a time, or else a direction that separates them as they are rounded then.
    pub(super) fn at(&self, time: f64, tally: &mut dyn Tally) -> Result<Witness, Apart> {
        let location = self.with_query(time, tally, |query, counts| locate(query, counts));
        match location {
            None | Some(Location::Outside(Separation::Exact(_))) => Err(None),
            Some(Location::Outside(Separation::Rounded(u))) => Err(Some(SeparatingDirection::Space(u))),
            Some(Location::Inside(witness) | Location::Boundary(witness)) => {
                if self.is_meeting(time, &witness) {
                    return Ok(witness);
                }
                let arcs = self.motions.map(|motion| motion.rounded_arc([time; 2], Clock::Kept));
                let completed = meeting::completed(self.zonotopes(), arcs.each_ref(), witness);
                completed.filter(|witness| self.is_meeting(time, witness)).ok_or(None)
            }
        }
    }

    /// How near the bodies are at a time, as they are rounded then; `None` where that leaves the range of doubles.
    pub(super) fn proximity_at(&self, time: f64, tally: &mut dyn Tally) -> Option<Proximity<3>> {
        self.with_query(time, tally, |query, counts| proximity(query, counts))
    }

    /// An answer about the bodies as they are rounded at a time; each pass over all generators counts as one support
    /// evaluation of either body.
    fn with_query<A>(
        &self,
        time: f64,
        tally: &mut dyn Tally,
        answer: impl FnOnce(&Query<'_, 3, Pose>, &mut OperationCounts) -> A,
    ) -> Option<A> {
        let [Some(p), Some(q)] = self.motions.map(|motion| motion.pose_at(time)) else { return None };
        let [a, b] = self.zonotopes();
        let query = Query::of_placed(a.at(&p), b.at(&q));
        let mut counts = OperationCounts::default();
        let answer = answer(&query, &mut counts);
        let passes = counts.get(Operation::GeneratorRead).div_ceil(query.len().max(1) as u64).max(1);
        tally.add(Operation::SupportEvaluation, 2 * passes);
        tally.add(Operation::ExactFallback, counts.get(Operation::ExactFallback));
        Some(answer)
    }

    fn is_meeting(&self, time: f64, witness: &Witness) -> bool {
        let times = [time; 2];
        let bodies = self.zonotopes();
        let [p, q] = self.motions.map(|motion| motion.arc(times, Clock::Kept));
        let angles_off = self.motions.map(|motion| motion.angle_off(times));
        let margin = self.margin(times);
        if meeting::is_certain(bodies, [&p, &q], witness, angles_off, margin) {
            return true;
        }
        let [p, q] = self.motions.map(|motion| motion.exact_arc(times, Clock::Kept));
        margin == 0.0 && angles_off == [0.0; 2] && meeting::is_proved(bodies, [&p, &q], witness)
    }

    /// A bound above the distance of the bodies at a time: that of the points which are nearest as the placements are
    /// rounded, as the motions put them, and by how much a rotation at constant rate may put them off; infinite where
    /// it leaves the range of doubles.
    pub(super) fn distance_at_most(&self, time: f64, tally: &mut dyn Tally) -> f64 {
        let nearest =
            self.with_query(time, tally, |query, counts| match proximity(query, counts).with_nearest_basis(query) {
                Proximity::Disjoint(gap) => gap.nearest.coefficients,
                Proximity::Touching(witness) | Proximity::Overlapping(witness) => witness.coefficients,
            });
        let Some(coefficients) = nearest else { return f64::INFINITY };
        let arcs = self.motions.map(|motion| motion.exact_arc([time; 2], Clock::Kept));
        let apart = meeting::distance_above(self.zonotopes(), arcs.each_ref(), coefficients);
        let bound = match self.margin([time; 2]) {
            0.0 => apart,
            margin => (apart + margin).next_up(),
        };
        if bound.is_nan() { f64::INFINITY } else { bound }
    }
}
