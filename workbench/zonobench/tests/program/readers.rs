//! Files that cannot be read: one line that names file and place, status 1, and nothing written.

mod kinds;

use std::fs;
use std::path::Path;

use crate::{Outcome, run, run_with_input};

/// Runs `enclose` on a file with this content, asking for both outputs.
fn enclose(name: &str, content: &[u8], more: &[&str]) -> (Outcome, bool) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join(name), content).expect("written");
    let mut words = vec!["enclose", name, "--svg", "a.svg", "--json", "a.json"];
    words.extend(more);
    let outcome = run(folder.path(), &words);
    let files = fs::read_dir(folder.path()).expect("listed").count();
    (outcome, files > 1)
}

fn refused(name: &str, content: impl AsRef<[u8]>, more: &[&str], expected: &str) {
    let (outcome, wrote) = enclose(name, content.as_ref(), more);
    assert_eq!(outcome.stderr, format!("zonobench: {expected}\n"));
    assert_eq!(outcome.status, 1);
    assert_eq!(outcome.stdout, "");
    assert!(!wrote, "a refused file leaves no output");
}

#[test]
fn tables() {
    refused("p.csv", "", &[], "p.csv: holds no points");
    refused("p.csv", "x,y\n", &[], "p.csv: holds no points");
    refused("p.csv", "x,y\n1,2\n\n3,abc\n", &[], "p.csv: line 4, column 2: 'abc' is not a number");
    let missing = |place: &str| format!("p.csv: {place}; --skip-nan leaves such points out");
    let nan = missing("line 3, column 1: 'NaN' is not a finite number");
    refused("p.csv", "x,y\r\n1,2\r\nNaN,3\r\n", &[], &nan);
    refused("p.csv", "x,y\n-inf,2\n", &[], &missing("line 2, column 1: '-inf' is not a finite number"));
    let beyond = missing("line 2, column 2: '1e400' is outside the range of a double");
    refused("p.csv", "x,y\n1,1e400\n", &[], &beyond);
    refused("p.csv", "1,2\n3\n", &[], "p.csv: line 2, column 2: the row has 1 cells, not 2");
    refused("p.csv", "1,2\n3,4,5\n", &[], "p.csv: line 2, column 3: the row has 3 cells, not 2");
    refused("p.csv", "1,2\n,4\n", &[], &missing("line 2, column 1: the cell is empty"));
    refused(
        "p.csv",
        "a,b,c\n1,2,3\n",
        &[],
        "p.csv: has 3 column(s); choose two to four with --columns, such as --columns a,b,c or --columns a,b",
    );
    let missing = "p.csv: line 1: there is no column 'z'; the columns are a, b, c";
    refused("p.csv", "a,b,c\n1,2,3\n", &["--columns", "a,z"], missing);
    let missing = "p.csv: line 1: there is no column 4; the row has 3 cells";
    refused("p.csv", "a,b,c\n1,2,3\n", &["--columns", "1,4"], missing);
    refused("p.csv", b"1,2\n3,\xff\xfe\n", &[], "p.csv: line 2, column 2: is not UTF-8 text");
}

/// No command takes the first row of a table with a column of text for a header.
#[test]
fn a_column_of_text_is_told_at_the_first_row() {
    let cities = "1,2,north\n3,4,south\n5,7,north\n";
    let text = "p.csv: line 1, column 3: 'north' is text; choose two to four of the 3 columns with --columns";
    for more in [&[][..], &["--epsilon", "0.1"], &["--objective", "length"], &["--directions", "axes"]] {
        refused("p.csv", cities, more, text);
    }
    let (outcome, _) = enclose("p.csv", cities.as_bytes(), &["--epsilon", "0.1", "--columns", "1,2"]);
    assert!(outcome.stdout.contains("points        3 in p.csv"), "{}", outcome.stdout);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("p.csv"), cities).expect("written");
    fs::write(folder.join("z.csv"), "1,0,0\n0,1,0\n0,0,1\n").expect("written");
    fs::write(folder.join("a.json"), r#"{"id":"p","kind":"min_length_all","result":{}}"#).expect("written");
    let number = "p.csv: line 1, column 3: 'north' is not a number";
    let commands: [(&[&str], &str); 5] = [
        (&["contains", "z.csv", "p.csv"], text),
        (&["verify", "p.csv", "a.json", "--epsilon", "0.1"], text),
        (&["draw", "zonogon", "p.csv", "--svg", "z.svg"], text),
        (&["inspect", "p.csv"], number),
        (&["intersect", "z.csv", "p.csv"], number),
    ];
    for (words, expected) in commands {
        assert_eq!(run(folder, words).stderr, format!("zonobench: {expected}\n"), "{words:?}");
    }
}

