//! No circle of imports, neither between files nor between the rooms of a folder: what a file rests on can be read
//! without it, and so can what a folder rests on.
//!
//! A name counts for the file that has it, through however many facades (`mod.rs`, `lib.rs`, `main.rs`) it is handed
//! on. A facade without functions declares and re-exports, so that nothing rests on it. One with functions is a file
//! like the others; but it does not rest on the names that it only hands on, as a problem's `mod.rs` has its types and
//! re-exports its default method.

mod circles;
mod exceptions;
mod graph;
mod paths;

use std::collections::BTreeSet;

use tests::sources::{Source, files};

use self::circles::{circles, folders, rooms};
use self::exceptions::{FACADES_IN_CIRCLES, FILES_IN_CIRCLES, ROOMS_IN_CIRCLES};
use self::graph::{Files, Module};

const CRATES: [&str; 10] = [
    "workbench/zonotope/src",
    "workbench/verifier/src",
    "workbench/batch/src",
    "workbench/zonobench/src",
    "experiments/src",
    "experiments/families/src",
    "experiments/rivals/src",
    "figures/src",
    "paper_checks/src",
    "tests/src",
];

/// The circles of a crate: of files and facades alike, of files alone, of rooms.
struct Found {
    with_facades: Vec<Vec<String>>,
    facades: BTreeSet<String>,
    files: Vec<Vec<String>>,
    rooms: BTreeSet<String>,
}

fn found(sources: &[Source], folder: &str) -> Found {
    let crate_files = Files::new(sources, folder);
    let uses = crate_files.uses();
    let path = |module: &Module| [&[folder.to_owned()][..], &module[..]].concat().join("/");
    let paths = |circles: Vec<Vec<Module>>| -> Vec<Vec<String>> {
        circles.iter().map(|circle| circle.iter().map(path).collect()).collect()
    };
    let all = circles(&uses);
    let facades = all.iter().flatten().filter(|module| crate_files.is_facade(module)).map(path).collect();
    let mut without = uses.clone();
    without.retain(|module, _| !crate_files.is_facade(module));
    let in_rooms = folders(&uses).into_iter().flat_map(|folder| circles(&rooms(&uses, &folder)));
    Found {
        with_facades: paths(all),
        facades,
        files: paths(circles(&without)),
        rooms: paths(in_rooms.collect()).into_iter().flatten().collect(),
    }
}

fn in_all_crates() -> Vec<Found> {
    CRATES.iter().map(|folder| found(&files(folder, &[".rs"]), folder)).collect()
}

/// Fails if something is in a circle that is not on a list, or on the list without being in one.
fn assert_listed(found: BTreeSet<String>, listed: &[&str], circles: &[Vec<String>]) {
    let listed: BTreeSet<String> = listed.iter().map(|&path| path.to_owned()).collect();
    let new: Vec<&String> = found.difference(&listed).collect();
    assert!(new.is_empty(), "{new:#?} are in a circle of imports: {circles:#?}");
    let done: Vec<&String> = listed.difference(&found).collect();
    assert!(done.is_empty(), "{done:#?} are in no circle any more: take them off the list");
}

#[test]
fn files_import_each_other_one_way() {
    let circles: Vec<Vec<String>> = in_all_crates().into_iter().flat_map(|found| found.files).collect();
    assert_listed(circles.iter().flatten().cloned().collect(), &FILES_IN_CIRCLES, &circles);
}

#[test]
fn facades_with_functions_are_imported_one_way() {
    let all = in_all_crates();
    let circles: Vec<Vec<String>> = all.iter().flat_map(|found| found.with_facades.clone()).collect();
    assert_listed(all.into_iter().flat_map(|found| found.facades).collect(), &FACADES_IN_CIRCLES, &circles);
}

#[test]
fn rooms_of_a_folder_import_each_other_one_way() {
    assert_listed(in_all_crates().into_iter().flat_map(|found| found.rooms).collect(), &ROOMS_IN_CIRCLES, &[]);
}

fn file(path: &str, text: &str) -> Source {
    Source { path: format!("x/src/{path}"), text: text.to_owned() }
}

fn named(paths: &[&str]) -> Vec<String> {
    paths.iter().map(|path| format!("x/src/{path}")).collect()
}

#[test]
fn a_circle_is_found_through_nested_imports_and_through_what_a_facade_hands_on() {
    let sources = [
        file("lib.rs", "pub mod a;\npub mod b;\n"),
        file("a/mod.rs", "mod one;\nmod two;\npub use one::One;\npub(crate) use self::two::Two as Second;\n"),
        file("a/one.rs", "use std::fmt;\n\nuse super::two::{\n    Deep, Two,\n};\n"),
        file(
            "a/two.rs",
            "//! use nothing.\nuse crate::{a::{one::One as First, three}, b};\n\
             #[cfg(test)]\nmod tests {\n    use crate::b::B;\n}\n",
        ),
        file("b.rs", "use crate::a::One;\n\nmod inner;\n"),
        file("b/inner.rs", "fn f() {}\n"),
    ];
    let all = found(&sources, "x/src");
    assert_eq!(all.files, [named(&["a/one", "a/two", "b"])]);
    assert_eq!(all.rooms, named(&["a", "a/one", "a/two", "b"]).into_iter().collect());
    let apart: Vec<Source> = sources.into_iter().filter(|source| source.name() != "b.rs").collect();
    assert_eq!(found(&apart, "x/src").files, [named(&["a/one", "a/two"])]);
    let one_way: Vec<Source> = apart.into_iter().filter(|source| source.name() != "one.rs").collect();
    let all = found(&one_way, "x/src");
    assert!(all.files.is_empty() && all.rooms.is_empty() && all.facades.is_empty());
}

#[test]
fn folders_are_in_a_circle_where_no_file_of_them_is() {
    let sources = [
        file("lib.rs", "pub mod a;\npub mod b;\n"),
        file("a/mod.rs", "mod low;\nmod high;\npub use low::Low;\npub use high::High;\n"),
        file("a/low.rs", "pub struct Low;\n"),
        file("a/high.rs", "fn f() { crate::b::middle::of() }\n"),
        file("b/mod.rs", "pub mod middle;\n"),
        file("b/middle.rs", "use crate::a::Low;\n\npub fn of() {}\n"),
    ];
    let all = found(&sources, "x/src");
    assert!(all.files.is_empty() && all.with_facades.is_empty());
    assert_eq!(all.rooms, named(&["a", "b"]).into_iter().collect());
}

#[test]
fn a_facade_is_in_a_circle_if_it_has_functions() {
    let with = |statement: &str| {
        let text = format!("mod one;\n\npub use one::{{One, start}};\n\npub struct Problem;\n{statement}");
        let sources = [
            file("lib.rs", "pub mod a;\n"),
            file("a/mod.rs", &text),
            file("a/one.rs", "use super::Problem;\n\npub fn start() {}\n\npub struct One;\n"),
        ];
        found(&sources, "x/src")
    };
    assert!(with("").facades.is_empty());
    assert!(with("fn f() -> &'static str { \"start of \\\"one\\\"\" }\n").facades.is_empty());
    let all = with("pub(crate) const fn solve() -> One { start() }\n");
    assert_eq!(all.with_facades, [named(&["a", "a/one"])]);
    assert_eq!(all.facades, named(&["a"]).into_iter().collect());
    assert!(all.files.is_empty() && all.rooms.is_empty());
}
