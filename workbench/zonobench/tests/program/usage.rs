//! Command lines that make no sense: status 2, nothing on standard output.

use std::fs;
use std::path::Path;

use crate::run;

#[test]
fn usage_errors_have_status_2() {
    let wrong: [&[&str]; 16] = [
        &[],
        &["frobnicate"],
        &["enclose"],
        &["enclose", "p.csv", "--columns", "1"],
        &["enclose", "p.csv", "--format", "xml"],
        &["enclose", "p.csv", "--seed", "x"],
        &["reproduce", "--profile", "huge"],
        &["reproduce", "--threads", "0"],
        &["verify", "q.jsonl"],
        &["enclose", "p.csv", "--objective", "volume"],
        &["enclose", "p.csv", "--directions", "net:0"],
        &["enclose", "p.csv", "--epsilon", "1"],
        &["enclose", "p.csv", "--epsilon", "0.1", "--directions", "axes"],
        &["enclose", "p.obj", "--objective", "area"],
        &["enclose", "p.csv", "--objective", "area", "--epsilon", "0.1"],
        &["enclose", "p.csv", "--objective", "length", "--exact"],
    ];
    for words in wrong {
        let outcome = run(Path::new("."), words);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""), "{words:?}");
        assert!(!outcome.stderr.is_empty(), "{words:?}");
    }
}

#[test]
fn help_and_version_are_results() {
    for words in [&["--help"][..], &["--version"], &["enclose", "--help"]] {
        let outcome = run(Path::new("."), words);
        assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""), "{words:?}");
        assert!(!outcome.stdout.is_empty());
    }
}

#[test]
fn the_list_names_what_there_is() {
    let all = run(Path::new("."), &["list"]);
    assert_eq!(all.status, 0);
    for (what, id) in [("claims", "theorem-4.5"), ("methods", "min_area"), ("experiments", "hull-scaling")] {
        let some = run(Path::new("."), &["list", what]);
        assert!(some.stdout.lines().any(|line| line.starts_with(&format!("{id}\t"))), "{what}: {}", some.stdout);
        assert!(all.stdout.contains(&some.stdout));
    }
}

#[test]
fn reproduce_keeps_its_hands_off_a_folder_that_is_in_use() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("thesis.tex"), "mine").expect("written");
    let outcome = run(folder.path(), &["reproduce", "--out", "."]);
    assert_eq!(outcome.stderr, "zonobench: .: is not empty; --force writes into it, --out names another folder\n");
    assert_eq!((outcome.status, fs::read_dir(folder.path()).expect("listed").count()), (1, 1));
}
