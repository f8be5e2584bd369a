//! Walks beside the twin, worked examples, refusals, and what a step costs.

use std::cell::Cell;

use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::NormalSense::{Against, Along};
use super::brute_force::BruteForceWalk;
use super::*;
use crate::numeric::scaling::scale_by_power_of_two;

thread_local! {
    static TURNS: Cell<u64> = const { Cell::new(0) };
}

/// Counts an orientation test of a dual line.
pub(super) fn count_turn() {
    TURNS.set(TURNS.get() + 1);
}

const CUBE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn name((first, second, normal): (usize, usize, NormalSense)) -> FacetName {
    FacetName::new(first, second, normal)
}

/// A walk of each method over the same body, or the one refusal of them all.
fn walks(generators: &[[f64; 3]]) -> Result<(BruteForceWalk, HullWalk, ScanWalk), WalkError> {
    let (truth, hull, scan) = (BruteForceWalk::new(generators), HullWalk::new(generators), ScanWalk::new(generators));
    assert_eq!(truth.as_ref().err(), hull.as_ref().err());
    assert_eq!(truth.as_ref().err(), scan.as_ref().err());
    Ok((truth?, hull?, scan?))
}

/// Small integers, scaled by powers of two of any size for some: everything is special.
fn special() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let exponent = prop_oneof![2 => Just(0i64), 1 => -1070i64..1020];
    let generator = ([-1i32..2, -1i32..2, -2i32..3], exponent);
    let scaled = |(v, exponent): ([i32; 3], i64)| v.map(|c| scale_by_power_of_two(f64::from(c), exponent));
    prop::collection::vec(generator.prop_map(scaled), 3..8)
}

