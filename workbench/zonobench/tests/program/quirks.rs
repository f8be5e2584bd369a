//! Files as other programs write them, which are read, or refused by the name of what is in doubt; the summary tells
//! what a reading leaves out, or takes in a way that is not plain.

mod off;

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::{Outcome, run};

/// Runs `enclose` on a file with this content.
fn enclose(name: &str, content: &[u8], more: &[&str]) -> Outcome {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join(name), content).expect("written");
    run(folder.path(), &[&["enclose", name][..], more].concat())
}

/// The value of a row of a summary; empty if there is no such row.
fn row(outcome: &Outcome, label: &str) -> String {
    let line = outcome.stdout.lines().find_map(|line| line.strip_prefix(label));
    line.map(str::trim).unwrap_or_default().to_owned()
}

/// The file has so many points, and this is told of the reading.
fn read(name: &str, content: impl AsRef<[u8]>, more: &[&str], points: usize, told: &str) -> Outcome {
    let outcome = enclose(name, content.as_ref(), more);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""), "{name}");
    let found = row(&outcome, "points");
    assert!(found.starts_with(&format!("{points} in {name}")), "{name}: {found}");
    assert_eq!(row(&outcome, "columns"), told, "{name}");
    outcome
}

fn refused(name: &str, content: impl AsRef<[u8]>, more: &[&str], expected: &str) {
    let outcome = enclose(name, content.as_ref(), more);
    assert_eq!(outcome.stderr, format!("zonobench: {name}: {expected}\n"));
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
}

const VERTICES: &str = "v 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\n";

#[test]
fn wavefront_obj() {
    read("p-and-l.obj", format!("{VERTICES}p 1 2 3 4\nl 1 2\n"), &[], 4, "");
    read("v-only.obj", VERTICES, &[], 4, "");
    let weighted = format!("{VERTICES}f 1 2 3 4\n").replace("1 0 0", "2 0 0 2");
    read("w2.obj", weighted, &[], 4, "1 vertex divided by its weight");
    let outcome =
        read("continued.obj", "v 0.5 0.25 \\\n0.125\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", &["--directions", "axes"], 3, "");
    assert_eq!(row(&outcome, "centre"), "(0.5, 0.5, 0.0625)");
    read("latin1.obj", [b"# Gr\xfc\xdfe\n", VERTICES.as_bytes(), b"f 1 2 3 4\n"].concat(), &[], 4, "");
    read("comment.obj", format!("{VERTICES}f 1 2 3 4\n").replace("v 0 0 0", "v 0 0 0 # origin"), &[], 4, "");
    let nan = format!("{VERTICES}f 1 2 3 4\n").replace("v 0 0 0", "v 0 nan 0");
    let named = "vertex 4, line 4: 'nan' is not a finite number; --skip-nan leaves such points out";
    refused("nan.obj", &nan, &[], named);
    read("nan.obj", &nan, &["--skip-nan"], 3, "left out: 1 point that is not finite");
}

const SOLID: &str = "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 2\n  \
    endloop\n endfacet\nendsolid a\n";

#[test]
fn stl_in_text() {
    read("upper.stl", SOLID.to_uppercase(), &[], 3, "");
    read("end-solid.stl", SOLID.replace("endsolid", "end solid"), &[], 3, "");
    read("nan-normal.stl", SOLID.replace("normal 0 0 1", "normal NaN NaN NaN"), &[], 3, "");
    let doubles = SOLID.replace("vertex 0 0 0", "vertex 0.1 0 0").replace("vertex 1 0 0", "vertex 0.2 0 0");
    let doubles = doubles.replace("vertex 0 1 2", "vertex 0.1 1 0");
    let outcome = read("doubles.stl", &doubles, &["--directions", "axes"], 3, "");
    assert!(row(&outcome, "length").starts_with("0.55"), "{}", outcome.stdout);
    // In single precision the coordinates are others from the ninth digit on, which the summary does not show.
    let answer = enclose("doubles.stl", doubles.as_bytes(), &["--directions", "axes", "--json", "-"]);
    let answer: Value = serde_json::from_str(&answer.stdout).expect("an answer is JSON");
    for (index, expected) in [0.15, 0.5, 0.0].into_iter().enumerate() {
        let center = answer["result"]["center"][index].as_f64().expect("a coordinate");
        assert!((center - expected).abs() < 1e-15, "{answer}");
    }
}

