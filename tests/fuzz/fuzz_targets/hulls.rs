//! The dynamic hull against its exact twin: insertions, deletions, tangents and extreme vertices.
#![no_main]

use std::sync::Arc;

use libfuzzer_sys::fuzz_target;
use zonotope::arrangement::dynamic_hull::brute_force::BruteForce;
use zonotope::arrangement::dynamic_hull::{
    Direction, DynamicChain, HullChain, PlanarPoint, Side, SiteIndex, SortedSites, Towards,
};

/// The most sites: the twin takes rationals for each of them at each step.
const SITE_LIMIT: usize = 24;

/// The steps in all.
const STEP_LIMIT: usize = 64;

/// A coordinate of one byte: whole numbers, neighbours of whole numbers, and numbers of very different sizes.
fn coordinate(byte: u8) -> f64 {
    let whole = f64::from(byte % 8) - 4.0;
    match byte / 8 % 8 {
        0..4 => whole,
        4 => whole.next_up(),
        5 => whole * f64::MIN_POSITIVE,
        6 => whole * 1e300,
        _ => whole + 0.1,
    }
}

fuzz_target!(|bytes: &[u8]| {
    let [count, rest @ ..] = bytes else { return };
    let count = usize::from(*count) % SITE_LIMIT + 1;
    if rest.len() < 2 * count {
        return;
    }
    let (places, steps) = rest.split_at(2 * count);
    let points: Vec<[f64; 2]> = places.chunks_exact(2).map(|p| [coordinate(p[0]), coordinate(p[1])]).collect();
    let points = PlanarPoint::list(&points).expect("all coordinates are finite");
    let sites = Arc::new(SortedSites::new(&points).expect("there are few sites"));
    for side in [Side::Lower, Side::Upper] {
        let mut fast = DynamicChain::new(sites.clone(), side, []).expect("no site is unknown");
        let mut twin = BruteForce::new(sites.clone(), side, []).expect("no site is unknown");
        for step in steps.iter().take(STEP_LIMIT) {
            let site = SiteIndex(u32::from(step % 32));
            match step / 32 {
                0..3 => assert_eq!(fast.insert(site), twin.insert(site)),
                3..5 => assert_eq!(fast.delete(site), twin.delete(site)),
                5 => {
                    let towards = if step % 2 == 0 { Towards::Left } else { Towards::Right };
                    let from = &points[usize::from(step % 32) % points.len()];
                    assert_eq!(fast.tangent(from, towards), twin.tangent(from, towards));
                }
                6 => {
                    let direction = Direction::at_abscissa(coordinate(step.wrapping_mul(37))).expect("it is finite");
                    assert_eq!(fast.extreme(direction), twin.extreme(direction));
                }
                _ => assert_eq!(fast.vertices(), twin.vertices()),
            }
            assert_eq!(fast.len(), twin.len());
        }
        assert_eq!(fast.vertices(), twin.vertices());
    }
});
