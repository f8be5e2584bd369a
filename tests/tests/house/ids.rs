//! Claim, code, experiment, figure: every id that one of them names exists.

use paper_checks::catalog::{self, CLAIMS};
use tests::sources::{LIBRARY, files, root};

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

/// The kinds of question about a problem, and the names of the methods in the problem's registry, by its folder.
fn registries() -> Vec<(&'static str, &'static [&'static str], Vec<&'static str>)> {
    use zonotope::arrangement::{facet_walk, separator, slope_selection};
    use zonotope::collision::{self, upper_hull};
    use zonotope::enclosing::{fixed_directions, min_area_zonogon, min_total_length};
    use zonotope::reduction;
    vec![
        ("arrangement/separator", &["separator"], separator::Method::ALL.map(separator::Method::id).to_vec()),
        // of a single step a pass over the generators is the quickest; the other methods prepare for many
        ("arrangement/facet_walk", &["walk"], vec![facet_walk::Method::ByScan.id()]),
        (
            "arrangement/slope_selection",
            &["slope_selection"],
            slope_selection::Method::ALL.map(slope_selection::Method::id).to_vec(),
        ),
        ("collision/upper_hull", &["upper_hull"], upper_hull::Method::ALL.map(upper_hull::Method::id).to_vec()),
        (
            "enclosing/min_area_zonogon",
            &["min_area"],
            min_area_zonogon::Method::ALL.map(min_area_zonogon::Method::id).to_vec(),
        ),
        (
            "enclosing/fixed_directions",
            &["min_length_dirs"],
            fixed_directions::Method::ALL.map(fixed_directions::Method::id).to_vec(),
        ),
        (
            "enclosing/min_total_length",
            &["min_length_all"],
            min_total_length::Method::ALL.map(min_total_length::Method::id).to_vec(),
        ),
        // the truth in rationals knows the distance, and proves nothing
        ("collision/distance", &["distance"], vec![collision::distance::Method::default().id()]),
        (
            "motion/continuous",
            &["collide"],
            zonotope::motion::continuous::Method::ALL.map(zonotope::motion::continuous::Method::id).to_vec(),
        ),
        (
            "motion/space_time",
            &["sweep"],
            zonotope::motion::space_time::Method::ALL.map(zonotope::motion::space_time::Method::id).to_vec(),
        ),
        ("bvh", &["mesh", "mesh_level"], zonotope::bvh::Method::ALL.map(zonotope::bvh::Method::id).to_vec()),
        ("reduction", &["reduce"], reduction::Method::ALL.map(reduction::Method::id).to_vec()),
        (
            "collision/doors",
            &["member", "intersect", "gauge"],
            collision::Method::ALL.iter().map(|method| method.id()).collect(),
        ),
    ]
}

/// Stages of other problems, and a problem of which a batch has no kind of question: none asks for them alone.
const REGISTRIES_OF_STAGES: [&str; 2] = ["hull", "lad/of_lines"];

/// `list methods` prints the methods of the kinds: those of the registries, the default first, and no others.
#[test]
fn the_program_lists_the_methods_of_the_registries() {
    for (folder, kinds, methods) in registries() {
        let mut listed: Vec<&str> = Vec::new();
        for name in kinds {
            let kind = batch::KINDS.iter().find(|kind| kind.name == *name);
            let kind = kind.unwrap_or_else(|| panic!("{folder}: there is no kind of question {name}"));
            listed.extend((kind.methods)());
        }
        let places: Vec<_> = methods.iter().map(|id| listed.iter().position(|other| other == id)).collect();
        assert!(places.iter().all(Option::is_some), "{folder}: {methods:?}, but {listed:?} are listed");
        assert!(
            listed.iter().all(|id| methods.contains(id)),
            "{folder}: {listed:?} are listed, but it has {methods:?}"
        );
        assert_eq!(listed.first(), methods.first(), "{folder}: the default is not listed first");
    }
}

/// A registry that the test above does not know would not be looked at.
#[test]
fn every_registry_of_methods_is_known() {
    let asked = registries();
    let asked = asked.iter().map(|registry| registry.0);
    let known: Vec<&str> = asked.chain(REGISTRIES_OF_STAGES).collect();
    for source in files(LIBRARY, &["method.rs"]) {
        let place = source.path.strip_prefix(LIBRARY).and_then(|path| path.strip_prefix('/'));
        if let Some(folder) = place.and_then(|path| path.strip_suffix("/method.rs")) {
            assert!(known.contains(&folder), "{folder}/method.rs: no kind of question lists its methods");
        }
    }
}
