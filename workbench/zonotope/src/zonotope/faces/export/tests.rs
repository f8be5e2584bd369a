//! Exports read back: the same vertices, the same polygons, outward normals.

use crate::zonotope::Zonotope;
use crate::zonotope::faces::{FaceLattice, Faces, Facet, faces};
use families::bodies::named;

fn lattice(body: &Zonotope<3>) -> FaceLattice {
    match faces(body, &mut ()).expect("few directions") {
        Faces::Flat(lattice) | Faces::Solid(lattice) => lattice,
        Faces::Point(_) | Faces::Segment(_) => unreachable!("two directions"),
    }
}

fn bodies() -> Vec<Zonotope<3>> {
    let prism = Zonotope::new([1e-300, 0.1, 1e300], named::hexagonal_prism()).expect("finite");
    let flat = Zonotope::new([0.1; 3], vec![[1.0, 2.0, 3.0], [0.3, 0.2, 0.1], [-1.0, 1.0, 0.0]]).expect("finite");
    let named = [named::cube(), named::truncated_cuboctahedron(), named::rhombic_triacontahedron()];
    let named = named.map(|generators| Zonotope::new([0.0; 3], generators).expect("finite"));
    named.into_iter().chain([prism, flat]).collect()
}

fn polygons(lattice: &FaceLattice) -> Vec<Vec<u32>> {
    let facets = (0..lattice.facet_count() as u32).map(Facet);
    facets.map(|facet| lattice.facet_vertices(facet).map(|vertex| vertex.0).collect()).collect()
}

fn numbers<T: std::str::FromStr>(line: &str) -> Vec<T> {
    line.split(' ').map(|word| word.parse().ok().expect("a number")).collect()
}

#[test]
fn obj_reads_back() {
    for body in bodies() {
        let lattice = lattice(&body);
        let text = lattice.to_obj();
        let points: Vec<Vec<f64>> = text.lines().filter_map(|line| line.strip_prefix("v ")).map(numbers).collect();
        assert_eq!(points, lattice.points());
        let faces = text.lines().filter_map(|line| line.strip_prefix("f ")).map(numbers::<u32>);
        let faces: Vec<Vec<u32>> = faces.map(|face| face.iter().map(|index| index - 1).collect()).collect();
        assert_eq!(faces, polygons(&lattice));
    }
}

#[test]
fn ply_reads_back() {
    for body in bodies() {
        let lattice = lattice(&body);
        let text = lattice.to_ply();
        let (header, content) = text.split_once("end_header\n").expect("a header");
        assert!(header.starts_with("ply\nformat ascii 1.0\n"));
        assert!(header.contains(&format!("element face {}\n", lattice.facet_count())));
        let lines: Vec<&str> = content.lines().collect();
        let (points, faces) = lines.split_at(lattice.vertex_count());
        assert_eq!(points.iter().map(|line| numbers::<f64>(line)).collect::<Vec<_>>(), lattice.points());
        let faces: Vec<Vec<u32>> = faces.iter().map(|line| numbers::<u32>(line)).collect();
        assert!(faces.iter().all(|face| face[0] as usize == face.len() - 1));
        assert_eq!(faces.iter().map(|face| face[1..].to_vec()).collect::<Vec<_>>(), polygons(&lattice));
    }
}

#[test]
fn stl_is_closed_and_faces_outward() {
    for body in bodies().into_iter().take(3) {
        let lattice = lattice(&body);
        let bytes = lattice.to_stl();
        let count = u32::from_le_bytes(bytes[80..84].try_into().expect("four bytes")) as usize;
        assert_eq!(bytes.len(), 84 + 50 * count);
        let mut edges = std::collections::BTreeMap::new();
        for triangle in bytes[84..].chunks(50) {
            let value = |k: usize| f32::from_le_bytes(triangle[4 * k..4 * k + 4].try_into().expect("four bytes"));
            let [normal, a, b, c] = [0, 3, 6, 9].map(|k| [value(k), value(k + 1), value(k + 2)]);
            let dot = |u: [f32; 3], v: [f32; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
            let minus = |u: [f32; 3], v: [f32; 3]| [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
            let (u, v) = (minus(b, a), minus(c, a));
            let turn = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            assert!((dot(normal, normal) - 1.0).abs() < 1e-5 && dot(normal, turn) > 0.0 && dot(normal, a) > 0.0);
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry([from, to].map(|p| p.map(f32::to_bits))).or_insert(0) += 1;
            }
        }
        assert!(edges.iter().all(|(&[from, to], &count)| count == 1 && edges.get(&[to, from]) == Some(&1)));
    }
}
