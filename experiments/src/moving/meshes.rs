//! Answers about two copies of a mesh that move fast, held to samples.

use families::source::RandomSource;
use zonotope::motion::Motion;
use zonotope::motion::continuous::of_meshes::{MeshContact, first_contact};

use super::samples::Samples;
use super::soundness::RIVAL_STEPS;
use crate::hierarchies::{Course, MovedMesh, poses_of};

/// The most samples of a motion.
const SAMPLE_LIMIT: u32 = 1 << 12;

/// A bound of the distance of rounded placements whose meshes meet, in terms of the diagonal.
const DISTANCE_OF_ROUNDING: f64 = 1e-9;

/// The factor by which rounding may make a bound of a speed too small, and more.
const SPEED_ROUNDING: f64 = 1.0 + 1e-9;

/// The verdicts on the answers about some motions.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct TalliedMeshes {
    /// Motions that were asked about.
    pub asked: u64,
    /// Answers that the meshes stay apart.
    pub separate: u64,
    /// Answers that they meet.
    pub contact: u64,
    /// Answers that leave it open.
    pub grazing: u64,
    /// Answers that samples contradict: collisions that were missed among them.
    pub contradicted: u64,
    /// Answers whose free time samples prove to be free, but for rounding.
    pub free_by_samples: u64,
    /// Collisions that samples at equal steps miss.
    pub missed_by_sampling: u64,
}

impl TalliedMeshes {
    /// The sum of two tallies.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            asked: self.asked + other.asked,
            separate: self.separate + other.separate,
            contact: self.contact + other.contact,
            grazing: self.grazing + other.grazing,
            contradicted: self.contradicted + other.contradicted,
            free_by_samples: self.free_by_samples + other.free_by_samples,
            missed_by_sampling: self.missed_by_sampling + other.missed_by_sampling,
        }
    }

    /// The verdict on two motions of a mesh for a seed, which turn by no more than `greatest_turn` in radians: copies
    /// that pass near each other, and copies that come nearer.
    ///
    /// # Errors
    /// A sentence, if a placement leaves the range of doubles.
    pub fn of_motions(moved: &MovedMesh, seed: u64, greatest_turn: f64) -> Result<Self, String> {
        let [apart, nearer] = moved.courses(&mut RandomSource::new(seed), greatest_turn)?;
        Ok(Self::of_courses(moved, &apart)?.plus(Self::of_courses(moved, &nearer)?))
    }

    fn of_courses(moved: &MovedMesh, courses: &[Course; 2]) -> Result<Self, String> {
        let motions = [courses[0].rational()?, courses[1].rational()?];
        let found = first_contact([&moved.boxes; 2], motions.each_ref()).map_err(|error| error.to_string())?;
        let samples = samples_against(moved, courses, &motions, &found)?;
        let mut tallied = Self {
            asked: 1,
            contradicted: u64::from(samples == Samples::Contradict),
            free_by_samples: u64::from(samples == Samples::Prove),
            ..Self::default()
        };
        match found {
            MeshContact::Separate { .. } => tallied.separate = 1,
            MeshContact::Contact { .. } => {
                tallied.contact = 1;
                let (least, _) = moved.nearest(&motions, RIVAL_STEPS as usize)?;
                tallied.missed_by_sampling = u64::from(least > 0.0);
            }
            MeshContact::Grazing { .. } => tallied.grazing = 1,
        }
        Ok(tallied)
    }
}

/// Samples of the time that an answer calls free, dense enough for the bound of the step, and of the contact.
fn samples_against(
    moved: &MovedMesh,
    courses: &[Course; 2],
    motions: &[Motion; 2],
    found: &MeshContact,
) -> Result<Samples, String> {
    // every pose of a step is within the range of doubles if those at its ends are
    for time in [0.0, 1.0] {
        poses_of(motions, time)?;
    }
    let distance_at = |time: f64| poses_of(motions, time).map_or(f64::NAN, |poses| moved.distance(&poses));
    let end = match found {
        MeshContact::Separate { .. } => 1.0,
        MeshContact::Contact { time, .. } | MeshContact::Grazing { time, .. } => time[0],
    };
    if let MeshContact::Contact { time: [_, at], .. } = found
        && distance_at(*at) > DISTANCE_OF_ROUNDING * moved.diagonal
    {
        return Ok(Samples::Contradict);
    }
    let reach = moved.diagonal / 2.0;
    let speed = courses.iter().map(|course| course.speed(reach)).sum::<f64>() * SPEED_ROUNDING;
    Ok(Samples::of_free_time(end, speed, SAMPLE_LIMIT, distance_at, |_| true))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hierarchies::mesh;

    #[test]
    fn no_collision_of_fast_meshes_is_missed() {
        let moved = MovedMesh::of(&mesh("torus").expect("it is a mesh")).expect("moved");
        let all = (0..4).map(|seed| TalliedMeshes::of_motions(&moved, seed, 3.0).expect("motions"));
        let tallied = all.fold(TalliedMeshes::default(), TalliedMeshes::plus);
        assert_eq!((tallied.asked, tallied.contradicted), (8, 0), "{tallied:?}");
        assert!(tallied.separate > 2 && tallied.contact > 2, "{tallied:?}");
    }

    /// A longer free time than the true one is contradicted, so that the check can fail.
    #[test]
    fn an_answer_that_misses_a_collision_is_contradicted() {
        let moved = MovedMesh::of(&mesh("torus").expect("it is a mesh")).expect("moved");
        let [_, nearer] = moved.courses(&mut RandomSource::new(2), 1.0).expect("courses");
        let motions = [nearer[0].rational().expect("a motion"), nearer[1].rational().expect("a motion")];
        let found = first_contact([&moved.boxes; 2], motions.each_ref()).expect("they are rational");
        assert!(matches!(found, MeshContact::Contact { .. }), "{}", found.name());
        let missed = MeshContact::Separate { free: Vec::new() };
        assert_eq!(samples_against(&moved, &nearer, &motions, &missed), Ok(Samples::Contradict));
        let early = MeshContact::Contact { free: Vec::new(), time: [0.0, 0.0], triangles: [0, 0] };
        assert_eq!(samples_against(&moved, &nearer, &motions, &early), Ok(Samples::Contradict));
    }
}
