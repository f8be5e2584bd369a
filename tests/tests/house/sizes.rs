//! Sizes on machines of 32 bits: a product of two sizes overflows there from some 65,000 on, where inputs of millions
//! are ordinary, so products are taken in 64 bits or saturate.

use tests::sources::{LIBRARY, files};

/// The text between the parentheses that end where a text ends; nothing if they are not balanced.
fn in_last_parentheses(text: &str) -> &str {
    let mut depth = 0;
    for (at, c) in text.char_indices().rev() {
        depth += match c {
            ')' => 1,
            '(' => -1,
            _ => 0,
        };
        if depth == 0 {
            return &text[at..];
        }
    }
    ""
}

/// Whether a line multiplies sizes before it widens the product, or multiplies two lengths in the width of the machine.
///
/// The capacity of a list may overflow only where the list itself would not fit, and a file of tests chooses its sizes.
fn multiplies_sizes(line: &str) -> bool {
    const WIDENED: &str = ") as u64";
    let widened_late = line.match_indices(WIDENED).any(|(at, _)| {
        let product = in_last_parentheses(&line[..=at]);
        product.contains(" * ") && !product.contains("u64") && !product.contains("u128") && !product.contains("f64")
    });
    let of_two_lengths = line.split(".len() * ").skip(1).any(|factor| {
        let end = factor.find([' ', ',', ';', ']', '<', '>']).unwrap_or(factor.len());
        factor[..end].ends_with(".len()") || factor[..end].ends_with(".len())")
    });
    (widened_late || of_two_lengths) && !line.contains("with_capacity(")
}

#[test]
fn products_of_sizes_are_taken_in_64_bits() {
    let mut found = Vec::new();
    for source in files(LIBRARY, &[".rs"]).iter().filter(|source| !source.is_test()) {
        for (number, line) in source.code_lines().filter(|(_, line)| multiplies_sizes(line)) {
            found.push(format!("{}:{number}: {}", source.path, line.trim()));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn products_are_told_from_sizes() {
    for line in
        ["tally.add((points.len() * rank) as u64);", "if a.len() * b.len() > LIMIT {", "(f(x) * (n + 1)) as u64"]
    {
        assert!(multiplies_sizes(line), "{line}");
    }
    for line in [
        "tally.add(points.len() as u64 * rank as u64);",
        "let reads = 2 * query.len() as u64;",
        "(u128::from(rank) * u128::from(picked)) as u64",
        "if a.len().saturating_mul(b.len()) > LIMIT {",
        "if 4 * few.len() > 3 * all.len() {",
    ] {
        assert!(!multiplies_sizes(line), "{line}");
    }
}
