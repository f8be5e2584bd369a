//! Pairs of triangles that meet, of every volume, equal to those of all pairs.

use super::meshes::{cube, random_poses, round, touching_poses};
use super::*;
use crate::Pose;
use crate::bvh::question::Question;
use crate::property_cases;
use crate::tally::{Operation, OperationCounts};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Compares a volume with the truth in every pose.
fn agree<V: BoundingVolume>(meshes: [&Mesh; 2], poses: &[[Pose; 2]], truth: &[Vec<[usize; 2]>]) {
    let [a, b] = meshes.map(Bvh::<V>::build);
    for ([of_a, of_b], truth) in poses.iter().zip(truth) {
        let (a, b) = (a.at(of_a), b.at(of_b));
        assert_eq!(&a.pairs(b), truth, "{} {of_a:?} {of_b:?}", V::NAME);
        let witness = a.witness(b, &mut ());
        assert_eq!(witness.is_some(), !truth.is_empty(), "{} {of_a:?} {of_b:?}", V::NAME);
        assert!(witness.is_none_or(|pair| truth.contains(&pair)), "{}", V::NAME);
    }
}

fn all_agree(meshes: [&Mesh; 2], poses: &[[Pose; 2]]) {
    let truth = |[a, b]: &[Pose; 2]| brute_force::all_pairs(meshes[0].at(a), meshes[1].at(b));
    let truth: Vec<Vec<[usize; 2]>> = poses.iter().map(truth).collect();
    let meeting = truth.iter().filter(|pairs| !pairs.is_empty()).count();
    assert!(meeting > 0 && meeting < truth.len(), "poses meet or not: {meeting} of {}", truth.len());
    for_each_volume!(agree(meshes, poses, &truth));
}

fn paired(first: Vec<Pose>, second: Vec<Pose>) -> Vec<[Pose; 2]> {
    first.into_iter().zip(second).map(<[Pose; 2]>::from).collect()
}

#[test]
fn pairs_of_touching_cubes_are_those_of_all_pairs() {
    let poses = paired(touching_poses(200, 1), touching_poses(200, 2));
    all_agree([&cube(), &cube()], &poses);
}

#[test]
fn pairs_of_turned_meshes_are_those_of_all_pairs() {
    let (torus, count) = (round(6, 7, 1.25), property_cases::config(100).cases as usize);
    all_agree([&cube(), &torus], &paired(random_poses(count, 2.5, 3), random_poses(count, 2.5, 4)));
    all_agree([&torus, &round(4, 5, 0.75)], &paired(random_poses(count, 2.0, 5), random_poses(count, 2.0, 6)));
}

/// Matrices that are off rotations by up to 1e-12 and points as far out as 1e15: what the frame makes of both is paid
/// for by its slack.
#[test]
fn pairs_under_what_is_nearly_a_rotation_are_those_of_all_pairs() {
    let mut random = Pcg64::seed_from_u64(77);
    for size in [1e-15, 1e-14, 1e-13, 2.4e-13] {
        for far in [0.0, 1e6, 1e15] {
            let mut off = |pose: Pose| {
                let matrix = pose.matrix().map(|row| row.map(|c| c + size * random.random_range(-1.0..1.0)));
                let near = |c: f64| far + c + 2.0 * size * random.random_range(-1.0..1.0);
                Pose::new(matrix, pose.translation().map(near)).expect("finite")
            };
            let poses = paired(touching_poses(16, 5), touching_poses(16, 6));
            let poses: Vec<[Pose; 2]> = poses.into_iter().map(|pair| pair.map(&mut off)).collect();
            for meshes in [[&cube(), &cube()], [&cube(), &round(4, 5, 0.75)]] {
                let truth = poses.iter().map(|[p, q]| brute_force::all_pairs(meshes[0].at(p), meshes[1].at(q)));
                let truth: Vec<Vec<[usize; 2]>> = truth.collect();
                for_each_volume!(agree(meshes, &poses, &truth));
            }
        }
    }
}

