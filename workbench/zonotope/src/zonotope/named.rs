//! Zonohedra with names, centred at the origin.
//!
//! The truncated icosidodecahedron is not among them: that its decagons are flat is a condition on the golden ratio
//! which no rational coordinates satisfy, so doubles give another body.

use std::f64::consts::{SQRT_2, TAU};

use super::Zonotope;

const GOLDEN: f64 = 1.618_033_988_749_895;

fn zonohedron(generators: Vec<[f64; 3]>) -> Zonotope<3> {
    Zonotope::new([0.0; 3], generators).expect("these coordinates are finite")
}

/// The cube with edges of length 2: 8 vertices, 12 edges, 6 facets.
pub fn cube() -> Zonotope<3> {
    zonohedron(vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
}

/// A regular hexagon, with its vertices rounded, times a segment: 12 vertices, 18 edges, 8 facets of which 2 hexagons.
pub fn hexagonal_prism() -> Zonotope<3> {
    let half_root = 0.5 * 3f64.sqrt();
    zonohedron(vec![[1.0, 0.0, 0.0], [0.5, half_root, 0.0], [-0.5, half_root, 0.0], [0.0, 0.0, 1.0]])
}

/// The rhombic dodecahedron, generators the diagonals of a cube: 14 vertices, 24 edges, 12 rhombi.
pub fn rhombic_dodecahedron() -> Zonotope<3> {
    zonohedron(vec![[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0]])
}

/// The elongated dodecahedron, a rhombic dodecahedron stretched along an axis: 18 vertices, 28 edges, 12 facets of
/// which 4 hexagons.
pub fn elongated_dodecahedron() -> Zonotope<3> {
    let mut generators = rhombic_dodecahedron().generators().to_vec();
    generators.push([0.0, 0.0, 1.0]);
    zonohedron(generators)
}

/// The truncated octahedron, generators the edges of an octahedron: 24 vertices, 36 edges, 14 facets of which 8
/// hexagons.
pub fn truncated_octahedron() -> Zonotope<3> {
    zonohedron(face_diagonals().to_vec())
}

/// The truncated cuboctahedron with edges of equal length, up to the rounding of √2: 48 vertices, 72 edges, 26 facets:
/// 12 squares, 8 hexagons, 6 octagons.
pub fn truncated_cuboctahedron() -> Zonotope<3> {
    let axes = [[SQRT_2, 0.0, 0.0], [0.0, SQRT_2, 0.0], [0.0, 0.0, SQRT_2]];
    zonohedron([&face_diagonals()[..], &axes].concat())
}

/// The rhombic triacontahedron, generators the six diagonals of an icosahedron, rounded: 32 vertices, 60 edges, 30
/// rhombi.
pub fn rhombic_triacontahedron() -> Zonotope<3> {
    zonohedron(cyclic(|sign| [0.0, 1.0, sign * GOLDEN]))
}

/// The rhombic enneacontahedron, generators the ten diagonals of a dodecahedron, rounded: 92 vertices, 180 edges, 90
/// rhombi.
pub fn rhombic_enneacontahedron() -> Zonotope<3> {
    let mut generators = rhombic_dodecahedron().generators().to_vec();
    generators.extend(cyclic(|sign| [0.0, GOLDEN - 1.0, sign * GOLDEN]));
    zonohedron(generators)
}

/// The polar zonohedron of n generators (cos φ, sin φ, pitch) evenly around an axis, rounded: n (n − 1) rhombi, for n ≥
/// 3 and a positive pitch. The pitch 1/√2 makes a cube (n = 3) and a rhombic dodecahedron (n = 4). A pitch that is not
/// finite counts as 1.
pub fn polar_zonohedron(count: u32, pitch: f64) -> Zonotope<3> {
    let pitch = if pitch.is_finite() { pitch } else { 1.0 };
    let generator = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(count);
        [libm::cos(angle), libm::sin(angle), pitch]
    };
    zonohedron((0..count).map(generator).collect())
}

fn face_diagonals() -> [[f64; 3]; 6] {
    [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]]
}

/// A vector for each sign, and those with coordinates moved round.
fn cyclic(vector: impl Fn(f64) -> [f64; 3]) -> Vec<[f64; 3]> {
    let around = |[x, y, z]: [f64; 3]| [[x, y, z], [z, x, y], [y, z, x]];
    [1.0, -1.0].into_iter().flat_map(|sign| around(vector(sign))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::combinatorics;
    use crate::zonotope::faces::{Faces, faces};

    fn check(body: &Zonotope<3>, counts: [usize; 3], facet_sizes: &[(usize, u64)]) {
        let Ok(Faces::Solid(lattice)) = faces(body, &mut ()) else { unreachable!("named bodies are solid") };
        assert_eq!([lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()], counts);
        let counted = combinatorics(body);
        assert_eq!([counted.vertices, counted.edges, counted.facets], counts.map(|count| count as u64));
        assert_eq!(counted.facet_sizes.into_iter().collect::<Vec<_>>(), facet_sizes);
    }

    #[test]
    fn counts_are_those_of_the_books() {
        check(&cube(), [8, 12, 6], &[(4, 6)]);
        check(&hexagonal_prism(), [12, 18, 8], &[(4, 6), (6, 2)]);
        check(&rhombic_dodecahedron(), [14, 24, 12], &[(4, 12)]);
        check(&elongated_dodecahedron(), [18, 28, 12], &[(4, 8), (6, 4)]);
        check(&truncated_octahedron(), [24, 36, 14], &[(4, 6), (6, 8)]);
        check(&truncated_cuboctahedron(), [48, 72, 26], &[(4, 12), (6, 8), (8, 6)]);
        check(&rhombic_triacontahedron(), [32, 60, 30], &[(4, 30)]);
        check(&rhombic_enneacontahedron(), [92, 180, 90], &[(4, 90)]);
        for n in 3..20 {
            let f = n * (n - 1);
            check(&polar_zonohedron(n as u32, 0.7), [f + 2, 2 * f, f], &[(4, f as u64)]);
        }
    }

    #[test]
    fn volumes_are_those_of_the_books() {
        assert_eq!(cube().exact_volume().to_f64(), 8.0);
        // edges of length a = 2 √3: 16 √3 a³ / 9
        assert_eq!(rhombic_dodecahedron().exact_volume().to_f64(), 128.0);
        // edges of length a = 2 √2: 8 √2 a³
        assert_eq!(truncated_octahedron().exact_volume().to_f64(), 256.0);
    }
}
