//! Answers that `enclose` writes: what they say of the columns, what `verify` makes of them, and the bodies that they
//! hold.

use std::fs;
use std::path::Path;

use crate::run;
use serde_json::{Value, json};

const SPACE: &str = "name,x,y,z\nA,0,0,1\nB,3,1,0\nC,1,2,5\nD,-1,0.5,2\n";

/// The output of `enclose` about a file in the folder; the answer goes to `a.json`.
fn enclosed(folder: &Path, file: &str, words: &[&str]) -> String {
    let outcome = run(folder, &[&["enclose", file, "--json", "a.json", "--force"], words].concat());
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""), "{file} {words:?}");
    outcome.stdout
}

/// The status of `verify`, with the kind, the verdict and the reason that it prints about `a.json`.
fn verified(folder: &Path, file: &str, words: &[&str]) -> (i32, [String; 3]) {
    let outcome = run(folder, &[&["verify", file, "a.json"], words].concat());
    assert_eq!(outcome.stderr, "", "{words:?}");
    let cells: Vec<&str> = outcome.stdout.trim_end().split('\t').collect();
    (outcome.status, [1, 2, 3].map(|cell| cells[cell].to_owned()))
}

fn row<'a>(summary: &'a str, label: &str) -> &'a str {
    let line = summary.lines().find_map(|line| line.strip_prefix(label));
    line.unwrap_or_else(|| panic!("no {label} in {summary}")).trim_start()
}

fn change(folder: &Path, change: impl FnOnce(&mut Value)) {
    let file = folder.join("a.json");
    let mut answer = serde_json::from_str(&fs::read_to_string(&file).expect("an answer")).expect("JSON");
    change(&mut answer);
    fs::write(&file, answer.to_string()).expect("written");
}

#[test]
fn a_table_of_space_is_enclosed_in_space() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), SPACE).expect("written");
    let summary = enclosed(folder, "p.csv", &[]);
    assert_eq!(row(&summary, "points"), "4 in p.csv, with 3 coordinates");
    assert_eq!(row(&summary, "columns"), "x, y, z; left out: name");
    let (status, [kind, verdict, _]) = verified(folder, "p.csv", &[]);
    assert_eq!((status, kind.as_str(), verdict.as_str()), (0, "min_length_all", "right"));

    let plane = run(folder, &["enclose", "p.csv", "--objective", "area"]);
    assert_eq!(plane.status, 1);
    assert!(plane.stderr.contains("columns x, y and z") && plane.stderr.contains("--columns"), "{}", plane.stderr);
    let summary = enclosed(folder, "p.csv", &["--objective", "area", "--columns", "x,z"]);
    assert_eq!(row(&summary, "columns"), "x, z; left out: name, y");
    assert_eq!(run(folder, &["enclose", "p.csv", "--exact"]).status, 2);
}

#[test]
fn what_is_left_out_is_said() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("map.csv"), "lat,lon,height\n1,2,3\n4,6,5\n2,0,1\n").expect("written");
    assert_eq!(row(&enclosed(folder, "map.csv", &[]), "columns"), "lon, lat; left out: height");
    fs::write(folder.join("map.geojson"), r#"{"type":"MultiPoint","coordinates":[[0,0,9],[6,0],[0,6,1]]}"#)
        .expect("written");
    assert_eq!(row(&enclosed(folder, "map.geojson", &[]), "columns"), "left out: the altitudes of 2 positions");
    fs::write(folder.join("mesh.obj"), "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 8 8 8 1\nf 2 3 4\nl 5 3\n")
        .expect("written");
    assert_eq!(row(&enclosed(folder, "mesh.obj", &[]), "columns"), "left out: 2 vertices that nothing uses");
}

