use super::lines::LINE_FAMILIES;
use super::{FAMILIES, random_convex, source::RandomSource};
use std::collections::BTreeSet;

const SIZES: [usize; 6] = [0, 1, 2, 3, 10, 257];

#[test]
fn point_families_have_the_asked_size_and_depend_on_nothing_but_the_seed() {
    for family in FAMILIES {
        for n in SIZES {
            let points = family.generate(n, 7);
            assert_eq!(points.len(), n, "{}", family.id);
            assert!(points.iter().flatten().all(|x| x.is_finite()), "{}", family.id);
            assert_eq!(points, family.generate(n, 7), "{}", family.id);
            if n >= 10 {
                assert_eq!(points != family.generate(n, 8), family.is_random, "{}", family.id);
            }
        }
    }
}

#[test]
fn line_families_have_the_asked_size_and_no_zero_normal() {
    for family in LINE_FAMILIES {
        for n in SIZES {
            let rows = family.generate(n, 7);
            assert_eq!(rows.len(), n, "{}", family.id);
            assert!(rows.iter().all(|(a, b)| *a != [0.0, 0.0] && b.is_finite()), "{}", family.id);
            assert_eq!(rows, family.generate(n, 7), "{}", family.id);
        }
    }
}

#[test]
fn ids_are_distinct() {
    let ids: BTreeSet<_> = FAMILIES.iter().map(|f| f.id).chain(LINE_FAMILIES.iter().map(|f| f.id)).collect();
    assert_eq!(ids.len(), FAMILIES.len() + LINE_FAMILIES.len());
}

/// A change of a generator changes every recorded instance: these words were computed once and must stay.
#[test]
fn the_random_stream_is_pinned() {
    let mut source = RandomSource::new(1);
    assert_eq!([source.bits(), source.bits()], PINNED_WORDS);
}

const PINNED_WORDS: [u64; 2] = [15_803_641_690_485_367_939, 2_537_432_388_316_380_799];

#[test]
fn random_convex_points_are_all_in_convex_position() {
    let points = random_convex::RANDOM_CONVEX.generate(60, 3);
    for (i, p) in points.iter().enumerate() {
        // p is extreme when the directions to all other points leave a gap of more than pi, that is, when one of those
        // directions has every other one on its left.
        let others: Vec<_> = points.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, q)| q).collect();
        let extreme = others.iter().any(|q| {
            others.iter().all(|r| std::ptr::eq(*q, *r) || (q[0] - p[0]) * (r[1] - p[1]) > (q[1] - p[1]) * (r[0] - p[0]))
        });
        assert!(extreme, "point {i}");
    }
}

#[test]
fn symmetric_families_are_exactly_symmetric() {
    for id in ["symmetric", "regular_polygon"] {
        let points = super::find(id).expect("listed").generate(32, 5);
        for &[x, y] in &points {
            assert!(points.contains(&[-x, -y]), "{id}");
        }
    }
}

#[test]
fn concurrent_lines_meet_exactly() {
    for (a, b) in super::lines::find("concurrent_lines").expect("listed").generate(100, 5) {
        // Half-integers below 2^41: every product and sum here is exact.
        assert_eq!(3.0 * a[0] - 5.0 * a[1] + b, 0.0);
    }
}