#[test]
fn points_of_another_dimension_say_which_columns_were_left_out() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("z.csv"), "1,0,0\n0,1,0\n0,0,1\n").expect("written");
    fs::write(folder.join("p.csv"), "lon,lat,alt\n0.5,0.5,0.5\n9,9,9\n").expect("written");
    let refused = run(folder, &["contains", "z.csv", "p.csv"]);
    let choice = "columns read: lon, lat; left out: alt; --columns chooses others";
    let expected = format!("zonobench: p.csv: holds points with 2 coordinates, not 3; {choice}\n");
    assert_eq!((refused.status, refused.stderr), (1, expected));
    let told = run(folder, &["contains", "z.csv", "p.csv", "--columns", "lon,lat,alt"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
}

#[test]
fn a_field_that_occurs_twice_is_named_by_every_command() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("z.json"), r#"{"c":[0,0],"G":[[1,0],[0,1]],"c":[5,5]}"#).expect("written");
    fs::write(folder.join("p.csv"), "0,0\n1,1\n").expect("written");
    let line = r#"{"id":"m","kind":"gauge","input":{"c":[0,0],"G":[[1,0]],"c":[5,5],"point":[0,0]}}"#;
    fs::write(folder.join("q.jsonl"), line).expect("written");
    let commands: [&[&str]; 5] = [
        &["contains", "z.json", "p.csv"],
        &["inspect", "z.json"],
        &["intersect", "z.json", "z.json"],
        &["enclose", "z.json"],
        &["verify", "q.jsonl", "z.json"],
    ];
    for words in commands {
        let outcome = run(folder, words);
        let told = outcome.stderr + &outcome.stdout;
        assert!(told.contains("the field `c` occurs twice in one object"), "{words:?}: {told}");
        assert_eq!(outcome.status, 1, "{words:?}");
    }
    let solved = run(folder, &["solve", "q.jsonl"]);
    assert!(solved.stdout.contains("the field `c` occurs twice in one object"), "{}", solved.stdout);
}

#[test]
fn documents() {
    refused("p.json", "", &[], "p.json: line 1, column 0: is not JSON: EOF while parsing a value");
    refused("p.json", "[]", &[], "p.json: holds no points");
    refused("p.json", "[[1,2],\n[3,x]]", &[], "p.json: line 2, column 4: is not JSON: expected value");
    let infinity = "p.json: [1][0]: 'Infinity' is not a finite number; --skip-nan leaves such points out";
    refused("p.json", "[[1,2],[\"Infinity\",4]]", &[], infinity);
    refused(
        "p.json",
        "[[1,2],[3,1e999]]",
        &[],
        "p.json: [1][1]: '1e999' is outside the range of a double; --skip-nan leaves such points out",
    );
    refused("p.geojson", "{\"type\":\"FeatureCollection\",\"features\":[]}", &[], "p.geojson: holds no points");
    let (outcome, wrote) = enclose("p.json", "[".repeat(300_000).as_bytes(), &[]);
    assert!(outcome.stderr.contains("recursion limit exceeded"), "{}", outcome.stderr);
    assert_eq!((outcome.status, wrote), (1, false));
}

#[test]
fn files() {
    let formats = "say --format csv, xyz, geojson, json, npy, obj, ply, stl or off";
    refused("p", "1,2\n", &[], &format!("p: the format cannot be told from the name; {formats}"));
    let unread = "p.dat: files that end in .dat are not read; if it holds one of the formats that are,";
    refused("p.dat", "1,2\n", &[], &format!("{unread} {formats}"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let outcome = run(folder.path(), &["enclose", "absent.csv"]);
    assert!(outcome.stderr.starts_with("zonobench: absent.csv: cannot be read: No such file"), "{}", outcome.stderr);
    assert_eq!((outcome.status, outcome.stderr.lines().count()), (1, 1));
    for words in [["enclose", "absent"], ["inspect", "absent"], ["inspect", "absent.dat"]] {
        let told = format!("zonobench: {}: cannot be read: No such file or directory (os error 2)\n", words[1]);
        assert_eq!(run(folder.path(), &words).stderr, told, "{words:?}");
    }
    for words in [&["enclose", "."][..], &["enclose", ".", "--format", "csv"], &["inspect", "."]] {
        assert_eq!(run(folder.path(), words).stderr, "zonobench: .: is a folder, not a file\n", "{words:?}");
    }
}

/// A sparse file takes no room on the disk and must take none in memory.
#[test]
fn huge_files_are_refused_by_their_size() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = fs::File::create(folder.path().join("huge.csv")).expect("created");
    file.set_len(1 << 40).expect("a sparse file");
    let outcome = run(folder.path(), &["enclose", "huge.csv"]);
    assert_eq!(outcome.stderr, "zonobench: huge.csv: is too large: more than 268435456 bytes\n");
    assert_eq!(outcome.status, 1);
}

#[test]
fn existing_outputs_are_kept_and_nothing_is_computed() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, content: &str| fs::write(folder.path().join(name), content).expect("written");
    write("p.csv", "0,0\n2,0\n0,2\n");
    write("a.json", "mine");
    let words = ["enclose", "p.csv", "--json", "a.json"];
    let outcome = run(folder.path(), &words);
    assert_eq!(outcome.stderr, "zonobench: a.json: exists already; --force replaces it\n");
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
    assert_eq!(fs::read_to_string(folder.path().join("a.json")).expect("read"), "mine");
    let outcome = run(folder.path(), &[&words[..], &["--force"]].concat());
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    assert_ne!(fs::read_to_string(folder.path().join("a.json")).expect("read"), "mine");
}

