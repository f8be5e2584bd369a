//! The ground floor (`numeric`) is written once: what it offers is not written again in the problems that stand on it.

use tests::sources::{LIBRARY, Source, files};

/// Functions that `numeric` has for all numbers: a second one elsewhere is a copy.
const ONE_OF_A_KIND: [&str; 21] = [
    "dot",
    "product",
    "sum_of_products",
    "cross",
    "determinant",
    "minor",
    "inverse",
    "dense_inverse",
    "add_multiple",
    "rational",
    "absolute",
    "above",
    "below",
    "at_least",
    "at_most",
    "rounded_towards",
    "largest_magnitude",
    "binary_exponent",
    "scale_by_power_of_two",
    "for_subsets",
    "for_each_subset",
];

/// Words that say how much, and nothing of what: a constant made of these alone does not say what it bounds.
const VAGUE_WORDS: [&str; 28] = [
    "FEW", "FEWER", "MANY", "MUCH", "MORE", "MOST", "ENOUGH", "FAR", "FARTHER", "FARTHEST", "NEAR", "NEARER",
    "NEAREST", "NEARLY", "SHORT", "SHORTER", "SHORTEST", "LONG", "LONGEST", "SURELY", "CLEAR", "BEYOND", "WIDER",
    "DEAR", "OFTEN", "NOTHING", "TINY", "SLACK",
];

fn library() -> Vec<Source> {
    files(LIBRARY, &[".rs"]).into_iter().filter(|source| !source.is_test()).collect()
}

fn inner(source: &Source) -> &str {
    source.path.trim_start_matches(LIBRARY).trim_start_matches('/')
}

/// Fails with the offences that were found.
fn none_of(offences: impl Iterator<Item = (String, String)>, what: &str) {
    let found: Vec<String> = offences.map(|(path, offence)| format!("{path}: {offence}")).collect();
    assert!(found.is_empty(), "{what}: {found:#?}");
}

/// The offences that a rule finds in a file's code, outside its unit tests.
fn offences<'a>(
    sources: &'a [Source],
    rule: impl Fn(&str) -> bool + 'a,
) -> impl Iterator<Item = (String, String)> + 'a {
    sources.iter().flat_map(move |source| {
        let lines: Vec<String> = source.code_lines().map(|(_, line)| line.trim().to_owned()).collect();
        lines.into_iter().filter(|line| rule(line)).map(|line| (inner(source).to_owned(), line)).collect::<Vec<_>>()
    })
}

/// The name that a line declares with a keyword.
fn declared<'a>(line: &'a str, keyword: &str) -> Option<&'a str> {
    let (before, rest) = line.split_once(keyword)?;
    let is_declaration = before.split_whitespace().all(|word| word.starts_with("pub") || word == "const");
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    is_declaration.then(|| &rest[..end])
}

fn is_a_copy(line: &str) -> bool {
    // a method is about its own type
    let is_method = line.contains("self");
    declared(line, "fn ").is_some_and(|name| ONE_OF_A_KIND.contains(&name) || name.ends_with("median")) && !is_method
}

/// Whether a line declares a constant that is a power of two by its bits, or a multiple of the unit of rounding.
fn is_an_error_bound(line: &str) -> bool {
    const MARKS: [&str; 5] = ["from_bits(", "EPSILON", "UNIT", "1_048_576.0", "power_of_two("];
    let value = line.split_once(": f64 =").map(|(_, value)| value);
    declared(line, "const ").is_some() && value.is_some_and(|value| MARKS.iter().any(|mark| value.contains(mark)))
}

fn is_vague(line: &str) -> bool {
    declared(line, "const ")
        .is_some_and(|name| !name.is_empty() && name.split('_').all(|word| VAGUE_WORDS.contains(&word)))
}

fn names_a_twin(line: &str) -> bool {
    (line.starts_with("use ") || line.starts_with("pub use ")) && line.contains("brute_force")
}

#[test]
fn products_determinants_and_medians_are_those_of_the_ground_floor() {
    let sources: Vec<Source> = library().into_iter().filter(|s| !inner(s).starts_with("numeric/")).collect();
    none_of(offences(&sources, is_a_copy), "copies of the ground floor");
}

#[test]
fn error_bounds_have_one_home() {
    let sources: Vec<Source> = library().into_iter().filter(|s| !inner(s).starts_with("numeric/")).collect();
    none_of(offences(&sources, is_an_error_bound), "constants of error bounds");
}

#[test]
fn constants_say_what_they_bound() {
    none_of(offences(&library(), is_vague), "constants that do not say what they bound");
}

/// Facades declare twins, and a registry of methods lists them; a method that rests on its own truth proves nothing.
#[test]
fn only_tests_rest_on_a_brute_force_twin() {
    let is_facade = |source: &Source| ["mod.rs", "lib.rs", "method.rs"].contains(&source.name());
    let sources: Vec<Source> = library().into_iter().filter(|source| !is_facade(source)).collect();
    none_of(offences(&sources, names_a_twin), "imports of a brute-force twin");
}

/// A twin that shares a method's code shares its errors.
#[test]
fn a_twin_rests_on_its_problem_and_on_numbers_alone() {
    let twins: Vec<Source> = library().into_iter().filter(|source| source.name() == "brute_force.rs").collect();
    assert!(twins.len() > 5, "twins are recognised by their name");
    let rests_on_a_method = |line: &str| line.starts_with("use ") && line.contains("by_");
    none_of(offences(&twins, rests_on_a_method), "methods in brute-force twins");
}

#[test]
fn offences_are_told_from_what_is_allowed() {
    for line in ["fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {", "pub(super) fn weighted_median<T>(items: &mut [T]) {"] {
        assert!(is_a_copy(line), "{line}");
    }
    for line in ["pub fn determinant(&self) -> &Dyadic {", "fn crossing(a: f64) {", "let x = dot(a, b);"] {
        assert!(!is_a_copy(line), "{line}");
    }
    assert!(is_an_error_bound("pub(super) const SLACK: f64 = 1.0 + 8.0 * UNIT;"));
    assert!(!is_an_error_bound("const BLOCK: usize = 256;") && !is_an_error_bound("let unit: f64 = UNIT;"));
    assert!(is_vague("const FEW: usize = 64;") && is_vague("pub const MUCH_NEARER: f64 = 10.0;"));
    assert!(!is_vague("const MOST_ROUNDS: usize = 8;") && !is_vague("const EXACT_SOLVE_LIMIT: usize = 64;"));
    assert!(names_a_twin("use super::brute_force::{Span, Vector};") && !names_a_twin("pub mod brute_force;"));
}