/// Holds the short test of each pair of nodes to the gap.
fn short_tests_agree<V: BoundingVolume>(meshes: [&Mesh; 2], poses: &[[Pose; 2]]) {
    let [a, b] = meshes.map(Bvh::<V>::build);
    let mut apart = [0; 2];
    for [of_a, of_b] in poses {
        let question = Question::new(a.at(of_a), b.at(of_b));
        let nodes = question.hierarchies().map(|hierarchy| hierarchy.volumes.len());
        for pair in (0..nodes[0]).flat_map(|i| (0..nodes[1]).map(move |j| [i, j])) {
            let is_apart = question.proven_gap(pair) > 0.0;
            assert_eq!(question.are_apart(pair), is_apart, "{} {pair:?}", V::NAME);
            apart[usize::from(is_apart)] += 1;
        }
    }
    assert!(apart.iter().all(|count| *count > 0), "{}: {apart:?}", V::NAME);
}

#[test]
fn nodes_are_apart_where_their_gap_says_so() {
    let poses = paired(random_poses(6, 2.0, 9), random_poses(6, 2.0, 10));
    for_each_volume!(short_tests_agree([&cube(), &round(6, 7, 1.25)], &poses));
}

#[test]
fn poses_that_shear_scale_and_flatten_are_taken_as_they_are() {
    let mut first = touching_poses(60, 7);
    let matrices = [
        [[1.0, 0.5, 0.0], [0.0, 1.0, 0.25], [0.0, 0.0, 1.0]],
        [[2.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, -1.0]],
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]],
        [[1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 0.0, 0.0]],
        [[0.0; 3]; 3],
    ];
    for (pose, matrix) in first.iter_mut().zip(matrices.iter().cycle()) {
        *pose = Pose::new(*matrix, pose.translation()).expect("finite");
    }
    all_agree([&cube(), &round(4, 5, 0.75)], &paired(first.clone(), touching_poses(60, 8)));
    // the same flat pose of both
    all_agree([&cube(), &cube()], &paired(first.clone(), first.iter().rev().copied().collect()));
}

#[test]
fn sizes_from_the_least_to_the_largest_doubles_do_not_matter() {
    let scaled = |mesh: &Mesh, size: f64| {
        let vertices = mesh.vertices().iter().map(|v| v.map(|c| c * size)).collect();
        mesh.with_vertices(vertices).expect("finite")
    };
    let moved = |size: f64, poses: Vec<Pose>| -> Vec<Pose> {
        let moved = |pose: Pose| Pose::new(pose.matrix(), pose.translation().map(|c| c * size));
        poses.into_iter().map(|pose| moved(pose).expect("finite")).collect()
    };
    for [size, other] in
        [[1e300, 1e300], [1e-300, 1e-300], [1e300, 1e-300], [5e-324, 5e-324], [1.0, 1e-300], [1e-300, 1e300]]
    {
        let larger = f64::max(size, other);
        let poses = paired(moved(larger, touching_poses(24, 9)), moved(larger, touching_poses(24, 10)));
        all_agree([&scaled(&cube(), size), &scaled(&cube(), other)], &poses);
    }
}

#[test]
fn a_hierarchy_tests_fewer_triangles_than_all_pairs() {
    let torus = round(20, 24, 2.0);
    let hierarchy = Bvh::<Zonotope6>::build(&torus);
    let mut counts = OperationCounts::default();
    let away = Pose::from_translation([6.1, 0.0, 0.0]).expect("finite");
    assert_eq!(hierarchy.at(&Pose::IDENTITY).witness(hierarchy.at(&away), &mut counts), None);
    assert!(counts.get(Operation::NodeTest) < 500, "{counts:?}");
    assert!(counts.get(Operation::TriangleTest) < 500, "{counts:?}");
}
