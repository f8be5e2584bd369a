//! `intersect`, `distance`, `reduce` and `inspect`: answers with their proofs, pictures, and files that are no
//! zonotopes.

use std::fs;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

use crate::program::{folder, output, written};

fn zonobench(folder: &TempDir) -> Command {
    let mut command = crate::program::zonobench();
    command.current_dir(folder.path());
    command
}

fn complaint(command: &mut Command, status: i32) -> String {
    let assertion = command.assert().code(status);
    let output = assertion.get_output();
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr.clone()).expect("a complaint is text")
}

/// The complaint about a result that cannot be made, beside the summary, which is printed in any case.
fn complaint_beside_summary(command: &mut Command) -> String {
    let assertion = command.assert().code(1);
    let output = assertion.get_output();
    let summary = String::from_utf8_lossy(&output.stdout);
    assert!(summary.starts_with("body ") && summary.contains("\ndimension "), "{summary}");
    String::from_utf8(output.stderr.clone()).expect("a complaint is text")
}

const CUBE: &str = r#"{"center":[0,0,0],"generators":[[1,0,0],[0,1,0],[0,0,1]]}"#;

/// Pairs of bodies, and what must be said of them.
const PAIRS: [(&str, &str, &str, &str); 5] = [
    ("apart.json", r#"{"center":[4,0,0],"generators":[[1,0,0],[0,1,0],[0,0,1]]}"#, "outside", "disjoint"),
    ("touching.json", r#"{"center":[2,0,0],"generators":[[1,0,0],[0,1,0],[0,0,1]]}"#, "boundary", "touch"),
    ("overlapping.json", r#"{"center":[1,1,0],"generators":[[1,0,0],[0,1,0],[0,0,1]]}"#, "inside", "overlap"),
    ("point.json", r#"{"center":[1,1,1],"generators":[]}"#, "boundary", "touch"),
    ("rows.csv", "x,y,z\n5,0,0\n", "inside", "overlap"),
];

#[test]
fn two_bodies_with_their_proof() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    for (name, content, status, word) in PAIRS {
        written(&folder, name, content);
        let words =
            ["intersect", "cube.json", name, "--json", "a.json", "--question", "q.json", "--svg", "p.svg", "--force"];
        let text = output(zonobench(&folder).args(words));
        assert!(text.contains(word) && text.contains("checked: "), "{name}: {text}");
        let answer = fs::read_to_string(folder.path().join("a.json")).expect("the answer");
        let answer: Value = serde_json::from_str(&answer).expect("JSON");
        assert_eq!(answer["result"]["status"], status, "{name}");
        let picture = fs::read_to_string(folder.path().join("p.svg")).expect("the picture");
        assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{name}");
        let verdict = output(zonobench(&folder).args(["verify", "q.json", "a.json"]));
        assert_eq!(verdict.split('\t').nth(2), Some("right"), "{name}: {verdict}");
    }
}

#[test]
fn a_gap_is_as_wide_as_it_is() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    written(&folder, "apart.json", PAIRS[0].1);
    let text = output(zonobench(&folder).args(["intersect", "cube.json", "apart.json"]));
    let line = |label: &str| text.lines().find(|line| line.starts_with(label)).expect("a line").to_owned();
    assert!(line("gap").contains("2.0,"), "{text}");
    assert!(line("gauge").contains("2.0:"), "{text}");
    assert!(line("direction").contains("(1.0, 0.0, 0.0)"), "{text}");
}

#[test]
fn how_far_apart_and_how_deep() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    for (name, content, status, _) in PAIRS {
        written(&folder, name, content);
        let words =
            ["distance", "cube.json", name, "--json", "a.json", "--question", "q.json", "--svg", "p.svg", "--force"];
        let text = output(zonobench(&folder).args(words));
        assert!(text.contains("checked: "), "{name}: {text}");
        let line = |label: &str| text.lines().find(|line| line.starts_with(label)).map(str::to_owned);
        match status {
            "outside" => assert!(line("distance").is_some_and(|line| line.ends_with("2.0")), "{text}"),
            "boundary" => assert!(line("they touch").is_some(), "{text}"),
            _ => assert!(line("depth").is_some_and(|line| line.contains("and 1.0")), "{text}"),
        }
        let picture = fs::read_to_string(folder.path().join("p.svg")).expect("the picture");
        assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{name}");
        let verdict = output(zonobench(&folder).args(["verify", "q.json", "a.json"]));
        assert_eq!(verdict.split('\t').nth(2), Some("right"), "{name}: {verdict}");
    }
}

#[test]
fn a_body_of_few_generators_around_one_of_many() {
    let folder = folder();
    let rows: Vec<String> = (1..40).map(|i| format!("{},{},{}", i % 7 - 3, i % 11 - 5, i % 5 + 1)).collect();
    written(&folder, "many.csv", format!("x,y,z\n{}\n", rows.join("\n")));
    let words = ["--json", "r.json", "--question", "q.json", "--svg", "p.svg", "--force"];
    for rule in ["cluster", "girard", "best"] {
        let text = output(zonobench(&folder).args(["reduce", "many.csv", "--count", "8", "--rule", rule]).args(words));
        assert!(text.contains("8 generators, around the same centre") && text.contains("checked: "), "{text}");
        let picture = fs::read_to_string(folder.path().join("p.svg")).expect("the picture");
        assert!(picture.starts_with("<svg") && !picture.contains("NaN") && !picture.contains("inf"), "{rule}");
        let verdict = output(zonobench(&folder).args(["verify", "q.json", "r.json"]));
        assert_eq!(verdict.split('\t').nth(2), Some("right"), "{rule}: {verdict}");
        let text = output(zonobench(&folder).args(["inspect", "r.json"]));
        assert!(text.contains("8 generators"), "other commands read the answer: {text}");
    }
    let complaint = complaint(zonobench(&folder).args(["reduce", "many.csv", "--count", "2"]), 1);
    assert!(complaint.contains("2 generators are too few"), "{complaint}");
}

#[test]
fn bodies_of_every_size_are_drawn() {
    let folder = folder();
    let bodies = [
        r#"[[5e-324,0,0],[0,1e-300,0]]"#,
        r#"{"center":[-1e308,1e308,0],"generators":[[1e308,0,0],[1e308,1e308,0]]}"#,
        r#"{"center":[1e16,1,0],"generators":[[1e-3,0,0],[0,1e-3,1e-3]]}"#,
        r#"{"center":[0,0,0],"generators":[]}"#,
    ];
    for (i, a) in bodies.iter().enumerate() {
        written(&folder, "a.json", a);
        let text = output(zonobench(&folder).args(["inspect", "a.json", "--svg", "p.svg", "--force"]));
        assert!(text.contains("bounding box"), "{text}");
        for b in &bodies[i..] {
            written(&folder, "b.json", b);
            for command in ["intersect", "distance"] {
                output(zonobench(&folder).args([command, "a.json", "b.json", "--svg", "p.svg", "--force"]));
                let picture = fs::read_to_string(folder.path().join("p.svg")).expect("the picture");
                assert!(!picture.contains("NaN") && !picture.contains("inf"), "{command} {a} and {b}");
            }
        }
    }
}

#[test]
fn a_body_by_itself() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    let words = ["inspect", "cube.json", "--json", "a.json", "--question", "q.json", "--svg", "p.svg"];
    let text = output(zonobench(&folder).args(words));
    for expected in
        ["8 vertices, 12 edges, 6 facets", "6 with 4 vertices", "8 = 8.0", "24.0", "[-1.0, 1.0] × [-1.0, 1.0]"]
    {
        assert!(text.contains(expected), "no {expected} in {text}");
    }
    let verdict = output(zonobench(&folder).args(["verify", "q.json", "a.json"]));
    assert_eq!(verdict.split('\t').nth(2), Some("right"), "{verdict}");
    assert!(fs::read_to_string(folder.path().join("p.svg")).expect("the picture").starts_with("<svg"));
    let bodies = [("[[1]]", "length"), ("[[1,0],[0,1],[1,1]]", "area"), ("[[1,0,0,0],[0,1,0,0]]", "a flat zonogon")];
    for (content, expected) in bodies {
        written(&folder, "z.json", content);
        let text = output(zonobench(&folder).args(["inspect", "z.json", "--svg", "p.svg", "--force"]));
        assert!(text.contains(expected), "{text}");
    }
}

