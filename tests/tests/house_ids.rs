//! Claim, code, experiment, figure: every id that one of them names exists.

use paper_checks::catalog::{self, CLAIMS};
use tests::sources::{LIBRARY, root};

#[test]
fn code_of_claims_exists() {
    for claim in CLAIMS {
        for path in claim.code {
            let mut parts = path.split("::");
            assert_eq!(parts.next(), Some("zonotope"), "{}: {path}", claim.id);
            let module = root().join(LIBRARY).join(parts.collect::<Vec<_>>().join("/"));
            assert!(
                module.join("mod.rs").is_file() || module.with_extension("rs").is_file(),
                "{}: there is no module {path}",
                claim.id
            );
        }
    }
}

#[test]
fn checked_claims_name_their_code() {
    for claim in CLAIMS {
        if matches!(claim.check, paper_checks::Check::Run(_)) {
            assert!(!claim.code.is_empty(), "{}", claim.id);
        }
    }
}

#[test]
fn claims_of_experiments_exist() {
    for experiment in experiments::catalog::EXPERIMENTS {
        for id in experiment.claims {
            assert!(catalog::find(id).is_some(), "{}: there is no claim {id}", experiment.id);
        }
    }
}
