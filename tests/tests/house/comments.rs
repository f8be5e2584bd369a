//! The first word of a comment: a noun of the field names its subject, and a word of a question leaves it open.

use tests::sources::files;

/// Words of a question, and the one of a conclusion, that no line of a comment begins with.
const REFUSED: [&str; 4] = ["What", "How", "Where", "So"];

/// Folders whose comments are held to it.
const HELD: [&str; 14] = [
    "experiments",
    "figures",
    "paper_checks",
    "tests",
    "workbench/batch",
    "workbench/verifier",
    "workbench/zonobench",
    "workbench/zonotope/src/bvh",
    "workbench/zonotope/src/collision/by_lad",
    "workbench/zonotope/src/collision/doors",
    "workbench/zonotope/src/collision/prepared/by_direction_tree",
    "workbench/zonotope/src/collision/proof",
    "workbench/zonotope/src/lad/of_generators",
    "workbench/zonotope/src/motion",
];

/// The first word of the comment that a line is, if it is one.
fn first_word(line: &str) -> Option<&str> {
    let comment = line.trim_start().strip_prefix("//")?.trim_start_matches(['/', '!']).trim_start();
    comment.split(|c: char| !c.is_alphanumeric()).next()
}

/// The numbers of the lines that begin with such a word.
fn refused(text: &str) -> Vec<usize> {
    let is_refused = |line: &str| first_word(line).is_some_and(|word| REFUSED.contains(&word));
    text.lines().enumerate().filter(|(_, line)| is_refused(line)).map(|(index, _)| index + 1).collect()
}

#[test]
fn words_of_a_question_are_found_at_the_start_of_any_comment() {
    let text =
        "//! What it is.\n    /// How far.\n// Where it lies, …\n//So be it\n/// Somewhat\nlet what = How; // Where\n";
    assert_eq!(refused(text), [1, 2, 3, 4]);
}

#[test]
fn comments_begin_with_a_noun() {
    let found: Vec<String> = HELD
        .iter()
        .flat_map(|folder| files(folder, &[".rs"]))
        .flat_map(|source| {
            refused(&source.text).into_iter().map(move |line| format!("{}:{line}", source.path)).collect::<Vec<_>>()
        })
        .collect();
    assert!(found.is_empty(), "{found:#?}");
}
