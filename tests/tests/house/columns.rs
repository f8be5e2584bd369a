//! The width of texts: a line that has to be scrolled sideways is not read.

use tests::sources::files;

/// The columns of a line of code, of a comment or of a text.
const COLUMN_LIMIT: usize = 120;

/// Whether a line cannot be broken: a row of a table, or a single word such as a link.
fn is_unbreakable(line: &str) -> bool {
    let text = line.trim_start().trim_start_matches(['/', '!']).trim_start();
    text.starts_with('|') || text.starts_with("![") || !text.contains(' ')
}

/// The numbers of the lines that are too wide.
fn too_wide(text: &str) -> Vec<usize> {
    let is_wide = |line: &str| line.chars().count() > COLUMN_LIMIT && !is_unbreakable(line);
    text.lines().enumerate().filter(|(_, line)| is_wide(line)).map(|(index, _)| index + 1).collect()
}

#[test]
fn a_line_is_too_wide_unless_it_cannot_be_broken() {
    let word = "x".repeat(COLUMN_LIMIT);
    let text = format!("{word}\n/// a {word}\n| a {word} |\n//! | a {word} |\n{word}x\n    ä {word}\n");
    assert_eq!(too_wide(&text), [2, 6]);
}

#[test]
fn lines_have_at_most_120_columns() {
    let sources = files("", &[".rs", ".md"]);
    let wide: Vec<String> = sources
        .iter()
        .flat_map(|source| too_wide(&source.text).into_iter().map(move |line| format!("{}:{line}", source.path)))
        .collect();
    assert!(wide.is_empty(), "{wide:#?}");
}
