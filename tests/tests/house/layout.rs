//! The layout of the house: which crate may use which, how long files are, what they are called.

use std::collections::{BTreeMap, BTreeSet};

use tests::sources::{LIBRARY, Source, files, root};

/// The crates from the bottom up; a crate may use those of the levels below its own.
const LEVELS: [&[&str]; 7] = [
    &["families", "verifier"],
    &["zonotope"],
    &["rivals"],
    &["experiments", "batch"],
    &["figures", "paper_checks", "peers"],
    &["zonobench"],
    &["tests"],
];

const FOLDERS: [&str; 11] = [
    "workbench/zonotope",
    "workbench/verifier",
    "workbench/batch",
    "workbench/zonobench",
    "experiments",
    "experiments/families",
    "experiments/peers",
    "experiments/rivals",
    "figures",
    "paper_checks",
    "tests",
];

fn level(name: &str) -> Option<usize> {
    LEVELS.iter().position(|crates| crates.contains(&name))
}

#[test]
fn dependencies_point_down() {
    let mut seen = BTreeSet::new();
    for folder in FOLDERS {
        let text = std::fs::read_to_string(root().join(folder).join("Cargo.toml")).expect("a member has a manifest");
        let manifest: toml::Table = text.parse().expect("a manifest is TOML");
        // others name a library by its crate, which a registry may know by another name
        let named = manifest.get("lib").and_then(|lib| lib.get("name")).unwrap_or(&manifest["package"]["name"]);
        let name = named.as_str().expect("a package has a name").to_owned();
        let own = level(&name).expect("every member has its level");
        for table in ["dependencies", "dev-dependencies", "build-dependencies"] {
            let Some(dependencies) = manifest.get(table).and_then(toml::Value::as_table) else { continue };
            for dependency in dependencies.keys() {
                if let Some(other) = level(dependency) {
                    assert!(other < own, "{name} must not depend on {dependency}");
                }
            }
        }
        seen.insert(name);
    }
    assert_eq!(seen.len(), LEVELS.iter().map(|crates| crates.len()).sum::<usize>());
}

/// The library hands its answers to the verifier where a caller asks for that, and does without in everything else.
#[test]
fn the_library_builds_without_the_verifier() {
    let text = std::fs::read_to_string(root().join("workbench/zonotope/Cargo.toml")).expect("a member has a manifest");
    let manifest: toml::Table = text.parse().expect("a manifest is TOML");
    assert_eq!(manifest["dependencies"]["verifier"].get("optional"), Some(&toml::Value::Boolean(true)));
    assert_eq!(manifest["features"]["default"], toml::Value::Array(Vec::new()));
    let names_it = |source: &Source| source.code_lines().any(|(_, line)| line.contains("verifier::"));
    let others: Vec<String> = files(LIBRARY, &[".rs"])
        .into_iter()
        .filter(|source| !source.is_test() && !source.path.contains("/interop/") && names_it(source))
        .map(|source| source.path)
        .collect();
    assert!(others.is_empty(), "{others:?} name the verifier");
}

#[test]
fn members_are_in_the_five_folders() {
    let text = std::fs::read_to_string(root().join("Cargo.toml")).expect("the workspace has a manifest");
    let manifest: toml::Table = text.parse().expect("a manifest is TOML");
    let members = manifest["workspace"]["members"].as_array().expect("the workspace has members");
    let members: BTreeSet<&str> = members.iter().filter_map(toml::Value::as_str).collect();
    assert_eq!(members, FOLDERS.into_iter().collect());
}

#[test]
fn no_source_file_is_longer_than_400_lines() {
    let long: Vec<String> = files("", &[".rs"])
        .iter()
        .map(|source| (source.text.lines().count(), &source.path))
        .filter(|(lines, _)| *lines > 400)
        .map(|(lines, path)| format!("{path}: {lines}"))
        .collect();
    assert!(long.is_empty(), "{long:#?}");
}

