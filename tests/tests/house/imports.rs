//! No circle of imports between files: what a file rests on can be read without it.
//!
//! Facades apart (`mod.rs`, `lib.rs`, `main.rs`): they declare and re-export, and every file may name what its folder
//! offers.

use std::collections::{BTreeMap, BTreeSet};

use tests::sources::{Source, files};

const CRATES: [&str; 7] = [
    "workbench/zonotope/src",
    "workbench/verifier/src",
    "workbench/batch/src",
    "workbench/zonobench/src",
    "experiments/src",
    "figures/src",
    "paper_checks/src",
];

/// Folders in which there are circles still, to be mended; a folder without one is taken off the list.
const WITH_CIRCLES: [&str; 0] = [];

/// The path of a module, from the crate's root.
type Module = Vec<String>;

fn module(path: &str) -> Module {
    let mut parts: Module = path.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
    if is_facade(path) {
        parts.pop();
    }
    parts
}

fn is_facade(path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path);
    ["mod.rs", "lib.rs", "main.rs"].contains(&name)
}

/// `a::{b, c::{d}}` as `a::b` and `a::c::d`.
fn expanded(tree: &str) -> Vec<String> {
    let tree = tree.trim();
    let Some((head, body)) = tree.strip_suffix('}').and_then(|tree| tree.split_once('{')) else {
        return vec![tree.split(" as ").next().unwrap_or_default().trim().to_owned()];
    };
    let (mut paths, mut depth, mut start) = (Vec::new(), 0, 0);
    for (at, letter) in body.char_indices().chain([(body.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                paths.extend(expanded(&body[start..at]).into_iter().map(|path| format!("{head}{path}")));
                start = at + 1;
            }
            _ => {}
        }
    }
    paths
}

/// The paths that a file imports outside its unit tests.
fn imports(source: &Source) -> Vec<String> {
    let code: Vec<&str> = source.code_lines().map(|(_, line)| line.split("//").next().unwrap_or(line)).collect();
    let code = code.join(" ");
    let mut found = Vec::new();
    for statement in code.split(';') {
        let Some(at) = statement.rfind("use ") else { continue };
        let before = statement[..at].trim_end();
        if before.is_empty() || before.ends_with(['}', '{', ']', ')']) || before.ends_with("pub") {
            found.extend(expanded(&statement[at + 4..]));
        }
    }
    found
}

/// The module that an imported path begins in, of those that are files.
fn origin(path: &str, own: &Module, modules: &BTreeMap<Module, String>) -> Option<Module> {
    let mut parts: Vec<&str> = path.split("::").map(str::trim).filter(|part| !part.is_empty()).collect();
    let mut base: Module = match *parts.first()? {
        "crate" => {
            parts.remove(0);
            Vec::new()
        }
        "self" => {
            parts.remove(0);
            own.clone()
        }
        "super" => own.clone(),
        first => {
            let child: Module = own.iter().cloned().chain([first.to_owned()]).collect();
            modules.contains_key(&child).then(|| own.clone())?
        }
    };
    while parts.first() == Some(&"super") {
        parts.remove(0);
        base.pop();
    }
    base.extend(parts.into_iter().map(str::to_owned));
    (0..=base.len()).rev().map(|length| base[..length].to_vec()).find(|prefix| modules.contains_key(prefix))
}

/// The files of circles, one list a circle.
fn circles(sources: &[Source], folder: &str) -> Vec<Vec<String>> {
    let inner = |source: &Source| source.path[folder.len() + 1..].to_owned();
    let library: Vec<&Source> = sources.iter().filter(|source| !source.is_test()).collect();
    let modules: BTreeMap<Module, String> =
        library.iter().map(|source| (module(&inner(source)), inner(source))).collect();
    let mut uses: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
    for source in library.iter().filter(|source| !is_facade(&source.path)) {
        let own = module(&inner(source));
        let origins = imports(source).into_iter().filter_map(|path| origin(&path, &own, &modules));
        let others: BTreeSet<Module> = origins.filter(|other| *other != own && !is_facade(&modules[other])).collect();
        uses.insert(own, others);
    }
    let reached: BTreeMap<&Module, BTreeSet<&Module>> =
        uses.keys().map(|start| (start, reachable(start, &uses))).collect();
    let mut found = Vec::new();
    let mut seen: BTreeSet<&Module> = BTreeSet::new();
    for (start, ends) in &reached {
        if ends.contains(start) && !seen.contains(start) {
            let circle: Vec<&Module> = ends.iter().copied().filter(|end| reached[end].contains(start)).collect();
            seen.extend(&circle);
            found.push(circle.iter().map(|member| format!("{folder}/{}", member.join("/"))).collect());
        }
    }
    found
}

/// The imports of one file, directly or through others.
fn reachable<'a>(start: &Module, uses: &'a BTreeMap<Module, BTreeSet<Module>>) -> BTreeSet<&'a Module> {
    let mut found = BTreeSet::new();
    let mut fresh: Vec<&Module> = uses.get(start).into_iter().flatten().collect();
    while let Some(next) = fresh.pop() {
        if found.insert(next) {
            fresh.extend(uses.get(next).into_iter().flatten());
        }
    }
    found
}

#[test]
fn files_import_each_other_one_way() {
    let mut still_needed = BTreeSet::new();
    let mut found = Vec::new();
    for folder in CRATES {
        for circle in circles(&files(folder, &[".rs"]), folder) {
            match WITH_CIRCLES.iter().find(|listed| circle.iter().any(|file| file.starts_with(*listed))) {
                Some(listed) => drop(still_needed.insert(*listed)),
                None => found.push(circle),
            }
        }
    }
    assert!(found.is_empty(), "files that import each other in a circle: {found:#?}");
    for listed in WITH_CIRCLES {
        assert!(still_needed.contains(listed), "{listed} has no circle any more: take it off the list");
    }
}

#[test]
fn a_circle_is_found_through_nested_imports_and_not_through_facades() {
    let file = |path: &str, text: &str| Source { path: format!("x/src/{path}"), text: text.to_owned() };
    let sources = [
        file("lib.rs", "pub mod a;\npub mod b;\n"),
        file("a/mod.rs", "mod one;\nmod two;\npub use one::One;\n"),
        file("a/one.rs", "use std::fmt;\n\nuse super::two::{\n    Deep, Two,\n};\n"),
        file(
            "a/two.rs",
            "//! use nothing.\nuse crate::{a::{one::One as First, three}, b};\n\
             #[cfg(test)]\nmod tests {\n    use crate::b::B;\n}\n",
        ),
        file("b.rs", "use crate::a::One;\nuse crate::a::two::Two;\n\nmod inner;\n"),
        file("b/inner.rs", "fn f() {}\n"),
    ];
    let through_b = ["x/src/a/one", "x/src/a/two", "x/src/b"].map(str::to_owned).to_vec();
    assert_eq!(circles(&sources, "x/src"), [through_b]);
    let apart: Vec<Source> = sources.into_iter().filter(|source| source.name() != "b.rs").collect();
    assert_eq!(circles(&apart, "x/src"), [["x/src/a/one", "x/src/a/two"].map(str::to_owned).to_vec()]);
    let one_way: Vec<Source> = apart.into_iter().filter(|source| source.name() != "one.rs").collect();
    assert!(circles(&one_way, "x/src").is_empty());
}
