//! The client in Python, as the README shows it, and when something comes in between.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Tells on standard error itself, which a test that passes does not keep for itself.
fn tell_skipped(reason: &str) {
    let _ = writeln!(io::stderr(), "SKIPPED, the client in Python was not run: {reason}");
}

/// Runs a script with the client in Python's path; none, and said so, where there is no Python.
fn run_python(script: &str) -> Option<Output> {
    let run = Command::new("python3")
        .args(["-c", script])
        .env("PYTHONPATH", root().join("workbench/zonobench/clients"))
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .env("ZONOBENCH", env!("CARGO_BIN_EXE_zonobench"))
        .output();
    match run {
        Ok(output) => Some(output),
        Err(error) => {
            tell_skipped(&format!("python3: {error}"));
            None
        }
    }
}

/// Runs a script that raises where it does not find what it expects.
fn holds(script: &str) -> String {
    let Some(Output { status, stdout, stderr }) = run_python(script) else { return String::new() };
    let [stdout, stderr] = [stdout, stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    assert!(status.success(), "{stderr}");
    stdout
}

#[test]
fn the_script_of_the_manual_prints_what_it_says() {
    let manual = fs::read_to_string(root().join("workbench/zonobench/MANUAL.md")).expect("the manual is there");
    let (_, rest) = manual.split_once("```python\n").expect("the manual has a script in Python");
    let (script, _) = rest.split_once("```").expect("the script ends");
    let said: Vec<&str> = script
        .lines()
        .filter_map(|line| line.split_once("print(")?.1.split_once("  # "))
        .map(|(_, said)| said)
        .collect();
    assert!(said.len() > 1);
    let Some(Output { status, stdout, stderr }) = run_python(script) else { return };
    let [stdout, stderr] = [stdout, stderr].map(|bytes| String::from_utf8(bytes).expect("Python writes text"));
    assert!(status.success(), "{stderr}");
    assert_eq!(stdout.lines().collect::<Vec<_>>(), said);
}

#[test]
fn a_refused_question_does_not_end_the_process() {
    let script = "
from zonobench import Refused, Workbench

with Workbench() as workbench:
    process = workbench._process
    try:
        workbench.ask('support', direction=[0, float('nan')], center=[0, 0], generators=[])
    except Refused as refused:
        print(refused.code)
    try:
        workbench.ask('no-such-kind')
    except Refused as refused:
        print(refused.code)
    try:
        workbench.ask('support', direction=(1, float('-inf')), center=[0, 0], generators=[])
    except Refused as refused:
        print(refused)
    print(workbench.ask('support', direction=[0, 2], center=[0, 1], generators=[[1, 1]])['value'])
    assert workbench._process is process
";
    let Some(Output { stdout, .. }) = run_python(script) else { return };
    let lines = String::from_utf8(stdout).expect("Python writes text");
    let lines: Vec<&str> = lines.lines().collect();
    let minus_infinity = "non_finite: direction, coordinate 2 is -Infinity";
    assert_eq!(lines, ["non_finite", "unknown_kind", minus_infinity, "4.0"]);
}

#[test]
fn a_program_that_is_not_there_is_told_with_the_remedy() {
    let script = "
from zonobench import Workbench

try:
    Workbench('no-such-program')
except FileNotFoundError as error:
    print(error)
";
    let Some(Output { stdout, .. }) = run_python(script) else { return };
    let said = String::from_utf8(stdout).expect("Python writes text");
    for word in ["'no-such-program'", "ZONOBENCH", "cargo install --path workbench/zonobench"] {
        assert!(said.contains(word), "{said}");
    }
}

#[test]
fn four_threads_get_their_own_answers() {
    holds(include_str!("clients/threads.py"));
}

#[test]
fn numbers_of_every_sort_are_asked_about() {
    if holds(include_str!("clients/sorts_of_numbers.py")).contains("numpy is not there") {
        tell_skipped("its part with the arrays of NumPy, which is not installed");
    }
}

#[cfg(unix)]
#[test]
fn no_question_gets_the_answer_of_one_that_a_signal_interrupted() {
    holds(include_str!("clients/interrupts.py"));
}

#[cfg(unix)]
#[test]
fn lines_that_answer_something_else_are_never_returned() {
    holds(include_str!("clients/wrong_answers.py"));
}

#[cfg(unix)]
#[test]
fn processes_end_with_their_workbench_and_not_with_a_fork() {
    holds(include_str!("clients/endings.py"));
}
