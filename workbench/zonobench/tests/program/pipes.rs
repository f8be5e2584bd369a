//! Commands that hand their answers on: through files, and through standard output and standard input.

use std::fs;
use std::path::Path;

use crate::{Outcome, run, run_with_input};

fn good(outcome: Outcome, what: &str) -> Outcome {
    assert_eq!(outcome.status, 0, "{what}: {}{}", outcome.stdout, outcome.stderr);
    outcome
}

/// A tetrahedron as a mesh, moved along the first axis.
fn mesh(by: i32) -> String {
    let corner = |[x, y, z]: [i32; 3]| format!("v {} {y} {z}\n", x + by);
    let corners: String = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]].map(corner).concat();
    format!("{corners}f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
}

#[test]
fn commands_chain_without_further_options() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("a.obj"), mesh(0)).expect("written");
    fs::write(folder.join("b.obj"), mesh(9)).expect("written");
    let run = |words: &[&str]| good(run(folder, words), &words.join(" ")).stdout;
    run(&["enclose", "a.obj", "--json", "a.json"]);
    run(&["enclose", "b.obj", "--json", "b.json"]);
    assert!(run(&["intersect", "a.json", "b.json", "--svg", "meeting.svg"]).contains("disjoint"));
    assert!(run(&["distance", "a.json", "b.json"]).contains("checked: "));
    assert!(run(&["inspect", "a.json", "--svg", "a.svg"]).contains("volume"));
    assert_eq!(run(&["contains", "a.json", "b.obj"]).matches("outside").count(), 4);
    for [mesh, answer] in [["a.obj", "a.json"], ["b.obj", "b.json"]] {
        assert!(run(&["verify", mesh, answer]).contains("\tright\t"));
    }
    run(&["reduce", "a.json", "--count", "3", "--json", "r.json"]);
    assert!(run(&["intersect", "r.json", "a.json"]).contains("overlap"));
    assert!(run(&["inspect", "r.json"]).contains("3 generators"));
}

#[test]
fn standard_output_takes_one_result_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "0,0\n2,0\n0,2\n").expect("written");
    fs::write(folder.join("z.json"), r#"{"c":[1,1],"G":[[1,0,1],[0,1,1]]}"#).expect("written");
    let commands: [&[&str]; 6] = [
        &["enclose", "p.csv"],
        &["enclose", "p.csv", "--directions", "axes"],
        &["intersect", "z.json", "z.json"],
        &["distance", "z.json", "z.json"],
        &["reduce", "z.json", "--count", "2"],
        &["inspect", "z.json"],
    ];
    for words in commands {
        let name = words.join(" ");
        let summary = good(run(folder, words), &name).stdout;
        for (option, start) in [("--json", "{\"id\""), ("--svg", "<svg")] {
            let piped = good(run(folder, &[words, &[option, "-"]].concat()), &name);
            assert!(piped.stdout.starts_with(start), "{name} {option}: {}", piped.stdout);
            let is_told = piped.stderr.lines().zip(summary.lines()).filter(|(piped, told)| piped == told).count();
            assert!(is_told + 1 >= summary.lines().count(), "{name}: all but how to verify\n{}", piped.stderr);
            fs::write(folder.join("same"), "").expect("written");
            good(run(folder, &[words, &[option, "same", "--force"]].concat()), &name);
            assert_eq!(fs::read_to_string(folder.join("same")).expect("written"), piped.stdout, "{name} {option}");
        }
        let both = run(folder, &[words, &["--json", "-", "--svg", "-"]].concat());
        assert_eq!(both.stderr, "zonobench: -: two results cannot be written to one file\n");
        assert_eq!((both.status, both.stdout.as_str()), (1, ""));
    }
    assert!(!Path::new(folder).join("-").exists());
}

#[test]
fn an_answer_goes_from_command_to_command() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), "0,0\n2,0\n0,2\n").expect("written");
    let piped = good(run(folder, &["enclose", "p.csv", "--json", "-"]), "enclose");
    assert!(piped.stderr.contains("zonobench verify p.csv -\n"), "{}", piped.stderr);
    let answer = piped.stdout.as_bytes();
    let verified = good(run_with_input(folder, &["verify", "p.csv", "-"], answer), "verify");
    assert!(verified.stdout.starts_with("p.csv\tmin_area\tright\t"), "{}", verified.stdout);
    let inspected = good(run_with_input(folder, &["inspect", "-", "--format", "json"], answer), "inspect");
    assert!(inspected.stdout.contains("dimension"), "{}", inspected.stdout);
    let words = ["enclose", "-", "--format", "csv", "--json", "-"];
    let both = good(run_with_input(folder, &words, b"0,0\n2,0\n0,2\n"), "enclose");
    assert!(both.stderr.contains("--json FILE writes the answer"), "{}", both.stderr);
}

