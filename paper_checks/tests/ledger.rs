//! The committed ledger is the generated one, and the catalog is in order.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::LazyLock;

use paper_checks::catalog::{self, CLAIMS};
use paper_checks::{COMMITTED, Check, CheckContext, ClaimResult, Tried, markdown, run};

/// The content of the committed ledger.
static RESULTS: LazyLock<Vec<ClaimResult>> = LazyLock::new(|| run(&CheckContext::default(), |_| ()));

#[test]
fn the_committed_ledger_is_the_generated_one() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("CLAIMS.md");
    let generated = markdown(&RESULTS, COMMITTED);
    if std::env::var_os("ZONOTOPE_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&path, &generated).expect("CLAIMS.md can be written");
    }
    let committed = std::fs::read_to_string(&path).expect("CLAIMS.md is committed");
    for (committed, generated) in committed.lines().zip(generated.lines()) {
        assert_eq!(committed, generated, "CLAIMS.md differs; rewrite it with ZONOTOPE_BLESS=1");
    }
    assert_eq!(committed, generated, "CLAIMS.md has lost or gained lines");
}

#[test]
fn ids_are_unique_and_restatements_resolve() {
    let ids: BTreeSet<&str> = CLAIMS.iter().map(|claim| claim.id).collect();
    assert_eq!(ids.len(), CLAIMS.len());
    for claim in CLAIMS {
        assert!(!claim.statement.is_empty() && !claim.place.label.is_empty(), "{}", claim.id);
        if let Check::Restates(id) = claim.check {
            let original = catalog::find(id).expect("a restated claim is listed");
            assert!(!matches!(original.check, Check::Restates(_)), "{}", claim.id);
        }
    }
}

/// A statement about any dimension was tried in some, which are named.
#[test]
fn claims_about_any_dimension_name_those_that_were_tried() {
    let is_general =
        |text: &str| ["R^d", "^(d-1)", "(d-1)-tuples", "hyper", "d axes"].iter().any(|word| text.contains(word));
    let mut seen = 0;
    for claim in CLAIMS.iter().filter(|claim| is_general(claim.statement)) {
        if let Tried::On(kinds) | Tried::Growth(kinds) = claim.tried {
            assert!(kinds.iter().all(|kind| kind.contains("R^")), "{}: {kinds:?}", claim.id);
            seen += 1;
        }
    }
    assert!(seen > 8, "{seen} claims are about any dimension");
}

#[test]
fn every_claim_file_is_in_the_catalog() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/claims");
    let mut files = 0;
    for section in std::fs::read_dir(folder).expect("the folder exists") {
        let section = section.expect("the folder can be read").path();
        if section.is_dir() {
            files += std::fs::read_dir(section)
                .expect("the section can be read")
                .filter(|file| file.as_ref().is_ok_and(|file| file.file_name() != "mod.rs"))
                .count();
        }
    }
    assert_eq!(files, CLAIMS.len());
}

#[test]
fn verdicts_do_not_hang_on_the_seed() {
    let findings = |results: &[ClaimResult]| -> Vec<_> {
        results.iter().map(|result| (result.claim.id, result.finding())).collect()
    };
    let others = run(&CheckContext { seed: 71, ..CheckContext::default() }, |_| ());
    assert_eq!(findings(&RESULTS), findings(&others));
}
