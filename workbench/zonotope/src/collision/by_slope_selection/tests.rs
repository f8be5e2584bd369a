//! The search against the truth and the kernel, on every family; every proof checked on its own.

use families::drawn::numbers::integer;
use proptest::prelude::*;

use super::*;
use crate::collision::{brute_force, by_lad};
use crate::interop::verifier::check_location;
use crate::tally::{Operation, OperationCounts};

type Vector = [f64; 3];

fn check(generators: &[Vector], from: Vector, to: Vector) -> Result<(), TestCaseError> {
    let question = Query::new(from, to, generators).expect("the family is finite");
    let truth = brute_force::locate(&question);
    for seed in [0, 1] {
        let location = locate(&question, seed, &mut ());
        prop_assert_eq!(location.status(), truth.status());
        prop_assert_eq!(check_location(&question, &location).proof().map(drop), Ok(()), "{:?}", location);
    }
    prop_assert_eq!(by_lad::locate(&question, &mut ()).status(), truth.status());
    Ok(())
}

/// Points around the boundary: a vertex, the middle of two, a point of a facet, and their neighbours in the last place.
fn check_around(generators: &[Vector], signs: &[bool], t: f64) -> Result<(), TestCaseError> {
    let vertex = |flip: usize| {
        generators.iter().zip(signs.iter().cycle()).enumerate().fold([0.0; 3], |sum, (i, (v, &sign))| {
            let sign = if sign != (i == flip) { 1.0 } else { -1.0 };
            [0, 1, 2].map(|axis| sum[axis] + sign * v[axis])
        })
    };
    let (first, second, third) = (vertex(usize::MAX), vertex(0), vertex(1));
    check(generators, [0.0; 3], first)?;
    check(generators, second, [0.0; 3])?;
    check(generators, [0.0; 3], [0, 1, 2].map(|i| (first[i] + second[i]) / 2.0))?;
    let inner = [0, 1, 2].map(|i| first[i] + t * (second[i] - first[i]) + (1.0 - t) * (third[i] - first[i]) / 2.0);
    check(generators, [0.0; 3], inner)?;
    check(generators, [0.0; 3], inner.map(|c| c.next_up()))?;
    check(generators, [0.0; 3], [inner[0], inner[1].next_down(), inner[2]])?;
    check(generators, [0.0; 3], inner.map(|c| c * t))
}

fn coordinates(coordinate: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Vector> + Clone {
    [coordinate.clone(), coordinate.clone(), coordinate]
}

fn scale() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![Just(1.0), Just(1e-300), Just(1e300), Just(f64::from_bits(1)), Just(1e-17), Just(1e16)]
}

fn several<S: Strategy<Value = Vector>>(v: S) -> impl Strategy<Value = Vec<Vector>> {
    proptest::collection::vec(v, 0..8)
}

fn signs() -> impl Strategy<Value = Vec<bool>> {
    proptest::collection::vec(any::<bool>(), 8)
}

