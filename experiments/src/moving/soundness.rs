//! Answers about moving bodies held to the verifier and to samples that are as dense as the speed of the bodies asks.

use families::motions::MotionFamily;
use rivals::first_contact::by_hull_of_end_poses::first_meeting_stretch;
use rivals::first_contact::by_sampling::first_sampled_contact;
use zonotope::motion::continuous::{FirstContact, Method};

use super::MovingBodies;
use super::samples::Samples;

/// Two times between which a contact must be.
pub const RESOLUTION: f64 = 1.0 / (1u64 << 30) as f64;

/// The steps of the rival that samples, and the stretches of the one that takes hulls of end poses.
pub const RIVAL_STEPS: u32 = 32;

/// The most samples of a motion: of bodies that stay as near as rounding, each interval would be halved to the end.
const SAMPLE_LIMIT: u32 = 1 << 14;

/// The depth, as a part of the bodies' sizes, to which rounded placements may overlap that are disjoint.
const DEPTH_OF_ROUNDING: f64 = 1e-9;

/// A bound of the distance of rounded placements whose bodies meet.
const DISTANCE_OF_ROUNDING: f64 = 1e-9;

/// The verdicts on the answers about some motions.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tallied {
    /// Motions that were asked about.
    pub asked: u64,
    /// Answers that the bodies stay apart.
    pub separate: u64,
    /// Answers that they meet, with a proof.
    pub contact: u64,
    /// Answers that leave it open.
    pub grazing: u64,
    /// Answers that samples contradict: collisions that were missed among them.
    pub contradicted: u64,
    /// Proofs that the verifier does not accept.
    pub refused: u64,
    /// Free motions whose intervals samples prove to the last one.
    pub free_by_samples: u64,
    /// Collisions that samples at equal steps miss.
    pub missed_by_sampling: u64,
    /// Collisions that hulls of end poses miss.
    pub missed_by_hulls: u64,
}

impl Tallied {
    /// The sum of two tallies.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            asked: self.asked + other.asked,
            separate: self.separate + other.separate,
            contact: self.contact + other.contact,
            grazing: self.grazing + other.grazing,
            contradicted: self.contradicted + other.contradicted,
            refused: self.refused + other.refused,
            free_by_samples: self.free_by_samples + other.free_by_samples,
            missed_by_sampling: self.missed_by_sampling + other.missed_by_sampling,
            missed_by_hulls: self.missed_by_hulls + other.missed_by_hulls,
        }
    }

    /// The verdict on the motion of a family for a seed.
    ///
    /// # Errors
    /// A sentence about numbers that are no motion.
    pub fn of_motion(family: &MotionFamily, seed: u64) -> Result<Self, String> {
        let moving = MovingBodies::of(&family.generate(seed))?;
        let (bodies, motions) = (moving.bodies.each_ref(), moving.motions.each_ref());
        let found = Method::default().first_contact(bodies, motions, RESOLUTION, &mut ());
        let samples = moving.samples_against(&found);
        let mut tallied = Self {
            asked: 1,
            contradicted: u64::from(samples == Samples::Contradict),
            free_by_samples: u64::from(samples == Samples::Prove && matches!(found, FirstContact::Separate { .. })),
            ..Self::default()
        };
        match found {
            FirstContact::Separate { .. } => {
                tallied.separate = 1;
                tallied.refused = u64::from(!moving.check(RESOLUTION, &found).is_right());
            }
            FirstContact::Contact { .. } => {
                tallied.contact = 1;
                tallied.missed_by_sampling = u64::from(first_sampled_contact(bodies, motions, RIVAL_STEPS).is_none());
                tallied.missed_by_hulls = u64::from(first_meeting_stretch(bodies, motions, RIVAL_STEPS).is_none());
            }
            FirstContact::Grazing { .. } => tallied.grazing = 1,
        }
        Ok(tallied)
    }
}

impl MovingBodies {
    /// Samples of the time that an answer calls free, dense enough for the bound of the step, and of the contact.
    pub fn samples_against(&self, found: &FirstContact) -> Samples {
        let end = found.free().last().map_or(0.0, |stretch| stretch.until);
        let met = match found {
            FirstContact::Separate { .. } => None,
            FirstContact::Contact { time, .. } | FirstContact::Grazing { time, .. } => Some(*time),
        };
        if end != met.map_or(1.0, |time| time[0]) {
            return Samples::Contradict;
        }
        if let (FirstContact::Contact { .. }, Some([_, at])) = (found, met)
            && self.distance_at(at) > DISTANCE_OF_ROUNDING
        {
            return Samples::Contradict;
        }
        let meet = |time| self.depth_at(time) > DEPTH_OF_ROUNDING;
        Samples::of_free_time(end, self.speed(), SAMPLE_LIMIT, |time| self.distance_at(time), meet)
    }

    /// The depth to which the bodies overlap at a time, from below.
    fn depth_at(&self, time: f64) -> f64 {
        let [p, q] = self.motions.each_ref().map(|motion| motion.pose_at(time));
        let [a, b] = &self.bodies;
        p.zip(q).map_or(f64::NAN, |(p, q)| a.at(&p).penetration(b.at(&q)).lower)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use families::motions::find;

    #[test]
    fn no_collision_of_fast_and_crafted_motions_is_missed() {
        for id in ["fast_boxes", "crafted_motions"] {
            let family = find(id).expect("it is among the families");
            let all = (0..300).map(|seed| Tallied::of_motion(family, seed).expect("a motion"));
            let tallied = all.fold(Tallied::default(), Tallied::plus);
            assert_eq!((tallied.contradicted, tallied.refused), (0, 0), "{tallied:?}");
            // bodies that touch for a while are left open, and of the random ones none
            assert!(tallied.grazing == 0 || id == "crafted_motions", "{tallied:?}");
            assert!(tallied.separate > 5 && tallied.contact > 5, "{tallied:?}");
        }
    }

    #[test]
    fn collisions_of_public_reports_are_found_and_proved() {
        for (id, seed) in [("parry_317", 0), ("rapier_js_258", 0), ("rapier_js_258", 1)] {
            let moving = MovingBodies::of(&find(id).expect("a family").generate(seed)).expect("a motion");
            let (bodies, motions) = (moving.bodies.each_ref(), moving.motions.each_ref());
            let found = Method::default().first_contact(bodies, motions, RESOLUTION, &mut ());
            assert!(matches!(found, FirstContact::Contact { .. }), "{id} {seed}: {found:?}");
            assert!(moving.check(RESOLUTION, &found).is_right(), "{id} {seed}");
        }
    }

    /// A longer free time than the true one is contradicted, so that the check can fail.
    #[test]
    fn an_answer_that_misses_a_collision_is_contradicted() {
        let family = find("fast_boxes").expect("it is among the families");
        let mut contradicted = 0;
        for seed in 0..300 {
            let moving = MovingBodies::of(&family.generate(seed)).expect("a motion");
            let (bodies, motions) = (moving.bodies.each_ref(), moving.motions.each_ref());
            let found = Method::default().first_contact(bodies, motions, RESOLUTION, &mut ());
            let FirstContact::Contact { free, .. } = found else { continue };
            let Some(last) = free.last() else { continue };
            let whole = zonotope::motion::continuous::FreeStretch { until: 1.0, ..*last };
            let missed = FirstContact::Separate { free: vec![whole] };
            assert_eq!(moving.samples_against(&missed), Samples::Contradict, "seed {seed}");
            contradicted += 1;
        }
        assert!(contradicted > 5);
    }
}