#[test]
fn every_format_gives_the_same_answer() {
    let contents: [(&str, &str, &[&str]); 6] = [
        ("p.csv", "\u{feff}x,y\r\n0,0\r\n2,0\r\n\r\n0,2\r\n", &[]),
        ("p.csv", "name;b;a\nu;0;0\nv;0;2\nw;2;0\n", &["--columns", "a,b"]),
        ("p.json", "[[0,0],[2,0],[0,2]]", &[]),
        ("p.json", "\u{feff}{\"points\":[{\"x\":0,\"y\":0},{\"x\":2,\"y\":0},{\"x\":0,\"y\":2}]}\r\n", &[]),
        ("p.geojson", "{\"type\":\"MultiPoint\",\"coordinates\":[[0,0,7],[2,0],[0,2]]}", &[]),
        ("p", "0 , 0\n2, 0\n0 ,2", &["--format", "csv"]),
    ];
    for (name, content, more) in contents {
        let (outcome, wrote) = enclose(name, content.as_bytes(), more);
        assert_eq!(outcome.status, 0, "{}", outcome.stderr);
        assert_eq!(outcome.stderr, "", "no bar where standard error is no terminal");
        assert!(wrote);
        let has = |line: &str| outcome.stdout.lines().any(|found| found == line);
        assert!(has("lower bound   4.0") || outcome.stdout.contains("lower bound   3.99999"), "{}", outcome.stdout);
        assert!(has("hull          3 vertices, area 2.0"), "{}", outcome.stdout);
    }
}

#[test]
fn standard_input_is_a_file_named_minus() {
    let words = ["enclose", "-", "--format", "csv"];
    let outcome = run_with_input(Path::new("."), &words, b"0,0\n2,0\n0,2\n");
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    assert!(outcome.stdout.contains("3 in -"), "{}", outcome.stdout);
}

