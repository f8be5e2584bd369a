//! Walks over facets beside the twin on all families of bodies, beside the face lattice on larger ones, and long walks
//! beside fresh starts.

use std::collections::BTreeMap;

use families::bodies::BODY_FAMILIES;
use families::drawn::bodies as drawn;
use proptest::collection::vec;
use proptest::prelude::*;
use tests::runner;
use zonotope::arrangement::facet_walk::brute_force::BruteForceWalk;
use zonotope::arrangement::facet_walk::{
    FacetEdge, FacetName, FacetWalk, HullWalk, NormalSense, ScanWalk, WalkError, adjacent_facets,
};
use zonotope::numeric::dyadic::Dyadic;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, Facet, faces};

/// Bodies of a long run for each family of strategies.
const CASES: u32 = 240;

/// The largest number of generators whose facets the twin lists.
const GENERATOR_LIMIT: usize = 7;

type Generators = Vec<[f64; 3]>;

/// The same facet, the same edges and the same neighbours as the twin, at every facet; the same steps; rays that leave
/// through one of the twin's facets.
fn agrees((generators, edges, rays): (Generators, Vec<prop::sample::Index>, Generators)) -> Result<(), TestCaseError> {
    let walks = (BruteForceWalk::new(&generators), HullWalk::new(&generators), ScanWalk::new(&generators));
    let (mut truth, mut hull, mut scan) = match walks {
        (Ok(truth), Ok(hull), Ok(scan)) => (truth, hull, scan),
        (truth, hull, scan) => {
            let is_flat = matches!(truth, Err(WalkError::Flat { .. }));
            prop_assert!(is_flat);
            prop_assert_eq!((hull.err(), scan.err()), (truth.as_ref().err().copied(), truth.as_ref().err().copied()));
            return Ok(());
        }
    };
    prop_assert_eq!((hull.facet(), scan.facet()), (truth.facet(), truth.facet()));
    for facet in truth.facets() {
        for walk in [&mut truth as &mut dyn FacetWalk, &mut hull, &mut scan] {
            walk.place_at(facet).expect("the twin lists it");
        }
        prop_assert_eq!((hull.facet(), scan.facet()), (facet, facet));
        prop_assert_eq!((hull.edges(), scan.edges()), (truth.edges(), truth.edges()));
        let neighbours = truth.neighbours();
        prop_assert_eq!(&hull.neighbours(), &neighbours);
        prop_assert_eq!(&scan.neighbours(), &neighbours);
    }
    for edge in edges {
        let edge = edge.index(hull.edges().len());
        for walk in [&mut truth as &mut dyn FacetWalk, &mut hull, &mut scan] {
            walk.step(edge).expect("there is this edge");
        }
        prop_assert_eq!((hull.facet(), scan.facet()), (truth.facet(), truth.facet()));
    }
    // besides the given rays one through a facet's centre, one through a vertex, and one along a generator
    let rounded = |v: [Dyadic; 3]| v.map(|c| c.to_f64());
    let vertex = hull.vertex(0).expect("every facet has edges");
    let special = [rounded(hull.center()).map(|c| -c), rounded(vertex).map(|c| -c), generators[0]];
    let is_direction = |ray: &[f64; 3]| *ray != [0.0; 3] && ray.iter().all(|c| c.is_finite());
    for ray in rays.into_iter().chain(special).filter(is_direction) {
        let steps = hull.walk_to(ray).expect("a direction");
        prop_assert_eq!(scan.walk_to(ray).expect("a direction"), steps);
        prop_assert_eq!(scan.facet(), hull.facet());
        prop_assert!(truth.exits(ray).contains(&hull.facet()), "{:?} does not leave through {:?}", ray, hull.facet());
    }
    Ok(())
}

fn with_choices(
    generators: impl Strategy<Value = Generators>,
) -> impl Strategy<Value = (Generators, Vec<prop::sample::Index>, Generators)> {
    let coordinate = || prop_oneof![(-2..3i32).prop_map(f64::from), -1.0..1.0f64];
    (generators, vec(any::<prop::sample::Index>(), 20), vec([coordinate(), coordinate(), coordinate()], 3))
}

#[test]
fn walks_are_those_of_the_twin() {
    for (name, generators) in drawn::families::<3>(GENERATOR_LIMIT) {
        println!("{name}");
        runner::for_all(&with_choices(generators), CASES, agrees);
    }
    for family in BODY_FAMILIES {
        println!("{}", family.id);
        let seeds = if family.is_random { 1u64 << 40 } else { 1 };
        let bodies = (1..=GENERATOR_LIMIT, 0..seeds).prop_map(move |(count, seed)| family.generate(count, seed));
        runner::for_all(&with_choices(bodies), CASES, agrees);
    }
}

