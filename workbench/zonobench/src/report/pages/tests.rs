use std::collections::BTreeSet;

use experiments::definition::Profile;
use experiments::environment::Environment;
use experiments::runner::Records;
use paper_checks::{ClaimResult, Finding, Verdict};

use super::*;
use crate::report::chapters::CHAPTERS;

/// A report without records: an empty drawing for every figure, every claim refuted.
fn evidence() -> Evidence {
    let records = Records { counts: Vec::new(), times: Vec::new(), environment: Environment::current() };
    let refuted = |&claim| ClaimResult { claim, verdict: Some(Verdict::Refuted("a witness".to_owned())) };
    let drawn = |figure| DrawnFigure { figure, drawing: Ok("<svg width=\"9\" height=\"9\"></svg>".to_owned()) };
    Evidence {
        profile: Profile::Quick,
        seed: 1,
        only: Vec::new(),
        config: None,
        experiments: ::experiments::catalog::EXPERIMENTS.iter().collect(),
        records,
        fits: Vec::new(),
        figures: ::figures::catalog::FIGURES.iter().map(drawn).collect(),
        claims: paper_checks::catalog::CLAIMS.iter().map(refuted).collect(),
    }
}

/// The values of an attribute, in their order.
fn values<'a>(page: &'a str, attribute: &str) -> Vec<&'a str> {
    let opening = format!(" {attribute}=\"");
    page.split(&opening).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

#[test]
fn links_within_a_page_lead_somewhere_and_anchors_are_unique() {
    let evidence = evidence();
    for page in [report(&evidence), times(&evidence)] {
        let anchors: BTreeSet<&str> = values(&page, "id").into_iter().collect();
        assert_eq!(anchors.len(), values(&page, "id").len());
        for link in values(&page, "href").into_iter().filter_map(|link| link.strip_prefix('#')) {
            assert!(anchors.contains(link), "#{link}");
        }
    }
    let (report, times) = (report(&evidence), times(&evidence));
    for link in values(&report, "href").into_iter().filter_map(|link| link.strip_prefix("times.html#")) {
        assert!(values(&times, "id").contains(&link), "times.html#{link}");
    }
}

#[test]
fn figures_are_numbered_through_the_page() {
    let page = report(&evidence());
    let captions = page.split("<figcaption><b>Figure ").skip(1);
    let numbers: Vec<usize> =
        captions.map(|rest| rest.split('.').next().and_then(|digits| digits.parse().ok()).expect("a number")).collect();
    let shown = ::figures::catalog::FIGURES.iter().filter(|figure| figure.deterministic).count();
    assert_eq!(numbers, (1..=shown).collect::<Vec<_>>());
}

#[test]
fn every_claim_is_told_once_and_corrections_by_their_sort() {
    let evidence = evidence();
    let page = report(&evidence);
    for result in &evidence.claims {
        let anchor = format!("id=\"claim-{}\"", result.claim.id);
        assert_eq!(page.matches(&anchor).count(), 1, "{}", result.claim.id);
    }
    for finding in [Finding::Erratum, Finding::MissingCondition, Finding::Restated, Finding::Refuted] {
        assert!(evidence.claims.iter().any(|result| result.finding() == finding), "{finding:?}");
        let told = format!(">{}</span> {}", finding.words(), finding.meaning());
        assert!(page.contains(&told), "{finding:?}");
    }
}

#[test]
fn pictures_of_chapters_are_figures_that_need_no_clock() {
    let mut seen = BTreeSet::new();
    for chapter in CHAPTERS {
        assert!(!chapter.pictures.is_empty(), "{}", chapter.id);
        for id in chapter.pictures {
            let figure = ::figures::catalog::find(id).unwrap_or_else(|| panic!("{}: no figure {id}", chapter.id));
            assert!(figure.deterministic && seen.insert(id), "{}: {id}", chapter.id);
        }
    }
}
