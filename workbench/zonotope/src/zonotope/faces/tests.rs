//! The face lattice against its twin and against the laws of polytopes.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use proptest::prelude::*;

use super::SignVector;
use super::brute_force::faces_by_dimension;
use super::{Edge, FaceLattice, Faces, Facet, Vertex, Zone, faces};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::{Operation, OperationCounts};
use crate::zonotope::Zonotope;

fn lattice_of(center: [f64; 3], generators: &[[f64; 3]]) -> Option<FaceLattice> {
    let body = Zonotope::new(center, generators.to_vec()).expect("finite");
    match faces(&body, &mut ()).expect("few directions") {
        Faces::Flat(lattice) | Faces::Solid(lattice) => Some(lattice),
        Faces::Point(_) | Faces::Segment(_) => None,
    }
}

fn vertices(lattice: &FaceLattice) -> impl Iterator<Item = Vertex> {
    (0..lattice.vertex_count() as u32).map(Vertex)
}

fn edges(lattice: &FaceLattice) -> impl Iterator<Item = Edge> {
    (0..lattice.edge_count() as u32).map(Edge)
}

fn facets(lattice: &FaceLattice) -> impl Iterator<Item = Facet> {
    (0..lattice.facet_count() as u32).map(Facet)
}

/// The laws that tie faces together, on any lattice.
fn check_incidences(lattice: &FaceLattice) {
    let [v, e, f] = [lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()];
    assert_eq!(v + f, e + 2, "Euler's relation");
    let mut seen_left = vec![0; e];
    let mut seen_right = vec![0; e];
    for facet in facets(lattice) {
        let around: Vec<Vertex> = lattice.facet_vertices(facet).collect();
        let sides: Vec<Edge> = lattice.facet_edges(facet).collect();
        assert_eq!((around.len(), sides.len()), (2 * lattice.facet_zones(facet).len(), around.len()));
        for (k, &edge) in sides.iter().enumerate() {
            let ends = [around[k], around[(k + 1) % around.len()]];
            let [left, right] = lattice.edge_facets(edge);
            if ends == lattice.edge_ends(edge) && left == facet {
                seen_left[edge.0 as usize] += 1;
            } else {
                assert_eq!([ends[1], ends[0]], lattice.edge_ends(edge), "{facet:?} {edge:?}");
                assert_eq!(right, facet);
                seen_right[edge.0 as usize] += 1;
            }
            assert_eq!(lattice.edge_zone(edge), lattice.edge_zone(sides[(k + sides.len() / 2) % sides.len()]));
        }
        let opposite = lattice.opposite_facet(facet);
        assert_eq!(lattice.opposite_facet(opposite), facet);
        let reflected: BTreeSet<Vertex> = around.iter().map(|&v| lattice.opposite_vertex(v)).collect();
        assert_eq!(reflected, lattice.facet_vertices(opposite).collect());
    }
    assert!(seen_left.iter().chain(&seen_right).all(|&count| count == 1));
    for zone in (0..lattice.zone_count() as u32).map(Zone) {
        for edge in lattice.zone_edges(zone).map(Edge) {
            assert_eq!(lattice.edge_zone(edge), zone);
            assert!(lattice.facet_zones(lattice.edge_facets(edge)[0]).any(|z| z == zone));
        }
    }
}

