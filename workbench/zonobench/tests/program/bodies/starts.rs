//! Lines above the vectors of a table: `--skip` and `--no-header` for every body, and the options that none has.

use std::fs;
use std::path::Path;

use crate::run;

const HEADED: &str = "mast,1,2\n1,0,0\n0,1,0\n0,0,1\n";

/// The row of a summary.
fn generators(folder: &Path, words: &[&str]) -> String {
    let outcome = run(folder, words);
    assert_eq!(outcome.status, 0, "{words:?}: {}", outcome.stderr);
    let summary = outcome.stdout + &outcome.stderr;
    let row = summary.lines().find(|line| line.starts_with("body ") || line.starts_with("a  "));
    row.unwrap_or_else(|| panic!("no body in {summary}")).split_whitespace().nth(1).unwrap_or_default().to_owned()
}

#[test]
fn lines_of_a_table_are_left_out_of_every_body() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for (name, text) in [("t.csv", HEADED), ("u.csv", HEADED), ("c.csv", "1,0,0\n0,1,0\n0,0,1\n"), ("p.csv", "0,0,0\n")]
    {
        fs::write(folder.join(name), text).expect("written");
    }
    let refused = |words: &[&str]| run(folder, words).stderr;
    let told =
        |option: &str| format!("'mast' is not a number, but below it is one; if this line is a header, {option} 1");
    for command in [
        &["inspect", "t.csv"][..],
        &["reduce", "t.csv", "--count", "3"],
        &["sweep", "t.csv", "--translation", "1,0,0"],
        &["intersect", "t.csv", "u.csv"],
        &["distance", "t.csv", "u.csv"],
        &["hausdorff", "t.csv", "u.csv"],
        &["collide", "t.csv", "u.csv", "--translation", "1,0,0"],
    ] {
        let complaint = refused(command);
        assert!(complaint.contains(&told("--skip")), "{command:?}: {complaint}");
        let answer = [command, &["--skip", "1", "--json", "a.json", "--force"]].concat();
        assert_eq!(generators(folder, &answer), "3", "{command:?}");
        let files = command.iter().copied().filter(|word| word.ends_with(".csv"));
        let verified = run(folder, &["verify"].into_iter().chain(files).chain(["a.json"]).collect::<Vec<_>>());
        assert!(verified.stdout.contains("\tright\t"), "{command:?}: {}{}", verified.stdout, verified.stderr);
    }
    let second = refused(&["intersect", "c.csv", "t.csv"]);
    assert!(second.contains(&told("--skip-b")), "{second}");
    assert_eq!(generators(folder, &["intersect", "c.csv", "t.csv", "--skip-b", "1"]), "3");
    assert_eq!(generators(folder, &["intersect", "t.csv", "c.csv", "--skip", "1", "--no-header-b"]), "3");
    let body = refused(&["contains", "t.csv", "p.csv"]);
    assert!(body.contains(&told("--body-skip")), "{body}");
    assert_eq!(generators(folder, &["contains", "t.csv", "p.csv", "--body-skip", "1"]), "3");
    let drawn = run(folder, &["draw", "tiling", "t.csv", "--skip", "1", "--svg", "t.svg"]);
    assert_eq!(drawn.status, 0, "{}", drawn.stderr);
}

#[test]
fn a_first_row_is_data_where_that_is_said() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("t.csv"), "2 3\n1 0 0\n0 1 0\n").expect("written");
    fs::write(folder.join("n.csv"), "0,1\n0.5,0.5\n1.5,0.25\n").expect("written");
    fs::write(folder.join("z.json"), "[[1,0,0],[0,1,0],[0,0,1]]").expect("written");
    assert_eq!(generators(folder, &["inspect", "n.csv", "--no-header"]), "3");
    assert!(run(folder, &["inspect", "n.csv", "--no-header"]).stderr.is_empty());
    assert_eq!(generators(folder, &["inspect", "n.csv", "--skip", "1"]), "2");
    let ragged = run(folder, &["inspect", "t.csv", "--no-header"]);
    assert!(ragged.status == 1 && ragged.stderr.contains("cells"), "the sizes are data: {}", ragged.stderr);
    let json = run(folder, &["inspect", "z.json", "--no-header"]);
    assert_eq!(json.status, 2);
    assert!(json.stderr.starts_with("zonobench: --skip: only tables have lines that are left out"), "{}", json.stderr);
}

#[test]
fn an_option_that_a_command_cannot_have_says_why() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (words, why) in [
        (&["inspect", "z.json", "--columns", "1,2"][..], "the rows of a zonotope are read whole"),
        (&["intersect", "z.json", "z.json", "--skip-nan"], "no generators of a zonotope are left out"),
        (&["mesh", "a.obj", "b.obj", "--no-header"], "meshes have no columns and no header"),
        (&["mesh", "a.obj", "b.obj", "--center-first"], "meshes have no generators"),
        (&["enclose", "p.csv", "--center-first"], "the rows of the file are points"),
        (&["verify", "z.json", "a.json", "--center-first"], "an answer records how its zonotopes were read"),
        (&["solve", "--columns=1,2"], "questions are lines of JSON"),
    ] {
        let outcome = run(folder.path(), words);
        assert!(
            outcome.status == 2 && outcome.stderr.contains(&format!("tip: {why}")),
            "{words:?}: {}",
            outcome.stderr
        );
    }
}
