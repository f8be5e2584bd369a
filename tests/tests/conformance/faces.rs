//! The face lattice, the counts and the vertices and facets by recursion against the twin, on all families of bodies,
//! and against the books.

use std::collections::BTreeSet;

use families::bodies::{BODY_FAMILIES, SPACE_TIME_FAMILIES, named};
use tests::runner;
use zonotope::zonotope::faces::SignVector;
use zonotope::zonotope::faces::brute_force::faces_by_dimension;
use zonotope::zonotope::faces::by_recursion::vertices_and_facets;
use zonotope::zonotope::faces::{Edge, FaceLattice, Faces, Facet, Vertex, faces};
use zonotope::zonotope::{Zonotope, combinatorics};

/// The number of seeds of a long run for each random family and each number of generators up to [`GENERATOR_LIMIT`].
const SEEDS: u32 = 265;

/// The largest number of generators whose faces the twin lists.
const GENERATOR_LIMIT: usize = 7;

fn set(faces: impl Iterator<Item = SignVector>) -> BTreeSet<SignVector> {
    let faces: Vec<SignVector> = faces.collect();
    let distinct: BTreeSet<SignVector> = faces.iter().cloned().collect();
    assert_eq!(distinct.len(), faces.len(), "a face is listed twice");
    distinct
}

fn check_lattice(lattice: &FaceLattice, truth: &[BTreeSet<SignVector>]) {
    assert_eq!(set((0..lattice.vertex_count() as u32).map(|v| lattice.vertex_signs(Vertex(v)))), truth[0]);
    assert_eq!(set((0..lattice.edge_count() as u32).map(|e| lattice.edge_signs(Edge(e)))), truth[1]);
    if lattice.is_flat() {
        assert_eq!((truth.len(), lattice.facet_count()), (3, 2));
    } else {
        assert_eq!(set((0..lattice.facet_count() as u32).map(|f| lattice.facet_signs(Facet(f)))), truth[2]);
    }
    for facet in (0..lattice.facet_count() as u32).map(Facet) {
        let corners = set(lattice.facet_vertices(facet).map(|v| lattice.vertex_signs(v)));
        let signs = lattice.facet_signs(facet);
        let on_facet = |v: &&SignVector| signs.iter().zip(*v).all(|(f, v)| f.is_eq() || f == v);
        assert!(truth[0].iter().filter(on_facet).eq(&corners));
    }
}

fn check_counts<const D: usize>(generators: &[[f64; D]], truth: &[BTreeSet<SignVector>]) {
    let body = Zonotope::new([0.0; D], generators.to_vec()).expect("families are finite");
    let counts = combinatorics(&body);
    let rank = truth.len() - 1;
    assert_eq!(counts.affine_dimension, rank);
    assert_eq!(counts.vertices, truth[0].len() as u64);
    let found = vertices_and_facets(&body);
    assert!(found.vertices.iter().eq(&truth[0]));
    if rank > 0 {
        assert_eq!([counts.edges, counts.facets], [truth[1].len() as u64, truth[rank - 1].len() as u64]);
        assert!(found.facets.iter().eq(&truth[rank - 1]));
    }
}

#[test]
fn faces_in_space_are_those_of_the_twin() {
    let seeds = u64::from(runner::cases(SEEDS));
    let mut cases = 0;
    for family in BODY_FAMILIES {
        for count in 1..=GENERATOR_LIMIT {
            for seed in 0..if family.is_random { seeds } else { 1 } {
                let generators = family.generate(count, seed);
                let truth = faces_by_dimension(&generators);
                let body = Zonotope::new([0.0; 3], generators.clone()).expect("families are finite");
                match faces(&body, &mut ()).expect("few directions") {
                    Faces::Flat(lattice) | Faces::Solid(lattice) => check_lattice(&lattice, &truth),
                    Faces::Segment(_) => assert_eq!(truth.len(), 2),
                    Faces::Point(_) => assert_eq!(truth.len(), 1),
                }
                if seed % 4 == 0 {
                    check_counts(&generators, &truth);
                }
                cases += 1;
            }
        }
    }
    assert!(cases > 60 * seeds, "{cases} cases of {seeds} seeds are few");
}

