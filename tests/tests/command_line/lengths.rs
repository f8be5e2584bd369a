//! Least total length on the command line: meshes, flowers and outlines, with proofs that `verify` checks.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tests::sources::root;

use crate::program::{contents, folder, zonobench};

fn data(name: &str) -> PathBuf {
    root().join("experiments/data").join(name)
}

/// Encloses a file, has the answer verified with the same words, and gives the result and the summary.
fn enclosed(input: &Path, words: &[&str]) -> (Value, String) {
    let folder = folder();
    let (answer, picture) = (folder.path().join("answer.json"), folder.path().join("picture.svg"));
    let mut command = zonobench();
    command.arg("enclose").arg(input).args(words).arg("--json").arg(&answer).arg("--svg").arg(&picture);
    let summary = String::from_utf8_lossy(&command.assert().success().get_output().stdout).into_owned();
    assert!(fs::read_to_string(&picture).expect("a picture").starts_with("<svg"));
    let verified = zonobench().arg("verify").args([input, &answer]).args(words).assert().success();
    let verdict = String::from_utf8_lossy(&verified.get_output().stdout).into_owned();
    assert_eq!(verdict.split('\t').nth(2), Some("right"), "{words:?}: {verdict}");
    let text = fs::read_to_string(&answer).expect("an answer");
    let answer: Value = serde_json::from_str(&text).expect("JSON");
    (answer["result"].clone(), summary)
}

#[test]
fn meshes_along_given_directions() {
    for name in ["teapot.obj", "assimp_spider.obj", "cgal_cow.obj"] {
        for directions in ["axes", "net:2"] {
            let (result, summary) = enclosed(&data(name), &["--directions", directions]);
            let [value, bound] = ["value", "lower_bound"].map(|name| result[name].as_f64().expect("a number"));
            assert!(bound <= value && value <= bound * (1.0 + 1e-12), "{name} {directions}: {value} {bound}");
            assert!(summary.contains("ratio") && summary.contains("checked, exactly"), "{summary}");
        }
    }
}

#[test]
fn real_inputs_within_a_proven_ratio() {
    let cases: [(&str, &[&str], f64); 3] = [
        ("teapot.obj", &["--epsilon", "0.1"], 1.1),
        ("iris.csv", &["--columns", "1,2,3,4", "--skip", "1", "--epsilon", "0.5"], 1.5),
        ("outline_iceland.csv", &["--objective", "length"], 1.001),
    ];
    for (name, words, ratio) in cases {
        let (result, _) = enclosed(&data(name), words);
        let proven = result["ratio"].as_f64().expect("a number");
        assert!((1.0..=ratio).contains(&proven), "{name}: {proven}");
    }
}

#[test]
fn a_box_around_a_mesh_is_that_of_its_coordinates() {
    let folder = folder();
    let file = folder.path().join("t.off");
    fs::write(&file, "OFF\n4 0 0\n0 0 0\n4 0 0\n0 2 0\n0 0 -6\n").expect("written");
    let (result, _) = enclosed(&file, &["--directions", "axes"]);
    assert_eq!(result["value"], 6.0);
    assert_eq!((&result["center"], &result["coefficients"]), (&json!([2.0, 1.0, -3.0]), &json!([2.0, 1.0, 3.0])));
    let mesh = folder.path().join("box.obj");
    zonobench().arg("enclose").arg(&file).args(["--directions", "axes", "--obj"]).arg(&mesh).assert().success();
    let corners = fs::read_to_string(&mesh).expect("a mesh").lines().filter(|line| line.starts_with("v ")).count();
    assert_eq!(corners, 8);
}