properties! {
    #![proptest_config(crate::property_cases::config(600))]

    #[test]
    fn random_bodies(g in several(coordinates(-1.0..1.0f64)), p in coordinates(-2.0..2.0f64)) {
        check(&g, [0.0; 3], p)?;
    }

    #[test]
    fn lattice_bodies(g in several(coordinates(integer(2))), p in coordinates((-4i32..5).prop_map(f64::from))) {
        check(&g, [0.0; 3], p)?;
    }

    #[test]
    fn around_random_bodies(g in several(coordinates(-1.0..1.0f64)), signs in signs(), t in 0.0..1.0f64) {
        check_around(&g, &signs, t)?;
    }

    #[test]
    fn around_lattice_bodies(
        g in several(coordinates(integer(2))),
        signs in signs(),
        t in (0i32..5).prop_map(|t| f64::from(t) / 4.0),
    ) {
        check_around(&g, &signs, t)?;
    }

    #[test]
    fn around_flat_bodies(
        g in several(coordinates(integer(2))), axis in 0usize..3, signs in signs(), t in 0.0..1.0f64
    ) {
        let flat: Vec<Vector> = g.into_iter().map(|mut v| { v[axis] = 0.0; v }).collect();
        check_around(&flat, &signs, t)?;
    }

    #[test]
    fn around_slanted_flat_bodies(g in several(coordinates(integer(2))), signs in signs(), t in 0.0..1.0f64) {
        let flat: Vec<Vector> = g.into_iter().map(|[x, y, _]| [x, y, 2.0 * x - y]).collect();
        check_around(&flat, &signs, t)?;
    }

    #[test]
    fn around_segments(
        factors in proptest::collection::vec(integer(2), 0..5),
        v in coordinates(integer(2)),
        signs in signs(),
        t in 0.0..1.0f64,
    ) {
        let line: Vec<Vector> = factors.into_iter().map(|f| v.map(|c| f * c)).collect();
        check_around(&line, &signs, t)?;
    }

    #[test]
    fn around_bodies_of_all_magnitudes(
        g in proptest::collection::vec((coordinates(integer(2)), scale()).prop_map(|(v, s)| v.map(|c| c * s)), 0..6),
        signs in signs(),
        t in 0.0..1.0f64,
    ) {
        check_around(&g, &signs, t)?;
    }

    #[test]
    fn around_bodies_of_one_magnitude(
        g in several(coordinates(-1.0..1.0f64)),
        s in scale(),
        signs in signs(),
        t in 0.0..1.0f64,
    ) {
        let g: Vec<Vector> = g.into_iter().map(|v| v.map(|c| c * s)).collect();
        check_around(&g, &signs, t)?;
    }

    #[test]
    fn around_bodies_with_coordinates_of_their_own_magnitudes(
        g in several(coordinates(integer(2))), s in coordinates(scale()), signs in signs(), t in 0.0..1.0f64,
    ) {
        let g: Vec<Vector> = g.into_iter().map(|v| [0, 1, 2].map(|i| v[i] * s[i])).collect();
        check_around(&g, &signs, t)?;
    }

    #[test]
    fn nudged_lattice_bodies(
        g in several(
            (coordinates(integer(2)), coordinates(integer(2)))
                .prop_map(|(v, n)| [0, 1, 2].map(|i| v[i] * (1.0 + n[i] * f64::EPSILON)))
        ),
        signs in signs(),
        t in 0.0..1.0f64,
    ) {
        check_around(&g, &signs, t)?;
    }

    #[test]
    fn distant_points(
        g in several(coordinates(integer(2))),
        from in coordinates(integer(2)),
        to in coordinates(integer(2)),
    ) {
        let from = from.map(|c| c * 1e16);
        let to = [0, 1, 2].map(|i| from[i] + to[i]);
        check(&g, from, to)?;
        check(&g, [-1.0, 0.0, 1e16], to)?;
    }

    #[test]
    fn two_boxes(sizes in [1i32..4, 1..4, 1..4, 1..4, 1..4, 1..4], p in [-7i32..8, -7..8, -7..8]) {
        let sized = |i: usize, axis: usize| { let mut v = [0.0; 3]; v[axis] = f64::from(sizes[i]); v };
        let boxes: Vec<Vector> = (0..6).map(|i| sized(i, i % 3)).collect();
        check(&boxes, [0.0; 3], p.map(f64::from))?;
    }

    #[test]
    fn the_plane(g in proptest::collection::vec([integer(2), integer(2)], 0..6), p in [-4i32..5, -4..5]) {
        let question = Query::new([0.0; 2], p.map(f64::from), &g).expect("finite");
        let location = locate(&question, 0, &mut ());
        prop_assert_eq!(location.status(), brute_force::locate(&question).status());
        prop_assert_eq!(check_location(&question, &location).proof().map(drop), Ok(()), "{:?}", location);
    }
}

fn body(count: usize) -> Vec<Vector> {
    use rand::RngExt;
    let mut random = Pcg64Mcg::seed_from_u64(count as u64);
    (0..count).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect()
}

#[test]
fn operations_grow_like_n_log_squared_n() {
    for exponent in (6..=14).step_by(2) {
        let count = 1usize << exponent;
        let generators = body(count);
        let point = [0.3, -0.2, 0.4].map(|c| c * count as f64 / 2.0);
        let question = Query::new([0.0; 3], point, &generators).expect("finite");
        let mut counts = OperationCounts::default();
        let location = locate(&question, 1, &mut counts);
        assert_eq!(location.status(), by_lad::locate(&question, &mut ()).status());
        let ratio = counts.get(Operation::Comparison) as f64 / (count * exponent * exponent) as f64;
        let steps = counts.get(Operation::SearchStep);
        println!("n = 2^{exponent}: {ratio:.2} n log2² n comparisons, {steps} vertical lines, {}", location.status());
        assert!(ratio < 60.0, "n = 2^{exponent}: {ratio}");
    }
}

