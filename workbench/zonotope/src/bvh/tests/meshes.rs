//! Meshes and poses for tests.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::Pose;
use crate::bvh::Mesh;

/// A mesh of vertices and triangles.
pub(super) fn mesh(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh::new(vertices.to_vec(), triangles.to_vec()).expect("the vertices are there")
}

/// The surface of the cube [−1, 1]³.
pub(super) fn cube() -> Mesh {
    let vertices: Vec<[f64; 3]> = (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 0 { -1.0 } else { 1.0 })).collect();
    let squares = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangles: Vec<[u32; 3]> = squares.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    mesh(&vertices, &triangles)
}

/// A sphere of latitudes and longitudes, or a torus where the tube is not a half circle; no coordinate is short.
pub(super) fn round(rows: u32, columns: u32, radius: f64) -> Mesh {
    let point = |i: u32, j: u32| {
        let (a, b) = (f64::from(i) * 6.0 / f64::from(rows), f64::from(j) * 6.25 / f64::from(columns));
        let reach = radius + libm::cos(a);
        [reach * libm::cos(b), reach * libm::sin(b), libm::sin(a)]
    };
    let vertices: Vec<[f64; 3]> = (0..rows).flat_map(|i| (0..columns).map(move |j| point(i, j))).collect();
    let at = |i: u32, j: u32| (i % rows) * columns + j % columns;
    let squares =
        (0..rows).flat_map(|i| (0..columns).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    let triangles: Vec<[u32; 3]> = squares.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    mesh(&vertices, &triangles)
}

/// Meshes with all that may be degenerate, each with its name.
pub(super) fn degenerate() -> Vec<(&'static str, Mesh)> {
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let needle = [[0.0, 0.0, 0.0], [4.0, 1e-9, 0.0], [4.0, 0.0, 1e-12], [-4.0, 0.0, 0.0]];
    let line: Vec<[f64; 3]> = (0..9).map(|i| [f64::from(i % 4), f64::from(i % 4), 0.0]).collect();
    vec![
        ("flat", mesh(&square, &[[0, 1, 2], [1, 3, 2]])),
        ("needle", mesh(&needle, &[[0, 1, 2], [1, 2, 3], [0, 2, 3]])),
        ("repeated", mesh(&square, &[[0, 1, 2]; 9])),
        ("single", mesh(&square, &[[0, 1, 2]])),
        ("vertex", mesh(&[[0.5, 0.5, 0.0]], &[[0, 0, 0]])),
        ("vertex of the origin", mesh(&[[0.0; 3]], &[[0, 0, 0], [0, 0, 0], [0, 0, 0]])),
        ("line", mesh(&line, &[[0, 1, 2], [3, 4, 5], [6, 7, 8], [0, 0, 8]])),
    ]
}

/// Poses with exact contacts: quarter turns with translations by halves.
pub(super) fn touching_poses(count: usize, seed: u64) -> Vec<Pose> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let pose = |_| {
        let mut matrix = [[0.0; 3]; 3];
        let first = random.random_range(0..3);
        let second = (first + random.random_range(1..3)) % 3;
        for (row, column) in matrix.iter_mut().zip([first, second, 3 - first - second]) {
            row[column] = if random.random_bool(0.5) { 1.0 } else { -1.0 };
        }
        let translation = [0; 3].map(|_| 0.5 * f64::from(random.random_range(-4i32..5)));
        Pose::new(matrix, translation).expect("finite")
    };
    (0..count).map(pose).collect()
}

/// Poses in general position, with translations of length up to `far`.
pub(super) fn random_poses(count: usize, far: f64, seed: u64) -> Vec<Pose> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut any = |size: f64| random.random_range(-size..size);
    let pose = |_| Pose::from_quaternion([0; 4].map(|_| any(1.0)), [0; 3].map(|_| any(far))).expect("a rotation");
    (0..count).map(pose).collect()
}
