//! The tree of bridges beside the twin on small sets, a walk over an arrangement, growth of the counts, memory.

mod growth;
mod walk;

use std::sync::Arc;

use proptest::prelude::*;

use super::brute_force::BruteForce;
use super::*;
use crate::numeric::non_finite::NonFinite;

fn sorted<S: Site>(sites: &[S]) -> Arc<SortedSites<S>> {
    Arc::new(SortedSites::new(sites).expect("the test has not that many sites"))
}

fn planar(points: &[[f64; 2]]) -> Vec<PlanarPoint> {
    PlanarPoint::list(points).expect("the points are finite")
}

/// One chain by the tree of bridges and the same by the twin.
fn chains<S: Site + 'static>(
    sites: &Arc<SortedSites<S>>,
    side: Side,
    present: impl IntoIterator<Item = SiteIndex> + Clone,
) -> Result<[Box<dyn HullChain<S>>; 2], UpdateError> {
    Ok([
        Box::new(DynamicChain::new(sites.clone(), side, present.clone())?),
        Box::new(BruteForce::new(sites.clone(), side, present)?),
    ])
}

/// Updates and queries of the tree of bridges beside those of the twin, on one chain.
fn check<S: Site + 'static>(
    sites: &[S],
    side: Side,
    steps: &[(bool, u32)],
    directions: &[Direction],
) -> Result<(), TestCaseError> {
    let (sorted, count) = (sorted(sites), sites.len() as u32);
    let start: Vec<SiteIndex> = (0..count).step_by(3).map(SiteIndex).collect();
    let [mut chain, mut truth] = chains(&sorted, side, start).expect("distinct indices");
    for &(is_insertion, number) in steps {
        // one index of them is unknown
        let site = SiteIndex(number % (count + 1));
        let update = |chain: &mut dyn HullChain<S>| if is_insertion { chain.insert(site) } else { chain.delete(site) };
        let outcome = update(truth.as_mut());
        let extremes = |chain: &dyn HullChain<S>| directions.iter().map(|&d| chain.extreme(d)).collect::<Vec<_>>();
        let from = sites.get((number / 64) as usize % sites.len().max(1));
        let tangents = |chain: &dyn HullChain<S>| {
            from.map(|from| [Towards::Left, Towards::Right].map(|towards| chain.tangent(from, towards)))
        };
        prop_assert_eq!(update(chain.as_mut()), outcome);
        prop_assert_eq!((chain.len(), chain.contains(site)), (truth.len(), truth.contains(site)));
        prop_assert_eq!(chain.vertices(), truth.vertices(), "{:?}", side);
        prop_assert_eq!(extremes(chain.as_ref()), extremes(truth.as_ref()), "{:?}", side);
        prop_assert_eq!(tangents(chain.as_ref()), tangents(truth.as_ref()), "{:?} {:?}", side, from);
    }
    Ok(())
}

fn coordinate() -> impl Strategy<Value = f64> {
    let ends = vec![0.0, -0.0, 5e-324, -5e-324, 1e308, -1e308, f64::MAX, f64::MIN, 1e-300];
    prop_oneof![4 => (-2i32..3).prop_map(f64::from), 3 => -1.0..1.0f64, 1 => prop::sample::select(ends)]
}

fn points() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let lattice = || (-2i32..3).prop_map(f64::from);
    let on_circle = |k: u32| {
        let (sine, cosine) = libm::sincos(f64::from(k) * std::f64::consts::TAU / 12.0);
        [cosine, sine]
    };
    let along =
        |point: fn(f64) -> [f64; 2]| prop::collection::vec((-5i32..6).prop_map(f64::from).prop_map(point), 0..25);
    prop_oneof![
        prop::collection::vec([coordinate(), coordinate()], 0..30),
        prop::collection::vec([-1.0..1.0f64, -1.0..1.0f64], 0..30),
        prop::collection::vec([lattice(), lattice()], 0..30),
        prop::collection::vec((0u32..12).prop_map(on_circle), 0..30),
        along(|k| [k * 0.1, k * 0.3]),
        along(|k| [k, k * k]),
        along(|k| [1.0, k]),
    ]
}

fn steps() -> impl Strategy<Value = Vec<(bool, u32)>> {
    prop::collection::vec(any::<(bool, u32)>(), 0..40)
}

fn directions() -> impl Strategy<Value = Vec<Direction>> {
    let directions = prop::collection::vec([coordinate(), coordinate()], 4);
    directions.prop_map(|vectors| vectors.into_iter().filter_map(|vector| Direction::new(vector).ok()).collect())
}

