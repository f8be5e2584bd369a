//! Each problem of the library has a benchmark, and the page on methodology says which.

use std::collections::BTreeSet;

use tests::sources::{LIBRARY, Source, files};

/// Modules of the library's table of problems that are not timed: an engine that others wrote, and conversions.
const NOT_TIMED: [&str; 2] = ["linear_program", "interop"];

/// The rows of the first table after a line, without its head: the first two cells of each.
fn rows<'t>(text: &'t str, after: &str) -> Vec<[&'t str; 2]> {
    let lines = text.lines().map(|line| line.trim_start_matches("//!").trim());
    let table = lines.skip_while(|line| !line.starts_with(after)).skip_while(|line| !line.starts_with('|'));
    let cells = |line: &'t str| {
        let mut cells = line.split('|').skip(1).map(str::trim);
        [cells.next().unwrap_or_default(), cells.next().unwrap_or_default()]
    };
    table.take_while(|line| line.starts_with('|')).skip(2).map(cells).collect()
}

fn text(folder: &str, name: &str) -> Source {
    let found = files(folder, &[name]).into_iter().find(|source| source.path == format!("{folder}/{name}"));
    found.unwrap_or_else(|| panic!("there is no {folder}/{name}"))
}

#[test]
fn every_problem_has_a_benchmark_that_the_methodology_names() {
    let (library, methodology) = (text(LIBRARY, "lib.rs"), text("experiments", "METHODOLOGY.md"));
    let module = |cell: &str| cell.trim_matches(['[', ']', '`']).to_owned();
    let problems: BTreeSet<String> = rows(&library.text, "# Problems").iter().map(|[cell, _]| module(cell)).collect();
    let timed = rows(&methodology.text, "## Public calls");
    let mut named: BTreeSet<String> = timed.iter().map(|[cell, _]| module(cell)).collect();
    named.extend(NOT_TIMED.map(str::to_owned));
    assert_eq!(problems, named);

    let sources = files("", &[".rs"]);
    let benchmark = |name: &str| sources.iter().find(|source| source.path.ends_with(&format!("/benches/{name}.rs")));
    for [module, benchmarks] in timed {
        let mut words = benchmarks.split('`').skip(1).step_by(2);
        let (Some(name), Some(id)) = (words.next(), words.next()) else { panic!("{module}: {benchmarks}") };
        let source = benchmark(name).unwrap_or_else(|| panic!("{module}: there is no benchmark {name}"));
        assert!(source.text.contains(&format!("\"{id}")), "{module}: {name} has no {id}");
    }
}

#[test]
fn every_benchmark_is_on_the_page() {
    let methodology = text("experiments", "METHODOLOGY.md").text;
    let sources = files("", &[".rs"]);
    let with_main =
        sources.iter().filter(|source| source.path.contains("/benches/") && source.text.contains("fn main"));
    let criterion = sources.iter().filter(|source| source.text.contains("criterion_main!(benches)"));
    let names: BTreeSet<&str> = with_main.chain(criterion).filter_map(|source| name(&source.path)).collect();
    assert!(names.len() > 5, "{names:?}");
    for name in names {
        assert!(methodology.contains(&format!("--bench {name}")), "{name}");
    }
}

/// The name of a benchmark by its path: `name.rs` or `name/main.rs` in a folder of benchmarks.
fn name(path: &str) -> Option<&str> {
    let (_, file) = path.split_once("/benches/")?;
    file.strip_suffix("/main.rs").or_else(|| file.strip_suffix(".rs"))
}