/// Standard error has one line for the numbers that doubles do not hold, whatever reads them; the work goes on.
#[test]
fn numbers_that_doubles_do_not_hold_are_told_on_standard_error() {
    let triangle = [["0", "0"], ["9007199254740993", "1"], ["5", "1e-400"]];
    let rows = |open: &str, between: &str, close: &str, end: &str| -> String {
        triangle.iter().map(|[x, y]| format!("{open}{x}{between}{y}{close}{end}")).collect()
    };
    let list = rows("[", ",", "]", ",");
    let list = list.trim_end_matches(',');
    let off = format!("OFF\n3 0 0\n{}", rows("", " ", " 2", "\n"));
    let contents = [
        ("p.csv", rows("", ",", "", "\n")),
        ("p.xyz", rows("", " ", " 2", "\n")),
        ("p.json", format!("[{list}]")),
        ("p.geojson", format!(r#"{{"type":"MultiPoint","coordinates":[{list}]}}"#)),
        ("p.obj", rows("v ", " ", " 2", "\n")),
        ("p.off", off),
    ];
    let rounded = "1 whole number has more digits than a double holds and is rounded (9007199254740993, line ";
    for (name, content) in &contents {
        let (outcome, _) = enclose(name, content.as_bytes(), &["--directions", "axes"]);
        assert_eq!(outcome.status, 0, "{name}: {}", outcome.stderr);
        let lines: Vec<&str> = outcome.stderr.lines().collect();
        assert_eq!(lines.len(), 1, "{name}: {}", outcome.stderr);
        assert!(lines[0].starts_with(&format!("zonobench: {name}: {rounded}")), "{name}: {}", lines[0]);
        assert!(
            lines[0].contains("1 number is too small for a double and is read as 0 (1e-400, line "),
            "{}",
            lines[0]
        );
    }
    let question = r#"{"id":"a","kind":"min_area","input":{"points":[[0,0],[1,0],[0,9007199254740993]]}}"#;
    let solved = run_with_input(Path::new("."), &["solve"], format!("{question}\n{question}\n").as_bytes());
    assert_eq!(solved.stderr.lines().count(), 2, "{}", solved.stderr);
    assert!(solved.stderr.lines().nth(1).is_some_and(|line| line.contains("line 2, column ")), "{}", solved.stderr);
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, content) in &contents[..3] {
        fs::write(folder.path().join(name), content).expect("written");
        if !name.ends_with("xyz") {
            let outcome = run(folder.path(), &["inspect", name]);
            assert!(outcome.stderr.contains(rounded), "{name}: {}", outcome.stderr);
        }
    }
}

/// A file of one format under the name of another is refused by the name of its own.
#[test]
fn contents_of_another_format_are_refused_by_their_name() {
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for name in ["p.xyz", "p.csv", "p.txt"] {
        let format = if name == "p.xyz" { "xyz" } else { "csv" };
        let advice = "--format obj reads it as such, and so does a name that ends in .obj";
        refused(name, obj, &[], &format!("{name}: holds obj, not {format}: {advice}"));
    }
    let (outcome, _) = enclose("p.xyz", obj.as_bytes(), &["--format", "obj"]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    let export = "which is not read; export the points as CSV, or the mesh as STL or PLY";
    for (content, name) in [(&b"\x89HDF\r\n\x1a\n\0\0"[..], "HDF5"), (b"%PDF-1.4\n1,2\n", "PDF")] {
        for file in ["p.csv", "p.json", "p.xyz"] {
            refused(file, content, &[], &format!("{file}: is {name}, {export}"));
        }
    }
    let topology = r#"{"type":"Topology","transform":{"scale":[1,1],"translate":[0,0]},"objects":{},"arcs":[]}"#;
    for file in ["p.json", "p.geojson"] {
        refused(file, topology, &[], &format!("{file}: is TopoJSON, which is not read; convert it to GeoJSON"));
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("z.csv"), "[[1,0],[0,1]]").expect("written");
    fs::write(folder.path().join("v.csv"), obj).expect("written");
    let json = run(folder.path(), &["inspect", "z.csv"]).stderr;
    assert!(json.contains("holds json, not csv: --format json reads it as such"), "{json}");
    let mesh = run(folder.path(), &["intersect", "z.csv", "v.csv", "--format", "json", "--format-b", "csv"]).stderr;
    assert!(mesh.contains("v.csv: the format obj holds no zonotopes"), "{mesh}");
}

#[test]
fn a_first_row_that_may_be_a_header_is_read_as_data_where_that_is_said() {
    let content = "0,1,2\n3,4,5\n6,7,9\n";
    let asked = "p.csv: line 1: the first row (0, 1, 2) may number the columns or be a point; --skip 1 leaves it out, \
                 and --no-header reads it as data";
    refused("p.csv", content, &[], asked);
    let points = |option: &[&str]| {
        let (outcome, _) = enclose("p.csv", content.as_bytes(), option);
        let line = outcome.stdout.lines().find(|line| line.starts_with("points")).map(str::to_owned);
        line.unwrap_or(outcome.stderr)
    };
    assert!(points(&["--no-header"]).contains("3 in p.csv"), "{}", points(&["--no-header"]));
    assert!(points(&["--skip", "1"]).contains("2 in p.csv"));
}

/// A negative number is a wrong value and no option that there is not.
#[test]
fn negative_numbers_are_refused_as_values() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("z.csv"), "1,0\n0,1\n1,1\n").expect("written");
    for (words, value) in [
        (&["reduce", "z.csv", "--count", "-1"][..], "'-1' for '--count <K>'"),
        (&["enclose", "z.csv", "--max-generators", "-1"], "'-1' for '--max-generators <K>'"),
        (&["enclose", "z.csv", "--skip", "-1"], "'-1' for '--skip <N>'"),
        (&["enclose", "z.csv", "--epsilon", "-0.5"], "'-0.5' for '--epsilon <EPSILON>'"),
        (&["enclose", "z.csv", "--columns=-1,2"], "no column '-1'"),
    ] {
        let outcome = run(folder.path(), words);
        assert!(outcome.stderr.contains(value), "{words:?}: {}", outcome.stderr);
        assert!(!outcome.stderr.contains("tip:"), "{}", outcome.stderr);
        assert_ne!(outcome.status, 0);
    }
    let outcome = run(folder.path(), &["enclose", "z.csv", "--columns", "-1,2"]);
    assert!(
        outcome.stderr.contains("an equals sign stands before a value that begins with a minus"),
        "{}",
        outcome.stderr
    );
}