#[test]
fn directions_from_a_file() {
    let folder = folder();
    let (points, directions) = (folder.path().join("p.csv"), folder.path().join("d.csv"));
    fs::write(&points, "1,0\n-1,0\n0,1\n0,-1\n").expect("written");
    fs::write(&directions, "5,5\n1,-1\n").expect("written");
    let file = directions.to_str().expect("a path of letters");
    let (result, _) = enclosed(&points, &["--directions", file]);
    assert!((result["value"].as_f64().expect("a number") - 2.0_f64.sqrt()).abs() < 1e-12);

    fs::write(&directions, "5,5,5\n").expect("written");
    let refused = zonobench().arg("enclose").arg(&points).args(["--directions", file]).assert().code(1);
    let complaint = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(complaint.contains("d.csv: directions with 3 coordinates"), "{complaint}");
}

#[test]
fn that_there_is_none_is_an_answer() {
    let folder = folder();
    let (points, directions) = (folder.path().join("p.csv"), folder.path().join("d.csv"));
    fs::write(&points, "0,0\n1,1\n2,2.5\n").expect("written");
    fs::write(&directions, "1,1\n2,2\n").expect("written");
    let answer = folder.path().join("a.json");
    let words = ["--directions", directions.to_str().expect("a path of letters")];
    let found = zonobench().arg("enclose").arg(&points).args(words).arg("--json").arg(&answer).assert().success();
    assert!(String::from_utf8_lossy(&found.get_output().stdout).contains("no zonotope along these directions"));
    zonobench().arg("verify").args([&points, &answer]).args(words).assert().success();
    let picture = folder.path().join("p.svg");
    zonobench().arg("enclose").arg(&points).args(words).arg("--svg").arg(&picture).assert().code(1);
    assert_eq!(contents(folder.path()), ["a.json", "d.csv", "p.csv"]);
}

#[test]
fn files_that_exist_are_kept_and_nothing_is_half_written() {
    let folder = folder();
    let (answer, mesh) = (folder.path().join("a.json"), folder.path().join("m.obj"));
    fs::write(&mesh, "mine").expect("written");
    let run = |force: &[&str]| {
        let mut command = zonobench();
        command.arg("enclose").arg(data("teapot.obj")).args(["--directions", "axes", "--json"]).arg(&answer);
        command.arg("--obj").arg(&mesh).args(force).assert()
    };
    run(&[]).code(1);
    assert_eq!(contents(folder.path()), ["m.obj"]);
    run(&["--force"]).success();
    assert_eq!(contents(folder.path()), ["a.json", "m.obj"]);
}

