//! Tests of nodes and of triangles that two copies of a mesh take, by bounding volume and distance, and the times.
//!
//! `cargo bench -p zonotope --bench bounding_volumes`; `-- 200` sets the poses of each mesh, `-- 200 20` also the
//! changes that are tried for each volume. A pose is a random rotation and a random direction along which the
//! second copy comes nearer, never by more than their distance, until they are at the wanted distance. The tree, the
//! leaf size, the traversal and the tests of triangles are the same for all volumes.

mod approach;
mod meshes;

use std::hint::black_box;
use std::time::Instant;

use approach::{DISTANCES, Placed, poses};
use zonotope::Pose;
use zonotope::bvh::{
    Aabb, BoundingVolume, BuildOptions, Bvh, Dop18, Dop26, Mesh, OrientedBox, Sphere, Zonotope3, Zonotope4, Zonotope5,
    Zonotope6,
};
use zonotope::tally::{Operation, OperationCounts};

/// Poses of each mesh, if no number is given.
const POSES: usize = 200;

/// The counts and the time of one volume over all poses at one distance.
#[derive(Debug, Clone, Copy)]
struct Cost {
    nodes: f64,
    triangles: f64,
    microseconds: f64,
}

fn cost(count: usize, mut ask: impl FnMut(usize, &mut OperationCounts)) -> Cost {
    let mut counts = OperationCounts::default();
    (0..count).for_each(|at| ask(at, &mut counts));
    let start = Instant::now();
    (0..count).for_each(|at| ask(at, black_box(&mut OperationCounts::default())));
    let mean = |total: f64| total / count as f64;
    Cost {
        nodes: mean(counts.get(Operation::NodeTest) as f64),
        triangles: mean(counts.get(Operation::TriangleTest) as f64),
        microseconds: mean(start.elapsed().as_secs_f64() * 1e6),
    }
}

/// The build time of a volume, and its costs: of first contact at each distance, of overlapping copies, and of all
/// pairs of these.
fn costs<V: BoundingVolume>(mesh: &Mesh, placed: &[Placed], effort: usize) -> (f64, Vec<Cost>) {
    let start = Instant::now();
    let hierarchy = Bvh::<V>::build_with(mesh, &BuildOptions { effort, ..BuildOptions::default() });
    let build = start.elapsed().as_secs_f64() * 1e3;
    let still = hierarchy.at(&Pose::IDENTITY);
    let mut all = Vec::new();
    for at in 0..DISTANCES.len() {
        all.push(cost(placed.len(), |pose, counts| {
            let found = still.witness(hierarchy.at(&placed[pose].apart[at]), counts);
            assert_eq!(found, None, "{} is wrong", V::NAME);
        }));
    }
    all.push(cost(placed.len(), |pose, counts| {
        assert!(still.witness(hierarchy.at(&placed[pose].overlapping), counts).is_some(), "{} is wrong", V::NAME);
    }));
    all.push(cost(placed.len(), |pose, counts| {
        black_box(still.at_most_pairs(hierarchy.at(&placed[pose].overlapping), usize::MAX, counts));
    }));
    (build, all)
}

fn row<V: BoundingVolume>(mesh: &Mesh, placed: &[Placed], effort: usize, of_boxes: Option<&[Cost]>) -> Vec<Cost> {
    let (build, costs) = costs::<V>(mesh, placed, effort);
    print!("{:18} {build:8.1}", V::NAME);
    for (at, cost) in costs.iter().enumerate() {
        let share = of_boxes.map_or_else(String::new, |boxes| format!("{:5.2}", cost.nodes / boxes[at].nodes));
        print!(" | {:8.0} {share:5} {:7.0} {:8.1}", cost.nodes, cost.triangles, cost.microseconds);
    }
    println!();
    costs
}

fn main() {
    let numbers: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let count = numbers.first().copied().unwrap_or(POSES);
    let effort = numbers.get(1).copied().unwrap_or(0);
    println!("{count} poses, {effort} changes a volume; for each case: node tests, their share of the OBB's, triangle");
    println!(
        "tests, microseconds; cases: apart by {DISTANCES:?} of the size, overlapping by 0.01: first pair, all pairs"
    );
    for (name, mesh) in meshes::all() {
        let placed = poses(&mesh, count);
        println!("\n{name}, {} triangles                 build, ms", mesh.triangles().len());
        let boxes = row::<OrientedBox>(&mesh, &placed, effort, None);
        let of_boxes = Some(boxes.as_slice());
        row::<Aabb>(&mesh, &placed, effort, of_boxes);
        row::<Sphere>(&mesh, &placed, effort, of_boxes);
        row::<Dop18>(&mesh, &placed, effort, of_boxes);
        row::<Dop26>(&mesh, &placed, effort, of_boxes);
        row::<Zonotope3>(&mesh, &placed, effort, of_boxes);
        row::<Zonotope4>(&mesh, &placed, effort, of_boxes);
        row::<Zonotope5>(&mesh, &placed, effort, of_boxes);
        row::<Zonotope6>(&mesh, &placed, effort, of_boxes);
    }
}