/// A catalog is a folder of equal entries: however many there are, a reader looks up one. Its entries are those that
/// the `catalog.rs` of its crate lists; all other files count.
#[test]
fn no_folder_has_more_than_14_source_files_without_stages() {
    const CATALOGS: [(&str, &str); 3] = [
        ("experiments/src/definitions", "experiments/src/catalog.rs"),
        ("figures/src/gallery", "figures/src/catalog.rs"),
        ("paper_checks/src/claims", "paper_checks/src/catalog.rs"),
    ];
    let sources = files("", &[".rs"]);
    let text_of = |path: &str| sources.iter().find(|source| source.path == path).map(|source| source.text.as_str());
    let is_entry = |folder: &str, stem: &str| {
        CATALOGS.iter().filter(|(catalog, _)| folder.starts_with(catalog)).any(|(_, list)| {
            let entries = text_of(list).expect("a catalog has its list").lines();
            let modules = entries.filter_map(|line| line.trim().trim_start_matches('&').rsplit_once("::"));
            modules.filter_map(|(path, _)| path.rsplit("::").next()).any(|module| module == stem)
        })
    };
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for source in &sources {
        let (folder, name) = source.path.rsplit_once('/').unwrap_or(("", &source.path));
        if !is_entry(folder, name.trim_end_matches(".rs")) {
            *counts.entry(folder).or_default() += 1;
        }
    }
    assert_eq!(counts["figures/src/gallery"], 1, "entries are recognised; `mod.rs` is none");
    let crowded: Vec<_> = counts.into_iter().filter(|(_, count)| *count > 14).collect();
    assert!(crowded.is_empty(), "{crowded:?}");
}

#[test]
fn names_say_what_is_inside() {
    const EMPTY_WORDS: [&str; 6] = ["util", "utils", "helper", "helpers", "misc", "common"];
    for source in files("", &[".rs"]) {
        for part in source.path.trim_end_matches(".rs").split(['/', '_']) {
            assert!(!EMPTY_WORDS.contains(&part), "{}", source.path);
        }
    }
}

/// A file that no `mod` names is not compiled, and no other test would notice.
#[test]
fn every_source_file_is_part_of_its_crate() {
    let sources = files("", &[".rs"]);
    let texts: BTreeMap<&str, &str> =
        sources.iter().map(|source| (source.path.as_str(), source.text.as_str())).collect();
    for source in &sources {
        let (folder, name) = source.path.rsplit_once('/').unwrap_or(("", &source.path));
        let is_root = ["lib.rs", "main.rs", "build.rs"].contains(&name)
            || folder.ends_with("/bin")
            || folder.ends_with("/examples")
            || folder.ends_with("/benches")
            || folder.ends_with("/fuzz_targets")
            || FOLDERS.iter().any(|member| folder == format!("{member}/tests"));
        if is_root {
            continue;
        }
        let (module, home) = match name.strip_suffix(".rs") {
            Some("mod") => {
                let (parent, module) = folder.rsplit_once('/').expect("a module folder is in a folder");
                (module, parent)
            }
            Some(stem) => (stem, folder),
            None => continue,
        };
        let parents =
            [format!("{home}/mod.rs"), format!("{home}/lib.rs"), format!("{home}/main.rs"), format!("{home}.rs")];
        let declaration = format!("mod {module};");
        let declared = parents
            .iter()
            .filter_map(|parent| texts.get(parent.as_str()))
            .any(|text| text.lines().any(|line| line.trim_start().trim_start_matches("pub").contains(&declaration)));
        assert!(declared, "{}: none of {parents:?} says `{declaration}`", source.path);
    }
}

#[test]
fn a_problem_names_its_methods() {
    for source in files(LIBRARY, &[".rs"]) {
        let name = source.name().trim_end_matches(".rs").to_owned();
        let is_method = name.starts_with("by_") || name == "brute_force";
        if !is_method {
            continue;
        }
        let folder = source.path.rsplit_once('/').expect("a method is in a folder").0;
        let problem = files(folder, &["mod.rs"]).into_iter().find(|file| file.path == format!("{folder}/mod.rs"));
        let problem = problem.unwrap_or_else(|| panic!("{folder} has no mod.rs that states the problem"));
        assert!(
            problem.text.contains(&format!("[`{name}`]")),
            "{}: its table of methods leaves out {name}",
            problem.path
        );
    }
}
