//! The program as its user meets it: arguments, files and standard input in; output, complaints and status out.

mod answers;
mod bodies;
mod clients;
mod documented;
mod drawings;
mod moving;
mod pipes;
mod quirks;
mod readers;
mod refusals;
mod runs;
mod usage;
mod verification;

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// The output of a run of the program.
struct Outcome {
    status: i32,
    stdout: String,
    stderr: String,
}

/// Runs the program in `folder` with the given words and standard input.
fn run_with_input(folder: &Path, words: &[&str], input: &[u8]) -> Outcome {
    let mut child = Command::new(env!("CARGO_BIN_EXE_zonobench"))
        .args(words)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("standard input is a pipe");
    let input = input.to_vec();
    let writer = std::thread::spawn(move || {
        // A program that refuses early does not read to the end.
        let _ = stdin.write_all(&input);
    });
    let Output { status, stdout, stderr } = child.wait_with_output().expect("the program ends");
    writer.join().expect("the writer ends");
    let text = |bytes| String::from_utf8(bytes).expect("the program writes text");
    Outcome { status: status.code().expect("the program was not killed"), stdout: text(stdout), stderr: text(stderr) }
}

/// Runs the program in `folder` with the given words.
fn run(folder: &Path, words: &[&str]) -> Outcome {
    run_with_input(folder, words, b"")
}
