//! `enclose`: real inputs with certified answers, files that are replaced only on request, and bad input.

use std::fs;

use tests::sources::root;

use crate::program::{contents, folder, written, zonobench};

#[test]
fn every_real_input_has_a_certified_optimum() {
    let data = root().join("experiments/data");
    let inputs = contents(&data).into_iter().filter(|name| name.ends_with(".csv") && name != "iris.csv");
    let mut tried = 0;
    for name in inputs {
        let columns: &[&str] = if name == "airports.csv" { &["--columns", "longitude,latitude"] } else { &[] };
        let folder = folder();
        let (answer, picture) = (folder.path().join("answer.json"), folder.path().join("picture.svg"));
        let input = data.join(&name);
        let assertion = zonobench()
            .arg("enclose")
            .arg(&input)
            .args(columns)
            .arg("--json")
            .arg(&answer)
            .arg("--svg")
            .arg(&picture)
            .assert();
        let summary = String::from_utf8_lossy(&assertion.success().get_output().stdout).into_owned();
        assert!(summary.contains("area"), "{name}: {summary}");
        assert!(fs::read_to_string(&picture).expect("a picture").starts_with("<svg"), "{name}");

        let verified = zonobench().arg("verify").args([&input, &answer]).args(columns).assert().success();
        let verdict = String::from_utf8_lossy(&verified.get_output().stdout).into_owned();
        assert_eq!(verdict.split('\t').nth(2), Some("right"), "{name}: {verdict}");
        tried += 1;
    }
    assert_eq!(tried, 11, "ten outlines and the airports");
}

#[test]
fn formats_and_columns_give_the_same_answer() {
    let folder = folder();
    let files = [
        (written(&folder, "plain.csv", "0,0\n6,0\n0,6\n"), None),
        (written(&folder, "named.csv", "name,y,x\nA,0,0\nB,0,6\nC,6,0\n"), Some("x,y")),
        (written(&folder, "numbered.csv", "A;0;0\nB;6;0\nC;0;6\n"), Some("2,3")),
        (written(&folder, "list.json", "[[0,0],[6,0],[0,6]]"), None),
        (written(&folder, "map.geojson", r#"{"type":"MultiPoint","coordinates":[[0,0],[6,0],[0,6,100]]}"#), None),
    ];
    for (file, columns) in files {
        let answer = file.with_extension("answer");
        let mut command = zonobench();
        command.arg("enclose").arg(&file).arg("--json").arg(&answer);
        if let Some(columns) = columns {
            command.args(["--columns", columns]);
        }
        command.assert().success();
        let text = fs::read_to_string(&answer).expect("an answer");
        let answer: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(answer["result"]["area"].as_f64(), Some(36.0), "{}", file.display());
    }
}

#[test]
fn files_that_exist_are_replaced_only_by_force() {
    let folder = folder();
    let input = written(&folder, "points.csv", "0,0\n6,0\n0,6\n");
    let (answer, picture) = (written(&folder, "answer.json", "mine"), folder.path().join("picture.svg"));
    let run = |force: &[&str]| {
        let mut command = zonobench();
        command.arg("enclose").arg(&input).arg("--svg").arg(&picture).arg("--json").arg(&answer).args(force);
        command.assert()
    };
    let complaint = String::from_utf8_lossy(&run(&[]).code(1).get_output().stderr).into_owned();
    assert!(complaint.contains("answer.json") && complaint.contains("--force"), "{complaint}");
    assert_eq!(fs::read_to_string(&answer).expect("the old file"), "mine");
    assert_eq!(contents(folder.path()), ["answer.json", "points.csv"], "something was left behind");

    run(&["--force"]).success();
    assert!(fs::read_to_string(&answer).expect("the new file").starts_with('{'));
    assert_eq!(contents(folder.path()), ["answer.json", "picture.svg", "points.csv"]);
}

/// Input files that are refused, with what the complaint must name besides the file.
const BAD: [(&str, &[u8], &[&str]); 14] = [
    ("nan.csv", b"x,y\n0,0\n1,NaN\n", &["line 3", "column 2", "NaN"]),
    ("infinite.csv", b"x,y\ninf,0\n1,1\n", &["line 2", "column 1"]),
    ("overflow.csv", b"x,y\n0,0\n1,1e999\n", &["line 3", "column 2", "1e999"]),
    ("text.csv", b"x,y\n0,0\n1,north\n", &["line 3", "column 2", "north"]),
    ("missing_cell.csv", b"x,y\n0,0\n1,\n", &["line 3", "column 2"]),
    ("ragged.csv", b"x,y\n0,0\n1,2,3\n", &["line 3", "3", "2"]),
    ("empty.csv", b"", &["no points"]),
    ("header_only.csv", b"x,y\n", &["no points"]),
    ("binary.csv", b"x,y\n0,0\n\xff\xfe,1\n", &["UTF-8"]),
    ("one_column.csv", b"1\n2\n3\n", &["has 1 column"]),
    ("broken.json", b"[[0,0],[1,", &["line 1", "column"]),
    ("shape.json", b"[[0,0],[1]]", &["[1]"]),
    ("nan.json", b"[[0,0],[\"NaN\",1]]", &["[1]"]),
    ("points.unknown", b"0,0\n1,1\n", &["--format"]),
];

#[test]
fn bad_input_is_refused_in_one_line_that_names_the_place() {
    for (name, content, places) in BAD {
        let folder = folder();
        let input = written(&folder, name, content);
        let (answer, picture) = (folder.path().join("answer.out"), folder.path().join("picture.svg"));
        let assertion = zonobench()
            .arg("enclose")
            .arg(&input)
            .arg("--json")
            .arg(&answer)
            .arg("--svg")
            .arg(&picture)
            .assert()
            .code(1);
        let output = assertion.get_output();
        let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(complaint.trim_end().lines().count(), 1, "{name}: {complaint}");
        for place in [&[name], places].concat() {
            assert!(complaint.contains(place), "{name}: no {place} in: {complaint}");
        }
        assert!(output.stdout.is_empty(), "{name}: a result was printed");
        assert_eq!(contents(folder.path()), [name], "{name}: something was left behind");
    }
}

#[test]
fn a_column_that_does_not_exist_is_named() {
    let folder = folder();
    let input = written(&folder, "points.csv", "x,y\n0,0\n1,1\n");
    for (columns, word) in [("x,z", "'z'"), ("1,7", "7")] {
        let assertion = zonobench().arg("enclose").arg(&input).args(["--columns", columns]).assert().code(1);
        let complaint = String::from_utf8_lossy(&assertion.get_output().stderr).into_owned();
        assert!(complaint.contains(word) && complaint.contains("points.csv"), "{complaint}");
    }
}

#[test]
fn points_without_area_are_enclosed_by_their_segment() {
    let folder = folder();
    for (name, rows) in [("one.csv", "3,4\n"), ("two.csv", "0,0\n4,2\n"), ("line.csv", "0,0\n2,1\n4,2\n2,1\n")] {
        let input = written(&folder, name, rows);
        let answer = folder.path().join(format!("{name}.json"));
        zonobench().arg("enclose").arg(&input).arg("--json").arg(&answer).assert().success();
        let text = fs::read_to_string(&answer).expect("an answer");
        let answer: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(answer["result"]["area"].as_f64(), Some(0.0), "{name}");
    }
}