#[test]
fn meshes() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    written(&folder, "square.json", "[[1,0],[0,1]]");
    written(&folder, "segment.json", "[[1,0,0]]");
    output(zonobench(&folder).args(["inspect", "cube.json", "--obj", "c.obj", "--ply", "c.ply", "--stl", "c.stl"]));
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a mesh");
    let count = |name: &str, start: &str| text(name).lines().filter(|line| line.starts_with(start)).count();
    assert_eq!((count("c.obj", "v "), count("c.obj", "f ")), (8, 6));
    assert_eq!(count("c.ply", "element vertex 8") + count("c.ply", "element face 6"), 2);
    assert_eq!(fs::read(folder.path().join("c.stl")).expect("a mesh").len(), 84 + 12 * 50);
    for name in ["square.json", "segment.json"] {
        let complaint = complaint_beside_summary(zonobench(&folder).args(["inspect", name, "--obj", "no.obj"]));
        assert!(complaint.starts_with(&format!("zonobench: {name}: ")), "{complaint}");
        assert!(!folder.path().join("no.obj").exists());
    }
}

#[test]
fn a_mesh_holds_finite_numbers() {
    let folder = folder();
    written(&folder, "large.json", "[[1e40,0,0],[0,1e40,0],[0,0,1e40]]");
    written(&folder, "largest.json", "[[1.7e308,0,0],[1.7e308,1e308,0],[0,0,1e308]]");
    output(zonobench(&folder).args(["inspect", "large.json", "--obj", "large.obj"]));
    for (body, switch) in [("large.json", "--stl"), ("largest.json", "--obj"), ("largest.json", "--ply")] {
        let complaint = complaint_beside_summary(zonobench(&folder).args(["inspect", body, switch, "mesh"]));
        assert!(complaint.contains("coordinate above"), "{complaint}");
        assert!(!folder.path().join("mesh").exists());
    }
}

