//! Rules for the code: each rule with the place where its exception lives.

use tests::sources::{BATCH, LIBRARY, Source, VERIFIER, files};

/// The lines of code that hold one of `words`.
fn offences(source: &Source, words: &[&str]) -> Vec<String> {
    let in_line = |(number, line): (usize, &str)| {
        let found = words.iter().find(|word| line.contains(**word))?;
        Some(format!("{}:{number}: {found}", source.path))
    };
    source.code_lines().filter_map(in_line).collect()
}

/// Fails with every line of code below `folders` that holds one of `words`, unless the file is `allowed`.
fn refuse(folders: &[&str], words: &[&str], allowed: impl Fn(&Source) -> bool) {
    let found: Vec<String> = folders
        .iter()
        .flat_map(|folder| files(folder, &[".rs"]))
        .filter(|source| !source.is_test() && !allowed(source))
        .flat_map(|source| offences(&source, words))
        .collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn an_offence_is_found_in_code_and_not_in_comments_or_unit_tests() {
    let source = Source {
        path: "some/file.rs".to_owned(),
        text: "/// dbg!(1)\nfn f() {\n    dbg!(2);\n}\n#[cfg(test)]\nmod tests \
            {\n    // dbg!\n    fn g() { dbg!(3); }\n}\n"
            .to_owned(),
    };
    assert_eq!(offences(&source, &["println!", "dbg!("]), ["some/file.rs:3: dbg!("]);
}

const CRATES: [&str; 10] = [
    "workbench/zonotope/src",
    "workbench/verifier/src",
    "workbench/batch/src",
    "workbench/zonobench/src",
    "experiments/src",
    "experiments/families/src",
    "experiments/peers/src",
    "experiments/rivals/src",
    "figures/src",
    "paper_checks/src",
];

#[test]
fn the_library_and_the_verifier_are_pure() {
    refuse(
        &[LIBRARY, VERIFIER, BATCH],
        &[
            "std::fs",
            "std::io",
            "std::env",
            "std::time",
            "std::thread",
            "std::process",
            "println!",
            "print!(",
            "static mut",
            "rand::rng(",
        ],
        |_| false,
    );
    // what a thread keeps there is the memory of lists, emptied, and never a value
    let keeps_memory = |source: &Source| source.path == format!("{LIBRARY}/numeric/reused.rs");
    refuse(&[LIBRARY, VERIFIER, BATCH], &["thread_local!"], keeps_memory);
}

#[test]
fn only_the_experiments_read_a_clock() {
    refuse(&CRATES, &["Instant::now", "SystemTime::now"], |source| source.path.starts_with("experiments/"));
}

#[test]
fn the_library_and_the_verifier_do_not_unwrap() {
    refuse(&[LIBRARY, VERIFIER, BATCH], &[".unwrap()", "panic!(", "dbg!("], |_| false);
}

/// The system's transcendental functions differ from machine to machine; those of `libm` do not.
#[test]
fn transcendental_functions_come_from_libm() {
    let methods = [
        ".sin()",
        ".cos()",
        ".tan()",
        ".sin_cos()",
        ".asin()",
        ".acos()",
        ".atan()",
        ".atan2(",
        ".exp()",
        ".exp2()",
        ".exp_m1()",
        ".ln()",
        ".ln_1p()",
        ".log(",
        ".log2()",
        ".log10()",
        ".powf(",
        ".cbrt()",
        ".sinh()",
        ".cosh()",
        ".tanh()",
    ];
    refuse(&CRATES, &methods, |_| false);
}

#[test]
fn no_decision_by_angle() {
    refuse(&[LIBRARY], &["atan2", "hypot("], |source| source.path.contains("/numeric/"));
}

#[test]
fn nothing_is_left_for_later() {
    let words = [
        concat!("to", "do!("),
        concat!("unimpl", "emented!("),
        concat!("FIX", "ME"),
        concat!("XX", "X"),
        concat!("HA", "CK"),
    ];
    for source in files("", &[".rs"]) {
        for word in words {
            assert!(!source.text.contains(word), "{} says {word}", source.path);
        }
        let ignored = concat!("#[ign", "ore");
        assert!(!source.text.contains(ignored), "{} has a test that never runs", source.path);
    }
}

/// Texts speak of the mathematics and the program; a path of somebody's machine works nowhere else.
#[test]
fn texts_are_about_the_project() {
    let words = [
        concat!("/wo", "rk/"),
        concat!("/ho", "me/"),
        concat!("/ro", "ot/"),
        concat!("/Us", "ers/"),
        concat!("/t", "mp/"),
        concat!("language ", "model"),
        concat!("AI-", "generated"),
        concat!("coding ", "agent"),
        concat!("this ", "session"),
    ];
    let endings = [".rs", ".md", ".toml", ".json", ".csv", ".svg", ".yml"];
    for source in files("", &endings).iter().filter(|source| source.name() != "Cargo.lock") {
        for word in words {
            let place = source.text.find(word).map(|at| source.text[..at].lines().count());
            assert!(place.is_none(), "{}:{}: {word}", source.path, place.unwrap_or_default());
        }
    }
}
