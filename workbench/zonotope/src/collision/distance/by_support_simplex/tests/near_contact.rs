//! Distances just beyond facets, edges and corners, which pairs of doubles tell.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::collision::distance::by_support_simplex::{active_set, in_pairs};
use crate::numeric::linear::{cross, euclidean_norm};

/// A point of a facet of a random body, in the coefficients of its two generators, and a direction between its normal
/// and another one.
fn beyond(random: &mut Pcg64Mcg, body: &[[f64; 3]], own: [f64; 2], gap: f64) -> [f64; 3] {
    let mut normal = cross(&body[0], &body[1]);
    if random.random() {
        normal = normal.map(|c| -c);
    }
    let tilt = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
    let (length, share) = (euclidean_norm(&normal), random.random_range(0.0..0.5));
    let direction = [0, 1, 2].map(|k| normal[k] / length + share * tilt[k]);
    let mut p = [0, 1, 2].map(|k| own[0] * body[0][k] + own[1] * body[1][k] + gap * direction[k]);
    for v in &body[2..] {
        let sign = f64::copysign(1.0, dot(v, &normal));
        p = [0, 1, 2].map(|k| p[k] + sign * v[k]);
    }
    p
}

#[test]
fn pairs_tell_the_distance_beyond_facets_edges_and_corners() {
    let random = &mut Pcg64Mcg::seed_from_u64(66);
    for n in [2, 3, 6, 40, 300] {
        let (mut asked, mut known) = (0, 0);
        for round in 0..120 {
            let body: Vec<[f64; 3]> = (0..n).map(|_| [0; 3].map(|_| random.random_range(-1.0..1.0))).collect();
            let own = [[0.3, -0.4], [1.0, 0.25], [-0.5, -1.0], [1.0, -1.0]][round % 4];
            let gap = [1e-9, 1e-5, 0.1, 10.0][round / 4 % 4];
            let p = beyond(random, &body, own, gap);
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let Location::Outside(separation) = decide(&query, &mut ()) else { continue };
            let start = direction(&separation);
            asked += 1;
            let Some(own) = in_pairs::distance(&query, start, &mut ()) else { continue };
            known += 1;
            let exact = in_space(&query, &query.ends(), start, &mut ()).distance();
            assert!(own.to_bits().abs_diff(exact.to_bits()) <= 4, "{own} {exact} {body:?} {p:?}");
        }
        assert!(asked > 60 && 10 * known >= 9 * asked, "{n}: {known} of {asked}");
    }
}

/// In the direction that is found the point is as far beyond the body as from it.
#[test]
fn an_active_set_finds_the_direction_from_the_nearest_point_of_few_generators() {
    let random = &mut Pcg64Mcg::seed_from_u64(67);
    let mut found = 0;
    for round in 0..400 {
        let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
        let body: Vec<[f64; 3]> = (0..round % 7).map(|_| vector()).collect();
        let far = [2.0, 4.0, 16.0][round % 3];
        let (point, near) = (vector().map(|c| far * c), vector());
        let query = Query::new([0.0; 3], point, &body).expect("finite");
        let truth = brute_force::nearest_point(&query).squared_distance.to_f64().value().sqrt();
        let Some(guess) = active_set::direction(&body, point, &near) else { continue };
        assert!(truth > 0.0, "{body:?} {point:?}");
        let along = dot(&guess.direction, &point) - body.iter().map(|v| dot(v, &guess.direction).abs()).sum::<f64>();
        assert!((along - truth).abs() <= 1e-9 * truth, "{along} {truth} {body:?} {point:?}");
        found += 1;
    }
    assert!(found > 250, "{found}");
}

#[test]
fn an_active_set_says_nothing_of_points_inside_and_parallel_generators() {
    let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert!(active_set::direction(&cube, [0.5, -0.25, 0.0], &[1.0, 1.0, 1.0]).is_none());
    let parallel = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    // two that could leave their bounds together
    assert!(active_set::direction(&parallel, [0.5, 1.0, 0.0], &[-1.0, 1.0, 0.0]).is_some());
    let guess = active_set::direction(&cube, [0.5, 0.5, 3.0], &[-1.0, -1.0, -1.0]).expect("it is above the cube");
    assert_eq!(guess.direction, [0.0, 0.0, 1.0]);
    assert!(active_set::direction(&[], [0.0; 3], &[1.0, 0.0, 0.0]).is_none());
    assert!(active_set::direction(&[[f64::NAN; 3]], [1.0; 3], &[1.0, 0.0, 0.0]).is_none());
}
