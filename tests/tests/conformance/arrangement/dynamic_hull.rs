//! Dynamic hulls beside the twin on all point families: a long run makes more than 10^6 updates of each method on small
//! sets. On large sets the methods are held to each other, and to the static hull at the end.

use std::sync::Arc;

use families::drawn::points::{Point, Points};
use families::points::FAMILIES;
use proptest::collection::vec;
use proptest::prelude::*;
use zonotope::arrangement::dynamic_hull::{
    Direction, HullChain, Method, PlanarPoint, Side, SiteIndex, SortedSites, Towards,
};
use zonotope::hull;

/// Of each of twelve families, on each of two chains, with [`UPDATES`] each: 10^6 updates and some.
const CASES: u32 = 720;
const UPDATES: usize = 60;
const LARGE: usize = 1500;

/// Points, and the sites to be inserted or deleted by turns, with a direction each.
type Instance = (Vec<Point>, Vec<(prop::sample::Index, Point)>);

type Chain = Box<dyn HullChain<PlanarPoint>>;

/// Two sets of a family, so that there are points enough, and some of them far from the others.
fn updates(points: Points) -> impl Strategy<Value = Instance> {
    let slanted = || (-1.0..1.0f64, 0.0..1.0f64).prop_map(|(x, y)| [x, y]);
    let direction = || prop_oneof![slanted(), (-2..3i32).prop_map(|x| [f64::from(x), 1.0])];
    let sites = (points.clone(), points).prop_map(|(points, others)| [points, others].concat());
    (sites, vec((any::<prop::sample::Index>(), direction()), UPDATES))
}

/// The chains on one side of every method, with every other point present.
fn chains(points: &[Point], side: Side) -> (Vec<PlanarPoint>, Vec<(Method, Chain)>) {
    let sites = PlanarPoint::list(points).expect("the families are finite");
    let sorted = Arc::new(SortedSites::new(&sites).expect("the families are small"));
    let present = || (0..points.len() as u32).step_by(2).map(SiteIndex);
    let chain = |method: Method| method.chain(sorted.clone(), side, present()).expect("no index is repeated");
    (sites, Method::ALL.map(|method| (method, chain(method))).into())
}

/// Inserts a site that is absent, deletes one that is present.
fn toggle(chain: &mut Chain, site: SiteIndex) {
    let outcome = if chain.contains(site) { chain.delete(site) } else { chain.insert(site) };
    outcome.expect("the site is absent when it is inserted and present when it is deleted");
}

fn agrees((points, updates): Instance) -> Result<(), TestCaseError> {
    for side in [Side::Lower, Side::Upper] {
        let (sites, chains) = chains(&points, side);
        let (mut truth, mut others): (Vec<_>, Vec<_>) =
            chains.into_iter().partition(|(method, _)| *method == Method::BruteForce);
        let truth = &mut truth[0].1;
        for (number, (index, vector)) in updates.iter().enumerate() {
            let site = SiteIndex(index.index(sites.len()) as u32);
            let from = &sites[(number + site.position()) % sites.len()];
            let towards = if number % 2 == 0 { Towards::Left } else { Towards::Right };
            let direction = Direction::new(*vector).ok();
            let queries = |chain: &Chain| {
                let vertices = number.is_multiple_of(6).then(|| chain.vertices());
                (chain.tangent(from, towards), direction.map(|direction| chain.extreme(direction)), vertices)
            };
            toggle(truth, site);
            let expected = queries(truth);
            for (method, chain) in &mut others {
                toggle(chain, site);
                prop_assert_eq!(&queries(chain), &expected, "{:?}, {:?}, update {}", method, side, number);
            }
        }
    }
    Ok(())
}

tests::test_on_point_families!(updates, CASES, agrees);

#[test]
fn methods_agree_on_large_sets() {
    for family in FAMILIES {
        let points = family.generate(LARGE, 3);
        for side in [Side::Lower, Side::Upper] {
            let (sites, mut chains) = chains(&points, side);
            chains.retain(|(method, _)| *method != Method::BruteForce);
            for number in 0..2 * LARGE {
                let site = SiteIndex((number * 7919 % LARGE) as u32);
                let from = &sites[number * 104_729 % LARGE];
                let direction = Direction::new([(number % 23) as f64 - 11.0, 5.0]).expect("a direction upward");
                let queries = |chain: &Chain| {
                    let tangents = [Towards::Left, Towards::Right].map(|towards| chain.tangent(from, towards));
                    (tangents, chain.extreme(direction))
                };
                chains.iter_mut().for_each(|(_, chain)| toggle(chain, site));
                let [first, rest @ ..] = &chains[..] else { unreachable!("there is a method") };
                for (method, chain) in rest {
                    assert_eq!(queries(chain), queries(&first.1), "{}: {method:?}, update {number}", family.id);
                }
            }
            let present: Vec<usize> = (0..LARGE).filter(|&k| chains[0].1.contains(SiteIndex(k as u32))).collect();
            let left: Vec<Point> = present.iter().map(|&k| points[k]).collect();
            let hull = hull::convex_hull(&left).expect("the points that are left are finite and not none");
            for (method, chain) in &chains {
                let vertices = chain.vertices();
                let on_hull = |site: &SiteIndex| hull.vertices().contains(&points[site.position()]);
                assert!(vertices.iter().all(on_hull), "{}: {method:?}", family.id);
                assert_eq!(vertices, chains[0].1.vertices(), "{}: {method:?}", family.id);
            }
        }
    }
}