fn check_against_twin(center: [f64; 3], generators: &[[f64; 3]]) {
    let truth = faces_by_dimension(generators);
    let Some(lattice) = lattice_of(center, generators) else {
        assert!(truth.len() <= 2, "the lattice left out {truth:?}");
        return;
    };
    check_incidences(&lattice);
    let collect = |signs: &mut dyn Iterator<Item = SignVector>| {
        let signs: Vec<SignVector> = signs.collect();
        let count = signs.len();
        let set: BTreeSet<SignVector> = signs.into_iter().collect();
        assert_eq!(set.len(), count, "a face is listed twice");
        set
    };
    assert_eq!(collect(&mut vertices(&lattice).map(|v| lattice.vertex_signs(v))), truth[0]);
    assert_eq!(collect(&mut edges(&lattice).map(|e| lattice.edge_signs(e))), truth[1]);
    assert_eq!(lattice.is_flat(), truth.len() == 3);
    if lattice.is_flat() {
        assert!(facets(&lattice).all(|f| lattice.facet_signs(f).iter().all(|s| s.is_eq())));
    } else {
        assert_eq!(collect(&mut facets(&lattice).map(|f| lattice.facet_signs(f))), truth[2]);
    }
    let smaller = |face: &SignVector, of: &SignVector| of.iter().zip(face).all(|(a, b)| a.is_eq() || a == b);
    for facet in facets(&lattice) {
        let signs = lattice.facet_signs(facet);
        assert!(lattice.facet_vertices(facet).all(|v| smaller(&lattice.vertex_signs(v), &signs)));
        check_orientation(&lattice, facet);
    }
    for edge in edges(&lattice) {
        let signs = lattice.edge_signs(edge);
        assert!(lattice.edge_ends(edge).iter().all(|&v| smaller(&lattice.vertex_signs(v), &signs)));
        let [tail, head] = lattice.edge_ends(edge).map(|v| lattice.vertex_signs(v));
        for member in lattice.zone_generators(lattice.edge_zone(edge)) {
            let ends = [tail[member.generator], head[member.generator]];
            let expected = [Ordering::Less, Ordering::Greater];
            assert_eq!(ends, if member.reversed { [expected[1], expected[0]] } else { expected });
        }
    }
    let error = lattice.coordinate_error();
    for vertex in vertices(&lattice) {
        for (axis, exact) in lattice.exact_point(vertex).iter().enumerate() {
            let point = lattice.point(vertex)[axis];
            let off = || (exact - &Dyadic::from_f64(point)).abs();
            assert!(error[axis] == f64::INFINITY || off() <= Dyadic::from_f64(error[axis]), "{point} {exact:?}");
        }
    }
}

/// Vertices go counter-clockwise around the outward normal, and no vertex is beyond the facet.
fn check_orientation(lattice: &FaceLattice, facet: Facet) {
    let normal = lattice.exact_normal(facet);
    let dot = |a: &[Dyadic; 3], b: &[Dyadic; 3]| &(&a[0] * &b[0]) + &(&(&a[1] * &b[1]) + &(&a[2] * &b[2]));
    let minus = |a: &[Dyadic; 3], b: &[Dyadic; 3]| [0, 1, 2].map(|k| &a[k] - &b[k]);
    let around: Vec<[Dyadic; 3]> = lattice.facet_vertices(facet).map(|v| lattice.exact_point(v)).collect();
    for (k, point) in around.iter().enumerate() {
        let [next, after] = [1, 2].map(|step| &around[(k + step) % around.len()]);
        let [a, b] = [minus(next, point), minus(after, next)];
        let minor = |k: usize, l: usize| &a[k] * &b[l] - &a[l] * &b[k];
        let turn = [minor(1, 2), minor(2, 0), minor(0, 1)];
        assert!(dot(&turn, &normal).sign().is_gt());
    }
    let height = dot(&around[0], &normal);
    assert!(vertices(lattice).all(|v| dot(&lattice.exact_point(v), &normal) <= height));
}

#[test]
fn named_counts_by_hand() {
    let counts = |generators: &[[f64; 3]]| {
        let lattice = lattice_of([0.0; 3], generators).expect("two directions");
        check_incidences(&lattice);
        [lattice.vertex_count(), lattice.edge_count(), lattice.facet_count()]
    };
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(counts(&axes), [8, 12, 6]);
    assert_eq!(counts(&axes[..2]), [4, 4, 2]);
    let diagonals = [[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];
    assert_eq!(counts(&diagonals), [14, 24, 12]);
    let roots =
        [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]];
    assert_eq!(counts(&roots), [24, 36, 14]);
    let all = [&axes[..], &roots].concat();
    assert_eq!(counts(&all), [48, 72, 26]);
}