#[test]
fn files_that_exist_are_replaced_only_by_force() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    let kept = written(&folder, "kept.svg", "mine");
    for words in [
        &["intersect", "cube.json", "cube.json", "--svg", "kept.svg"][..],
        &["inspect", "cube.json", "--svg", "kept.svg"],
    ] {
        let complaint = complaint(zonobench(&folder).args(words), 1);
        assert_eq!(complaint, "zonobench: kept.svg: exists already; --force replaces it\n");
        assert_eq!(fs::read_to_string(&kept).expect("kept"), "mine");
    }
}

#[test]
fn what_is_no_zonotope_is_refused_in_one_line() {
    let folder = folder();
    written(&folder, "cube.json", CUBE);
    let bad = [
        ("plane.json", r#"{"center":[0,0],"generators":[]}"#, "has 2 coordinates, while cube.json has 3"),
        ("ragged.csv", "1,2,3\n4,5\n", "line 2"),
        ("nan.json", r#"[[0,0,"NaN"]]"#, "[0][2]"),
        ("broken.json", "[[0,0", "line 1"),
        ("nothing.json", "[]", "holds no zonotope"),
        ("seven.json", r#"{"generators":[[1,2,3,4,5,6,7]]}"#, "7"),
    ];
    for (name, content, place) in bad {
        written(&folder, name, content);
        let complaint = complaint(zonobench(&folder).args(["intersect", name, "cube.json"]), 1);
        assert!(complaint.lines().count() == 1 && complaint.contains(place), "{name}: {complaint}");
    }
    for words in [&["intersect", "cube.json"][..], &["inspect"], &["inspect", "cube.json", "--columns", "1,2"]] {
        complaint(zonobench(&folder).args(words), 2);
    }
}