/// Concurrent, parallel and nearly parallel lines by the hundred: each vertical line still halves the tiles.
#[test]
fn structured_bodies_take_few_steps() {
    use rand::RngExt;
    const COUNT: usize = 400;
    let mut random = Pcg64Mcg::seed_from_u64(5);
    let mut vectors = |make: &mut dyn FnMut([f64; 3], usize) -> Vector| -> Vec<Vector> {
        (0..COUNT).map(|i| make([0; 3].map(|_| random.random_range(-1.0..1.0)), i)).collect()
    };
    let directions = body(8);
    let families = [
        ("random", vectors(&mut |v, _| v)),
        ("lattice", vectors(&mut |v, _| v.map(|c| (3.5 * c).round()))),
        ("flat", vectors(&mut |[x, y, _], _| [x, y, x - 2.0 * y])),
        ("level", vectors(&mut |[x, y, _], _| [x, y, 0.0])),
        ("vertical plane", vectors(&mut |[x, _, z], _| [x, x, z])),
        ("nearly flat", vectors(&mut |[x, y, z], i| [x, y, if i % 10 == 0 { z } else { 1e-9 * z }])),
        ("eight directions", vectors(&mut |v, i| directions[i % 8].map(|c| c * v[0]))),
        ("noisy directions", vectors(&mut |v, i| [0, 1, 2].map(|axis| directions[i % 8][axis] + 1e-9 * v[axis]))),
        ("uneven lengths", vectors(&mut |v, i| v.map(|c| c * 2f64.powi(-(i as i32) / 4)))),
    ];
    for (name, generators) in families {
        for t in [0.2, 0.9, 1.1] {
            // t times the farthest point in a direction
            let along = |v: &Vector| 0.3 * v[0] + 0.5 * v[1] + 0.8 * v[2];
            let top = generators.iter().fold([0.0; 3], |p, v| [0, 1, 2].map(|i| p[i] + v[i] * along(v).signum()));
            let question = Query::new([0.0; 3], top.map(|c| t * c), &generators).expect("finite");
            let mut counts = OperationCounts::default();
            let location = locate(&question, 0, &mut counts);
            assert_eq!(location.status(), by_lad::locate(&question, &mut ()).status(), "{name}, {t}");
            assert_eq!(check_location(&question, &location).proof().map(drop), Ok(()), "{name}, {t}");
            println!("{name}, {t}: {}, {counts:?}", location.status());
            assert!(counts.get(Operation::SearchStep) <= 2 * 3 * 18, "{name}, {t}: {counts:?}");
        }
    }
}

/// The farther from the middle, the nearer to the boundary: proofs on both sides of it, down to one unit in the last
/// place.
#[test]
fn proofs_hold_close_to_the_boundary() {
    let generators = body(60);
    let question = |t: f64| [0.3, -0.2, 0.4].map(|c| c * t);
    let (mut low, mut high) = (0.0f64, 1e3f64);
    while low.next_up() < high {
        let middle = f64::midpoint(low, high);
        let middle = if middle <= low || middle >= high { low.next_up() } else { middle };
        let displacement = Query::new([0.0; 3], question(middle), &generators).expect("finite");
        let location = locate(&displacement, 0, &mut ());
        assert_eq!(check_location(&displacement, &location).proof().map(drop), Ok(()), "{location:?}");
        if location.is_member() { low = middle } else { high = middle }
    }
}

#[test]
fn a_trace_tells_the_search() {
    let generators = body(12);
    let question = Query::new([0.0; 3], [0.4, 0.3, 0.2], &generators).expect("finite");
    let trace = trace(&question, 0);
    assert_eq!(trace.location, locate(&question, 0, &mut ()));
    for hull in [Hull::Upper, Hull::Lower] {
        let steps: Vec<&SearchStep> = trace.steps.iter().filter(|step| step.hull == hull).collect();
        assert_eq!(steps[0].tiles_before, 66);
        assert!(steps.windows(2).all(|pair| pair[0].tiles_after == pair[1].tiles_before));
        assert!(steps.iter().all(|step| 2 * step.tiles_after <= step.tiles_before));
        assert_eq!(steps.last().map(|step| step.side), Some(Side::Within));
        assert!(steps.iter().all(|step| step.chains.iter().all(|chain| chain.len() == 13)));
        let tile = trace.tiles.iter().find(|tile| tile.hull == hull).expect("a member is between two facets");
        assert_eq!((tile.generators.len(), tile.corners.len()), (2, 4));
        assert!(tile.depth > 0.0);
    }
}