#[test]
fn points_are_located_one_by_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("z.json"), r#"{"c":[1,1],"G":[[1,0],[0,1]]}"#).expect("written");
    fs::write(folder.join("p.csv"), "id,x,y\na,1,1\nb,2,0.5\nc,2.5,1\nd,1.5,1.5\n").expect("written");
    let words = ["contains", "z.json", "p.csv", "--json", "a.json", "--question", "q.json"];
    let found = good(run(folder, &words), "contains");
    assert_eq!(found.stdout, "1\tinside\t0.0\n2\tboundary\t1.0\n3\toutside\t1.5\n4\tinside\t0.5\n");
    let rows = ["points        4 in p.csv", "columns       x, y; left out: id", "inside        2", "outside       1"];
    assert!(rows.iter().all(|row| found.stderr.lines().any(|line| line == *row)), "{}", found.stderr);
    assert!(good(run(folder, &["verify", "q.json", "a.json"]), "verify").stdout.contains("\tright\t"));
    let answer = fs::read_to_string(folder.join("a.json")).expect("written");
    let piped = good(run(folder, &["contains", "z.json", "p.csv", "--json", "-"]), "contains");
    assert_eq!(piped.stdout, answer);

    fs::write(folder.join("a.obj"), mesh(0)).expect("written");
    good(run(folder, &["enclose", "a.obj", "--json", "around.json"]), "enclose");
    let around = good(run(folder, &["contains", "around.json", "a.obj"]), "contains");
    assert_eq!(around.stdout.lines().count(), 4);
    assert!(!around.stdout.contains("outside"), "{}", around.stdout);

    let refused = run(folder, &["contains", "z.json", "a.obj"]);
    assert_eq!(refused.stderr, "zonobench: a.obj: holds points with 3 coordinates, not 2\n");
    assert_eq!(run(folder, &["contains", "-", "-", "--format", "csv"]).status, 2);
    assert_eq!(run(folder, &["contains", "z.json", "a.obj", "--skip", "1"]).status, 2);
}

#[test]
fn vertices_of_a_planar_body_are_points() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("z.json"), r#"{"c":[1,1],"G":[[1,0,1],[0,1,1]]}"#).expect("written");
    for file in ["v.csv", "v.geojson"] {
        good(run(folder, &["inspect", "z.json", "--vertices", file]), file);
        let enclosed = good(run(folder, &["enclose", file]), file).stdout;
        assert!(enclosed.contains("6 vertices, area 12.0") && enclosed.contains("3 generators"), "{file}: {enclosed}");
        // The ring of a polygon ends with its first point.
        let located = good(run(folder, &["contains", "z.json", file]), file).stdout;
        assert!(located.lines().count() >= 6 && located.lines().all(|line| line.contains("\tboundary\t")), "{located}");
    }
    let piped = good(run(folder, &["inspect", "z.json", "--vertices", "-"]), "-");
    assert_eq!(piped.stdout, fs::read_to_string(folder.join("v.csv")).expect("written"));
    fs::write(folder.join("cube.json"), "[[1,0,0],[0,1,0],[0,0,1]]").expect("written");
    for (body, file, complaint) in [
        ("cube.json", "c.csv", "has 3 coordinates"),
        ("z.json", "c.svg", "c.svg: vertices are written as .csv or .geojson"),
    ] {
        let refused = run(folder, &["inspect", body, "--vertices", file]);
        assert_eq!((refused.status, folder.join(file).exists()), (1, false));
        assert!(refused.stderr.contains(complaint), "{}", refused.stderr);
    }
}

/// The case `vertices-repeated`: two pairs of the six vertices round to the same doubles.
#[test]
fn vertices_that_round_to_one_point_are_written_once() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("z.json"), r#"{"generators": [[1, 0], [0, 1], [1e-20, 1e-20]]}"#).expect("written");
    let told = "zonobench: z.json: 6 vertices round to 4 points of doubles, each of which is written once\n";
    let piped = good(run(folder, &["inspect", "z.json", "--vertices", "-"]), "-");
    assert_eq!(piped.stdout, "x,y\n-1.0,-1.0\n1.0,-1.0\n1.0,1.0\n-1.0,1.0\n");
    assert!(piped.stderr.starts_with(told), "{}", piped.stderr);
    let written = good(run(folder, &["inspect", "z.json", "--vertices", "v.geojson"]), "v.geojson");
    assert_eq!(written.stderr, told);
    let ring = fs::read_to_string(folder.join("v.geojson")).expect("written");
    let corners = "[[[-1.0,-1.0],[1.0,-1.0],[1.0,1.0],[-1.0,1.0],[-1.0,-1.0]]]";
    assert!(ring.contains(corners), "{ring}");
    for (body, geometry, rows) in [
        (r#"{"center": [1, 1], "generators": [[1e-30, 0], [0, 1e-30], [1e-30, 1e-30]]}"#, "\"Point\"", 1),
        (r#"{"center": [1, 1], "generators": [[1e-30, 2], [0, 1e-30]]}"#, "\"LineString\"", 2),
    ] {
        fs::write(folder.join("thin.json"), body).expect("written");
        good(run(folder, &["inspect", "thin.json", "--vertices", "thin.geojson", "--force"]), body);
        let written = fs::read_to_string(folder.join("thin.geojson")).expect("written");
        let table = good(run(folder, &["inspect", "thin.json", "--vertices", "-"]), body);
        assert!(written.contains(geometry), "{body}: {written}");
        assert_eq!(table.stdout.lines().count(), 1 + rows, "{body}: {}", table.stdout);
    }
}
