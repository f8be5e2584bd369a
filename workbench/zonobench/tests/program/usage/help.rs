//! The program's words on itself: a sentence each in the short help, lines as wide as the terminal.

use std::path::Path;
use std::process::Command;

use clap::{CommandFactory, ValueEnum};
use zonobench::cli::Cli;
use zonobench::input::Format;

use crate::run;

/// The help of a command on a terminal of so many columns.
fn help(words: &[&str], columns: usize) -> String {
    let run = Command::new(env!("CARGO_BIN_EXE_zonobench")).args(words).env("COLUMNS", columns.to_string()).output();
    String::from_utf8(run.expect("the program runs").stdout).expect("help is text")
}

#[test]
fn lines_are_no_wider_than_the_terminal() {
    for command in Cli::command().get_subcommands() {
        for option in ["-h", "--help"] {
            for columns in [72, 100] {
                let text = help(&[command.get_name(), option], columns);
                let widest = text.lines().map(|line| line.chars().count()).max().unwrap_or_default();
                assert!(widest <= columns && text.contains("Usage"), "{} {option}: {widest}", command.get_name());
            }
        }
    }
}

#[test]
fn the_short_help_has_a_sentence_for_each_option() {
    for command in Cli::command().get_subcommands() {
        for argument in command.get_arguments() {
            let help = argument.get_help().map(ToString::to_string).unwrap_or_default();
            let name = format!("{} {}", command.get_name(), argument.get_id());
            let sentences = help.split(". ").filter(|rest| rest.starts_with(char::is_uppercase)).count();
            assert_eq!(sentences, 1, "{name}: {help}");
            assert!(help.chars().count() <= 130, "{name}: {help}");
        }
    }
    let short = help(&["enclose", "-h"], 80);
    let long = help(&["enclose", "--help"], 80);
    assert!(!short.contains("local minimum") && long.contains("local minimum"), "the rest is in the long help");
}

#[test]
fn the_formats_of_a_command_are_those_that_it_reads() {
    let formats = |words: &[&str], option: &str| -> Vec<String> {
        let text = help(&[words, &["-h"]].concat(), 1000);
        let line = text.lines().find(|line| line.contains(&format!("{option} <"))).unwrap_or_else(|| panic!("{text}"));
        let (_, values) = line.split_once("[possible values: ").expect("it has values");
        values.trim_end_matches(']').split(", ").map(str::to_owned).collect()
    };
    let all: Vec<String> = Format::value_variants().iter().map(Format::to_string).collect();
    assert_eq!(formats(&["enclose"], "--format"), all);
    assert_eq!(formats(&["contains"], "--format"), all);
    for (command, option) in [
        ("intersect", "--format"),
        ("distance", "--format"),
        ("hausdorff", "--format"),
        ("collide", "--format"),
        ("sweep", "--format"),
        ("reduce", "--format"),
        ("inspect", "--format"),
        ("contains", "--body-format"),
    ] {
        // two meshes collide as well
        let of_meshes: &[&str] = if command == "collide" { &["obj", "ply", "stl", "off"] } else { &[] };
        assert_eq!(formats(&[command], option), [&["csv", "json", "npy"], of_meshes].concat(), "{command}");
        let text = help(&[command, "-h"], 1000);
        assert!(text.contains("(csv, json, npy)"), "{text}");
    }
    let refused = run(Path::new("."), &["inspect", "z.obj", "--format", "obj"]);
    assert_eq!(refused.status, 2, "{}", refused.stderr);
}