#[test]
fn faces_in_space_time_are_those_of_the_twin() {
    for family in SPACE_TIME_FAMILIES {
        for count in 1..=GENERATOR_LIMIT {
            for seed in 0..8 {
                let generators = family.generate(count, seed);
                check_counts(&generators, &faces_by_dimension(&generators));
            }
        }
    }
}

#[test]
fn many_generators_keep_the_laws_of_polytopes() {
    for family in BODY_FAMILIES {
        let body = Zonotope::new([0.0; 3], family.generate(150, 1)).expect("families are finite");
        let (Faces::Flat(lattice) | Faces::Solid(lattice)) = faces(&body, &mut ()).expect("few directions") else {
            unreachable!("150 generators of a family have more than one direction")
        };
        assert_eq!(lattice.vertex_count() + lattice.facet_count(), lattice.edge_count() + 2, "{}", family.id);
        let mut sides = vec![0; lattice.edge_count()];
        for facet in (0..lattice.facet_count() as u32).map(Facet) {
            lattice.facet_edges(facet).for_each(|edge| sides[edge.0 as usize] += 1);
        }
        assert!(sides.iter().all(|&count| count == 2), "{}", family.id);
        let counts = combinatorics(&body);
        assert_eq!(counts.vertices as usize, lattice.vertex_count(), "{}", family.id);
        assert_eq!(counts.edges as usize, lattice.edge_count(), "{}", family.id);
    }
}

fn zonohedron(generators: Vec<[f64; 3]>) -> Zonotope<3> {
    Zonotope::new([0.0; 3], generators).expect("finite")
}

fn check_named(generators: Vec<[f64; 3]>, counts: [usize; 3], facet_sizes: &[(usize, u64)]) {
    let body = zonohedron(generators);
    let Ok(Faces::Solid(lattice)) = faces(&body, &mut ()) else { unreachable!("named bodies are solid") };
    assert_eq!([lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()], counts);
    let counted = combinatorics(&body);
    assert_eq!([counted.vertices, counted.edges, counted.facets], counts.map(|count| count as u64));
    assert_eq!(counted.facet_sizes.into_iter().collect::<Vec<_>>(), facet_sizes);
}

#[test]
fn counts_are_those_of_the_books() {
    check_named(named::cube(), [8, 12, 6], &[(4, 6)]);
    check_named(named::hexagonal_prism(), [12, 18, 8], &[(4, 6), (6, 2)]);
    check_named(named::rhombic_dodecahedron(), [14, 24, 12], &[(4, 12)]);
    check_named(named::elongated_dodecahedron(), [18, 28, 12], &[(4, 8), (6, 4)]);
    check_named(named::truncated_octahedron(), [24, 36, 14], &[(4, 6), (6, 8)]);
    check_named(named::truncated_cuboctahedron(), [48, 72, 26], &[(4, 12), (6, 8), (8, 6)]);
    check_named(named::rhombic_triacontahedron(), [32, 60, 30], &[(4, 30)]);
    check_named(named::rhombic_enneacontahedron(), [92, 180, 90], &[(4, 90)]);
    for n in 3..20 {
        let f = n * (n - 1);
        check_named(named::polar_zonohedron(n as u32, 0.7), [f + 2, 2 * f, f], &[(4, f as u64)]);
    }
}

#[test]
fn volumes_are_those_of_the_books() {
    let volume = |generators| zonohedron(generators).exact_volume().to_f64();
    assert_eq!(volume(named::cube()), 8.0);
    // edges of length a = 2 √3: 16 √3 a³ / 9
    assert_eq!(volume(named::rhombic_dodecahedron()), 128.0);
    // edges of length a = 2 √2: 8 √2 a³
    assert_eq!(volume(named::truncated_octahedron()), 256.0);
}
