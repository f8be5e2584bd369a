//! The structure for repeated queries that is chosen, and all facets, against answers that are known before any method
//! is asked, on all families; every proof is verified and every budget kept.

use experiments::question::{PLACEMENTS, Question};
use families::bodies::BODY_FAMILIES;
use families::drawn::bodies::families;
use proptest::prelude::*;
use tests::body_questions::{Asked, asked};
use tests::runner::{cases, for_all};
use zonotope::Zonotope;
use zonotope::collision::prepared::choice::Kind;
use zonotope::collision::prepared::{PreparedByFacets, QueryStructure};
use zonotope::collision::{Gauge, Query, brute_force, by_lad};
use zonotope::interop::verifier::check_location;

/// The bodies of a long run for each of the eleven families and each size; each is asked about eleven placements.
const BODIES: u32 = 16;

/// The questions of a long run for each of the fourteen families that reach the ends of the doubles.
const CASES: u32 = 300;

/// The structure answers as the truth does, with a proof.
fn agrees(structure: &QueryStructure, query: &Query<'_, 3>, truth: &Gauge<3>) -> Result<(), TestCaseError> {
    let (kind, status) = (structure.which(), truth.location.status());
    prop_assert_eq!(structure.status(query.to()), Ok(status), "{:?}", kind);
    prop_assert_eq!(structure.contains(query.to()), Ok(truth.location.is_member()), "{:?}", kind);
    let (value, error) = structure.gauge(query.to()).expect("finite");
    let is_near = value == truth.value || (value - truth.value).abs() <= error + truth.error;
    prop_assert!(is_near, "{:?}: {} ± {}, not {} ± {}", kind, value, error, truth.value, truth.error);
    let location = structure.locate(query.to()).expect("finite");
    prop_assert_eq!(location.status(), status, "{:?}", kind);
    prop_assert_eq!(check_location(query, &location).proof().map(drop), Ok(()), "{:?}", kind);
    Ok(())
}

#[test]
fn all_facets_answer_as_the_truth_does() {
    for (family, generators) in families::<3>(7) {
        for_all(&asked(generators), CASES, |asked| {
            let Asked { from, to, generators } = asked;
            let body = Zonotope::new(from, generators).expect("finite");
            let query = Query::of_point(to, &body).expect("finite");
            let facets = QueryStructure::of_kind(body.clone(), Kind::Facets).expect("facets have no requirements");
            agrees(&facets, &query, &brute_force::gauge(&query))
                .map_err(|error| TestCaseError::fail(format!("{family}: {error}")))
        });
    }
}

#[test]
fn what_is_chosen_answers_as_the_truth_does_within_its_budget() {
    for family in BODY_FAMILIES {
        for (n, budget, queries) in [(10, 1 << 12, 1 << 20), (60, 1 << 11, 9), (60, 1 << 13, 99), (900, 1 << 17, 500)] {
            for seed in 0..u64::from(cases(BODIES)) {
                for placement in PLACEMENTS {
                    let Some(asked) = Question::about(family.generate(n, seed), placement, seed) else { continue };
                    let body = Zonotope::new(asked.from, asked.generators.clone()).expect("finite");
                    let query = Query::of_point(asked.to, &body).expect("finite");
                    let structure = QueryStructure::new(body.clone(), budget, queries).expect("the body fits");
                    assert!(structure.bytes() <= budget);
                    let truth = by_lad::gauge(&query, &mut ());
                    assert_eq!(truth.location.status().name(), asked.status);
                    let answer = agrees(&structure, &query, &truth);
                    assert!(answer.is_ok(), "{} {n} {seed} {}: {answer:?}", family.id, placement.id);
                }
            }
        }
    }
    let flat = PreparedByFacets::new(Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0]; 5]).expect("finite"));
    assert_eq!(flat.facet_count(), 0);
}
