//! Counts of faces and the volume against the twin that knows the sign vectors of all faces.

use std::collections::BTreeMap;

use dashu_ratio::RBig;
use proptest::prelude::*;
use zonotope::Zonotope;
use zonotope::zonotope::combinatorics;
use zonotope::zonotope::faces::brute_force::faces_by_dimension;
use zonotope::zonotope::faces::by_recursion::total_volume;

fn check<const D: usize>(generators: Vec<[f64; D]>) {
    let truth = faces_by_dimension(&generators);
    let body = Zonotope::new([0.25; D], generators).expect("finite");
    let counts = combinatorics(&body);
    let rank = truth.len() - 1;
    assert_eq!(counts.affine_dimension, rank);
    let count = |dimension: usize| truth.get(dimension).map_or(0, |faces| faces.len() as u64);
    assert_eq!([counts.vertices, counts.edges], [count(0), count(1)]);
    let facets = if rank == 0 { 0 } else { count(rank - 1) };
    assert_eq!((counts.facets, counts.facet_sizes.values().sum::<u64>()), (facets, facets));
    let mut sizes = BTreeMap::new();
    for facet in truth.iter().rev().nth(1).into_iter().flatten() {
        let of = |v: &&Vec<_>| facet.iter().zip(*v).all(|(f, v)| f.is_eq() || f == v);
        *sizes.entry(truth[0].iter().filter(of).count()).or_insert(0) += 1;
    }
    assert_eq!(counts.facet_sizes, sizes);
    if rank < D {
        assert_eq!(counts.measure, RBig::ZERO);
    } else {
        assert_eq!(counts.measure, total_volume(&body).to_rational());
    }
}

fn vectors<const D: usize>(most: usize) -> impl Strategy<Value = Vec<[f64; D]>> {
    let coordinate = prop_oneof![3 => (-1i8..2).prop_map(f64::from), 1 => (-9i8..9).prop_map(|k| f64::from(k) * 0.1)];
    let vector = proptest::collection::vec(coordinate, D).prop_map(|v| std::array::from_fn(|k| v[k]));
    proptest::collection::vec(vector, 0..most)
}

#[test]
fn a_point_and_a_segment() {
    check::<3>(vec![]);
    check(vec![[0.0, 2.0, 1.0], [0.0, -4.0, -2.0]]);
    check(vec![[0.5], [-3.0], [0.0]]);
}

tests::properties! {
    400;

    #[test]
    fn counts_are_those_of_the_twin_in_1_to_3(a in vectors::<1>(5), b in vectors::<2>(7), c in vectors::<3>(7)) {
        check(a);
        check(b);
        check(c);
    }
}

tests::properties! {
    60;

    #[test]
    fn counts_are_those_of_the_twin_in_4_and_5(a in vectors::<4>(7), b in vectors::<5>(7)) {
        check(a);
        check(b);
    }
}