properties! {
    #![proptest_config(crate::property_cases::config(150))]

    #[test]
    fn walks_are_those_of_the_twin(
        generators in special(),
        edges in prop::collection::vec(any::<prop::sample::Index>(), 30),
        rays in prop::collection::vec([-2i32..3, -2i32..3, -2i32..3], 4),
    ) {
        let Ok((mut truth, mut hull, mut scan)) = walks(&generators) else { return Ok(()) };
        prop_assert_eq!(truth.facet(), hull.facet());
        for facet in truth.facets() {
            for walk in [&mut truth as &mut dyn FacetWalk, &mut hull, &mut scan] {
                walk.place_at(facet).expect("the twin has it");
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
        for ray in rays.into_iter().filter(|ray| *ray != [0; 3]) {
            let ray = ray.map(f64::from);
            let steps = hull.walk_to(ray).expect("a direction");
            prop_assert_eq!(scan.walk_to(ray).expect("a direction"), steps);
            prop_assert_eq!(scan.facet(), hull.facet());
            prop_assert!(truth.exits(ray).contains(&hull.facet()));
            let mut fresh = HullWalk::new(&generators).expect("as before");
            fresh.place_at(hull.facet()).expect("the walk is there");
            prop_assert_eq!(fresh.center(), hull.center());
            prop_assert_eq!(fresh.signs(), hull.signs());
        }
    }
}

#[test]
fn a_prism_over_a_hexagon_has_facets_of_six_edges() {
    let generators =
        [[1.0, 0.0, 0.0], [0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 2.0], [0.0, 1.0, 0.0], [-2.0, 0.0, 0.0]];
    let mut walk = HullWalk::new(&generators).expect("they span space");
    walk.place_at(name((2, 4, Along))).expect("it is a facet by another name");
    assert_eq!(walk.facet(), name((0, 2, Along)));
    let edges = [(0, false), (2, false), (4, false), (0, true), (2, true), (4, true)];
    assert_eq!(walk.edges(), edges.map(|(generator, is_reversed)| FacetEdge { generator, is_reversed }));
    let sides = [(0, 3, Along), (2, 3, Along), (3, 4, Against), (0, 3, Against), (2, 3, Against), (3, 4, Along)];
    assert_eq!(walk.neighbours(), sides.map(name));
    assert_eq!(walk.along().collect::<Vec<_>>(), [0, 5, 2, 4]);
    assert_eq!(walk.center().map(|c| c.to_f64()), [0.0, 0.0, 2.0]);
    // half edges 3, 0, 0 and 1, 1, 0 and 0, 1, 0: the first edge begins at minus their sum
    assert_eq!(walk.vertex(0).expect("it has six").map(|c| c.to_f64()), [-4.0, -2.0, 2.0]);
    assert_eq!(walk.vertex(4).expect("it has six").map(|c| c.to_f64()), [-2.0, 2.0, 2.0]);
    assert_eq!(walk.vertex(6), Err(WalkError::UnknownEdge { edge: 6, count: 6 }));
    assert_eq!(walk.step(7), Err(WalkError::UnknownEdge { edge: 7, count: 6 }));
}

#[test]
fn around_the_cube_and_back() {
    for method in Method::ALL {
        let mut walk = method.walk(&CUBE).expect("it has interior");
        for expected in [(0, 2, Along), (0, 1, Against), (0, 2, Against), (0, 1, Along)] {
            walk.step(0).expect("edge 0 is along the x axis");
            // across an edge along x the next facet has it as edge 2, so edge 0 is the one on the other side
            assert_eq!(walk.facet(), name(expected), "{method:?}");
        }
        assert_eq!(Method::from_id(method.id()), Some(method));
    }
}

#[test]
fn flat_bodies_and_wrong_names_are_refused() {
    let flat = |generators: &[[f64; 3]]| walks(generators).err();
    assert_eq!(flat(&[]), Some(WalkError::Flat { rank: 0 }));
    assert_eq!(flat(&[[0.0; 3], [1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]]), Some(WalkError::Flat { rank: 1 }));
    assert_eq!(flat(&[[1.0, 1.0, 0.0], CUBE[0], CUBE[1]]), Some(WalkError::Flat { rank: 2 }));
    assert!(matches!(HullWalk::new(&[[f64::NAN; 3]]), Err(WalkError::NonFinite(_))));
    let generators = [CUBE[0], CUBE[1], CUBE[2], [0.0; 3], [0.0, 0.0, -1.0]];
    for method in Method::ALL {
        let mut walk = method.walk(&generators).expect("it has interior");
        let mut place_at = |first, second| walk.place_at(name((first, second, Along))).err();
        assert_eq!(place_at(0, 5), Some(WalkError::UnknownGenerator { generator: 5, count: 5 }));
        assert_eq!(place_at(1, 0), Some(WalkError::NotAscending { first: 1, second: 0 }));
        assert_eq!(place_at(2, 4), Some(WalkError::NoPlane { first: 2, second: 4 }));
        assert_eq!(place_at(2, 3), Some(WalkError::NoPlane { first: 2, second: 3 }));
        assert_eq!(place_at(0, 4), None);
        assert_eq!(walk.facet(), name((0, 2, Against)));
        assert_eq!(walk.walk_to([0.0; 3]), Err(WalkError::NoDirection));
        assert!(matches!(walk.walk_to([0.0, f64::INFINITY, 0.0]), Err(WalkError::NonFinite(_))));
    }
}

#[test]
fn neighbours_in_general_position_or_why_not() {
    let add = |other: [f64; 3]| [CUBE[0], CUBE[1], CUBE[2], other];
    let at = |generators: &[[f64; 3]]| adjacent_facets(generators, name((0, 1, Along)));
    // the normals (0, −2, 1) and (−4, 0, 1) are orthogonal to the fourth generator, before they are to the third
    let sides = [(0, 3, Along), (1, 2, Along), (0, 2, Against), (1, 3, Against)];
    assert_eq!(at(&add([0.25, 0.5, 1.0])), Ok(sides.map(name)));
    assert_eq!(at(&add([0.0; 3])), Err(GeneralPositionError::Zero { generator: 3 }));
    assert_eq!(at(&add([0.0, 3.0, 0.0])), Err(GeneralPositionError::Parallel { generators: [1, 3] }));
    assert_eq!(at(&add([1.0, 3.0, 0.0])), Err(GeneralPositionError::Coplanar { generators: [0, 1, 3] }));
    assert_eq!(at(&add([1.0, 0.0, 1.0])), Err(GeneralPositionError::Coplanar { generators: [0, 2, 3] }));
    assert_eq!(at(&CUBE[..2]), Err(GeneralPositionError::Walk(WalkError::Flat { rank: 2 })));
    assert_eq!(sides.map(name).map(FacetName::opposite)[0], name((0, 3, Against)));
    assert_eq!([1, -1, 0].map(NormalSense::from_sign), [Some(Along), Some(Against), None]);
}

fn random_generators(count: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
    (0..count).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect()
}

#[test]
fn turns_of_a_step_grow_like_the_square_of_the_logarithm() {
    for height in [6, 8, 10, 12, 14] {
        let mut random = Pcg64Mcg::seed_from_u64(height);
        let generators = random_generators(1 << height, &mut random);
        let mut walk = HullWalk::new(&generators).expect("they span space");
        let (mut most, mut total, steps) = (0, 0, 2000);
        for _ in 0..steps {
            TURNS.set(0);
            walk.step(random.random_range(0..4)).expect("facets are parallelograms");
            most = most.max(TURNS.get());
            total += TURNS.get();
        }
        let mean = total as f64 / f64::from(steps);
        println!("n = 2^{height}: {mean:.1} turns a step, at most {most}");
        assert!(mean <= 2.0 * (height * height) as f64, "n = 2^{height}: {mean}");
        // two updates of two chains each, and the tangents
        assert!(most <= 12 * (height + 1).pow(2), "n = 2^{height}: {most}");
        assert!(walk.bytes() <= 256 << height, "n = 2^{height}: {} bytes", walk.bytes());
    }
}
