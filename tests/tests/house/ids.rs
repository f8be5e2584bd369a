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

/// The crate of the claims may not know the figures, so both name each other, and must agree.
#[test]
fn figures_and_claims_name_each_other() {
    for figure in figures::catalog::FIGURES {
        for id in figure.claims {
            let claim = catalog::find(id).unwrap_or_else(|| panic!("{}: there is no claim {id}", figure.id));
            assert!(claim.figures.contains(&figure.id), "the claim {id} does not name its figure {}", figure.id);
        }
        for id in figure.experiments {
            assert!(experiments::catalog::find(id).is_some(), "{}: there is no experiment {id}", figure.id);
        }
    }
    for claim in CLAIMS {
        for id in claim.figures {
            let figure = figures::catalog::find(id).unwrap_or_else(|| panic!("{}: there is no figure {id}", claim.id));
            assert!(figure.claims.contains(&claim.id), "the figure {id} does not name the claim {}", claim.id);
        }
    }
}
