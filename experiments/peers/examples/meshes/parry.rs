//! The meshes of parry3d, in doubles and in single precision: its own test of intersection, which takes the triangles
//! of one mesh in turn, and in doubles also its pairs of leaves of two trees with a test of turned boxes.

use anyhow::Context;
use experiments::hierarchies::Course;
use parry3d::shape::TriMesh as SingleMesh;
use parry3d_f64::glamx::{DMat3, DQuat, DVec3};
use parry3d_f64::math::{Pose as ParryPose, Vector};
use parry3d_f64::partitioning::BvhNode;
use parry3d_f64::query::{NonlinearRigidMotion, intersection_test};
use parry3d_f64::shape::TriMesh;
use zonotope::Pose;
use zonotope::bvh::Mesh;

use super::contender::Contender;
use super::obb::{Cuboid, Turn};
use super::triangles::meet;

/// The axes of a test of two boxes: those of the faces, as for the tree of the crate bvh.
const AXES: usize = 6;

/// The isometry of a pose.
pub fn isometry(pose: &Pose) -> ParryPose {
    let rows = DMat3::from_cols_array_2d(&pose.matrix());
    ParryPose::from_parts(DVec3::from_array(pose.translation()), DQuat::from_mat3(&rows.transpose()))
}

/// The motion at constant rate between the poses of a course.
pub fn at_constant_rate(course: &Course) -> NonlinearRigidMotion {
    let [w, x, y, z] = course.first;
    let [from, to, axis] = [course.from, course.to, course.axis].map(DVec3::from_array);
    let start = ParryPose::from_parts(from, DQuat::from_xyzw(x, y, z, w));
    NonlinearRigidMotion::new(start, Vector::ZERO, to - from, axis * course.angle)
}

/// The mesh in doubles.
pub fn mesh(mesh: &Mesh) -> anyhow::Result<TriMesh> {
    let vertices = mesh.vertices().iter().map(|v| Vector::from_array(*v)).collect();
    Ok(TriMesh::new(vertices, mesh.triangles().to_vec())?)
}

/// The mesh in single precision.
pub fn single_mesh(mesh: &Mesh) -> anyhow::Result<SingleMesh> {
    let vertices = mesh.vertices().iter().map(|v| parry3d::math::Vector::from_array(v.map(|c| c as f32))).collect();
    Ok(SingleMesh::new(vertices, mesh.triangles().to_vec())?)
}

/// The test of intersection of two meshes.
pub struct Doubles {
    pub mesh: TriMesh,
    pub poses: Vec<ParryPose>,
}

impl Contender for Doubles {
    fn meets(&self, at: usize) -> anyhow::Result<bool> {
        let test = intersection_test(&ParryPose::IDENTITY, &self.mesh, &self.poses[at], &self.mesh);
        Ok(test.ok().context("two meshes are not tested")?.intersecting)
    }

    fn pairs(&self, _: usize) -> anyhow::Result<Option<usize>> {
        Ok(None)
    }
}

/// The same in single precision: vertices and poses are rounded.
pub struct Singles {
    pub mesh: SingleMesh,
    pub poses: Vec<parry3d::math::Pose>,
}

impl Singles {
    pub fn new(mesh: SingleMesh, poses: &[Pose]) -> Self {
        let single = |pose: &Pose| {
            let exact = isometry(pose);
            parry3d::math::Pose::from_parts(exact.translation.as_vec3(), exact.rotation.as_quat())
        };
        Self { mesh, poses: poses.iter().map(single).collect() }
    }
}

impl Contender for Singles {
    fn meets(&self, at: usize) -> anyhow::Result<bool> {
        let still = parry3d::math::Pose::IDENTITY;
        let test = parry3d::query::intersection_test(&still, &self.mesh, &self.poses[at], &self.mesh);
        Ok(test.ok().context("two meshes are not tested")?.intersecting)
    }

    fn pairs(&self, _: usize) -> anyhow::Result<Option<usize>> {
        Ok(None)
    }
}

/// The pairs of leaves of two trees, by a test of turned boxes, with the test of triangles of the other trees.
pub struct LeafPairs {
    pub mesh: TriMesh,
    pub turns: Vec<Turn>,
}

impl LeafPairs {
    fn pairs_at(&self, at: usize) -> impl Iterator<Item = (u32, u32)> {
        let turn = self.turns[at];
        let cuboid = |node: &BvhNode| Cuboid::between(node.mins().to_array(), node.maxs().to_array());
        let check = move |a: &BvhNode, b: &BvhNode| turn.meet::<AXES>(&cuboid(a), &cuboid(b));
        let corners = |t: u32| self.mesh.indices()[t as usize].map(|v| self.mesh.vertices()[v as usize].to_array());
        let tree = self.mesh.bvh();
        let pairs = tree.leaf_pairs(tree, check);
        pairs.filter(move |&(i, j)| meet(&corners(i), &corners(j).map(|corner| turn.image(corner))))
    }
}

impl Contender for LeafPairs {
    fn meets(&self, at: usize) -> anyhow::Result<bool> {
        Ok(self.pairs_at(at).next().is_some())
    }

    fn pairs(&self, at: usize) -> anyhow::Result<Option<usize>> {
        Ok(Some(self.pairs_at(at).count()))
    }
}
