//! The meshes and motions of a question, times a power of two where their numbers are very large or very small: guesses
//! in doubles then neither overflow nor vanish, and directions prove the same.

use crate::bvh::{BoundingVolume, Bvh};
use crate::motion::Motion;
use crate::motion::continuous::ordinary_sizes;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::scaling::scaled_exactly;
use crate::zonotope::pose::Pose;

/// Two meshes and their motions.
pub(super) struct MeshScene<'a, V> {
    pub(super) hierarchies: [&'a Bvh<V>; 2],
    /// The motions as they were given.
    given: [&'a Motion; 2],
    /// The motions times a power of two, where that makes numbers ordinary and is exact.
    scaled: Option<[Motion; 2]>,
    /// The exponent of that power; 0 where there is none.
    pub(super) exponent: i64,
}

impl<'a, V: BoundingVolume> MeshScene<'a, V> {
    pub(super) fn new(hierarchies: [&'a Bvh<V>; 2], given: [&'a Motion; 2]) -> Self {
        let scaled = change(hierarchies, given).and_then(|exponent| {
            let mut vertices = hierarchies.iter().flat_map(|hierarchy| hierarchy.mesh().vertices());
            let [p, q] = given.map(|motion| motion.scaled(exponent));
            let motions = [p?, q?];
            vertices.all(|vertex| scaled_exactly(vertex, exponent).is_some()).then_some((motions, exponent))
        });
        let (scaled, exponent) = scaled.map_or((None, 0), |(motions, exponent)| (Some(motions), exponent));
        Self { hierarchies, given, scaled, exponent }
    }

    /// The motions of the meshes times 2^`exponent`.
    pub(super) fn motions(&self) -> [&Motion; 2] {
        self.scaled.as_ref().map_or(self.given, |motions| motions.each_ref())
    }

    /// The poses of the meshes times 2^`exponent` at a time, rounded.
    pub(super) fn poses_at(&self, time: f64) -> Option<[Pose; 2]> {
        poses_at(self.motions(), time)
    }

    /// The poses of the meshes at a time, rounded.
    pub(super) fn given_poses_at(&self, time: f64) -> Option<[Pose; 2]> {
        poses_at(self.given, time)
    }

    /// The placement of the second mesh as the first one sees it at a time: a rotation and a translation, rounded.
    pub(super) fn seen_at(&self, time: f64) -> Option<([[f64; 3]; 3], [f64; 3])> {
        let [p, q] = self.poses_at(time)?;
        let column = |pose: &Pose, j: usize| pose.rows().map(|row| row[j]);
        let apart = [0, 1, 2].map(|k| q.translation()[k] - p.translation()[k]);
        let rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(&column(&p, i), &column(&q, j))));
        Some((rotation, [0, 1, 2].map(|i| dot(&column(&p, i), &apart))))
    }
}

fn poses_at(motions: [&Motion; 2], time: f64) -> Option<[Pose; 2]> {
    let [p, q] = motions.map(|motion| motion.pose_at(time));
    Some([p?, q?])
}

/// The exponent of the power of two by which numbers become ordinary; `None` where they are.
fn change<V: BoundingVolume>(hierarchies: [&Bvh<V>; 2], motions: [&Motion; 2]) -> Option<i64> {
    let of_meshes = hierarchies.iter().filter_map(|hierarchy| {
        let coordinates = hierarchy.mesh().vertices().as_flattened().iter();
        Dyadic::from_f64(coordinates.fold(0.0f64, |largest, c| largest.max(c.abs()))).binary_exponent()
    });
    let of_motions = motions.iter().filter_map(|motion| motion.size_exponent());
    ordinary_sizes::change(of_meshes.chain(of_motions).max()?)
}
