//! Two meshes: whether and where they meet, how far apart they are, and how many tests that takes with which volume.

use zonotope::Pose;
use zonotope::bvh::{Aabb, BoundingVolume, Bvh, Mesh, OrientedBox, Zonotope6};
use zonotope::tally::{Operation, OperationCounts};

/// Rows and columns of the surface.
const SIDE: u32 = 24;

/// A sphere of radius 1, its poles cut off.
fn sphere() -> Mesh {
    let point = |i: u32, j: u32| {
        let (a, b) = (f64::from(i) * 3.0 / f64::from(SIDE) - 1.5, f64::from(j) * 6.25 / f64::from(SIDE));
        [libm::cos(a) * libm::cos(b), libm::cos(a) * libm::sin(b), libm::sin(a)]
    };
    let vertices = (0..=SIDE).flat_map(|i| (0..SIDE).map(move |j| point(i, j))).collect();
    let at = |i: u32, j: u32| i * SIDE + j % SIDE;
    let square = |(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]];
    let squares = (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| (i, j)));
    Mesh::new(vertices, squares.flat_map(square).collect()).expect("the vertices are there")
}

/// Tests of nodes that prove two bodies disjoint.
fn node_tests<V: BoundingVolume>(mesh: &Mesh, pose: &Pose) -> u64 {
    let hierarchy = Bvh::<V>::build(mesh);
    let mut counts = OperationCounts::default();
    assert_eq!(hierarchy.at(&Pose::IDENTITY).witness(hierarchy.at(pose), &mut counts), None);
    counts.get(Operation::NodeTest)
}

/// Asks, prints and asserts.
pub fn main() {
    let mesh = sphere();
    let body = Bvh::<Zonotope6>::build(&mesh);

    // overlapping a little: all pairs of triangles that cross, exactly
    let near = Pose::from_axis_angle([1.0, 2.0, 3.0], 0.7, [1.2, 1.2, 0.9]).expect("an axis");
    let pairs = body.pairs(body.at(&near));
    println!("{} pairs of triangles meet, {:?} among them", pairs.len(), pairs.first());
    assert!(body.intersects(body.at(&near)) && !pairs.is_empty());

    // apart by about a hundredth of the size
    let apart = Pose::from_axis_angle([1.0, 2.0, 3.0], 0.7, [1.2, 1.2, 1.1]).expect("an axis");
    let distance = body.distance(body.at(&apart));
    println!("the distance is between {} and {}", distance.lower, distance.upper);
    assert!(0.0 < distance.lower && distance.upper < 0.1);

    let [boxes, turned, zonotopes] =
        [node_tests::<Aabb>, node_tests::<OrientedBox>, node_tests::<Zonotope6>].map(|count| count(&mesh, &apart));
    println!(
        "tests of nodes: {boxes} with boxes along the axes, {turned} with turned ones, {zonotopes} with zonotopes"
    );
    assert!(zonotopes < boxes);
}
