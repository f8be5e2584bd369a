//! Dynamic hulls beside the twin on all point families: a long run makes more than 10^6 updates on small sets. Large
//! sets are held to static hulls.

use std::sync::Arc;

use families::drawn::points::{Point, Points};
use families::points::FAMILIES;
use proptest::collection::vec;
use proptest::prelude::*;
use zonotope::arrangement::dynamic_hull::brute_force::BruteForce;
use zonotope::arrangement::dynamic_hull::{
    Direction, DynamicChain, HullChain, PlanarPoint, Side, SiteIndex, SortedSites, Towards,
};
use zonotope::hull;

/// Of each of twelve families, on each of two chains, with [`UPDATES`] each: 10^6 updates and some.
const CASES: u32 = 720;
const UPDATES: usize = 60;
const LARGE: usize = 1500;

/// Points, and the sites to be inserted or deleted by turns, with a direction each.
type Instance = (Vec<Point>, Vec<(prop::sample::Index, Point)>);

/// Two sets of a family, so that there are points enough, and some of them far from the others.
fn updates(points: Points) -> impl Strategy<Value = Instance> {
    let slanted = || (-1.0..1.0f64, 0.0..1.0f64).prop_map(|(x, y)| [x, y]);
    let direction = || prop_oneof![slanted(), (-2..3i32).prop_map(|x| [f64::from(x), 1.0])];
    let sites = (points.clone(), points).prop_map(|(points, others)| [points, others].concat());
    (sites, vec((any::<prop::sample::Index>(), direction()), UPDATES))
}

/// The points as sites, and the same sorted.
fn sites(points: &[Point]) -> (Vec<PlanarPoint>, Arc<SortedSites<PlanarPoint>>) {
    let sites = PlanarPoint::list(points).expect("the families are finite");
    let sorted = Arc::new(SortedSites::new(&sites).expect("the families are small"));
    (sites, sorted)
}

/// Every other site, which is present at first.
fn start(points: &[Point]) -> impl Iterator<Item = SiteIndex> + use<> {
    (0..points.len() as u32).step_by(2).map(SiteIndex)
}

/// Inserts a site that is absent, deletes one that is present.
fn toggle(chain: &mut impl HullChain<PlanarPoint>, site: SiteIndex) {
    let outcome = if chain.contains(site) { chain.delete(site) } else { chain.insert(site) };
    outcome.expect("the site is absent when it is inserted and present when it is deleted");
}

fn agrees((points, updates): Instance) -> Result<(), TestCaseError> {
    let (sites, sorted) = sites(&points);
    for side in [Side::Lower, Side::Upper] {
        let mut chain = DynamicChain::new(sorted.clone(), side, start(&points)).expect("no index is repeated");
        let mut truth = BruteForce::new(sorted.clone(), side, start(&points)).expect("no index is repeated");
        for (number, (index, vector)) in updates.iter().enumerate() {
            let site = SiteIndex(index.index(sites.len()) as u32);
            let from = &sites[(number + site.position()) % sites.len()];
            let towards = if number % 2 == 0 { Towards::Left } else { Towards::Right };
            let direction = Direction::new(*vector).ok();
            toggle(&mut chain, site);
            toggle(&mut truth, site);
            prop_assert_eq!(chain.tangent(from, towards), truth.tangent(from, towards), "{:?}, {}", side, number);
            if let Some(direction) = direction {
                prop_assert_eq!(chain.extreme(direction), truth.extreme(direction), "{:?}, {}", side, number);
            }
            if number.is_multiple_of(6) {
                prop_assert_eq!(chain.vertices(), truth.vertices(), "{:?}, {}", side, number);
            }
        }
    }
    Ok(())
}

tests::test_on_point_families!(updates, CASES, agrees);

/// Both chains together have the vertices of the hull.
#[test]
fn chains_of_large_sets_are_those_of_static_hulls() {
    for family in FAMILIES {
        let points = family.generate(LARGE, 3);
        let (_, sorted) = sites(&points);
        let chain = |side| DynamicChain::new(sorted.clone(), side, start(&points)).expect("no index is repeated");
        let mut chains = [Side::Lower, Side::Upper].map(chain);
        for number in 0..2 * LARGE {
            let site = SiteIndex((number * 7919 % LARGE) as u32);
            chains.iter_mut().for_each(|chain| toggle(chain, site));
            if number % 150 == 149 {
                let present = points.iter().enumerate().filter(|(k, _)| chains[0].contains(SiteIndex(*k as u32)));
                let present: Vec<Point> = present.map(|(_, point)| *point).collect();
                let hull = hull::convex_hull(&present, &mut ()).expect("the points are finite and not none");
                let at = |site: SiteIndex| points[site.position()].map(|c| c + 0.0);
                let mut of_chains: Vec<_> = chains.iter().flat_map(|chain| chain.vertices()).map(at).collect();
                let mut of_hull: Vec<_> = hull.vertices().iter().map(|vertex| vertex.map(|c| c + 0.0)).collect();
                for vertices in [&mut of_chains, &mut of_hull] {
                    vertices.sort_by(|a, b| a.partial_cmp(b).expect("the points are finite"));
                    vertices.dedup();
                }
                assert_eq!(of_chains, of_hull, "{}: update {number}", family.id);
            }
        }
    }
}