#[test]
fn counts_tell_what_the_sweep_did() {
    let generators: Vec<[f64; 3]> = (1..40).map(f64::from).map(|k| [k, 0.1 * k * k, 9.7 - k * k * k]).collect();
    let body = Zonotope::new([0.0; 3], generators).expect("finite");
    let mut counts = OperationCounts::default();
    let found = faces(&body, &mut counts).expect("few directions");
    let Faces::Solid(lattice) = found else { unreachable!("the moment curve is not flat") };
    assert_eq!(2 * counts.get(Operation::SearchStep), lattice.facet_count() as u64);
    assert!(counts.get(Operation::Comparison) >= 39 * 37);
    assert!(100 * counts.get(Operation::ExactFallback) < counts.get(Operation::Comparison));
}

#[test]
fn parallelograms_take_92_bytes() {
    let generators: Vec<[f64; 3]> = (1..60).map(f64::from).map(|k| [k, k * k, k * k * k]).collect();
    let lattice = lattice_of([0.0; 3], &generators).expect("many directions");
    check_incidences(&lattice);
    assert_eq!(lattice.facet_count(), 59 * 58);
    assert!(lattice.size_in_bytes() < 93 * lattice.facet_count());
}

fn coordinate() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        3 => (-2i32..3).prop_map(f64::from),
        2 => -1.0..1.0f64,
        1 => (-3i32..4).prop_map(|k| f64::from(k) * 0.1),
        1 => Just(0.0),
    ]
}

/// Generators of one of several kinds, most of them degenerate.
fn generators() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let vector = || [coordinate(), coordinate(), coordinate()];
    let free = proptest::collection::vec(vector(), 0..7);
    let lattice = proptest::collection::vec([-1i8..2, -1i8..2, -1i8..2].prop_map(|v| v.map(f64::from)), 0..8);
    let flat = (vector(), vector(), proptest::collection::vec((-2i32..3, -2i32..3), 0..7)).prop_map(|(a, b, mix)| {
        mix.into_iter().map(|(s, t)| std::array::from_fn(|k| f64::from(s) * a[k] + f64::from(t) * b[k])).collect()
    });
    let line = (vector(), proptest::collection::vec(-2i32..3, 0..5))
        .prop_map(|(v, factors)| factors.into_iter().map(|f| v.map(|c| c * f64::from(f))).collect::<Vec<_>>());
    let ulps = (vector(), vector(), proptest::collection::vec((-1i32..2, -1i32..2, 0usize..6), 0..6)).prop_map(
        |(a, b, mix)| {
            let near = |(s, t, up): (i32, i32, usize)| {
                let mut v: [f64; 3] = std::array::from_fn(|k| f64::from(s) * a[k] + f64::from(t) * b[k]);
                if up < 3 {
                    v[up] = v[up].next_up();
                }
                v
            };
            mix.into_iter().map(near).collect()
        },
    );
    let scaled = (proptest::collection::vec(vector(), 0..7), proptest::collection::vec(-1000i64..1000, 7)).prop_map(
        |(generators, exponents)| {
            generators.iter().zip(exponents).map(|(g, e)| g.map(|c| scale_by_power_of_two(c, e))).collect()
        },
    );
    let rough = proptest::collection::vec(
        [0, 1, 2].map(|_| any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |v| v.is_finite())),
        0..6,
    );
    let doubled = lattice.clone().prop_map(|generators| {
        let halves = generators.iter().map(|g| g.map(|c| -0.5 * c));
        generators.iter().copied().chain(halves.take(3)).collect()
    });
    prop_oneof![2 => free, 3 => lattice, 2 => flat, 1 => line, 2 => ulps, 2 => scaled, 1 => rough, 2 => doubled]
}