#[test]
fn arrays_are_points_and_generators() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 3), }";
    let numbers: [f32; 12] = [0.0, 0.0, 1.0, 3.0, 1.0, 0.0, 1.0, 2.0, 5.0, -1.0, 0.5, 2.0];
    let numbers: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    let array = [b"\x93NUMPY\x01\x00\x40\x00", format!("{header:<63}\n").as_bytes(), &numbers].concat();
    fs::write(folder.join("p.npy"), &array).expect("written");
    let summary = enclosed(folder, "p.npy", &[]);
    assert_eq!(row(&summary, "points"), "4 in p.npy, with 3 coordinates");
    assert_eq!(row(&summary, "columns"), "1, 2, 3");
    assert_eq!(verified(folder, "p.npy", &[]).1[1], "right");
    let summary = enclosed(folder, "p.npy", &["--columns", "3,1"]);
    assert_eq!(row(&summary, "columns"), "3, 1; left out: column 2");
    assert_eq!(verified(folder, "p.npy", &[]).1[..2], ["min_area", "right"]);
    let inspected = run(folder, &["inspect", "p.npy"]);
    assert!(row(&inspected.stdout, "body").starts_with("4 generators"), "{}{}", inspected.stdout, inspected.stderr);
    fs::write(folder.join("p.npy"), &array[..array.len() - 1]).expect("written");
    let refused = run(folder, &["enclose", "p.npy"]);
    assert_eq!(refused.status, 1);
    assert!(refused.stderr.starts_with("zonobench: p.npy: is not npy: 47 bytes follow"), "{}", refused.stderr);
}

#[test]
fn skipped_lines_are_recorded() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "3,2,north,south\n# rows\n0,0,0,\n2,0,1,\n0,2,1,\n").expect("written");
    let refused = run(folder, &["enclose", "p.csv", "--columns", "1,2"]);
    assert!(
        refused.stderr.contains("line 1, column 3: 'north' stands beside numbers and above one; if"),
        "{}",
        refused.stderr
    );
    let summary = enclosed(folder, "p.csv", &["--columns", "1,2", "--skip", "1"]);
    assert_eq!(row(&summary, "columns"), "1, 2; left out: column 3, the first line, 1 line that begins with #");
    assert_eq!(verified(folder, "p.csv", &[]).1[1], "right");
    let (status, [_, verdict, _]) = verified(folder, "p.csv", &["--skip", "2"]);
    assert_eq!((status, verdict.as_str()), (0, "right"), "the second line is a comment");
    assert_eq!(verified(folder, "p.csv", &["--skip", "3"]).1[1], "unchecked");
}

#[test]
fn verify_needs_no_option() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), SPACE).expect("written");
    fs::write(folder.join("p.dat"), SPACE).expect("written");
    fs::write(folder.join("d.csv"), "1,0,0\n0,1,0\n0,0,1\n1,1,1\n").expect("written");
    let asked: [(&str, &[&str], &str); 8] = [
        ("p.csv", &["--columns", "3,2"], "min_area"),
        ("p.csv", &["--columns", "y,x", "--exact"], "min_area"),
        ("p.csv", &["--columns", "x,y", "--epsilon", "0.25"], "min_length_all"),
        ("p.csv", &["--max-generators", "4"], "min_length_all"),
        ("p.csv", &["--objective", "volume", "--epsilon", "0.1"], "min_length_all"),
        ("p.csv", &["--directions", "net:2"], "min_length_dirs"),
        ("p.csv", &["--directions", "d.csv"], "min_length_dirs"),
        ("p.dat", &["--format", "csv", "--objective", "length"], "min_length_all"),
    ];
    for (file, words, kind) in asked {
        let summary = enclosed(folder, file, words);
        assert_eq!(row(&summary, "verify"), format!("zonobench verify {file} a.json"), "{words:?}");
        let (status, [found, verdict, reason]) = verified(folder, file, &[]);
        assert_eq!((status, found.as_str(), verdict.as_str()), (0, kind, "right"), "{words:?}: {reason}");
        let repeated: Vec<&str> = words.iter().copied().filter(|word| *word != "--exact").collect();
        assert_eq!(verified(folder, file, &repeated).0, 0, "{words:?}");
    }
}