#[test]
fn ply_and_off_in_text() {
    let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let dot = format!("{header}end_header\n.5 0 0\n0 1 0\n0 0 1\n");
    let outcome = read("dot5.ply", &dot, &["--directions", "axes"], 3, "");
    assert_eq!(row(&outcome, "centre"), "(0.25, 0.5, 0.5)");
    read("nan.ply", format!("{header}property float n\nend_header\n0 0 0 nan\n1 0 0 0\n0 1 2 0\n"), &[], 3, "");
    read("surplus.ply", format!("{dot}7 7 7\n"), &[], 3, "left out: 1 line behind the last element");
    let off = "OFF4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n";
    read("glued.off", off, &[], 4, "");
    read("lines.off", off.replace("OFF4", "OFF 4").replace(' ', "\n"), &[], 4, "");
    read("surplus.off", off.replace("4 2 0", "4 1 0"), &[], 4, "left out: 1 line behind the faces");
    refused("short.off", off.replace("4 2 0", "4 3 0"), &[], "is not OFF: ends after 2 of 3 faces");
    let past = "line 7: is not OFF: a face has the vertex 4, counted from 0, of 4";
    refused("past.off", off.replace("3 0 1 3", "3 0 1 4"), &[], past);
}

#[test]
fn tables_with_decimal_commas() {
    let commas = "commas are read as decimal points";
    let content = "0,5;0,5\n1,5;0,5\n1,5;1,5\n";
    let outcome = read("p.csv", content, &[], 3, &format!("1, 2; {commas}"));
    assert_eq!(row(&outcome, "hull"), "3 vertices, area 0.5");
    refused("p.csv", content, &["--columns", "1,3"], "line 1: there is no column 3; the row has 2 cells");
    let doubt = "line 1, column 1: '0,5' may be one number with a decimal comma or two numbers; separate the cells by \
                 semicolons or tabs";
    refused("p.csv", content.replace(';', " "), &[], doubt);
    read("p.csv", content.replace(';', "\t"), &[], 3, &format!("1, 2; {commas}"));
}

#[test]
fn tables_with_headers_of_numbers_and_encodings() {
    let numbered = "1, 2; left out: the first row (0, 1), which numbers the columns";
    let outcome = read("p.csv", "0,1\n0.0,0.5\n1.0,0.5\n0.0,1.5\n", &[], 3, numbered);
    assert!(row(&outcome, "area").starts_with("1.0"), "{}", outcome.stdout);
    let told = "1, 2; the first row (0, 1) is read as data; --skip 1 leaves it out";
    read("p.csv", "0,1\n0.5,0.5\n1.5,0.5\n0.5,1.5\n", &[], 4, told);
    read("p.csv", "0,1\n5,6\n7,9\n", &[], 3, told);
    read("p.csv", "0,1\n5,6\n7,9\n", &["--skip", "0"], 3, "1, 2");
    read("p.csv", ",a,b\n0,5,6\n1,7,9\n", &[], 2, "a, b; left out: column 1, which counts the rows");
    let wide: Vec<u8> = "\u{feff}x,y\r\n0,0\r\n1,0\r\n0,1\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    read("p.csv", &wide, &[], 3, "x, y");
    let unmarked = "is in UTF-16 without a byte order mark; UTF-8 is read, and UTF-16 with a byte order mark";
    refused("p.csv", &wide[2..], &[], unmarked);
    let cloud = "//X,Y,Z,R,G,B\n0,0,0,1,2,3\n1,0,0,1,2,3\n0,1,2,1,2,3\n";
    read("cloud.csv", cloud, &[], 3, "X, Y, Z; left out: R, G, B");
    for name in ["cloud.xyz", "cloud.asc"] {
        read(name, "0 0 0\n1 0 0\n0 1 0\n0\t0 1\n", &[], 4, "1, 2, 3");
    }
    let counted = "1, 2, 3; left out: column 4, the first row, which counts 3 points";
    read("cloud.pts", "3\n0 0 0 7\n1 0 0 7\n0 1 2 7\n", &[], 3, counted);
}

#[test]
fn points_that_are_not_finite() {
    let told = |columns: &str| format!("{columns}left out: 2 points that are not finite");
    let table = "x,y\n0,0\nnan,3\n,4\n1,0\n0,1\n";
    read("p.csv", table, &["--skip-nan"], 3, &told("x, y; "));
    read("q.csv", "x,y\n0,0\n1400e400,1\n1,-1e999\n1,0\n0,1\n", &["--skip-nan"], 3, &told("x, y; "));
    read("p.json", "[[0,0],[NaN,1],[1,null],[1,0],[0,1]]", &["--skip-nan"], 3, &told("1, 2; "));
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("p.csv"), table).expect("written");
    let written = run(folder.path(), &["enclose", "p.csv", "--skip-nan", "--json", "a.json"]);
    assert_eq!(written.status, 0, "{}", written.stderr);
    assert_eq!(run(folder.path(), &["verify", "p.csv", "a.json"]).status, 0, "the answer records the option");
}

