//! Every algorithm of the library says the same things about itself, in the same order; what all methods of a problem
//! have in common is said once, by the problem.

use tests::sources::{LIBRARY, Source, files};

const HEADINGS: [&str; 10] =
    ["Statement", "Source", "Method", "Complexity", "Shapes", "Numerics", "Errors", "Panics", "Checked by", "Example"];

/// The headings that are left out where there is nothing to say.
const OPTIONAL: [&str; 2] = ["Errors", "Panics"];

/// The headings that a problem's `mod.rs` may have for all its methods: the statement is the problem's.
const OF_THE_PROBLEM: [&str; 4] = ["Statement", "Shapes", "Errors", "Checked by"];

/// A file is an algorithm's if it is named like one, or has a counted function, or describes a method.
fn is_algorithm(source: &Source) -> bool {
    let name = source.name();
    let folder = source.path.trim_start_matches(LIBRARY).trim_start_matches('/');
    let in_problem = folder.contains('/') && !folder.starts_with("numeric/");
    let named = name.starts_with("by_") || name == "brute_force.rs";
    let counted = source.code_lines().any(|(_, line)| line.starts_with("pub fn ") && line.contains("tally: &mut"));
    let described = headings(source).contains(&"Method");
    in_problem && name != "mod.rs" && !source.is_test() && (named || counted || described)
}

/// The text of the module's documentation without its code.
fn prose(source: &Source) -> Vec<&str> {
    let mut in_code = false;
    let header = source.text.lines().take_while(|line| line.starts_with("//!"));
    header
        .map(|line| line.trim_start_matches("//!").trim())
        .filter(|line| {
            let fence = line.starts_with("```");
            in_code ^= fence;
            !in_code && !fence
        })
        .collect()
}

fn headings(source: &Source) -> Vec<&str> {
    prose(source).iter().filter_map(|line| line.strip_prefix("# ")).collect()
}

/// The headings of the problem that a method is in, which are the method's where it has none of its own.
fn of_the_problem<'a>(source: &Source, sources: &'a [Source]) -> Vec<&'a str> {
    let folder = source.path.trim_end_matches(source.name());
    let problem = sources.iter().find(|other| other.path == format!("{folder}mod.rs"));
    let said = problem.map(headings).unwrap_or_default();
    said.into_iter().filter(|heading| OF_THE_PROBLEM.contains(heading)).collect()
}

#[test]
fn algorithms_are_documented_under_the_agreed_headings() {
    let sources = files(LIBRARY, &[".rs"]);
    let mut algorithms = 0;
    for source in sources.iter().filter(|source| is_algorithm(source)) {
        let (found, of_problem) = (headings(source), of_the_problem(source, &sources));
        let may_lack = |heading: &&str| OPTIONAL.contains(heading) || of_problem.contains(heading);
        let expected: Vec<&str> =
            HEADINGS.into_iter().filter(|heading| !may_lack(heading) || found.contains(heading)).collect();
        assert_eq!(found, expected, "{}", source.path);
        algorithms += 1;
    }
    assert!(algorithms > 0, "the rule found no algorithm to look at");
}

#[test]
fn every_section_of_a_header_says_something() {
    for source in files(LIBRARY, &[".rs"]).iter().filter(|source| is_algorithm(source)) {
        let sections = source.text.split("//! # ").skip(1);
        for section in sections.filter(|section| HEADINGS.iter().any(|heading| section.starts_with(heading))) {
            let mut lines = section.lines().skip(1).map(|line| line.trim_start_matches("//!").trim());
            assert!(
                lines.next().is_some_and(|line| !line.is_empty()),
                "{}: nothing under {:?}",
                source.path,
                section.lines().next()
            );
        }
    }
}

/// A heading under which stands "None" or "Never" says what its absence says.
#[test]
fn no_optional_section_says_that_there_is_nothing_to_say() {
    for source in files(LIBRARY, &[".rs"]).iter().filter(|source| is_algorithm(source)) {
        for heading in OPTIONAL {
            let section = source.text.split(&format!("//! # {heading}\n//! ")).nth(1).unwrap_or_default();
            let is_empty = ["None", "Never"].iter().any(|word| section.starts_with(word));
            assert!(!is_empty, "{}: the section {heading:?} is empty", source.path);
        }
    }
}

#[test]
fn an_example_asserts_something_in_few_lines() {
    for source in files(LIBRARY, &[".rs"]).iter().filter(|source| is_algorithm(source)) {
        let example = source.text.split("//! # Example").nth(1).expect("the headings are there");
        let code: Vec<&str> = example
            .lines()
            .take_while(|line| line.is_empty() || line.starts_with("//!"))
            .map(|line| line.trim_start_matches("//!").trim())
            .skip_while(|line| !line.starts_with("```"))
            .skip(1)
            .take_while(|line| !line.starts_with("```"))
            .collect();
        assert!(code.iter().any(|line| line.contains("assert")), "{}: the example asserts nothing", source.path);
        assert!(code.len() <= 15, "{}: the example has {} lines", source.path, code.len());
    }
}

/// A row that goes on in a second line is no row of a table, and neither is what follows.
#[test]
fn a_row_of_a_table_is_one_line() {
    for source in ["workbench", "experiments", "figures", "paper_checks"].iter().flat_map(|top| files(top, &[".rs"])) {
        for (number, line) in source.text.lines().enumerate() {
            let is_row = ["//! | ", "/// | "].iter().any(|start| line.trim_start().starts_with(start));
            assert!(!is_row || line.ends_with('|'), "{}:{}: {line}", source.path, number + 1);
        }
    }
}
