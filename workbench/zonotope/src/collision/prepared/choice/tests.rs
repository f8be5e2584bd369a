use super::*;
use crate::collision::{Query, Status, by_lad};
use crate::interop::verifier::check_location;
use crate::zonotope::Zonotope;

const SIZES: [u64; 9] = [0, 1, 3, 8, 40, 300, 4096, 1 << 17, 1 << 40];

/// Powers of two and what is next to them.
fn amounts() -> impl Iterator<Item = u64> {
    (0..=62).flat_map(|k| [1u64 << k, (1u64 << k) + (1 << k) / 2]).chain([0, u64::MAX])
}

#[test]
fn more_memory_never_costs_more() {
    for n in SIZES {
        for queries in [0, 1, 50, 10_000, 1 << 33] {
            let mut budgets: Vec<u64> = amounts().collect();
            budgets.sort_unstable();
            let best: Vec<Option<Plan>> = budgets.iter().map(|&b| plans(n, b, queries).first().copied()).collect();
            let totals = best.iter().map(|plan| plan.map_or(f64::INFINITY, |plan| plan.total(queries)));
            assert!(totals.is_sorted_by(|a, b| a >= b), "{n} {queries}");
            assert!(best.iter().zip(budgets).all(|(plan, budget)| plan.is_none_or(|plan| plan.bytes <= budget)));
        }
    }
}

#[test]
fn more_queries_never_choose_a_cheaper_building_or_a_dearer_query() {
    for n in SIZES {
        for budget in [1 << 10, 1 << 20, 1 << 30, u64::MAX] {
            let mut queries: Vec<u64> = amounts().collect();
            queries.sort_unstable();
            let best: Vec<Plan> = queries.iter().filter_map(|&q| plans(n, budget, q).first().copied()).collect();
            assert!(best.is_sorted_by(|a, b| a.build <= b.build && a.query >= b.query), "{n} {budget}");
        }
    }
}

#[test]
fn each_end_is_chosen_somewhere() {
    let first = |n, budget, queries| plans(n, budget, queries)[0].kind;
    assert_eq!(first(1000, u64::MAX, 1), Kind::Rows);
    assert_eq!(first(1 << 20, u64::MAX, 1 << 20), Kind::DirectionTree);
    assert_eq!(first(6, u64::MAX, 1 << 40), Kind::Facets);
    assert!(plans(100, 2400, 9).is_empty());
}

fn body(n: u32) -> Zonotope<3> {
    let number = |i: u32, of: u32| f64::from(i * i % of) / f64::from(of) - 0.4;
    let generators = (1..=n).map(|i| [number(i, 101), number(i, 83), number(i, 61)]);
    Zonotope::new([0.5, 0.0, -1.0], generators.collect()).expect("finite")
}

fn check(structure: &QueryStructure, body: &Zonotope<3>) {
    for i in 0..24u32 {
        let u = [i % 5, i % 7, i % 3].map(|c| f64::from(c) - 1.5);
        let vertex = body.support(u).point();
        let center = body.center();
        let point =
            [0, 1, 2].map(|k| center[k] + [1.0, 0.5, 1.0 - 1e-12, 2.0][i as usize % 4] * (vertex[k] - center[k]));
        let query = Query::of_point(point, body).expect("finite");
        let truth = by_lad::gauge(&query, &mut ());
        let status = truth.location.status();
        assert_eq!(structure.status(point), Ok(status), "{:?}", structure.which());
        assert_eq!(structure.contains(point), Ok(status != Status::Outside));
        let (value, error) = structure.gauge(point).expect("finite");
        assert!(value == truth.value || (value - truth.value).abs() <= error + truth.error);
        let location = structure.locate(point).expect("finite");
        assert_eq!(location.status(), status);
        assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
    }
    assert!(structure.gauge([f64::NAN; 3]).is_err() && structure.contains([f64::INFINITY; 3]).is_err());
}

#[test]
fn every_structure_answers_as_the_kernel_does() {
    for n in [0u32, 2, 7, 40] {
        let body = body(n);
        let space = u64::from(n) * u64::from(n.min(3)).max(1);
        let kinds = [Kind::Rows, Kind::Blocks, Kind::DirectionTree, Kind::Cutting { space }, Kind::Facets];
        for kind in kinds {
            let structure = QueryStructure::of_kind(body.clone(), kind).expect("between n and n²");
            assert_eq!(structure.which(), kind);
            check(&structure, &body);
        }
    }
    let refused = QueryStructure::of_kind(body(5), Kind::Cutting { space: 4 });
    assert!(matches!(refused, Err(ChoiceError::Cutting(_))));
}

#[test]
fn the_budget_is_kept() {
    for n in [1u32, 12, 40, 700, 9000] {
        let body = body(n);
        let alone = QueryStructure::of_kind(body.clone(), Kind::Rows).expect("rows fit every body").bytes();
        for factor in [0, 1, 2, 3, 30, 3000] {
            for queries in [1, 100, 1_000_000] {
                match QueryStructure::new(body.clone(), alone * factor, queries) {
                    Ok(structure) => assert!(factor > 0 && structure.bytes() <= alone * factor),
                    Err(error) => {
                        assert_eq!(error, ChoiceError::TooLittleMemory { budget: alone * factor, needed: alone });
                        assert_eq!(factor, 0);
                    }
                }
            }
        }
    }
}
