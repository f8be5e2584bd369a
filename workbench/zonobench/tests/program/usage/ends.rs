//! Results that cannot be written: refused before the work, never taken for success, and no reason to keep others back.

use std::fs;
use std::path::Path;

use crate::run;

const POINTS: &str = "0,0\n2,0\n0,2\n";

#[test]
fn a_result_that_cannot_be_written_is_refused_before_the_work() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for name in ["p.csv", "taken"] {
        fs::write(folder.join(name), POINTS).expect("written");
    }
    fs::write(folder.join("z.json"), "[[1,0,0],[0,1,0],[0,0,1]]").expect("written");
    fs::create_dir(folder.join("folder")).expect("made");
    let wrong = ["taken/a", "taken/b/a", "folder", "taken"];
    let commands: [(&[&str], &[&str]); 11] = [
        (&["enclose", "lost.csv"], &["--json", "--svg", "--obj"]),
        (&["intersect", "lost.json", "z.json"], &["--json", "--svg", "--question"]),
        (&["distance", "lost.json", "z.json"], &["--json", "--svg", "--question"]),
        (&["hausdorff", "lost.json", "z.json"], &["--json", "--question"]),
        (&["collide", "lost.json", "z.json", "--translation", "1,0,0"], &["--json", "--question"]),
        (&["sweep", "lost.json", "--translation", "1,0,0"], &["--json", "--obj", "--ply", "--stl"]),
        (&["contains", "lost.json", "p.csv"], &["--json", "--question"]),
        (&["reduce", "lost.json", "--count", "3"], &["--json", "--svg", "--question"]),
        (&["inspect", "lost.json"], &["--json", "--svg", "--question", "--obj", "--ply", "--stl"]),
        (&["draw", "zonogon", "lost.csv"], &["--svg"]),
        (&["figure", "paper-figure-1"], &["--svg"]),
    ];
    for (command, options) in commands {
        for option in options {
            for file in wrong {
                let outcome = run(folder, &[command, &[option, file]].concat());
                assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""), "{command:?} {option} {file}");
                // The input is lost, but the output was looked at before.
                let expected = format!("zonobench: {file}: ");
                assert!(outcome.stderr.starts_with(&expected), "{command:?} {option}: {}", outcome.stderr);
            }
        }
    }
    assert_eq!(fs::read_dir(folder).expect("listed").count(), 4, "nothing is left of the refused commands");
}

#[test]
fn a_result_that_fails_keeps_back_neither_the_summary_nor_other_results() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("segment.json"), "[[1,0,0]]").expect("written");
    let outcome = run(folder, &["inspect", "segment.json", "--obj", "z.obj", "--json", "z.json"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stdout.contains("dimension     1 in 3: a segment"), "{}", outcome.stdout);
    assert!(outcome.stderr.contains("a segment has no facets to be written"), "{}", outcome.stderr);
    assert_eq!((folder.join("z.obj").exists(), folder.join("z.json").exists()), (false, true));
}

/// Runs a line of a shell in the folder, with the path of the program as `$P`; gives status and complaints.
#[cfg(unix)]
fn shell(folder: &Path, line: &str) -> (Option<i32>, String) {
    let program = env!("CARGO_BIN_EXE_zonobench");
    let run = std::process::Command::new("sh").args(["-c", line]).env("P", program).current_dir(folder).output();
    let output = run.expect("a shell");
    (output.status.code(), String::from_utf8(output.stderr).expect("the program writes text"))
}

#[cfg(target_os = "linux")]
#[test]
fn answers_that_nobody_can_read_are_no_success() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let question = r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}"#;
    fs::write(folder.join("q.jsonl"), format!("{question}\n").repeat(2000)).expect("written");
    fs::write(folder.join("p.csv"), POINTS).expect("written");
    let closed = "standard output is closed";
    for line in ["$P solve q.jsonl >&-", "$P solve <q.jsonl >&-", "$P solve --strict q.jsonl >&-"] {
        let (status, complaint) = shell(folder, line);
        assert_eq!(status, Some(1), "{line}");
        assert!(
            complaint.starts_with("zonobench: the answers cannot be written: ") && complaint.contains(closed),
            "{complaint}"
        );
    }
    let (status, complaint) = shell(folder, "$P enclose p.csv --json - >&-");
    assert!(status == Some(1) && complaint.contains(closed), "{complaint}");
    let (status, complaint) = shell(folder, "$P solve q.jsonl >/dev/full");
    assert!(status == Some(1) && complaint.contains("os error 28"), "{complaint}");
    assert_eq!(shell(folder, "$P solve q.jsonl >/dev/null"), (Some(0), String::new()), "dropped on purpose");
    assert_eq!(shell(folder, "$P enclose p.csv --json a.json >&-"), (Some(0), String::new()), "the answer is kept");
}

/// As a program that the signal SIGPIPE ends: silent, and a failure for who looks at its status.
#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_ends_the_program_with_its_status() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let question = r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}"#;
    fs::write(folder.join("q.jsonl"), format!("{question}\n").repeat(2000)).expect("written");
    let line = "{ $P solve q.jsonl; echo $? >status; } | head -n 1 >first";
    assert_eq!(shell(folder, line), (Some(0), String::new()));
    let text = |name: &str| fs::read_to_string(folder.join(name)).expect("written");
    assert_eq!((text("status").as_str(), text("first").lines().count()), ("141\n", 1));
    let whole = "{ $P solve q.jsonl; echo $? >status; } | cat >all";
    assert_eq!(shell(folder, whole), (Some(0), String::new()));
    assert_eq!((text("status").as_str(), text("all").lines().count()), ("0\n", 2000));
}
