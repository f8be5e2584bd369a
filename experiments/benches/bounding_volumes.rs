//! Tests of nodes and of triangles that two copies of a mesh take, by bounding volume and distance, and the times.
//!
//! `cargo bench -p experiments --bench bounding_volumes`; `-- 200` sets the poses of each mesh, `-- 200 20` also the
//! changes that are tried for each volume after its first fit. The tree, the leaf size, the traversal and the tests of
//! triangles are the same for all volumes; the turning of a question is part of its time.
//!
//! The table has a line for each mesh, volume and case, as comma-separated values: `node_tests` and `triangle_tests`
//! are means over all poses and exact, `of_obb` is the ratio to the node tests of oriented boxes, `microseconds` the
//! mean over all poses of the least of a few rounds, and `build` the build time in terms of that of the tree with boxes
//! along the axes.

use std::hint::black_box;
use std::time::Instant;

use experiments::hierarchies::{Asked, MESHES, Placed, Scene, Tests, scene};
use zonotope::bvh::{
    Aabb, BoundingVolume, BuildOptions, Bvh, Dop18, Dop26, OrientedBox, Sphere, Zonotope3, Zonotope4, Zonotope5,
    Zonotope6, ZonotopeByCost,
};
use zonotope::tally::OperationCounts;

/// Poses of each mesh, if no number is given.
const POSES: usize = 200;

/// Times of a question, of which the least counts.
const ROUNDS: usize = 5;

/// Builds of the tree with boxes along the axes, of which the quickest counts.
const BUILDS: usize = 20;

/// Builds of every volume, of which the quickest counts.
const BUILDS_OF_A_VOLUME: usize = 3;

/// One mesh with its poses, and what its lines are compared with.
struct Measurement<'a> {
    name: &'a str,
    scene: &'a Scene,
    effort: usize,
    seconds_of_axes: f64,
    of_boxes: Vec<Tests>,
}

impl Measurement<'_> {
    fn lines<V: BoundingVolume>(&mut self) {
        let options = BuildOptions { effort: self.effort, ..BuildOptions::default() };
        let build = || {
            let start = Instant::now();
            let hierarchy = Bvh::<V>::build_with(&self.scene.mesh, &options);
            (start.elapsed().as_secs_f64() / self.seconds_of_axes, hierarchy)
        };
        let (mut build_time, hierarchy) = build();
        (1..BUILDS_OF_A_VOLUME).for_each(|_| build_time = build_time.min(build().0));
        let tests =
            |asked: Asked| asked.tests(&hierarchy, &self.scene.placed).expect("the answer is that of the pose").0;
        let all: Vec<Tests> = Asked::all().map(tests).collect();
        if self.of_boxes.is_empty() {
            self.of_boxes = all.clone();
        }
        for ((asked, Tests { nodes, triangles }), boxes) in Asked::all().zip(all).zip(&self.of_boxes) {
            println!(
                "{},{},{},{build_time:.1},{},{nodes:.1},{:.3},{triangles:.1},{:.2}",
                self.name,
                self.scene.mesh.triangles().len(),
                V::NAME.replace(',', ""),
                asked.name(),
                nodes / boxes.nodes,
                self.microseconds(asked, &hierarchy),
            );
        }
    }

    fn microseconds<V: BoundingVolume>(&self, asked: Asked, hierarchy: &Bvh<V>) -> f64 {
        let of_pose = |placed: &Placed| {
            let round = |_| {
                let start = Instant::now();
                black_box(asked.ask(hierarchy, placed, &mut OperationCounts::default())).expect("it was right before");
                start.elapsed().as_secs_f64()
            };
            (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
        };
        1e6 * self.scene.placed.iter().map(of_pose).sum::<f64>() / self.scene.placed.len() as f64
    }
}

fn main() {
    let numbers: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let count = numbers.first().copied().unwrap_or(POSES);
    let effort = numbers.get(1).copied().unwrap_or(0);
    println!("mesh,triangles,volume,build,case,node_tests,of_obb,triangle_tests,microseconds");
    for name in MESHES {
        let scene = scene(name, count, 1).expect("it is among the meshes");
        let build = |_| {
            let start = Instant::now();
            black_box(Bvh::<Aabb>::build(&scene.mesh));
            start.elapsed().as_secs_f64()
        };
        let seconds_of_axes = (0..BUILDS).map(build).fold(f64::INFINITY, f64::min);
        let of_boxes = Vec::new();
        let mut measured = Measurement { name, scene: &scene, effort, seconds_of_axes, of_boxes };
        // oriented boxes first: the others are compared with them
        measured.lines::<OrientedBox>();
        measured.lines::<Aabb>();
        measured.lines::<Sphere>();
        measured.lines::<Dop18>();
        measured.lines::<Dop26>();
        measured.lines::<Zonotope3>();
        measured.lines::<Zonotope4>();
        measured.lines::<Zonotope5>();
        measured.lines::<Zonotope6>();
        measured.lines::<ZonotopeByCost>();
    }
}
