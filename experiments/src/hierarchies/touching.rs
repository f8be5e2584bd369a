//! Poses at which a copy of a mesh touches the mesh exactly, and poses one double further away.
//!
//! The copy is turned by half a turn about an axis through a vertex, along a coordinate axis. Where no vertex lies
//! further along a direction across that axis, a plane through the vertex separates mesh and copy, and both have the
//! vertex. The entries of such a pose are 0, ±1 and twice a coordinate, so that it is a pose of doubles without any
//! rounding.

use families::source::RandomSource;
use zonotope::Pose;
use zonotope::bvh::Mesh;

/// The poses for one vertex.
#[derive(Debug, Clone, Copy)]
pub struct TouchingPoses {
    /// The copy has a vertex in common with the mesh, and a plane through the vertex separates their interiors.
    pub at_contact: Pose,
    /// The translation of the contact with one coordinate changed to the next double away from the mesh.
    pub one_step_apart: Pose,
}

impl TouchingPoses {
    /// Poses for `count` random directions, each across one of the coordinate axes.
    pub fn of(mesh: &Mesh, count: usize, seed: u64) -> Vec<Self> {
        let mut random = RandomSource::new(seed);
        let pose = |index: usize| {
            let angle = std::f64::consts::PI * random.signed_unit();
            // the first four are along coordinate axes: whole faces may touch
            let (sine, cosine) = match index {
                0..4 => [(0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0)][index],
                _ => libm::sincos(angle),
            };
            let [axis, first, second] = [[2, 0, 1], [0, 1, 2], [1, 2, 0]][index % 3];
            let along = |v: &[f64; 3]| cosine * v[first] + sine * v[second];
            let extreme = mesh.vertices().iter().copied().max_by(|v, w| along(v).total_cmp(&along(w)));
            let vertex = extreme.expect("meshes have vertices");
            let mut matrix = [[0.0; 3]; 3];
            let mut translation = [0.0; 3];
            matrix[axis][axis] = 1.0;
            for k in [first, second] {
                matrix[k][k] = -1.0;
                translation[k] = 2.0 * vertex[k];
            }
            let mut apart = translation;
            let (k, sign) = if sine.abs() > cosine.abs() { (second, sine) } else { (first, cosine) };
            apart[k] = if sign > 0.0 { apart[k].next_up() } else { apart[k].next_down() };
            let [at_contact, one_step_apart] =
                [translation, apart].map(|translation| Pose::new(matrix, translation).expect("finite"));
            Self { at_contact, one_step_apart }
        };
        (0..count).map(pose).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hierarchies::{mesh, pairs_by_every_pair};

    #[test]
    fn copies_touch_and_one_double_further_many_do_not() {
        let mesh = mesh("torus").expect("it is a mesh");
        let poses = TouchingPoses::of(&mesh, 8, 1);
        let pairs = |pose: &Pose| pairs_by_every_pair(&mesh, pose).expect("pairs").len();
        assert!(poses.iter().all(|poses| pairs(&poses.at_contact) > 0));
        let apart = poses.iter().filter(|poses| pairs(&poses.one_step_apart) == 0).count();
        assert!(apart >= 4, "{apart} of 8");
    }
}
