//! Texts of the program that must not change by accident: `ZONOTOPE_BLESS=1` rewrites them.

use std::path::{Path, PathBuf};

use assert_cmd::Command;

fn zonobench() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_zonobench_under_test"));
    command.current_dir(folder());
    command
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("goldens")
}

/// Compares line by line, so that a failure shows the line.
fn compare(name: &str, text: &[u8]) {
    let file = folder().join(name);
    if std::env::var_os("ZONOTOPE_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&file, text).expect("the golden can be written");
    }
    let golden = std::fs::read_to_string(&file).expect("the golden is committed");
    let text = String::from_utf8(text.to_vec()).expect("the program prints text");
    for (number, (golden, text)) in (1..).zip(golden.lines().zip(text.lines())) {
        assert_eq!(golden, text, "{name}, line {number}; ZONOTOPE_BLESS=1 rewrites it");
    }
    assert_eq!(golden.lines().count(), text.lines().count(), "{name} has lost or gained lines");
}

fn output(arguments: &[&str]) -> Vec<u8> {
    zonobench().args(arguments).assert().success().get_output().stdout.clone()
}

#[test]
fn answers_to_questions() {
    compare("answers.jsonl", &output(&["solve", "questions.jsonl"]));
}

/// The seed may choose among several optima and certificates, and nothing else.
#[test]
fn answers_for_another_seed_are_right_as_well() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let answers = folder.path().join("answers.jsonl");
    std::fs::write(&answers, output(&["solve", "questions.jsonl", "--seed", "17"])).expect("the answers are written");
    zonobench().args(["verify", "questions.jsonl"]).arg(&answers).assert().success();
}

#[test]
fn verdicts_on_the_answers() {
    compare("verdicts.txt", &output(&["verify", "questions.jsonl", "answers.jsonl"]));
}

#[test]
fn summary_of_an_enclosure() {
    compare("summary.txt", &output(&["enclose", "points.csv", "--exact"]));
}
