//! Tests of nodes and of triangles that two copies of a mesh take, by bounding volume and distance, and the times.
//!
//! `cargo bench -p zonotope --bench bounding_volumes`; `-- 200` sets the poses of each mesh, `-- 200 20` also the
//! changes that are tried for each volume after its first fit. A pose is a random rotation and a random direction along
//! which the second copy comes nearer, never by more than their distance, until they are at the wanted distance. The
//! tree, the leaf size, the traversal and the tests of triangles are the same for all volumes; the turning of a
//! question is part of its time.
//!
//! The table has a line for each mesh, volume and case, as comma-separated values: `node_tests` and `triangle_tests` are
//! means over all poses and exact, `of_obb` is the ratio to the node tests of oriented boxes, `microseconds` the mean
//! over all poses of the least of a few rounds, and `build` the build time in terms of that of the tree with boxes along
//! the axes.

mod approach;
mod meshes;

use std::hint::black_box;
use std::time::Instant;

use approach::{DISTANCES, Placed, poses};
use zonotope::Pose;
use zonotope::bvh::{
    Aabb, BoundingVolume, BuildOptions, Bvh, Dop18, Dop26, Mesh, OrientedBox, PlacedBvh, Sphere, Zonotope3, Zonotope4,
    Zonotope5, Zonotope6,
};
use zonotope::tally::{Operation, OperationCounts};

/// Poses of each mesh, if no number is given.
const POSES: usize = 200;

/// Times of a question, of which the least counts.
const ROUNDS: usize = 5;

/// Builds of the tree with boxes along the axes, of which the quickest counts.
const BUILDS: usize = 20;

/// The questions of a case.
#[derive(Debug, Clone, Copy)]
enum Case {
    Apart(usize),
    FirstContact,
    AllPairs,
}

/// The counts and the time of one volume in one case.
#[derive(Debug, Clone, Copy)]
struct Cost {
    nodes: f64,
    triangles: f64,
    microseconds: f64,
}

impl Case {
    fn all() -> impl Iterator<Item = Self> {
        (0..DISTANCES.len()).map(Self::Apart).chain([Self::FirstContact, Self::AllPairs])
    }

    fn name(self) -> String {
        match self {
            Self::Apart(at) => DISTANCES[at].to_string(),
            Self::FirstContact => "first contact".to_owned(),
            Self::AllPairs => "all pairs".to_owned(),
        }
    }

    fn pose(self, placed: &Placed) -> &Pose {
        match self {
            Self::Apart(at) => &placed.apart[at],
            Self::FirstContact | Self::AllPairs => &placed.overlapping,
        }
    }

    /// Asks the question, and holds the answer to the pose.
    fn ask<V: BoundingVolume>(self, still: PlacedBvh<'_, V>, moved: PlacedBvh<'_, V>, counts: &mut OperationCounts) {
        let meets = match self {
            Self::Apart(_) | Self::FirstContact => still.witness(moved, counts).is_some(),
            Self::AllPairs => still.at_most_pairs(moved, usize::MAX, counts).is_some_and(|pairs| !pairs.is_empty()),
        };
        assert_eq!(meets, !matches!(self, Self::Apart(_)), "{} is wrong", V::NAME);
    }

    fn cost<V: BoundingVolume>(self, hierarchy: &Bvh<V>, placed: &[Placed]) -> Cost {
        let still = hierarchy.at(&Pose::IDENTITY);
        let mut counts = OperationCounts::default();
        let mut seconds = 0.0;
        for placed in placed {
            let moved = hierarchy.at(self.pose(placed));
            self.ask(still, moved, &mut counts);
            let round = |_| {
                let start = Instant::now();
                self.ask(still, moved, black_box(&mut OperationCounts::default()));
                start.elapsed().as_secs_f64()
            };
            seconds += (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min);
        }
        let mean = |total: f64| total / placed.len() as f64;
        Cost {
            nodes: mean(counts.get(Operation::NodeTest) as f64),
            triangles: mean(counts.get(Operation::TriangleTest) as f64),
            microseconds: mean(seconds * 1e6),
        }
    }
}

/// One mesh with its poses, and what its lines are compared with.
struct Measurement<'a> {
    name: &'a str,
    mesh: &'a Mesh,
    placed: Vec<Placed>,
    effort: usize,
    seconds_of_axes: f64,
    of_boxes: Vec<Cost>,
}

impl Measurement<'_> {
    fn lines<V: BoundingVolume>(&mut self) {
        let options = BuildOptions { effort: self.effort, ..BuildOptions::default() };
        let start = Instant::now();
        let hierarchy = Bvh::<V>::build_with(self.mesh, &options);
        let build = start.elapsed().as_secs_f64() / self.seconds_of_axes;
        let costs: Vec<Cost> = Case::all().map(|case| case.cost(&hierarchy, &self.placed)).collect();
        if self.of_boxes.is_empty() {
            self.of_boxes = costs.clone();
        }
        for ((case, cost), boxes) in Case::all().zip(&costs).zip(&self.of_boxes) {
            let Cost { nodes, triangles, microseconds } = cost;
            println!(
                "{},{},{},{build:.1},{},{nodes:.1},{:.3},{triangles:.1},{microseconds:.2}",
                self.name,
                self.mesh.triangles().len(),
                V::NAME.replace(',', ""),
                case.name(),
                nodes / boxes.nodes,
            );
        }
    }
}

fn main() {
    let numbers: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let count = numbers.first().copied().unwrap_or(POSES);
    let effort = numbers.get(1).copied().unwrap_or(0);
    println!("mesh,triangles,volume,build,case,node_tests,of_obb,triangle_tests,microseconds");
    for (name, mesh) in meshes::all() {
        let build = |_| {
            let start = Instant::now();
            black_box(Bvh::<Aabb>::build(&mesh));
            start.elapsed().as_secs_f64()
        };
        let seconds_of_axes = (0..BUILDS).map(build).fold(f64::INFINITY, f64::min);
        let placed = poses(&mesh, count);
        let of_boxes = Vec::new();
        let mut measured = Measurement { name, mesh: &mesh, placed, effort, seconds_of_axes, of_boxes };
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
    }
}
