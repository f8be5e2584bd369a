//! Every command that README, the manual and the report show is run as it is written.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The command with which a checkout runs the program; in the commands below its path takes the place.
const IN_A_CHECKOUT: &str = "cargo run --release -- ";

/// Commands that other programs run, or this one elsewhere: the first words of each, and where it is run.
const ELSEWHERE: [(&str, &str); 5] = [
    ("cargo run --release -- reproduce  ", "the main job of continuous integration"),
    ("cargo test --workspace", "this test is a part of it"),
    ("cargo run --release -p peers", "a race of six minutes; its methods are tested in its crate"),
    ("cargo add", "changes the manifest of another project"),
    ("cargo install", "compiles everything a second time; the release build of the main job is the same code"),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The commands among the indented lines of a text: all up to a `#` that begins a remark. Lines of the form `command
/// PLACEHOLDER      what it does` are a synopsis.
fn indented_commands(markdown: &str) -> Vec<String> {
    let lines = markdown.lines().filter_map(|line| line.strip_prefix("    "));
    let commands = lines.filter(|line| line.starts_with("cargo ") || line.starts_with("zonobench "));
    commands
        .map(|line| line.split_once(" # ").map_or(line, |(command, _)| command))
        .filter(|line| line.starts_with("cargo ") || !line.trim().contains("   "))
        .map(str::to_owned)
        .collect()
}

/// The commands of the report's chapters, as the chapters write them: string literals, the lines of which are joined.
fn chapter_commands() -> Vec<String> {
    let folder = root().join("workbench/zonobench/src/report/chapters");
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder).expect("the chapters are there").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    let mut commands = Vec::new();
    for file in files {
        let source = fs::read_to_string(&file).expect("a chapter");
        let lists = source.split("commands: &[").skip(1);
        for list in lists.filter_map(|rest| rest.split_once("\n    ],").or_else(|| rest.split_once(")],"))) {
            let literals = list.0.replace("\\\"", "\u{1}");
            let strings = literals.split('"').skip(1).step_by(2);
            let joined = strings.map(|literal| literal.split("\\\n").map(str::trim_start).collect::<String>());
            commands.extend(joined.filter(|text| text.contains(IN_A_CHECKOUT)).map(|text| text.replace('\u{1}', "\"")));
        }
    }
    commands
}

/// A folder that looks as a checkout does to the commands, with the files that they call the user's own.
fn checkout() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let at = |name: &str| folder.path().join(name);
    for files in ["experiments/data", "tests/goldens"] {
        fs::create_dir_all(at(files)).expect("created");
        for entry in fs::read_dir(root().join(files)).expect("listed").map(|entry| entry.expect("a file")) {
            if entry.path().is_file() {
                fs::copy(entry.path(), at(files).join(entry.file_name())).expect("copied");
            }
        }
    }
    let data = |name: &str| at("experiments/data").join(name);
    fs::copy(data("cgal_fandisk.obj"), at("a.obj")).expect("copied");
    fs::copy(data("cgal_cow.obj"), at("b.obj")).expect("copied");
    fs::copy(data("outline_croatia.csv"), at("points.csv")).expect("copied");
    let in_general_position = "[[1,0,0.5],[0.25,1,-0.5],[-1,0.75,1],[0.5,0.5,2],[1,-2,0.125]]";
    let body = format!("{{\"center\":[0,0,0],\"generators\":{in_general_position}}}");
    for name in ["z.json", "first.json", "second.json"] {
        fs::write(at(name), &body).expect("written");
    }
    folder
}

/// Runs a command in a folder by the shell, the program in the place of what a checkout builds, and in the place of the
/// browser, which a machine may not have, a command that does nothing.
fn run_by_shell(folder: &Path, command: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_zonobench");
    let own = command.replace(IN_A_CHECKOUT, "zonobench ").replace("zonobench ", &format!("'{program}' "));
    Command::new("sh").args(["-c", &own]).env("BROWSER", "true").current_dir(folder).output().expect("a shell")
}

/// Runs the commands one after the other in one folder.
fn all_succeed(commands: &[String]) {
    if cfg!(not(unix)) {
        eprintln!("SKIPPED, documented commands were not run: they are written for a shell of Unix");
        return;
    }
    let folder = checkout();
    for command in commands {
        let Output { status, stderr, .. } = run_by_shell(folder.path(), command);
        assert!(status.success(), "{command}\n{}", String::from_utf8_lossy(&stderr));
    }
}

fn is_run_here(command: &String) -> bool {
    let padded = format!("{command}   ");
    !ELSEWHERE.iter().any(|(begin, _)| padded.starts_with(begin))
}

#[test]
fn commands_of_the_readme_run_as_written() {
    let readme = text("README.md");
    let mut commands = indented_commands(&readme);
    assert!(commands.len() > 15, "{commands:#?}");
    for (begin, _) in ELSEWHERE {
        let is_there = commands.iter().any(|command| format!("{command}   ").starts_with(begin));
        assert!(is_there || readme.contains(begin), "README does not speak of `{begin}`");
    }
    commands.retain(is_run_here);
    // those within sentences, where a line may break
    let flat = readme.split_whitespace().collect::<Vec<_>>().join(" ");
    let within = flat.split('`').skip(1).step_by(2).filter(|span| span.contains(".json") && span.contains(' '));
    let within: Vec<String> =
        within.filter(|span| !span.contains('/')).map(|span| format!("zonobench {span}")).collect();
    assert!(within.len() >= 2, "{within:#?}");
    commands.extend(within);
    all_succeed(&commands);
}

#[test]
fn commands_of_the_manual_run_as_written() {
    let commands = indented_commands(&text("workbench/zonobench/MANUAL.md"));
    assert!(commands.len() >= 8, "{commands:#?}");
    all_succeed(&commands);
}

#[test]
fn commands_of_the_report_run_as_written() {
    let mut commands = chapter_commands();
    let found = commands.len();
    commands.sort();
    commands.dedup();
    // `enclose` of an outline before `verify` of its answer
    commands.sort_by_key(|command| command.contains(" verify "));
    assert!(found > 10 && commands.len() > 8, "{commands:#?}");
    all_succeed(&commands);
}
