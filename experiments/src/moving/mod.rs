//! Pairs of moving bodies of the families as the library and the verifier take them, at a clearance, with the least
//! distance that samples see; [`soundness`] holds answers to samples.

pub mod meshes;
pub mod samples;
pub mod soundness;
pub mod swept;

use families::motions::{BodyRow, Course, MotionFamily, MovingPair};
use verifier::FirstContactProof;
use zonotope::interop::verifier::check_first_contact;
use zonotope::motion::Motion;
use zonotope::motion::continuous::FirstContact;
use zonotope::zonotope::Zonotope;

use crate::definition::Verdict;

/// Equal parts of the time at whose ends the distance is asked for before it is refined.
const SAMPLES: u32 = 96;

/// The samples lower than their neighbours around which the distance is refined, from the lowest on.
const REFINED: usize = 6;

/// Halvings of the time between samples around each of them.
const HALVINGS: u32 = 16;

/// The part by which the least distance may be more than the clearance.
const CLEARANCE_EXCESS: f64 = 0.01;

/// The factor by which rounding may make a bound of a speed too small, and more.
const SPEED_ROUNDING: f64 = 1.0 + 1e-12;

/// The farthest that the second body is moved aside at once: scenes are a few units large.
const FARTHEST_ASIDE: f64 = 1e3;

/// Draws of a scene, of which the first is taken whose bodies come as near as is asked for.
const DRAW_LIMIT: u64 = 16;

/// Steps of the search for the place at which the clearance is as it should be.
const STEP_LIMIT: u32 = 60;

/// Two bodies with their motions.
#[derive(Debug, Clone)]
pub struct MovingBodies {
    /// The bodies at the start.
    pub bodies: [Zonotope<3>; 2],
    /// Their motions.
    pub motions: [Motion; 2],
    courses: [Course; 2],
}

impl MovingBodies {
    /// The bodies of a pair.
    ///
    /// # Errors
    /// A sentence about numbers that are no bodies or no motions.
    pub fn of(pair: &MovingPair) -> Result<Self, String> {
        let body = |row: &BodyRow| Zonotope::new(row.center, row.generators.clone()).map_err(|error| error.to_string());
        let motion = |course: &Course| {
            let Course { axis_point, axis, angle, translation } = *course;
            Motion::constant_rate(axis_point, axis, angle, translation).map_err(|error| error.to_string())
        };
        let ([a, b], [first, second]) = (&pair.bodies, &pair.courses);
        Ok(Self { bodies: [body(a)?, body(b)?], motions: [motion(first)?, motion(second)?], courses: pair.courses })
    }

    /// The pair of a scene for a seed, its second body moved aside so far that the least distance that samples see is
    /// the clearance, or at most a hundredth of it more.
    ///
    /// # Errors
    /// A sentence, where moving the body aside does not part the bodies.
    pub fn at_clearance(family: &MotionFamily, seed: u64, clearance: f64) -> Result<Self, String> {
        let draws = (0..DRAW_LIMIT).map(|draw| family.generate(seed.wrapping_add(draw << 32)));
        let mut made = draws.map(|pair| Self::of_pair_at_clearance(family.id, &pair, clearance));
        let first = made.next().expect("there are several draws");
        // bodies that pass each other whatever the second one is moved are drawn anew
        first.or_else(|error| made.find(Result::is_ok).unwrap_or(Err(error)))
    }

    fn of_pair_at_clearance(family: &str, pair: &MovingPair, clearance: f64) -> Result<Self, String> {
        let distance = |aside: f64| Self::of(&pair.moved_aside(aside)).map(|moving| moving.least_distance());
        // the distance changes by no more than the body is moved, so a step back of the gap does not pass a contact
        let mut low = 0.0;
        let mut gap = distance(low)? - clearance;
        while gap > 0.0 {
            if gap <= CLEARANCE_EXCESS * clearance {
                return Self::of(&pair.moved_aside(low));
            }
            if low < -FARTHEST_ASIDE {
                return Err(format!("{family}: the bodies do not come near by moving one back by {}", -low));
            }
            low -= gap + 0.5 * CLEARANCE_EXCESS * clearance;
            gap = distance(low)? - clearance;
        }
        let mut high = low + 1.0;
        let mut beyond = distance(high)? - clearance;
        while beyond < 0.0 {
            if high - low > FARTHEST_ASIDE {
                return Err(format!("{family}: the bodies are not parted by moving one aside"));
            }
            (low, high) = (high, high + 2.0 * (high - low));
            beyond = distance(high)? - clearance;
        }
        for _ in 0..STEP_LIMIT {
            if beyond <= CLEARANCE_EXCESS * clearance {
                return Self::of(&pair.moved_aside(high));
            }
            // as near as the distance allows, and at least to the middle
            let middle = low + (high - low) / 2.0;
            let next = (high - beyond + 0.5 * CLEARANCE_EXCESS * clearance).min(middle).max(low);
            let found = distance(next)? - clearance;
            if found < 0.0 { low = next } else { (high, beyond) = (next, found) }
        }
        Err(format!("{family}: the clearance is not reached"))
    }