#[test]
fn broken_meshes_are_refused_in_one_line() {
    let cases: [(&str, &str, &str); 4] = [
        ("b.obj", "v 0 0 0\nv 1 x 0\nf 1 2 1\n", "line 2"),
        (
            "b.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float \
                z\nend_header\n0 0 0\n0 q 0\n",
            "line 9",
        ),
        ("b.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "line 4"),
        ("b.off", "OFF\n1 0 0\n0 0 zero\n", "line 3, column 3"),
    ];
    for (name, content, place) in cases {
        let folder = folder();
        let file = folder.path().join(name);
        fs::write(&file, content).expect("written");
        let output = zonobench().arg("enclose").arg(&file).args(["--svg", "x.svg"]).assert().code(1);
        let complaint = String::from_utf8_lossy(&output.get_output().stderr).into_owned();
        assert_eq!(complaint.trim_end().lines().count(), 1, "{complaint}");
        assert!(complaint.contains(name) && complaint.contains(place), "{complaint}");
    }
}

/// Answers of both kinds, each spoilt in every way that `verify` must notice.
#[test]
fn wrong_answers_do_not_pass_verification() {
    let points = json!([[0, 0, 1], [3, 1, 0], [1, 2, 5], [-1, 0.5, 2]]);
    let directions = json!([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]);
    let questions = [
        json!({"id": "d", "kind": "min_length_dirs", "input": {"points": points, "directions": directions,
            "weights": [1, 1, 1, 1.5]}}),
        json!({"id": "i", "kind": "min_length_dirs", "input": {"points": [[0, 0], [1, 2]], "directions": [[1, 1]],
            "weights": [1]}}),
        json!({"id": "a", "kind": "min_length_all", "input": {"points": points, "epsilon": 0.01}}),
    ];
    let folder = folder();
    let lines = |values: &[Value]| values.iter().map(|value| format!("{value}\n")).collect::<String>();
    let write = |name: &str, values: &[Value]| {
        let file = folder.path().join(name);
        fs::write(&file, lines(values)).expect("written");
        file
    };
    let asked = write("q.jsonl", &questions);
    let output = zonobench().arg("solve").arg(&asked).assert().success().get_output().stdout.clone();
    let right: Vec<Value> = String::from_utf8_lossy(&output)
        .lines()
        .map(|line| serde_json::from_str(line).expect("an answer is JSON"))
        .collect();
    zonobench().arg("verify").args([&asked, &write("right.jsonl", &right)]).assert().success();

    let scaled = |value: &Value, factor: f64| Value::from(value.as_f64().expect("a number") * factor);
    type Spoil = fn(&mut Value, &dyn Fn(&Value, f64) -> Value);
    let spoils: [(usize, &str, Spoil); 15] = [
        (0, "value", |r, scaled| r["value"] = scaled(&r["value"], 1.0 + 1e-10)),
        (0, "bound", |r, scaled| r["lower_bound"] = scaled(&r["lower_bound"], 1.0 + 1e-14)),
        (0, "weak bound", |r, scaled| r["lower_bound"] = scaled(&r["lower_bound"], 0.5)),
        (0, "centre", |r, _| r["center"][0] = json!(100.0)),
        (0, "no coefficient", |r, _| r["coefficients"] = json!([])),
        (0, "balance", |r, _| r["certificate"]["forces"][0]["vector"][0] = json!("7/3")),
        (0, "status", |r, _| r["status"] = json!("infeasible")),
        (1, "functional", |r, _| r["certificate"]["functional"] = json!(["1", "1"])),
        (1, "points", |r, _| r["certificate"]["points"] = json!([0, 0])),
        (2, "length", |r, scaled| r["length"] = scaled(&r["length"], 1.0 - 1e-10)),
        (2, "bound", |r, scaled| r["lower_bound"] = scaled(&r["lower_bound"], 1.0 + 1e-9)),
        (2, "ratio", |r, _| r["ratio"] = json!(1.0)),
        (2, "outcome", |r, _| r["within_epsilon"] = json!(false)),
        (2, "generator", |r, _| r["generators"][0] = json!([0, 0, 0])),
        (2, "force", |r, _| r["certificate"]["forces"][0]["point"] = json!(99)),
    ];
    for (index, what, spoil) in spoils {
        let mut spoilt = right.clone();
        spoil(&mut spoilt[index]["result"], &scaled);
        let file = write("spoilt.jsonl", &spoilt);
        let output = zonobench().arg("verify").args([&asked, &file]).assert().code(1);
        let verdicts = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
        let wrong: Vec<usize> =
            (0..).zip(verdicts.lines()).filter(|(_, line)| line.contains("\tWRONG\t")).map(|(at, _)| at).collect();
        assert_eq!(wrong, [index], "{what}: {verdicts}");
    }
}

/// Far from the origin no centre in doubles is near enough for a precision of 1e-12: the answer holds, but it is not
/// what was asked for.
#[test]
fn an_answer_above_one_plus_epsilon_says_so() {
    let folder = folder();
    let [points, answer] = ["far.csv", "answer.json"].map(|name| folder.path().join(name));
    fs::write(&points, "1e9 0 3\n1000000001 0.5 3\n1e9 1 2.7\n".replace(' ', ",")).expect("written");
    for (epsilon, is_within) in [("1e-12", false), ("1e-4", true)] {
        let output = zonobench()
            .arg("enclose")
            .arg(&points)
            .args(["--epsilon", epsilon, "--force", "--json"])
            .arg(&answer)
            .assert()
            .success();
        let text = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
        assert_eq!(text.contains("above 1 + epsilon: the search ended before"), !is_within, "{text}");
        let answer: Value = serde_json::from_slice(&fs::read(&answer).expect("written")).expect("JSON");
        assert_eq!(answer["result"]["within_epsilon"], json!(is_within));
    }
}
