//! Results that cannot be written: refused before the work, never taken for success, and no reason to keep others back.

use std::fs;
use std::path::Path;

use crate::run;

/// A short question of `solve`.
const QUESTION: &str = r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[2,0],[0,2]]}}"#;

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
    fs::write(folder.join("q.jsonl"), format!("{QUESTION}\n").repeat(2000)).expect("written");
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
    let (status, complaint) = shell(folder, "$P solve q.jsonl >/dev/full");
    assert_eq!(status, Some(1));
    assert!(complaint.starts_with("zonobench: the answers cannot be written: standard output: "), "{complaint}");
    assert_eq!(shell(folder, "$P solve q.jsonl >/dev/null"), (Some(0), String::new()), "dropped on purpose");
    let (status, complaint) = shell(folder, "$P enclose p.csv --json a.json >&-");
    assert!(status == Some(1) && complaint.contains(closed), "the summary is lost: {complaint}");
    assert!(folder.join("a.json").is_file(), "the answer is kept");
}

/// Every command that prints on standard output, with something to work on.
#[cfg(target_os = "linux")]
const PRINTING: [&str; 27] = [
    "enclose p.csv",
    "enclose a.obj",
    "enclose p.csv --json -",
    "intersect z.json z.json",
    "distance z.json z.json",
    "hausdorff z.json z.json",
    "collide z.json z.json --translation 5,0,0",
    "sweep z.json --axis 0,0,1 --degrees 30",
    "contains z.json a.obj",
    "reduce z.json --count 3",
    "inspect z.json",
    "mesh a.obj a.obj",
    "mesh a.obj --level 1",
    "verify p.csv right.json",
    "verify q.jsonl nothing.json",
    "solve q.jsonl",
    "list",
    "list figures",
    "draw zonogon p.csv --svg -",
    "figure paper-figure-1 --svg -",
    "explore --out -",
    "completions bash",
    "man enclose",
    "compare r r",
    "records export r --csv -",
    "merge shards",
    "--version",
];

/// Writes points, a body, a question and the configuration of a short run.
#[cfg(target_os = "linux")]
fn write_inputs(folder: &Path) {
    let config = "[experiment.hull-scaling]\nfamilies = [\"disc\"]\nsizes = [8]\ninstances = 1\n";
    for (name, text) in
        [("p.csv", POINTS), ("z.json", "[[1,0,0],[0,1,0],[0,0,1]]"), ("q.jsonl", QUESTION), ("my.toml", config)]
    {
        fs::write(folder.join(name), text).expect("written");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn no_command_takes_a_lost_output_for_success() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let mesh = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    write_inputs(folder);
    for (name, text) in [("a.obj", mesh), ("nothing.json", "")] {
        fs::write(folder.join(name), text).expect("written");
    }
    for made in [
        "enclose p.csv --json right.json",
        "reproduce --config my.toml --out r",
        "solve q.jsonl --shard 0/1 --out shards",
    ] {
        assert_eq!(shell(folder, &format!("$P {made} >/dev/null")).0, Some(0), "{made}");
    }
    for command in PRINTING {
        let dropped = shell(folder, &format!("$P {command} >/dev/null")).0;
        assert_eq!(dropped, Some(i32::from(command.ends_with("nothing.json"))), "{command}: dropped on purpose");
        for (end, complaint) in [(">&-", "standard output is closed"), (">/dev/full", "standard output: cannot be")] {
            let (status, told) = shell(folder, &format!("$P {command} {end}"));
            assert_eq!(status, Some(1), "{command} {end}: {told}");
            let last = told.lines().last().unwrap_or_default();
            assert!(last.starts_with("zonobench: ") && last.contains(complaint), "{command} {end}: {told}");
        }
        let (_, told) = shell(folder, &format!("{{ $P {command}; echo $? >status; }} | head -c 0"));
        let status = fs::read_to_string(folder.join("status")).expect("written");
        // a short answer may be gone before its reader is
        assert!(["141\n", "0\n"].contains(&&*status) || command.ends_with("nothing.json"), "{command}: {status}");
        assert!(!told.contains("zonobench: "), "{command}: {told}");
    }
    let files_are_kept = "$P reproduce --config my.toml --out s >&-";
    assert_eq!(shell(folder, files_are_kept).0, Some(1), "the summary is lost");
    assert!(folder.join("s/manifest.json").is_file(), "the report is kept");
}

/// No file may grow, as on a disk that is full: the complaint names the file that was asked for, not a temporary one,
/// and no summary says that it is there.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_with_the_name_of_the_file() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    write_inputs(folder);
    assert_eq!(shell(folder, "$P reproduce --config my.toml --out r >/dev/null").0, Some(0));
    assert_eq!(shell(folder, "$P solve q.jsonl --shard 0/1 --out shards").0, Some(0));
    for (command, file) in [
        ("enclose p.csv --json new.json", "new.json"),
        ("enclose p.csv --svg new.svg", "new.svg"),
        ("inspect z.json --obj new.obj", "new.obj"),
        ("inspect z.json --ply new.ply", "new.ply"),
        ("inspect z.json --stl new.stl", "new.stl"),
        ("inspect z.json --question new.json", "new.json"),
        ("contains z.json z.json --format json --json new.json", "new.json"),
        ("figure paper-figure-1 --svg new.svg", "new.svg"),
        ("draw zonogon p.csv --svg new.svg", "new.svg"),
        ("explore --out new.html", "new.html"),
        ("records export r --csv new.csv", "new.csv"),
        ("merge shards --out new.jsonl", "new.jsonl"),
        ("solve q.jsonl --shard 0/1 --out new", "new/solve.0-of-1.shard"),
        ("reproduce --config my.toml --out s", "s/records: counts.jsonl"),
    ] {
        let (status, told) = shell(folder, &format!("trap '' XFSZ; ulimit -f 0; $P {command}"));
        let complaint = told.lines().last().unwrap_or_default();
        assert!(status == Some(1) && complaint.contains(file), "{command}: {told}");
        assert!(complaint.starts_with("zonobench: ") && !told.contains(".zonobench-"), "{command}: {told}");
        assert!(complaint.contains("File too large"), "{command}: {told}");
        assert!(!folder.join(file).exists(), "{command}");
    }
    let (status, told) = shell(folder, "trap '' XFSZ; ulimit -f 0; $P explore --out new.html");
    assert!(status == Some(1) && told.starts_with("zonobench: new.html: cannot be written: "), "{told}");
    let printed = "trap '' XFSZ; ulimit -f 0; $P draw zonogon p.csv --svg new.svg | grep -c new.svg";
    assert_eq!(shell(folder, printed).0, Some(1), "no line says that the picture is there");
}

/// As a program that the signal SIGPIPE ends: silent, and a failure for who looks at its status.
#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_ends_the_program_with_its_status() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("q.jsonl"), format!("{QUESTION}\n").repeat(2000)).expect("written");
    let line = "{ $P solve q.jsonl; echo $? >status; } | head -n 1 >first";
    assert_eq!(shell(folder, line), (Some(0), String::new()));
    let text = |name: &str| fs::read_to_string(folder.join(name)).expect("written");
    assert_eq!((text("status").as_str(), text("first").lines().count()), ("141\n", 1));
    let whole = "{ $P solve q.jsonl; echo $? >status; } | cat >all";
    assert_eq!(shell(folder, whole), (Some(0), String::new()));
    assert_eq!((text("status").as_str(), text("all").lines().count()), ("0\n", 2000));
}