#[test]
fn geojson_with_altitudes_gaps_and_another_name() {
    let square = r#"{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]}"#;
    let outcome = read("map.json", square, &[], 5, "");
    assert!(row(&outcome, "area").starts_with("4.0"), "{}", outcome.stdout);
    let high = r#"{"type": "MultiPoint", "coordinates": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}"#;
    let outcome = read("map.geojson", high, &["--columns", "lon,lat,alt"], 4, "lon, lat, alt");
    assert!(row(&outcome, "length").starts_with("1.299"), "{}", outcome.stdout);
    read("map.json", high, &["--columns", "lon,lat,alt"], 4, "lon, lat, alt");
    let gap = r#"{"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":null},
        {"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[1,2],[3,5]]}}]}"#;
    read("map.geojson", gap, &[], 2, "left out: 1 geometry that is null or empty");
}

#[test]
fn rows_of_json_by_the_names_that_tables_may_have() {
    read("p.json", r#"[{"Lat":1,"lon":2},{"lon":0,"Lat":0},{"lon":2,"Lat":5}]"#, &[], 3, "lon, Lat");
}

/// The numbers of `contains` are those of the points in the file, whatever is left out.
#[test]
fn points_that_are_left_out_keep_their_numbers() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("a.json"), r#"{"center": [0, 0], "generators": [[1, 0], [0, 1]]}"#).expect("written");
    let contents = [
        ("p.csv", "5,5\nnan,1\n0,0\n"),
        ("p.json", "[[5,5],[1e400,1],[0,0]]"),
        ("q.json", r#"[{"x":5,"y":5},{"x":3},{"x":0,"y":0}]"#),
        ("r.json", r#"{"x":[5,null,0],"y":[5,1,0]}"#),
    ];
    for (name, content) in contents {
        fs::write(folder.path().join(name), content).expect("written");
        let outcome = run(folder.path(), &["contains", "a.json", name, "--skip-nan"]);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (0, "1\toutside\t5.0\n3\tinside\t0.0\n"), "{name}");
        let refused = run(folder.path(), &["contains", "a.json", name]);
        assert!(refused.stderr.contains("--skip-nan leaves such points out"), "{name}: {}", refused.stderr);
    }
}

/// Rows of JSON under names that say nothing are read as those of a table are, and a first column that counts is told.
#[test]
fn rows_of_json_as_tables() {
    let told = "b, a; the columns b, a are read in the order in which they stand";
    read("p.csv", "b,a\n2,3\n0,0\n1,5\n", &[], 3, told);
    read("p.json", r#"[{"b":2,"a":3},{"b":0,"a":0},{"b":1,"a":5}]"#, &[], 3, told);
    read("p.json", r#"{"b":[2,0,1],"a":[3,0,5]}"#, &[], 3, told);
    let counts = "1, 2; column 1 counts the rows and is read as a coordinate";
    read("p.json", "[[0,5],[1,6],[2,9]]", &[], 3, counts);
    refused(
        "p.json",
        r#"{"center":[0,0],"generators":[[1,0],[0,1]]}"#,
        &[],
        "holds a zonotope, not points; `inspect` and the other commands about bodies read it",
    );
}

/// The columns that a message proposes have names and numbers, and are no labels.
#[test]
fn columns_that_are_advised_may_hold_coordinates() {
    let advice = |cells: usize| format!("has {cells} column(s); choose two to four with --columns, such as --columns ");
    refused("p.csv", ",a,b,c\n0,1,2,3\n1,4,5,6\n", &[], &(advice(3) + "a,b,c or --columns a,b"));
    refused("p.csv", "id,name,a,b\n7,u,1,2\n8,v,4,5\n", &[], &(advice(4) + "a,b"));
    refused("p.csv", "id,a b,c,d\n7,1,2,3\n", &[], &(advice(4) + "2,c,d or --columns 2,c"));
    let title = "has 1 column, and points of the plane or of space need two or three; line 1 has 1 cell, and line 2 \
                 has 2; if the table begins there, --skip 1 leaves out what stands above it";
    refused("p.csv", "title\nx,y\n1,2\n", &[], title);
}

#[test]
fn numbers_behind_the_vertices_of_obj_are_told() {
    for (numbers, count) in [("2 0.5 0.5 0.5", 7), ("1 2", 5), ("1 2 3 4 5 6", 9)] {
        let told = format!(
            "left out: the numbers behind three coordinates of 1 vertex (the first has {count}, line 1), which may be \
             a weight and a colour"
        );
        read("m.obj", format!("v 2 0 0 {numbers}\nv 0 0 0\nv 0 1 0\nv 0 0 1\n"), &[], 4, &told);
    }
    refused(
        "m.obj",
        "v 1,0,0\n",
        &[],
        "line 1, column 2: is not OBJ: a vertex has three coordinates, with spaces between them, not commas",
    );
}

/// A file that is not there is told first, an experiment is no figure.
#[test]
fn names_of_nothing() {
    for name in ["nosuch.dwg", "iris.cvs", "nosuch.xlsx"] {
        let outcome = run(Path::new("."), &["enclose", name]);
        let complaint = format!("zonobench: {name}: cannot be read: No such file or directory (os error 2)\n");
        assert_eq!((outcome.status, outcome.stderr), (1, complaint));
    }
    let outcome = run(Path::new("."), &["figure", "hull-scaling", "--svg", "x.svg"]);
    let told = "'hull-scaling' is an experiment, not a figure; `zonobench reproduce --only hull-scaling` runs it";
    assert!(outcome.stderr.contains(told), "{}", outcome.stderr);
}