/// The sign of v_i × v_j along a facet's normal.
fn sense(lattice: &FaceLattice, facet: Facet, [i, j]: [usize; 2]) -> NormalSense {
    let [a, b] = [i, j].map(|generator| lattice.body().generators()[generator].map(Dyadic::from_f64));
    let normal = lattice.exact_normal(facet);
    let minor = |k: usize, l: usize| &a[k] * &b[l] - &a[l] * &b[k];
    let product = &minor(1, 2) * &normal[0] + &minor(2, 0) * &normal[1] + &minor(0, 1) * &normal[2];
    if product.sign().is_gt() { NormalSense::Along } else { NormalSense::Against }
}

fn name(lattice: &FaceLattice, facet: Facet) -> FacetName {
    let least = |zone| lattice.zone_generators(zone).map(|member| member.generator).min();
    let mut along: Vec<usize> = lattice.facet_zones(facet).filter_map(least).collect();
    along.sort_unstable();
    let [i, j] = [along[0], along[1]];
    FacetName::new(i, j, sense(lattice, facet, [i, j]))
}

#[test]
fn neighbours_are_those_of_the_face_lattice() {
    let mut facets = 0;
    for family in BODY_FAMILIES {
        for count in [9, 24, 64] {
            let generators = family.generate(count, 2);
            let body = Zonotope::new([0.0; 3], generators.clone()).expect("families are finite");
            let lattice = match faces(&body, &mut ()).expect("few directions") {
                Faces::Solid(lattice) => lattice,
                _ => {
                    assert!(matches!(HullWalk::new(&generators), Err(WalkError::Flat { .. })), "{}", family.id);
                    continue;
                }
            };
            let mut walk = HullWalk::new(&generators).expect("the body is solid");
            let all = (0..lattice.facet_count() as u32).map(Facet);
            let names: BTreeMap<Facet, FacetName> = all.map(|facet| (facet, name(&lattice, facet))).collect();
            for (&facet, &name) in &names {
                walk.place_at(name).expect("the lattice has it");
                assert_eq!(walk.facet(), name, "{}", family.id);
                let across = |edge| lattice.edge_facets(edge).into_iter().find(|&other| other != facet);
                let mut expected: Vec<FacetName> =
                    lattice.facet_edges(facet).filter_map(across).map(|facet| names[&facet]).collect();
                let mut found = walk.neighbours();
                // both are counter-clockwise
                let start = expected.iter().position(|name| *name == found[0]).expect("a neighbour of the lattice");
                expected.rotate_left(start);
                assert_eq!(found, expected, "{} {name:?}", family.id);
                assert_eq!(walk.signs(), lattice.facet_signs(facet));
                found.sort_unstable();
                found.dedup();
                assert_eq!(found.len(), expected.len(), "two facets of a body have one edge in common at most");
                facets += 1;
            }
        }
    }
    assert!(facets > 20_000, "{facets} facets are few");
}

#[test]
fn long_walks_come_back() {
    for family in BODY_FAMILIES {
        let generators = family.generate(1000, 4);
        let Ok(mut walk) = HullWalk::new(&generators) else { continue };
        let mut scan = ScanWalk::new(&generators).expect("a walk by hulls is there");
        let mut state = 11u64;
        let steps = if family.id == "random_bodies" { runner::cases(100_000) } else { runner::cases(8_000) };
        let (start, center) = (walk.facet(), walk.center());
        let mut crossed: Vec<FacetEdge> = Vec::new();
        for step in 0..steps {
            let edges = walk.edges();
            // a linear congruential generator by Knuth, of which the higher bits are used
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let edge = (state >> 33) as usize % edges.len();
            walk.step(edge).expect("there is this edge");
            crossed.push(edges[edge]);
            if step % 500 == 0 {
                scan.place_at(walk.facet()).expect("the walk is there");
                assert_eq!(scan.neighbours(), walk.neighbours(), "{} after {step} steps", family.id);
                let mut fresh = HullWalk::new(&generators).expect("as before");
                fresh.place_at(walk.facet()).expect("the walk is there");
                assert_eq!(fresh.center(), walk.center(), "{} after {step} steps", family.id);
            }
        }
        for edge in crossed.into_iter().rev() {
            // the boundary of the facet beyond runs the other way along the edge
            let back = FacetEdge { is_reversed: !edge.is_reversed, ..edge };
            let back = walk.edges().iter().position(|other| *other == back).expect("both facets have the edge");
            walk.step(back).expect("there is this edge");
        }
        assert_eq!((walk.facet(), walk.center()), (start, center), "{}", family.id);
    }
}

#[test]
fn neighbours_in_general_position_are_those_of_the_walk() {
    for count in [3, 5, 40, 300] {
        let generators = BODY_FAMILIES[0].generate(count, 8);
        let mut walk = HullWalk::new(&generators).expect("random generators span space");
        for step in 0..40 {
            let neighbours = walk.neighbours();
            assert_eq!(adjacent_facets(&generators, walk.facet()).map(Vec::from), Ok(neighbours));
            walk.step(step % 3).expect("facets are parallelograms");
        }
    }
}
