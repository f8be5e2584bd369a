//! Two bodies and their motions: the stretches of a step of time, and the directions that prove them.

use std::rc::Rc;

use super::SeparatingDirection;
use super::gap::{ArcPair, Stretch};
use super::parts::body::{Body, Side};
use super::parts::margin::{self, Margin};
use super::simplex_search::{Lowest, Outcome, search};
use crate::motion::Motion;
use crate::motion::arc::Arc;
use crate::motion::constant_rate::Timing;
use crate::motion::quaternion::{image, transposed_image};
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};
use crate::zonotope::pose::Pose;

/// The share of the distance that the gap along a direction has at least, if it is to tell when the bodies meet.
const NEAR_THE_SHORTEST: f64 = 0.9;

/// The number of shares of a span of time at whose multiples it is cut.
const SHARES: f64 = 64.0;

/// Two bodies and their motions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving<'a> {
    pub(super) bodies: [Body<'a>; 2],
    pub(super) motions: [&'a Motion; 2],
    /// Bounds of the distances of the bodies' points from their axes, for rotations at constant rate.
    from_axes: [f64; 2],
    /// Whether a free stretch is about the set of the placements alone: one body turns and the other rests.
    timing: Timing,
}

/// The spans of time in which no part of two motions ends, in order.
pub(super) fn spans(motions: [&Motion; 2]) -> Vec<[f64; 2]> {
    let mut times: Vec<f64> = motions.iter().flat_map(|motion| motion.breaks()).chain([0.0, 1.0]).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

impl<'a> Moving<'a> {
    /// The bodies, and bounds of the distances of their points from the axes of rotations at constant rate.
    pub(super) fn new(bodies: [Body<'a>; 2], motions: [&'a Motion; 2], from_axes: [f64; 2]) -> Self {
        let [first, second] = motions;
        let is_one_turn = (first.only_turns() && second.is_rest()) || (first.is_rest() && second.only_turns());
        let timing = if is_one_turn { Timing::Untimed } else { Timing::Timed };
        Self { bodies, motions, from_axes, timing }
    }

    /// The stretches that are asked about first: the spans of the motions, each cut evenly where a body turns by more
    /// than a quarter turn. Halving would cut into more, and look at the bodies at each cut.
    pub(super) fn first_stretches(&self) -> Vec<[f64; 2]> {
        spans(self.motions).into_iter().flat_map(|span| self.cut(span)).collect()
    }

    /// The stretches of a span of time, cut at multiples of one of its [`SHARES`] shares: such times have few digits,
    /// so that exact proofs about them are cheap. Of 4.2 quarter turns, one takes 15 whole shares (64 / 4.2, rounded
    /// down), which makes five stretches (64 / 15, rounded up) of 13 shares (64 / 5, rounded up), the last one of 12.
    fn cut(&self, span @ [from, until]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
        let quarter_turns = self.motions.iter().map(|motion| motion.quarter_turns(span)).fold(1.0, f64::max);
        let count = (SHARES / (SHARES / quarter_turns).floor().max(1.0)).ceil();
        // no longer than a quarter turn: a quarter turn is at least as many whole shares as 64 over the count
        let step = (SHARES / count).ceil() as u32;
        let time = move |share: f64| if share < SHARES { from + (until - from) * (share / SHARES) } else { until };
        (0..SHARES as u32).step_by(step as usize).map(move |share| [share, share + step].map(|s| time(f64::from(s))))
    }

    /// Whether the motion of each body between two times is one stretch.
    pub(super) fn is_whole(&self, times: [f64; 2]) -> bool {
        self.motions.iter().all(|motion| motion.is_one_arc(times))
    }

    /// A stretch of motions that are not off their arcs, by these arcs.
    pub(super) fn stretch_of(&self, pair: Rc<ArcPair<f64>>) -> Stretch<'a, f64> {
        Stretch::new(self.bodies, pair, [Margin::NONE; 2])
    }

    /// The stretch between two times, in doubles without bounds.
    pub(super) fn rounded_stretch(&self, times: [f64; 2]) -> Stretch<'a, f64> {
        let pair = ArcPair::new(self.rounded_arcs(times));
        let margins = self.margins(times, &pair.arcs);
        Stretch::new(self.bodies, Rc::new(pair), margins)
    }

    /// The same with bounds.
    pub(super) fn stretch(&self, times: [f64; 2]) -> Stretch<'a, Bounded> {
        let margins = self.margins(times, &self.rounded_arcs(times));
        let pair = ArcPair::new(self.motions.map(|motion| motion.arc(times, self.timing)));
        Stretch::new(self.bodies, Rc::new(pair), margins)
    }

    fn rounded_arcs(&self, times: [f64; 2]) -> [Arc<f64>; 2] {
        self.motions.map(|motion| motion.rounded_arc(times, self.timing))
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
        let margins = self.margins(times, &self.rounded_arcs(times));
        let are_finite = direction.is_finite()
            && margins.iter().all(Margin::is_finite)
            && margin::along(&margins, direction).is_finite();
        if bound.iter().any(is_refuted) || !are_finite {
            return false;
        }
        tally.add(Operation::ExactFallback, 1);
        let pair = ArcPair::<Dyadic>::new(self.motions.map(|motion| motion.exact_arc(times, self.timing)));
        let exact = Stretch::new(self.bodies, Rc::new(pair), margins);
        exact.gap_along(direction).iter().all(|c| c.sign().is_gt())
    }

    /// For each body bounds of how far it is from its place on the stretch at the same time; none where
    /// it need not be there at that time.
    fn margins(&self, times: [f64; 2], arcs: &[Arc<f64>; 2]) -> [Margin; 2] {
        let angles = self.motions.map(|motion| match motion.angle_off(times) {
            angle if angle.is_finite() && self.timing == Timing::Untimed => 0.0,
            angle => angle,
        });
        if angles == [0.0; 2] {
            return [Margin::NONE; 2];
        }
        [[0, 1], [1, 0]].map(|[own, other]| {
            if angles[own] == 0.0 {
                return Margin::NONE;
            }
            let both = [own, other].map(|i| (&arcs[i], self.bodies[i]));
            Margin::new(angles[own], self.motions[own].unit_axis(), self.from_axes[own], both)
        })
    }

    /// A bound of how far points of both bodies together are off their places on a stretch.
    pub(super) fn margin(&self, times: [f64; 2]) -> f64 {
        let off = [0, 1].map(|i| match self.motions[i].angle_off(times) {
            0.0 => 0.0,
            angle => (angle * self.from_axes[i]).next_up(),
        });
        if off == [0.0; 2] { 0.0 } else { (off[0] + off[1]).next_up() }
    }

    /// A direction that separates the bodies at a time, as they are rounded then, by a search in doubles from a first
    /// one, or from the path between the centres. It proves nothing, and [`Outcome::Inside`] as little.
    pub(super) fn search_at(&self, time: f64, first: Option<[f64; 3]>, tally: &mut dyn Tally) -> Outcome {
        let [Some(p), Some(q)] = self.motions.map(|motion| motion.pose_at(time)) else { return Outcome::Undecided };
        self.search_placed([&p, &q], first, tally)
    }

    /// The same for the bodies where poses put them.
    pub(super) fn search_placed(&self, [p, q]: [&Pose; 2], first: Option<[f64; 3]>, tally: &mut dyn Tally) -> Outcome {
        let centers = [(0, p), (1, q)].map(|(i, pose): (usize, &Pose)| {
            let (turned, moved) = (image(pose.rows(), &self.bodies[i].center()), pose.translation());
            [0, 1, 2].map(|k| turned[k] + moved[k])
        });
        let apart = [0, 1, 2].map(|k| centers[1][k] - centers[0][k]);
        search(&[first.unwrap_or(apart)], NEAR_THE_SHORTEST, |u| {
            tally.add(Operation::SupportEvaluation, 2);
            let [from, to] = [(0, p, Side::Away), (1, q, Side::Toward)].map(|(i, pose, side)| {
                let [farthest] = self.bodies[i].farthest(side, &[transposed_image(pose.rows(), u)]);
                image(pose.rows(), &farthest)
            });
            let point = [0, 1, 2].map(|k| apart[k] - from[k] - to[k]);
            Lowest { point, is_found: dot(u, &point) > 0.0 }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::continuous::scene::Scene;
    use crate::zonotope::Zonotope;

    fn first_stretches(angle: f64) -> Vec<[f64; 2]> {
        let body = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0]]).expect("finite");
        let turning = Motion::constant_rate([0.0; 3], [0.0, 0.0, 1.0], angle, [0.0; 3]).expect("an axis");
        Scene::new([&body, &body], [&Motion::rest(), &turning]).moving.first_stretches()
    }

    #[test]
    fn turns_are_cut_evenly_into_stretches_of_a_quarter_turn_at_most() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let counts = [(0.0, 1), (quarter, 1), (1.5 * quarter, 2), (-4.0 * quarter, 4), (6.5, 5), (8.0, 6), (1e300, 64)];
        for (angle, count) in counts {
            let stretches = first_stretches(angle);
            assert_eq!(stretches.len(), count, "{angle}");
            assert_eq!([stretches[0][0], stretches[count - 1][1]], [0.0, 1.0], "{angle}");
            assert!(stretches.windows(2).all(|pair| pair[0][1] == pair[1][0]), "{angle}: {stretches:?}");
            let is_short = |[from, until]: &[f64; 2]| angle.abs() * (until - from) <= quarter;
            assert!(angle == 1e300 || stretches.iter().all(is_short), "{angle}: {stretches:?}");
        }
        assert_eq!(first_stretches(6.5).concat(), [0, 13, 13, 26, 26, 39, 39, 52, 52, 64].map(|k| f64::from(k) / 64.0));
    }
}