properties! {
    #![proptest_config(crate::property_cases::config(300))]

    #[test]
    fn the_twin_agrees_on_points(points in points(), steps in steps(), directions in directions()) {
        for side in [Side::Lower, Side::Upper] {
            check(&planar(&points), side, &steps, &directions)?;
        }
    }

    #[test]
    fn the_twin_agrees_on_lines(
        rows in prop::collection::vec([coordinate(), coordinate(), coordinate()], 0..30),
        steps in steps(),
        directions in directions(),
    ) {
        let lines: Vec<SlopedLine> = rows.into_iter().filter_map(|row| SlopedLine::new(row).ok()).collect();
        for side in [Side::Lower, Side::Upper] {
            check(&lines, side, &steps, &directions)?;
        }
    }

    #[test]
    fn both_chains_of_the_twin_are_the_hull(points in points()) {
        let (sites, all) = (planar(&points), (0..points.len() as u32).map(SiteIndex));
        let chain = |side| BruteForce::new(sorted(&sites), side, all.clone()).expect("distinct indices");
        let [lower, upper] = [Side::Lower, Side::Upper].map(|side| chain(side).vertices());
        let around = lower.iter().chain(upper.iter().rev().skip(1)).map(|site| site.position());
        let truth = crate::hull::convex_hull(&points, &mut ()).map(|hull| {
            hull.indices().iter().map(|index| index.get()).collect::<Vec<_>>()
        });
        let turns = if lower.len() > 1 { lower.len() + upper.len() - 2 } else { lower.len() };
        prop_assert_eq!(around.take(turns).collect::<Vec<_>>(), truth.unwrap_or_default());
    }
}

#[test]
fn a_line_meets_an_envelope_where_hand_and_eye_say() {
    // y = |x| is the upper envelope of y = x and y = −x; y = 1 is above it from −1 to 1, y = −1 nowhere, y = 2 x − 1
    // from 1 on, as it is steeper than both
    let [rising, falling] = [[1.0, -1.0, 0.0], [-1.0, -1.0, 0.0]];
    let lines = [rising, falling].map(|row| SlopedLine::new(row).expect("a line with a slope"));
    let line = |row: [f64; 3]| SlopedLine::new(row).expect("a line with a slope");
    for chain in chains(&sorted(&lines), Side::Upper, [0, 1].map(SiteIndex)).expect("distinct indices") {
        let ends = |row| [Towards::Left, Towards::Right].map(|towards| chain.tangent(&line(row), towards));
        assert_eq!(ends([0.0, 1.0, -1.0]), [1, 0].map(|k| Tangent::Touches(SiteIndex(k))));
        assert_eq!(ends([0.0, 1.0, 1.0]), [Tangent::Hidden; 2]);
        assert_eq!(ends([2.0, -1.0, -1.0]), [Tangent::Touches(SiteIndex(0)), Tangent::Unbounded]);
        let at = |x| chain.extreme(Direction::at_abscissa(x).expect("a finite abscissa"));
        assert_eq!([at(-3.0), at(0.0), at(3.0)], [1, 1, 0].map(|k| Some(SiteIndex(k))));
    }
}

#[test]
fn what_is_refused() {
    let sites = planar(&[[0.0, 0.0], [1.0, 1.0]]);
    let repeated = [1, 1].map(SiteIndex);
    let refusal = Some(UpdateError::Present(SiteIndex(1)));
    assert_eq!(DynamicChain::new(sorted(&sites), Side::Lower, repeated).err(), refusal);
    assert_eq!(BruteForce::new(sorted(&sites), Side::Lower, repeated).err(), refusal);
    for mut chain in chains(&sorted(&sites), Side::Lower, [SiteIndex(1)]).expect("one index") {
        assert_eq!(chain.insert(SiteIndex(1)), Err(UpdateError::Present(SiteIndex(1))));
        assert_eq!(chain.delete(SiteIndex(0)), Err(UpdateError::Absent(SiteIndex(0))));
        let unknown = Err(UpdateError::Unknown { site: SiteIndex(2), count: 2 });
        assert_eq!((chain.insert(SiteIndex(2)), chain.delete(SiteIndex(2))), (unknown, unknown));
        assert_eq!(chain.vertices(), [SiteIndex(1)]);
    }
    assert!(matches!(PlanarPoint::new([0.0, f64::NAN]), Err(NonFinite { .. })));
    assert!(PlanarPoint::list(&[[0.0, 0.0], [f64::INFINITY, 0.0]]).is_err());
    assert_eq!(SlopedLine::new([1.0, 0.0, 1.0]), Err(SlopedLineError::Vertical));
    assert!(matches!(SlopedLine::new([1.0, f64::NAN, 1.0]), Err(SlopedLineError::NonFinite(_))));
    assert_eq!(Direction::new([1.0, -0.0]), Err(DirectionError::NotUpward { ordinate: -0.0 }));
    assert!(matches!(Direction::at_abscissa(f64::NAN), Err(DirectionError::NonFinite(_))));
}
