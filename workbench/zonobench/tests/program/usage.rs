//! Command lines that make no sense: status 2, nothing on standard output.

mod ends;
mod explore;
mod help;
mod nearest;

use std::fs;
use std::path::Path;

use crate::run;

#[test]
fn usage_errors_have_status_2() {
    let wrong: [&[&str]; 35] = [
        &[],
        &["frobnicate"],
        &["enclose"],
        &["enclose", "p.csv", "--columns", "1"],
        &["enclose", "p.csv", "--format", "xml"],
        &["enclose", "p.csv", "--seed", "x"],
        &["reproduce", "--profile", "huge"],
        &["reproduce", "--threads", "0"],
        &["verify", "q.jsonl"],
        &["verify", "-", "-"],
        &["intersect", "-", "-", "--format", "csv"],
        &["distance", "-", "-", "--format", "json"],
        &["hausdorff", "-", "-", "--format", "json"],
        &["collide", "a.json", "b.json"],
        &["collide", "a.json", "b.json", "--axis", "0,0,1"],
        &["collide", "a.json", "b.json", "--axis", "0,1", "--angle", "1"],
        &["collide", "a.json", "b.json", "--motion", "m.json", "--translation", "1,0,0"],
        &["sweep", "a.json"],
        &["sweep", "a.json", "--axis", "0,0,1"],
        &["sweep", "a.json", "--angle", "1"],
        &["sweep", "a.json", "--degrees", "1"],
        &["collide", "a.json", "b.json", "--axis", "0,0,1", "--angle", "1", "--degrees", "57"],
        &["enclose", "-", "--format", "csv", "--directions", "-"],
        &["enclose", "p.csv", "--objective", "perimeter"],
        &["enclose", "p.csv", "--directions", "net:0"],
        &["enclose", "p.csv", "--epsilon", "1"],
        &["enclose", "p.csv", "--epsilon", "0.1", "--directions", "axes"],
        &["enclose", "p.obj", "--objective", "area"],
        &["enclose", "p.obj", "--columns", "1,2"],
        &["enclose", "p.stl", "--columns", "x,y"],
        &["enclose", "p.json", "--skip", "1"],
        &["enclose", "p.npy", "--skip", "0"],
        &["enclose", "p.csv", "--epsilon", "0.1", "--seed", "1"],
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

#[test]
fn two_runs_do_not_write_into_one_folder() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mark = fs::File::create(folder.path().join("reproduce.unfinished")).expect("created");
    mark.lock().expect("the mark of a run that is not finished is locked");
    for words in [&["reproduce", "--out", "."][..], &["reproduce", "--out", ".", "--force"]] {
        let outcome = run(folder.path(), words);
        assert!(outcome.stderr.starts_with("zonobench: .: another run writes into it; "), "{}", outcome.stderr);
        assert!(outcome.stderr.contains("--out") && outcome.stderr.contains("a run that died"), "{}", outcome.stderr);
        assert_eq!((outcome.status, fs::read_dir(folder.path()).expect("listed").count()), (1, 1));
    }
}

#[test]
fn standard_input_is_read_once() {
    let outcome = run(Path::new("."), &["intersect", "-", "-", "--format", "csv"]);
    let complaint = "-: two inputs cannot both be read from standard input; give the name of a file for one of them";
    assert_eq!(outcome.stderr, format!("zonobench: {complaint}\n"));
}

#[test]
fn questions_take_no_options() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let question = r#"{"id":"q","kind":"min_area","input":{"points":[[0,0]]}}"#;
    fs::write(folder.path().join("q.jsonl"), question).expect("written");
    fs::write(folder.path().join("a.jsonl"), r#"{"id":"q","kind":"min_area","result":{}}"#).expect("written");
    let outcome = run(folder.path(), &["verify", "q.jsonl", "a.jsonl", "--epsilon", "0.1"]);
    assert!(outcome.stderr.starts_with("zonobench: q.jsonl: read as questions"), "{}", outcome.stderr);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""));
}

