use std::collections::BTreeSet;

use clap::Parser;
use experiments::analysis::{FittedGrowth, Range};
use experiments::definition::{Bound, Profile, Quantity};
use experiments::environment::Environment;
use experiments::fit::{GrowthModel, fit_growth};
use experiments::runner::Records;
use paper_checks::{ClaimResult, Finding, Verdict};

use super::*;
use crate::report::chapters::CHAPTERS;

/// A report without records: an empty drawing for every figure, every claim refuted.
fn evidence() -> Evidence {
    let records =
        Records { counts: Vec::new(), times: Vec::new(), environment: Environment::current(), elsewhere: Vec::new() };
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

/// Samples of the bound up and down at every second size, so that they decide nothing.
fn undecided() -> FittedGrowth {
    let samples: Vec<(f64, f64)> =
        (10..=14).map(|log| (f64::from(1 << log), f64::from((1 << log) * (1 + 8 * (log % 2))))).collect();
    FittedGrowth {
        experiment: "hull-scaling",
        family: "disc",
        variant: "by_monotone_chain",
        quantity: Quantity::AllCounts,
        bound: Some(Bound::of_paper(GrowthModel::Linear, "Theorem 0")),
        floor: None,
        range: Range::Whole,
        growth: fit_growth(&samples, &[GrowthModel::Linear]),
        samples,
        left_out: 0,
    }
}

#[test]
fn undecided_bounds_are_listed() {
    let none = report(&evidence());
    assert!(!none.contains("id=\"laws\""));
    let page = report(&Evidence { fits: vec![undecided()], ..evidence() });
    assert!(
        page.contains(
            "<li><a href=\"#experiment-hull-scaling\">hull-scaling</a>: operations of Monotone chain on disc"
        )
    );
    assert!(page.contains("No bound of our own is undecided"));
    assert!(page.contains("growth undecided in 1 of 1 fits"));
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

/// The parts of a page that are to be copied as commands.
fn commands(page: &str) -> Vec<&str> {
    let all = page.split("<code class=\"repeat\">").skip(1);
    all.filter_map(|rest| rest.split_once("</code>")).map(|(command, _)| command).collect()
}

#[test]
fn the_command_of_each_figure_and_experiment_stands_under_it() {
    let mut evidence = evidence();
    let check = |evidence: &Evidence, page: &str, options: &str| {
        let commands = commands(page);
        for command in &commands {
            let words: Vec<&str> = command.strip_prefix("cargo run --release -- ").expect(command).split(' ').collect();
            assert!(crate::cli::Cli::try_parse_from([&["zonobench"], &words[..]].concat()).is_ok(), "{command}");
        }
        for experiment in &evidence.experiments {
            let id = experiment.id;
            let command = format!("cargo run --release -- reproduce --only {id} --out out/{id}{options}");
            let own = page.split(&format!("id=\"experiment-{id}\"")).nth(1).expect(id);
            assert!(self::commands(own).contains(&command.as_str()), "{command}");
        }
        commands.len()
    };
    evidence.seed = crate::report::USUAL_SEED;
    let page = report(&evidence);
    let shown = ::figures::catalog::FIGURES.iter().filter(|figure| figure.deterministic);
    for figure in shown.clone() {
        let own = page.split(&format!("<figure id=\"figure-{}\"", figure.id)).nth(1).expect(figure.id);
        let command = format!("cargo run --release -- figure {0} --svg {0}.svg", figure.id);
        assert_eq!(commands(own).first(), Some(&command.as_str()));
    }
    assert_eq!(check(&evidence, &page, ""), shown.count() + evidence.experiments.len());
    evidence.seed = 7;
    evidence.profile = Profile::Full;
    let page = report(&evidence);
    check(&evidence, &page, " --profile full --seed 7");
    for (id, command) in [
        ("paper-figure-1", "figure paper-figure-1 --svg paper-figure-1.svg"),
        ("country-outlines", "reproduce --only country-outlines --out out/country-outlines --profile full --seed 7"),
    ] {
        let own = page.split(&format!("<figure id=\"figure-{id}\"")).nth(1).expect("a figure");
        assert_eq!(commands(own)[0], format!("cargo run --release -- {command}"));
    }
    evidence.config = Some("my.toml".into());
    assert_eq!(commands(&report(&evidence)), Vec::<&str>::new(), "a part of a changed run has no command of its own");
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