    /// The distance of the bodies at a time, as they are rounded then.
    pub fn distance_at(&self, time: f64) -> f64 {
        let [p, q] = self.motions.each_ref().map(|motion| motion.pose_at(time));
        let [a, b] = &self.bodies;
        p.zip(q).map_or(f64::NAN, |(p, q)| a.at(&p).distance(b.at(&q)))
    }

    /// A bound above the speed of any point of either body against the other.
    fn speed(&self) -> f64 {
        let of_body = |i: usize| {
            let Course { axis_point, axis, angle, translation } = self.courses[i];
            let norm = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
            let off_axis = |[x, y, z]: [f64; 3]| {
                let [a, b, c] = axis;
                norm([b * z - c * y, c * x - a * z, a * y - b * x]) / norm(axis)
            };
            let center = self.bodies[i].center();
            let arm = off_axis([0, 1, 2].map(|k| center[k] - axis_point[k]));
            let reach = self.bodies[i].generators().iter().fold(arm, |sum, g| sum + off_axis(*g));
            angle.abs() * reach + norm(translation)
        };
        (of_body(0) + of_body(1)) * SPEED_ROUNDING
    }

    /// The least distance that samples see: equally spaced ones, and more of them around the lowest.
    pub fn least_distance(&self) -> f64 {
        let step = 1.0 / f64::from(SAMPLES);
        let mut samples: Vec<(f64, f64)> = Vec::with_capacity(SAMPLES as usize + 1);
        for time in (0..=SAMPLES).map(|i| f64::from(i) * step) {
            let distance = self.distance_at(time);
            if distance == 0.0 {
                return 0.0;
            }
            samples.push((distance, time));
        }
        let at = |i: usize| samples.get(i).map_or(f64::INFINITY, |sample| sample.0);
        let is_low = |&i: &usize| at(i) <= at(i + 1) && (i == 0 || at(i) <= at(i - 1));
        let mut lows: Vec<(f64, f64)> = (0..samples.len()).filter(is_low).map(|i| samples[i]).collect();
        lows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let refined = lows.iter().take(REFINED).map(|&sample| self.refined(sample, step));
        refined.fold(f64::INFINITY, f64::min)
    }

    fn refined(&self, (mut least, mut middle): (f64, f64), step: f64) -> f64 {
        let mut width = step;
        for _ in 0..HALVINGS {
            width /= 2.0;
            for time in [middle - width, middle + width] {
                let distance = if (0.0..=1.0).contains(&time) { self.distance_at(time) } else { f64::INFINITY };
                if distance < least {
                    (least, middle) = (distance, time);
                }
            }
        }
        least
    }

    /// The verifier's verdict on an answer about these bodies.
    pub fn check(&self, resolution: f64, found: &FirstContact) -> verifier::Verdict<FirstContactProof> {
        let motions = self.courses.map(|Course { axis_point, axis, angle, translation }| {
            verifier::Motion::ConstantRate { axis_point, axis, angle, translation }
        });
        check_first_contact(self.bodies.each_ref(), motions.each_ref(), resolution, found)
    }

    /// The verdict on an answer that must be a proof that the bodies stay apart.
    pub fn verdict_on_separate(&self, resolution: f64, found: &FirstContact) -> Verdict {
        match found {
            FirstContact::Separate { .. } => Verdict::of_verifier("verifier", self.check(resolution, found)),
            other => Verdict::Wrong(format!("the bodies are apart, and the answer is {}", other.name())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use families::motions::SCENES;

    #[test]
    fn scenes_of_many_seeds_reach_their_clearance() {
        let mut missed = Vec::new();
        for family in SCENES {
            for seed in (0..24).chain([1 << 63, u64::MAX / 3, u64::MAX]) {
                if let Err(reason) = MovingBodies::at_clearance(family, seed, 1e-2) {
                    missed.push(format!("seed {seed}: {reason}"));
                }
            }
        }
        assert!(missed.is_empty(), "{missed:#?}");
    }

    #[test]
    fn scenes_are_at_their_clearance_and_proved_to_be_free() {
        for family in SCENES {
            for clearance in [0.1, 1e-3] {
                let moving = MovingBodies::at_clearance(family, 5, clearance).expect("a scene");
                let least = moving.least_distance();
                assert!((clearance..=1.02 * clearance).contains(&least), "{}: {least}", family.id);
                let found =
                    zonotope::motion::continuous::first_contact(moving.bodies.each_ref(), moving.motions.each_ref());
                assert_eq!(moving.verdict_on_separate(1e-9, &found), Verdict::Correct("verifier".to_owned()));
            }
        }
    }
}
