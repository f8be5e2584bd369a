//! Meshes that are flat, thin, repeated or a point.

use super::meshes::{degenerate, random_poses, touching_poses};
use super::*;
use crate::Pose;

fn agree<V: BoundingVolume>(a: &Mesh, b: &Mesh, pose: &Pose, truth: &[[usize; 2]], what: &str) {
    let [first, second] = [a, b].map(Bvh::<V>::build);
    assert_eq!(first.pairs(second.at(pose)), truth, "{} {what} {pose:?}", V::NAME);
}

#[test]
fn degenerate_meshes_meet_as_all_pairs_say() {
    let meshes = degenerate();
    let mut poses = touching_poses(6, 11);
    poses.extend(random_poses(3, 1.0, 12));
    poses.push(Pose::IDENTITY);
    for (name, a) in &meshes {
        for (other, b) in &meshes {
            for pose in &poses {
                let truth = brute_force::all_pairs(a, b.at(pose));
                for_each_volume!(agree(a, b, pose, &truth, &format!("{name}, {other}")));
            }
        }
    }
}

fn validate<V: BoundingVolume>(name: &str, mesh: &Mesh) {
    assert_eq!(Bvh::<V>::build(mesh).validate(), Ok(()), "{} {name}", V::NAME);
}

#[test]
fn degenerate_meshes_are_inside_their_volumes() {
    for (name, mesh) in &degenerate() {
        for_each_volume!(validate(name, mesh));
    }
}

#[test]
fn triangles_of_growing_sizes_make_no_deep_tree() {
    let vertices: Vec<[f64; 3]> = (0..1500).map(|i| [libm::ldexp(1.0, i % 750), f64::from(i / 750), 0.0]).collect();
    let triangles: Vec<[u32; 3]> = (0..749).map(|i| [i, i + 1, i + 750]).collect();
    let mesh = meshes::mesh(&vertices, &triangles);
    let hierarchy = Bvh::<Aabb>::build(&mesh);
    assert_eq!(hierarchy.validate(), Ok(()));
    let moved = Pose::from_translation([0.0, 5.0, 0.0]).expect("finite");
    assert!(!hierarchy.intersects(hierarchy.at(&moved)));
    assert!(hierarchy.intersects(&hierarchy));
}
