//! The command line itself: help, listing, and what makes no sense.

use paper_checks::catalog::CLAIMS;

use crate::program::{output, zonobench};

#[test]
fn a_command_line_that_makes_no_sense_ends_with_status_2() {
    let senseless: [&[&str]; 7] = [
        &[],
        &["no-such-command"],
        &["list", "no-such-list"],
        &["enclose"],
        &["verify", "one-file-only.jsonl"],
        &["reproduce", "--threads", "0"],
        &["solve", "--no-such-switch"],
    ];
    for arguments in senseless {
        let assertion = zonobench().args(arguments).assert().code(2);
        let output = assertion.get_output();
        assert!(output.stdout.is_empty(), "{arguments:?} printed a result");
        assert!(!output.stderr.is_empty(), "{arguments:?} was refused without a word");
    }
}

#[test]
fn help_and_version_are_results() {
    assert!(output(zonobench().arg("--help")).contains("reproduce"));
    assert!(output(zonobench().arg("--version")).starts_with("zonobench "));
    let commands = [
        "reproduce",
        "figure",
        "list",
        "enclose",
        "contains",
        "intersect",
        "distance",
        "reduce",
        "inspect",
        "solve",
        "verify",
        "records",
        "completions",
        "man",
    ];
    for command in commands {
        let help = output(zonobench().args([command, "--help"]));
        assert!(help.contains("Usage"), "{command}");
    }
}

#[test]
fn everything_is_listed_by_id() {
    let listed = |what: &str| -> Vec<String> {
        output(zonobench().args(["list", what]))
            .lines()
            .map(|line| line.split('\t').next().unwrap_or_default().to_owned())
            .collect()
    };
    assert_eq!(listed("claims"), CLAIMS.iter().map(|claim| claim.id).collect::<Vec<_>>());
    let experiments: Vec<&str> = experiments::catalog::EXPERIMENTS.iter().map(|experiment| experiment.id).collect();
    assert_eq!(listed("experiments"), experiments);
    assert!(listed("methods").contains(&"support".to_owned()));
}

#[test]
fn a_missing_file_is_named_and_ends_with_status_1() {
    for arguments in [["solve", "missing.jsonl", "--strict"].as_slice(), &["verify", "missing.jsonl", "missing.jsonl"]]
    {
        let assertion = zonobench().args(arguments).assert().code(1);
        let complaint = String::from_utf8_lossy(&assertion.get_output().stderr).into_owned();
        assert_eq!(complaint.lines().count(), 1, "{complaint}");
        assert!(complaint.starts_with("zonobench: missing.jsonl: cannot be read"), "{complaint}");
    }
}

#[test]
fn reproduce_does_not_write_into_a_folder_that_holds_something() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("notes.txt"), "mine").expect("a file of somebody's");
    let assertion = zonobench().arg("reproduce").arg("--out").arg(folder.path()).assert().code(1);
    let complaint = String::from_utf8_lossy(&assertion.get_output().stderr).into_owned();
    assert!(complaint.contains("--force"), "{complaint}");
    let names: Vec<_> =
        std::fs::read_dir(folder.path()).expect("the folder").map(|entry| entry.expect("a file").file_name()).collect();
    assert_eq!(names, ["notes.txt"]);
}
