//! Files that cannot be read: one line that names file and place, status 1, and nothing written.

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
        "p.csv: has 3 column(s); choose two to four with --columns, such as --columns 1,2,3 or --columns 1,2",
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
fn documents() {
    refused("p.json", "", &[], "p.json: line 1, column 0: is not JSON: EOF while parsing a value");
    refused("p.json", "[]", &[], "p.json: holds no points");
    refused("p.json", "[[1,2],\n[3,x]]", &[], "p.json: line 2, column 4: is not JSON: expected value");
    let infinity = "p.json: [1][0]: 'Infinity' is not a finite number; --skip-nan leaves such points out";
    refused("p.json", "[[1,2],[\"Infinity\",4]]", &[], infinity);
    refused("p.json", "[[1,2],[3,1e999]]", &[], "p.json: line 1, column 15: a number is outside the range of a double");
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
