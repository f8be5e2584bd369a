//! Generators of zonohedra with names.
//!
//! The truncated icosidodecahedron is not among them: that its decagons are flat is a condition on the golden ratio
//! which no rational coordinates satisfy, so doubles give another body.

use std::f64::consts::{SQRT_2, TAU};

const GOLDEN: f64 = 1.618_033_988_749_895;

/// The cube with edges of length 2: 8 vertices, 12 edges, 6 facets.
pub fn cube() -> Vec<[f64; 3]> {
    vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
}

/// A regular hexagon, with its vertices rounded, times a segment: 12 vertices, 18 edges, 8 facets of which 2 hexagons.
pub fn hexagonal_prism() -> Vec<[f64; 3]> {
    let half_root = 0.5 * 3f64.sqrt();
    vec![[1.0, 0.0, 0.0], [0.5, half_root, 0.0], [-0.5, half_root, 0.0], [0.0, 0.0, 1.0]]
}

/// The rhombic dodecahedron, generators the diagonals of a cube: 14 vertices, 24 edges, 12 rhombi.
pub fn rhombic_dodecahedron() -> Vec<[f64; 3]> {
    vec![[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]]
}

/// The elongated dodecahedron, a rhombic dodecahedron stretched along an axis: 18 vertices, 28 edges, 12 facets of
/// which 4 hexagons.
pub fn elongated_dodecahedron() -> Vec<[f64; 3]> {
    let mut generators = rhombic_dodecahedron();
    generators.push([0.0, 0.0, 1.0]);
    generators
}

/// The truncated octahedron, generators the edges of an octahedron: 24 vertices, 36 edges, 14 facets of which 8
/// hexagons.
pub fn truncated_octahedron() -> Vec<[f64; 3]> {
    face_diagonals().to_vec()
}

/// The truncated cuboctahedron with edges of equal length, up to the rounding of √2: 48 vertices, 72 edges, 26 facets:
/// 12 squares, 8 hexagons, 6 octagons.
pub fn truncated_cuboctahedron() -> Vec<[f64; 3]> {
    let axes = [[SQRT_2, 0.0, 0.0], [0.0, SQRT_2, 0.0], [0.0, 0.0, SQRT_2]];
    [&face_diagonals()[..], &axes].concat()
}

/// The rhombic triacontahedron, generators the six diagonals of an icosahedron, rounded: 32 vertices, 60 edges, 30
/// rhombi.
pub fn rhombic_triacontahedron() -> Vec<[f64; 3]> {
    cyclic(|sign| [0.0, 1.0, sign * GOLDEN])
}

/// The rhombic enneacontahedron, generators the ten diagonals of a dodecahedron, rounded: 92 vertices, 180 edges, 90
/// rhombi.
pub fn rhombic_enneacontahedron() -> Vec<[f64; 3]> {
    let mut generators = rhombic_dodecahedron();
    generators.extend(cyclic(|sign| [0.0, GOLDEN - 1.0, sign * GOLDEN]));
    generators
}

/// The polar zonohedron of n generators (cos φ, sin φ, pitch) evenly around an axis, rounded: n (n − 1) rhombi, for n ≥
/// 3 and a positive pitch. The pitch 1/√2 makes a cube (n = 3) and a rhombic dodecahedron (n = 4). A pitch that is not
/// finite counts as 1.
pub fn polar_zonohedron(count: u32, pitch: f64) -> Vec<[f64; 3]> {
    let pitch = if pitch.is_finite() { pitch } else { 1.0 };
    let generator = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(count);
        [libm::cos(angle), libm::sin(angle), pitch]
    };
    (0..count).map(generator).collect()
}

fn face_diagonals() -> [[f64; 3]; 6] {
    [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]]
}

/// A vector for each sign, and those with coordinates moved round.
fn cyclic(vector: impl Fn(f64) -> [f64; 3]) -> Vec<[f64; 3]> {
    let around = |[x, y, z]: [f64; 3]| [[x, y, z], [z, x, y], [y, z, x]];
    [1.0, -1.0].into_iter().flat_map(|sign| around(vector(sign))).collect()
}