properties! {
    #![proptest_config(crate::property_cases::config(1500))]

    #[test]
    fn faces_are_those_of_the_twin(
        generators in generators(),
        center in prop_oneof![Just([0.0; 3]), Just([1e16, -1.0, 3e-300]), [coordinate(), coordinate(), coordinate()]],
    ) {
        check_against_twin(center, &generators);
    }

    #[test]
    fn larger_bodies_keep_the_laws(
        generators in proptest::collection::vec([-4i32..5, -4i32..5, -4i32..5].prop_map(|v| v.map(f64::from)), 8..40),
    ) {
        if let Some(lattice) = lattice_of([0.0; 3], &generators) {
            check_incidences(&lattice);
        }
    }
}

fn check_recursion<const D: usize>(generators: &[[f64; D]]) {
    let truth = faces_by_dimension(generators);
    let body = Zonotope::new([0.0; D], generators.to_vec()).expect("finite");
    let found = super::by_recursion::vertices_and_facets(&body);
    assert_eq!(found.dimension, truth.len() - 1);
    assert!(found.vertices.iter().eq(&truth[0]), "{found:?}");
    if found.dimension > 0 {
        assert!(found.facets.iter().eq(&truth[found.dimension - 1]));
        assert_eq!(found.edge_count(), truth[1].len());
    }
    for (facet, &size) in found.facets.iter().zip(&found.facet_sizes) {
        let on_facet = |v: &&SignVector| facet.iter().zip(*v).all(|(f, v)| f.is_eq() || f == v);
        assert_eq!(found.vertices.iter().filter(on_facet).count(), size);
    }
}

/// Zaslavsky: an arrangement of hyperplanes through the origin has as many cells as the sum of (−1)^(|S| − rank S) over
/// subsets S of normals.
fn cells_by_ranks<const D: usize>(vectors: &[[f64; D]]) -> i64 {
    (0..1u32 << vectors.len())
        .map(|subset| {
            let chosen: Vec<[f64; D]> =
                vectors.iter().enumerate().filter(|(i, _)| subset >> i & 1 == 1).map(|(_, v)| *v).collect();
            let rank = crate::numeric::exact_linear::Span::of_doubles(&chosen).rank();
            if (chosen.len() - rank).is_multiple_of(2) { 1 } else { -1 }
        })
        .sum()
}

fn few_vectors<const D: usize>(most: usize) -> impl Strategy<Value = Vec<[f64; D]>> {
    let vector = proptest::collection::vec(coordinate(), D).prop_map(|v| std::array::from_fn(|k| v[k]));
    proptest::collection::vec(vector, 0..most)
}

properties! {
    #![proptest_config(crate::property_cases::config(150))]

    #[test]
    fn recursion_is_right_in_every_dimension(
        line in few_vectors::<1>(5),
        plane in few_vectors::<2>(8),
        space in generators(),
        four in few_vectors::<4>(8),
        five in few_vectors::<5>(7),
    ) {
        check_recursion(&line);
        check_recursion(&plane);
        check_recursion(&space);
        check_recursion(&four);
        check_recursion(&five);
    }

    #[test]
    fn vertices_are_as_many_as_zaslavsky_says(four in few_vectors::<4>(9), space in generators()) {
        let four: Vec<[f64; 4]> = four.into_iter().filter(|v| *v != [0.0; 4]).collect();
        let body = Zonotope::new([0.0; 4], four.clone()).expect("finite");
        let found = super::by_recursion::vertices_and_facets(&body);
        prop_assert_eq!(found.vertices.len() as i64, cells_by_ranks(&four));
        let space: Vec<[f64; 3]> = space.into_iter().filter(|v| *v != [0.0; 3]).collect();
        if let Some(lattice) = lattice_of([0.0; 3], &space) {
            prop_assert_eq!(lattice.vertex_count() as i64, cells_by_ranks(&space));
        }
    }
}