#[test]
fn a_cause_is_told_once() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("p.csv"), "0,0\n2,0\n0,2\n").expect("written");
    let outcome = run(folder.path(), &["enclose", "p.csv", "--json", "p.csv/a.json"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stderr.starts_with("zonobench: p.csv/a.json: cannot be written: "), "{}", outcome.stderr);
    assert_eq!(outcome.stderr.matches("os error").count(), 1, "{}", outcome.stderr);
}

#[test]
fn the_most_similar_command_is_named_first() {
    let outcome = run(Path::new("."), &["enclos", "p.csv"]);
    assert_eq!(outcome.status, 2);
    let [near, far] = ["'enclose'", "'records'"].map(|name| outcome.stderr.find(name));
    assert!(near.is_some() && far.is_none_or(|far| near < Some(far)), "{}", outcome.stderr);
}

#[test]
fn a_result_is_not_named_as_another_format() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "x,y\n0,0\n4,0\n0,4\n").expect("written");
    fs::write(folder.join("z.json"), "[[1,0,0],[0,1,0],[0,0,1]]").expect("written");
    let cases: [(&[&str], &str); 5] = [
        (&["enclose", "p.csv", "--svg", "x.png"], "x.png: the name is that of another format; SVG is written here"),
        (&["enclose", "p.csv", "--json", "x.svg"], "x.svg: the name is that of another format; JSON is written here"),
        (&["inspect", "z.json", "--obj", "x.STL"], "x.STL: the name is that of another format; OBJ is written here"),
        (&["figure", "paper-figure-1", "--svg", "x.pdf"], "SVG is written here, so name it .svg"),
        (&["reduce", "z.json", "--count", "3", "--question", "q.csv"], "JSON is written here, so name it .json"),
    ];
    for (words, complaint) in cases {
        let outcome = run(folder, words);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""), "{words:?}");
        assert!(outcome.stderr.contains(complaint), "{words:?}: {}", outcome.stderr);
    }
    let free = run(folder, &["enclose", "p.csv", "--svg", "picture", "--json", "answer.jsonl"]);
    assert_eq!(free.status, 0, "{}", free.stderr);
    assert_eq!(fs::read_dir(folder).expect("listed").count(), 4);
}

#[test]
fn bodies_that_are_meant_otherwise_are_told() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("points.csv"), "x,y\n1,0\n0,2\n").expect("written");
    fs::write(folder.join("rows.csv"), "a,b\n1,0\n0,2\n").expect("written");
    fs::write(folder.join("b.json"), r#"{"c":[1,1],"G":[[1,0],[0,1]]}"#).expect("written");
    fs::write(folder.join("space.json"), "[[1,0,0],[0,1,0],[0,0,1]]").expect("written");
    fs::write(folder.join("L.off"), "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n").expect("written");
    let told = run(folder, &["intersect", "points.csv", "b.json"]);
    let advice = "zonobench: points.csv: each row of x, y is read as a generator; `zonobench enclose` makes a body \
                  around points\n";
    assert_eq!((told.status, told.stderr.as_str()), (0, advice));
    let silent = run(folder, &["intersect", "rows.csv", "b.json"]);
    assert_eq!((silent.status, silent.stderr.as_str()), (0, ""));
    for command in [&["intersect"][..], &["distance"], &["hausdorff"], &["collide", "--translation", "1,0,0"]] {
        let refused = run(folder, &[command, &["b.json", "space.json"]].concat());
        let complaint = "zonobench: b.json: has 2 coordinates, while space.json has 3\n";
        assert_eq!((refused.status, refused.stderr.as_str()), (1, complaint));
    }
    let refused = run(folder, &["intersect", "L.off", "b.json"]);
    assert!(refused.stderr.contains("`zonobench enclose L.off --json body.json` makes one"), "{}", refused.stderr);
}
