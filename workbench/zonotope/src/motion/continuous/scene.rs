//! Two moving bodies, and the questions that every method asks about them: a stretch of time, and a moment.

use super::SeparatingDirection;
use super::body::Body;
use super::gap::Stretch;
use super::meeting;
use crate::collision::by_lad::locate;
use crate::collision::distance::Proximity;
use crate::collision::distance::by_support_simplex::proximity;
use crate::collision::{Location, Query, Separation, Witness};
use crate::motion::Motion;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::sum_norm;
use crate::numeric::tolerance::POSE_ROUNDING;
use crate::tally::{Operation, OperationCounts, Tally};
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;

/// Two bodies and their motions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scene<'a> {
    pub(super) bodies: [Body<'a>; 2],
    pub(super) motions: [&'a Motion; 2],
    /// Bounds of how far from the axes the bodies reach, for rotations at constant rate.
    reaches: [f64; 2],
}

/// How two bodies stand at a time that they are not proved to meet at.
pub(super) type Apart = Option<SeparatingDirection>;

impl<'a> Scene<'a> {
    pub(super) fn new(bodies: [&'a Zonotope<3>; 2], motions: [&'a Motion; 2]) -> Self {
        let reaches = [0, 1].map(|i| motions[i].reach(bodies[i]));
        Self { bodies: bodies.map(Body::of), motions, reaches }
    }

    fn zonotopes(&self) -> [&'a Zonotope<3>; 2] {
        self.bodies.map(|body| body.zonotope)
    }

    /// A proof that the bodies meet at a time with the coefficients of its basis rounded from what they are for the
    /// exact placements.
    pub(super) fn with_nearest_basis(&self, time: f64, witness: Witness) -> Witness {
        let arcs = self.motions.map(|motion| motion.exact_arc([time; 2]));
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

    /// The stretch between two times.
    pub(super) fn stretch(&self, times: [f64; 2]) -> Stretch<'a, Bounded> {
        Stretch::new(self.bodies, self.motions.map(|motion| motion.arc(times)), self.margin(times))
    }

    /// Whether a direction proves a stretch: in doubles with bounds, or exactly where no coefficient is negative for
    /// certain.
    pub(super) fn is_proved(
        &self,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        direction: &SeparatingDirection,
        tally: &mut dyn Tally,
    ) -> bool {
        tally.add(Operation::SupportEvaluation, stretch.support_evaluations(direction));
        let bound = stretch.gap_along(direction);
        if bound.iter().all(|c| c.is_positive()) {
            return true;
        }
        // a bound that is infinite or NaN says nothing
        let is_refuted = |c: &Bounded| c.sign() == Some(-1) || (c.value, c.error) == (0.0, 0.0);
        let margin = self.margin(times);
        if bound.iter().any(is_refuted) || !margin.is_finite() {
            return false;
        }
        tally.add(Operation::ExactFallback, 1);
        let arcs = self.motions.map(|motion| motion.exact_arc(times));
        let exact = Stretch::<Dyadic>::new(self.bodies, arcs, margin);
        exact.gap_along(direction).iter().all(|c| c.sign().is_gt())
    }

    /// A bound of how far points of both bodies together are off their places on a stretch.
    pub(super) fn margin(&self, times: [f64; 2]) -> f64 {
        let off = [0, 1].map(|i| match self.motions[i].angle_off(times) {
            0.0 => 0.0,
            angle => (angle * self.reaches[i]).next_up(),
        });
        if off == [0.0; 2] { 0.0 } else { (off[0] + off[1]).next_up() }
    }

    /// The proof that the bodies meet at a time, or else a direction that separates them as they are rounded then.
    pub(super) fn at(&self, time: f64, tally: &mut dyn Tally) -> Result<Witness, Apart> {
        let location = self.with_query(time, tally, |query, counts| locate(query, counts).with_nearest_basis(query));
        match location {
            None | Some(Location::Outside(Separation::Exact(_))) => Err(None),
            Some(Location::Outside(Separation::Rounded(u))) => Err(Some(SeparatingDirection::Space(u))),
            Some(Location::Inside(witness) | Location::Boundary(witness)) => {
                if self.is_meeting(time, &witness) {
                    return Ok(witness);
                }
                let arcs = self.motions.map(|motion| motion.arc([time; 2]).rounded());
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
        let [p, q] = self.motions.map(|motion| motion.arc(times));
        let angles_off = self.motions.map(|motion| motion.angle_off(times));
        let margin = self.margin(times);
        if meeting::is_certain(bodies, [&p, &q], witness, angles_off, margin) {
            return true;
        }
        let [p, q] = self.motions.map(|motion| motion.exact_arc(times));
        margin == 0.0 && angles_off == [0.0; 2] && meeting::is_proved(bodies, [&p, &q], witness)
    }

    /// A bound above the distance of the bodies at a time: that of the rounded placements, and by how much rounding
    /// and a rotation at constant rate put them off; infinite where it leaves the range of doubles.
    pub(super) fn distance_at_most(&self, time: f64, tally: &mut dyn Tally) -> f64 {
        let Some(distance) = self.proximity_at(time, tally).map(|proximity| proximity.distance()) else {
            return f64::INFINITY;
        };
        let size = [0, 1].map(|i| {
            let body = self.bodies[i];
            let moved = self.motions[i].pose_at(time).map_or(f64::INFINITY, |pose| sum_norm(&pose.translation()));
            body.magnitude() + sum_norm(&body.center()) + moved
        });
        let bound = (distance + POSE_ROUNDING * (size[0] + size[1]) + self.margin([time; 2])).next_up();
        if bound.is_nan() { f64::INFINITY } else { bound }
    }
}