#[test]
fn options_that_ask_for_something_else_make_no_answer_wrong() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), SPACE).expect("written");
    let asked: [(&[&str], &[&[&str]]); 3] = [
        (&["--columns", "x,y"], &[&["--columns", "y,x"], &["--objective", "length"], &["--epsilon", "0.1"]]),
        (&[], &[&["--columns", "x,y"], &["--epsilon", "1e-9"], &["--directions", "axes"], &["--objective", "area"]]),
        (&["--directions", "axes"], &[&["--directions", "net:2"], &["--epsilon", "0.1"], &["--columns", "z,y,x"]]),
    ];
    for (words, others) in asked {
        enclosed(folder, "p.csv", words);
        for other in others {
            let (status, [_, verdict, reason]) = verified(folder, "p.csv", other);
            assert_eq!((status, verdict.as_str()), (1, "unchecked"), "{words:?} {other:?}: {reason}");
        }
    }
}

#[test]
fn wrong_answers_are_wrong_and_others_are_not() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let verdict = |file: &str| {
        let (status, [_, verdict, reason]) = verified(folder, file, &[]);
        (status, verdict, reason)
    };
    fs::write(folder.join("p.csv"), SPACE).expect("written");
    let spoilt = |answer: &mut Value| answer["result"]["center"][0] = json!(100.0);
    for words in [&["--columns", "x,y"][..], &["--directions", "axes"], &[]] {
        enclosed(folder, "p.csv", words);
        change(folder, spoilt);
        let (status, word, reason) = verdict("p.csv");
        assert_eq!((status, word.as_str()), (1, "WRONG"), "{words:?}: {reason}");
        // The same answer without its record may be right for other columns.
        change(folder, |answer| drop(answer.as_object_mut().expect("an object").remove("request")));
        let (status, word, reason) = verdict("p.csv");
        assert_eq!((status, word.as_str()), (1, "unchecked"), "{words:?}: {reason}");
    }

    // Other data: what is right for them is right, what is not may have been right for those of the answer.
    enclosed(folder, "p.csv", &[]);
    fs::write(folder.join("p.csv"), SPACE.replace(",5\n", ",5.0\n")).expect("written");
    assert_eq!(verdict("p.csv").1, "right");
    fs::write(folder.join("p.csv"), SPACE.replace(",5\n", ",50\n")).expect("written");
    let (status, word, reason) = verdict("p.csv");
    assert_eq!((status, word.as_str()), (1, "unchecked"), "{reason}");
    assert!(reason.starts_with("the data are not those that the answer was computed from"), "{reason}");

    change(folder, |answer| answer["request"]["columns"] = json!(["x", "y", "w"]));
    let (status, word, reason) = verdict("p.csv");
    assert_eq!((status, word.as_str()), (1, "unchecked"), "{reason}");
    assert!(reason.contains("no column 'w'"), "{reason}");
    change(folder, |answer| answer["request"]["columns"] = json!(0));
    assert_eq!(verdict("p.csv").2, "the answer's `request` has no readable `columns`");
}

#[test]
fn answers_are_bodies() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), SPACE).expect("written");
    fs::write(folder.join("cube.json"), r#"{"c":[9,0,0],"G":[[1,0,0],[0,1,0],[0,0,1]]}"#).expect("written");
    let shapes: [(&[&str], &str, bool); 4] = [
        (&["--columns", "x,y"], "in 2", false),
        (&["--columns", "x,y,z", "--epsilon", "0.1"], "in 3", true),
        (&["--directions", "axes"], "in 3", true),
        (&["--directions", "net:2"], "in 3", true),
    ];
    for (words, dimension, in_space) in shapes {
        enclosed(folder, "p.csv", words);
        let inspected = run(folder, &["inspect", "a.json"]);
        assert_eq!(inspected.status, 0, "{words:?}: {}", inspected.stderr);
        assert!(row(&inspected.stdout, "dimension").contains(dimension), "{words:?}: {}", inspected.stdout);
        let met = run(folder, &["intersect", "a.json", if in_space { "cube.json" } else { "a.json" }]);
        assert_eq!(met.status, 0, "{words:?}: {}", met.stderr);
        let answer = row(&met.stdout, "answer");
        assert_eq!(answer.contains("disjoint"), in_space, "{words:?}: {answer}");
    }
    let summary = run(folder, &["inspect", "a.json"]).stdout;
    assert!(row(&summary, "body").ends_with("; coefficients times directions, rounded"), "{summary}");
    let axes = enclosed(folder, "p.csv", &["--directions", "axes"]);
    assert!(axes.contains("3 generators"), "{axes}");
    let inspected = run(folder, &["inspect", "a.json"]).stdout;
    assert!(row(&inspected, "volume").ends_with("about 40.0"), "{inspected}");
}

