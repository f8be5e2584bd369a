//! Two moving zonotopes, and the questions that every method asks about them at a moment.

use super::SeparatingDirection;
use super::meeting;
use super::moving::Moving;
use super::parts::body::Body;
use crate::collision::by_lad::locate;
use crate::collision::distance::Proximity;
use crate::collision::distance::by_support_simplex::proximity;
use crate::collision::{Location, Query, Separation, Witness};
use crate::motion::Motion;
use crate::motion::constant_rate::Timing;
use crate::tally::{Operation, OperationCounts, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;

/// Two zonotopes that move.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scene<'a> {
    pub(super) moving: Moving<'a>,
    zonotopes: [&'a Zonotope<3>; 2],
}

/// A direction that separates two bodies at a time, with which later searches begin; none where none is known.
pub(super) type Hint = Option<SeparatingDirection>;

/// The position of two bodies to each other at a time.
pub(super) enum Position {
    /// They meet, with the proof.
    Meeting(Witness),
    /// Nothing is proved: they are disjoint as they are rounded then, or so near that rounding leaves a doubt.
    NotProved(Hint),
}

impl<'a> Scene<'a> {
    pub(super) fn new(zonotopes: [&'a Zonotope<3>; 2], motions: [&'a Motion; 2]) -> Self {
        let from_axes = [0, 1].map(|i| motions[i].distance_from_axis(zonotopes[i]));
        Self { moving: Moving::new(zonotopes.map(Body::of), motions, from_axes), zonotopes }
    }

    /// A proof that the bodies meet at a time with the coefficients of its basis rounded from what they are for the
    /// exact placements.
    pub(super) fn with_nearest_basis(&self, time: f64, witness: Witness) -> Witness {
        let arcs = self.moving.motions.map(|motion| motion.exact_arc([time; 2], Timing::Timed));
        meeting::with_nearest_basis(self.zonotopes, arcs.each_ref(), witness)
    }

    /// The position at a time: the proof that the bodies meet, or else a direction that separates them as they are
    /// rounded then.
    pub(super) fn position_at(&self, time: f64, tally: &mut dyn Tally) -> Position {
        let location = self.with_query(time, tally, |query, counts| locate(query, counts));
        match location {
            None | Some(Location::Outside(Separation::Exact(_))) => Position::NotProved(None),
            Some(Location::Outside(Separation::Rounded(u))) => Position::NotProved(Some(SeparatingDirection::Space(u))),
            Some(Location::Inside(witness) | Location::Boundary(witness)) => {
                if self.is_meeting(time, &witness) {
                    return Position::Meeting(witness);
                }
                let arcs = self.moving.motions.map(|motion| motion.rounded_arc([time; 2], Timing::Timed));
                let completed = meeting::completed(self.zonotopes, arcs.each_ref(), witness);
                completed
                    .filter(|witness| self.is_meeting(time, witness))
                    .map_or(Position::NotProved(None), Position::Meeting)
            }
        }
    }

    /// The distance of the bodies at a time, as they are rounded then; `None` where that leaves the range of doubles.
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
        let [Some(p), Some(q)] = self.moving.motions.map(|motion| motion.pose_at(time)) else { return None };
        let [a, b] = self.zonotopes;
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
        let bodies = self.zonotopes;
        let [p, q] = self.moving.motions.map(|motion| motion.arc(times, Timing::Timed));
        let angles_off = self.moving.motions.map(|motion| motion.angle_off(times));
        let margin = self.moving.margin(times);
        if meeting::is_certain(bodies, [&p, &q], witness, angles_off, margin) {
            return true;
        }
        let [p, q] = self.moving.motions.map(|motion| motion.exact_arc(times, Timing::Timed));
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
        let arcs = self.moving.motions.map(|motion| motion.exact_arc([time; 2], Timing::Timed));
        let apart = meeting::distance_above(self.zonotopes, arcs.each_ref(), coefficients);
        let bound = match self.moving.margin([time; 2]) {
            0.0 => apart,
            margin => (apart + margin).next_up(),
        };
        if bound.is_nan() { f64::INFINITY } else { bound }
    }
}
