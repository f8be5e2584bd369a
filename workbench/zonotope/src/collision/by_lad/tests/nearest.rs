//! The gauge of answers of bodies is that of exact arithmetic to its last digits.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::{FAMILIES, displacement, family};
use crate::collision::prepared::DirectionTree;
use crate::collision::{Gauge, Query, brute_force, by_lad};
use crate::numeric::tolerance::NEAREST_GAUGE;
use crate::zonotope::pose::Pose;
use crate::zonotope::{PreparedBody, Zonotope};

fn check(name: &str, n: usize, found: (f64, f64), truth: f64) {
    let (value, error) = found;
    if (f64::MIN_POSITIVE..f64::MAX).contains(&truth) {
        assert!((value - truth).abs() <= NEAREST_GAUGE * truth, "{name} {n}: {value} ± {error:e}, not {truth}");
        assert!(error <= NEAREST_GAUGE * value + f64::from_bits(1), "{name} {n}: {value} ± {error:e}");
    } else {
        assert!(value == truth || error >= (value - truth).abs(), "{name} {n}: {value} ± {error:e}, not {truth}");
    }
}

fn of<const D: usize, L>(gauge: &Gauge<D, L>) -> (f64, f64) {
    (gauge.value, gauge.error)
}

fn cross_in<const D: usize>(seed: u64) {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    for name in FAMILIES {
        for n in [1, 3, 6, 9, 14, 18, 24] {
            let generators = family::<D>(name, n, &mut random);
            let (from, to) = displacement(&generators, &mut random);
            let query = Query::new(from, to, &generators).expect("finite");
            check(name, n, of(&by_lad::nearest_gauge(&query, &mut ())), brute_force::gauge(&query).value);
        }
    }
}

#[test]
fn in_the_plane_and_in_space() {
    cross_in::<2>(52);
    cross_in::<3>(53);
}

#[test]
fn of_prepared_and_posed_bodies_and_of_trees() {
    let mut random = Pcg64Mcg::seed_from_u64(54);
    // images under this matrix are doubles for most families, so that the truth is that of a body without a pose
    let turned = Pose::new([[0.0, -2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 0.5]], [0.0; 3]).expect("finite");
    let image = |v: &[f64; 3]| [-2.0 * v[1], 2.0 * v[0], 0.5 * v[2]];
    for name in FAMILIES {
        for n in [3, 9, 24, 200, 700] {
            let generators = family::<3>(name, n, &mut random);
            let (_, to) = displacement(&generators, &mut random);
            let body = Zonotope::new([0.0; 3], generators.clone()).expect("finite");
            let truth = by_lad::facet(&Query::of_point(to, &body).expect("finite"), &mut ()).exact_value();
            check(name, n, of(&body.gauge(to).expect("finite")), truth);
            check(name, n, of(&PreparedBody::new(body.clone()).gauge(to).expect("finite")), truth);
            let tree = DirectionTree::new(&body);
            check(name, n, tree.gauge(to, &mut ()).expect("finite").nearest_value(), truth);
            let images: Vec<[f64; 3]> = generators.iter().map(image).collect();
            let is_exact = images.iter().flatten().all(|c| c.is_finite() && (*c == 0.0 || c.abs() > 1e-290));
            let end = image(&to);
            if is_exact && end.iter().all(|c| c.is_finite() && (*c == 0.0 || c.abs() > 1e-290)) {
                check(name, n, of(&body.at(&turned).gauge(end).expect("finite")), truth);
            }
        }
    }
}