/// The search takes 200,000 points of space: of more it gets the corners of their hull, and the proof is about all.
#[test]
fn many_points_of_space_go_through_their_hull() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let lattice = (0..59 * 59 * 59).map(|i| format!("{},{},{}\n", i % 59, i / 59 % 59, i / 3481));
    fs::write(folder.join("p.csv"), format!("x,y,z\n{}", lattice.collect::<String>())).expect("written");
    for words in [&[][..], &["--directions", "axes"]] {
        let summary = enclosed(folder, "p.csv", words);
        assert!(row(&summary, "points").starts_with("205379 in p.csv"), "{summary}");
        assert!(row(&summary, "zonotope").starts_with("3 generators"), "{summary}");
        assert!(row(&summary, "certificate").starts_with("checked, exactly"), "{summary}");
        assert!(row(&summary, "hull").starts_with("1.0000 times"), "{summary}");
    }
}

/// The box that the summary compares with is among the starts of the search for few generators.
#[test]
fn three_generators_are_no_worse_than_the_oriented_box_that_is_told() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    let turned = |x: f64, y: f64, z: f64| {
        format!("{},{},{}\n", 2.0 * x - 2.0 * y + z, x + 2.0 * y + 2.0 * z, 2.0 * x + y - 2.0 * z)
    };
    let rows: String = corners.iter().flat_map(|[x, y]| [0.0, 1.0].map(|z| turned(*x, *y, z))).collect();
    fs::write(folder.join("p.csv"), format!("x,y,z\n{rows}")).expect("written");
    for objective in ["length", "volume"] {
        let summary = enclosed(folder, "p.csv", &["--max-generators", "3", "--objective", objective]);
        let told = row(&summary, "oriented box");
        let ratio = |end: &str| -> f64 {
            let before = told.split(end).next().and_then(|text| text.rsplit(' ').next());
            before.and_then(|ratio| ratio.parse().ok()).unwrap_or_else(|| panic!("no ratio in {told}"))
        };
        let found = if objective == "length" { ratio(" times its length") } else { ratio(" times the zonotope's") };
        assert!(found >= 1.0, "{objective}: {told}");
        assert_eq!(verified(folder, "p.csv", &[]).1[1], "right");
    }
}

/// The bound on the length has one row and one number; the certificate says that both sides of it were checked.
#[test]
fn the_ratio_of_length_to_lower_bound_is_told_once() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "x,y,z\n0,0,0\n2,0.3,1\n0.1,2,0\n1.5,1.7,2\n3,1,1\n").expect("written");
    for words in [
        &[][..],
        &["--directions", "net:2"],
        &["--directions", "axes"],
        &["--max-generators", "3"],
        &["--epsilon", "0.1"],
        &["--objective", "volume"],
    ] {
        let summary = enclosed(folder, "p.csv", words);
        let ratio = row(&summary, "ratio");
        let (number, words_behind) =
            ratio.split_once(", of length to lower bound: proven, none is shorter by more").expect("told");
        let factor =
            number.strip_prefix("1 + ").map_or_else(|| number.parse(), |part| part.parse().map(|x: f64| 1.0 + x));
        assert!(factor.is_ok_and(|factor| (1.0..1.2).contains(&factor)), "{words:?}: {ratio}");
        assert!(words_behind.is_empty() || words_behind.starts_with("; "), "{ratio}");
        let certificate = row(&summary, "certificate");
        assert!(
            certificate.starts_with("checked, exactly: contains all 5 points; length and lower bound"),
            "{certificate}"
        );
        for other in ["times the least", "of the proven bound"] {
            assert!(!summary.contains(other), "{words:?}: {summary}");
        }
    }
}
