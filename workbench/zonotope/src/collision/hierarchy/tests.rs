use super::*;
use crate::collision::{Location, Query, Status, by_lad};
use crate::interop::verifier::check_location;
use crate::reduction::contains;
use crate::zonotope::Zonotope;
use crate::zonotope::pose::Pose;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Generators of nine kinds: even; few directions; whole numbers; nearly in a plane; in a plane; along a line; of
/// lengths far apart; some zero; at the ends of the range of doubles.
const KINDS: usize = 9;

fn body(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Zonotope<3> {
    let generators = (0..n).map(|i| {
        let [x, y, z] = [0; 3].map(|_| random.random_range(-1.0..1.0f64));
        match kind {
            0 => [x, y, z],
            1 => [[1.0, 0.5, 0.0], [0.0, 1.0, -1.0], [1.0, 1.0, 1.0]][i % 3].map(|c| c * x),
            2 => [x, y, z].map(|c| (3.0 * c).round()),
            3 => [x, y, x + 1e-7 * z],
            4 => [x, y, x - y],
            5 => [x, 3.0 * x, -x],
            6 => [x, y, z].map(|c| c * libm::exp10(60.0 * x)),
            7 => [x, y, z].map(|c| if i % 3 == 0 { 0.0 } else { c }),
            _ => [x, y, z].map(|c| c * if i % 2 == 0 { 1e307 } else { f64::from_bits(9) }),
        }
    });
    Zonotope::new([0.0; 3], generators.collect()).expect("finite")
}

#[test]
fn levels_are_nested_and_as_few_as_they_say() {
    let random = &mut Pcg64Mcg::seed_from_u64(3);
    for kind in 0..KINDS {
        for n in [0, 1, 30, 60, 400] {
            let hierarchy = Hierarchy::new(body(kind, n, random));
            let last = hierarchy.level_count() - 1;
            assert_eq!(hierarchy.outer(last).body(), hierarchy.body());
            assert!(kind == 8 || n < 400 || last > 0, "{kind}");
            for level in 0..last {
                let [outer, finer] = [level, level + 1].map(|level| hierarchy.outer(level).body());
                assert!(3 * outer.generators().len() <= finer.generators().len(), "{kind} {n} {level}");
                if outer.generators().len() <= 80 {
                    assert_eq!(contains(outer, finer), Some(true), "{kind} {n} {level}");
                    assert_eq!(contains(outer, hierarchy.body()), Some(true), "{kind} {n} {level}");
                }
                assert!(hierarchy.inner(level).is_some() || kind > 2, "{kind} {n} {level}");
                if let Some(inner) = hierarchy.inner(level)
                    && n <= 60
                {
                    assert_eq!(contains(hierarchy.body(), inner.body()), Some(true), "{kind} {n} {level}");
                }
            }
        }
    }
}

/// The answer is that of the kernel, and its proofs hold.
fn check(first: &Hierarchy, second: &Hierarchy) -> u32 {
    let query = Query::between(first.body(), second.body());
    let descent = first.intersection(second, &mut ());
    assert_eq!(descent.status(), by_lad::locate(&query, &mut ()).status());
    let location = descent.location();
    assert_eq!(location.status(), descent.status());
    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
    if let Some(separation) = descent.separation() {
        assert_eq!(location, Location::Outside(separation.clone()));
    }
    if let Some(witness) = descent.level_witness() {
        let [a, b] = descent.levels();
        let inner = [first.inner(a), second.inner(b)].map(|inner| inner.expect("a witness is about it").body());
        let query = Query::between(inner[0], inner[1]);
        let of_levels = by_lad::locate(&query, &mut ()).status();
        let location = if of_levels == Status::Inside {
            Location::Inside(witness.clone())
        } else {
            Location::Boundary(witness.clone())
        };
        assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
    }
    assert!(descent.generators_read() > 0 || query.is_empty());
    let levels = [first, second].map(|body| body.level_count() as u32);
    assert!(descent.visited() < levels[0] + levels[1]);
    descent.visited()
}

#[test]
fn bodies_meet_as_the_kernel_says() {
    let random = &mut Pcg64Mcg::seed_from_u64(5);
    for kind in 0..KINDS {
        for (n, m) in [(0, 60), (9, 9), (60, 200), (300, 300)] {
            let first = Hierarchy::new(body(kind, n, random));
            let other = body(if n == 300 { kind } else { 0 }, m, random);
            let u = [0; 3].map(|_| random.random_range(-1.0..1.0f64));
            let far: Vec<[f64; 3]> = [first.body(), &other].map(|body| body.support(u).point()).to_vec();
            for factor in [0.0, 0.3, 0.9, 0.999, 1.0, 1.0 + 1e-12, 1.001, 1.1, 4.0] {
                let center = [0, 1, 2].map(|k| (factor * (far[0][k] + far[1][k])).clamp(-f64::MAX, f64::MAX));
                let moved =
                    Zonotope::new(center.map(|c| if c.is_nan() { 0.0 } else { c }), other.generators().to_vec());
                check(&first, &Hierarchy::new(moved.expect("finite")));
            }
        }
    }
}

#[test]
fn far_bodies_are_told_by_the_coarsest_levels_and_near_ones_by_finer_ones() {
    let random = &mut Pcg64Mcg::seed_from_u64(7);
    let generators = body(0, 2000, random).generators().to_vec();
    let at = |x: f64| Hierarchy::new(Zonotope::new([x, 0.0, 0.0], generators.clone()).expect("finite"));
    let own = at(0.0);
    let reach: f64 = generators.iter().map(|v| 2.0 * v[0].abs()).sum();
    let visited = [9.0, 1.1, 1.01, 1.0, 0.99, 0.9, 0.1].map(|part| check(&own, &at(part * reach)));
    assert!(own.level_count() >= 5);
    assert_eq!((visited[0], visited[3]), (1, own.level_count() as u32));
    assert!(
        visited.is_sorted_by(|a, b| a <= b) || visited[..4].is_sorted() && visited[3..].is_sorted_by(|a, b| a >= b)
    );
    assert!(visited[1] < visited[3] && visited[6] < visited[3], "{visited:?}");
}

#[test]
fn the_larger_body_goes_down_first() {
    let random = &mut Pcg64Mcg::seed_from_u64(11);
    let large = body(0, 2000, random);
    let small: Vec<[f64; 3]> = large.generators().iter().map(|v| v.map(|c| c / 1024.0)).collect();
    let reach: f64 = large.generators().iter().map(|v| v[0].abs()).sum();
    let beside = Zonotope::new([1.02 * reach, 0.0, 0.0], small).expect("finite");
    let [large, small] = [large, beside].map(Hierarchy::new);
    let levels = large.intersection(&small, &mut ()).levels();
    assert!(levels[0] > levels[1] && levels[1] + 1 < small.level_count(), "{levels:?}");
}

#[test]
fn posed_bodies_meet_as_the_kernel_says() {
    let random = &mut Pcg64Mcg::seed_from_u64(13);
    for kind in 0..KINDS - 1 {
        let [first, second] = [200, 100].map(|n| Hierarchy::new(body(kind, n, random)));
        for step in 0..24 {
            let axis = [0; 3].map(|_| random.random_range(-1.0..1.0f64));
            let away = libm::exp10(random.random_range(-1.0..2.5)) * f64::from(step % 4);
            let turned = Pose::from_axis_angle(axis, 1.0 + axis[0], axis.map(|c| c * away)).expect("finite");
            let flattened = Pose::new([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, 2.0, 0.0]], axis).expect("finite");
            for [from, to] in [[Pose::IDENTITY, turned], [turned, flattened]] {
                let descent = first.at(&from).intersection(&second.at(&to), &mut ());
                let truth = first.body().at(&from).intersection(second.body().at(&to));
                assert_eq!((descent.status(), descent.location().status()), (truth.status(), truth.status()));
                assert!(descent.status() != Status::Outside || descent.separation().is_some());
            }
        }
    }
}
