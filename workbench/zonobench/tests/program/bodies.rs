//! Bodies from files: the centre wherever it stands, the pose wherever it is given, and what is not read is said.

mod levels;
mod spellings;
mod starts;

use std::fs;
use std::path::Path;

use crate::{Outcome, run};

const SQUARE: &str = r#"{"center": [0, 0], "generators": [[1, 0], [0, 1]]}"#;
const CUBE: &str = r#"{"center": [0, 0, 0], "generators": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}"#;

/// A folder with files.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, content) in files {
        fs::write(folder.path().join(name), content).expect("written");
    }
    folder
}

fn good(folder: &Path, words: &[&str]) -> Outcome {
    let outcome = run(folder, words);
    assert_eq!(outcome.status, 0, "{words:?}: {}{}", outcome.stdout, outcome.stderr);
    outcome
}

fn has(outcome: &Outcome, line: &str) {
    let found = outcome.stdout.lines().chain(outcome.stderr.lines()).any(|found| found == line);
    assert!(found, "{line}\n{}{}", outcome.stdout, outcome.stderr);
}

/// The centre under `c` beside generators by rows.
#[test]
fn body_c_generators() {
    centre_is_read(r#"{"c": [10, 0], "generators": [[1, 0], [0, 1]]}"#);
}

#[test]
fn body_centre() {
    centre_is_read(r#"{"centre": [10, 0], "generators": [[1, 0], [0, 1]]}"#);
}

#[test]
fn body_point_and_matrix() {
    centre_is_read(r#"{"x": [10, 0], "G": [[1, 0], [0, 1]]}"#);
}

fn centre_is_read(content: &str) {
    let folder = folder(&[("a.json", content), ("square.json", SQUARE), ("p.csv", "x,y\n10,0.5\n0,0\n")]);
    let folder = folder.path();
    let outcome = good(folder, &["intersect", "a.json", "square.json"]);
    has(&outcome, "a             2 generators in a.json, centre (10.0, 0.0)");
    has(&outcome, "answer        a and b are disjoint");
    has(&good(folder, &["distance", "a.json", "square.json"]), "distance      8.0");
    has(
        &good(folder, &["hausdorff", "a.json", "square.json"]),
        "distance      10.0, between 10.0 and 10.0: no point of one body is farther than that from the other",
    );
    let outcome = good(folder, &["inspect", "a.json"]);
    has(&outcome, "centre        (10.0, 0.0)");
    has(&outcome, "bounding box  [9.0, 11.0] × [-1.0, 1.0]");
    assert_eq!(good(folder, &["contains", "a.json", "p.csv"]).stdout, "1\tinside\t0.5\n2\toutside\t10.0\n");
    has(
        &good(folder, &["reduce", "a.json", "--count", "2"]),
        "body          2 generators in a.json, centre (10.0, 0.0)",
    );
}

/// A body as it stands in a question, with its pose: every command that takes a body reads it.
#[test]
fn body_pose() {
    let pose = r#""pose": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "translation": [10, 0, 0]}"#;
    let posed = CUBE.replace('}', &format!(", {pose}}}"));
    let folder = folder(&[("a.json", &posed), ("b.json", CUBE), ("p.csv", "x,y,z\n10,0.5,0\n0,0,0\n")]);
    let folder = folder.path();
    let outcome = good(folder, &["inspect", "a.json"]);
    has(&outcome, "centre        (10.0, 0.0, 0.0)");
    has(&outcome, "bounding box  [9.0, 11.0] × [-1.0, 1.0] × [-1.0, 1.0]");
    has(&outcome, "pose          translation (10.0, 0.0, 0.0)");
    has(&good(folder, &["intersect", "a.json", "b.json"]), "answer        a and b are disjoint");
    has(&good(folder, &["distance", "b.json", "a.json"]), "distance      8.0");
    assert_eq!(good(folder, &["contains", "a.json", "p.csv"]).stdout, "1\tinside\t0.5\n2\toutside\t10.0\n");
    good(folder, &["reduce", "a.json", "--count", "3", "--json", "r.json"]);
    has(&good(folder, &["inspect", "r.json"]), "centre        (10.0, 0.0, 0.0)");
    let outcome = good(folder, &["draw", "search", "a.json", "--point", "10,0.1,0.2", "--svg", "s.svg"]);
    has(&outcome, "pose: translation (10.0, 0.0, 0.0)");
}

/// A question that a command writes has the pose, so that `verify` checks the answer for the exact image.
#[test]
fn questions_about_posed_bodies_are_verified() {
    let turned = r#"{"c": [0, 0], "G": [[1, 0.1], [0, 0.3]], "pose": {"matrix": [[0.6, -0.8], [0.8, 0.6]]}}"#;
    let folder = folder(&[("a.json", turned), ("b.json", SQUARE), ("p.csv", "x,y\n0.5,0.5\n3,1\n")]);
    let folder = folder.path();
    let commands: [&[&str]; 4] = [
        &["intersect", "a.json", "b.json", "--move-b", "1.5,0.7"],
        &["distance", "a.json", "b.json", "--move-b", "7.1,0.7", "--turn-b", "30"],
        &["contains", "a.json", "p.csv", "--turn", "12", "--move", "0.1,0"],
        &["inspect", "a.json", "--turn", "12"],
    ];
    for words in commands {
        let outputs = ["--question", "q.json", "--json", "r.json", "--force"];
        good(folder, &[words, &outputs].concat());
        let question = fs::read_to_string(folder.join("q.json")).expect("written");
        assert!(question.contains(r#""pose":{"matrix":"#), "{question}");
        let outcome = good(folder, &["verify", "q.json", "r.json"]);
        assert!(outcome.stdout.contains("\tright\t"), "{words:?}: {}", outcome.stdout);
    }
}

/// The lines that the second body meets name its own options.
#[test]
fn complaints_name_the_options_of_their_body() {
    let wide = "1,0,3\n0,1,4\n";
    let folder = folder(&[("a.json", CUBE), ("b.dat", wide), ("b.csv", wide), ("p.json", "[[1, 0]]")]);
    let folder = folder.path();
    for (words, complaint) in [
        (&["a.json", "--move-b", "1,2"][..], "zonobench: --move-b: 2 numbers for a body with 3 coordinates"),
        (&["a.json", "--turn-b", "30"], "zonobench: --turn-b: in space a turn is about an axis: z,30 or 1,1,0,30"),
        (&["a.json", "--pose-b", "p.json"], "zonobench: --pose-b p.json: 1 rows with 2 numbers; "),
        (&["a.json", "--center-first-b"], "--columns-are-generators-b and --center-first-b are for tables, arrays"),
        (&["b.dat"], "if it holds one, say csv, json or npy by --format-b"),
    ] {
        let outcome = run(folder, &[&["distance", "a.json"], words].concat());
        assert!(outcome.status == 1 && outcome.stderr.contains(complaint), "{words:?}: {}", outcome.stderr);
    }
    let outcome = good(folder, &["distance", "a.json", "b.dat", "--format-b", "csv"]);
    assert!(outcome.stderr.contains("--columns-are-generators-b reads the columns"), "{}", outcome.stderr);
    let outcome = run(folder, &["contains", "b.dat", "b.csv"]);
    assert!(outcome.stderr.contains("say csv, json or npy by --body-format"), "{}", outcome.stderr);
}

/// A matrix with one row, as systems write it that make no difference between a number and a list of one.
#[test]
fn bodies_of_the_line_may_have_numbers_for_vectors() {
    let folder = folder(&[("a.json", r#"{"c": 5, "G": [1, 2, 3]}"#), ("b.json", r#"{"c": 5, "G": 2}"#)]);
    has(&good(folder.path(), &["inspect", "a.json"]), "bounding box  [-1.0, 11.0]");
    has(&good(folder.path(), &["inspect", "b.json"]), "bounding box  [3.0, 7.0]");
}

/// Six digits of a coordinate do not show where a small body far from the origin is.
#[test]
fn points_are_shown_in_terms_of_the_size() {
    let lot = "500000.123456,4500000.654321\n500100.123456,4500100.654321\n500100.5,4500000\n";
    let folder = folder(&[("p.csv", lot)]);
    let outcome = good(folder.path(), &["enclose", "p.csv", "--json", "a.json"]);
    has(&outcome, "centre        (500100.312, 4500050.327)");
    has(&good(folder.path(), &["inspect", "a.json"]), "centre        (500100.312, 4500050.327)");
}

/// The gauge of bodies that no doubles hold is that of the nearest ones, and says so.
#[test]
fn turned_bodies_have_a_gauge() {
    let folder = folder(&[("a.json", CUBE), ("b.json", &CUBE.replace("0, 1, 0", "0, 1.1, 0"))]);
    let words = ["intersect", "a.json", "b.json", "--turn-b", "z,30", "--move-b", "4,0,0"];
    // Along x, a reaches 1 and b reaches the cosine of 30 degrees and 1.1 times a half.
    let gauge = "gauge         1.65561: taken so many times about their centres they touch, of the bodies under their \
                 poses as doubles hold them";
    has(&good(folder.path(), &words), gauge);
}

#[test]
fn options_turn_and_move_and_say_the_numbers_that_are_taken() {
    let folder = folder(&[
        ("a.json", CUBE),
        ("b.csv", "1,0,0\n0,1,0\n0,0,1\n"),
        ("pose.json", r#"{"translation": [0, 0, 5]}"#),
        ("rows.csv", "0,-1,0,1\n1,0,0,2\n0,0,1,3\n0,0,0,1\n"),
    ]);
    let folder = folder.path();
    let outcome = good(folder, &["intersect", "a.json", "b.csv", "--move", "0.25,-1,0", "--turn-b", "z,45"]);
    has(&outcome, "pose of a     translation (0.25, -1.0, 0.0)");
    let root = 0.5_f64.sqrt();
    has(
        &outcome,
        &format!(
            "pose of b     matrix (({root:?}, -{root:?}, 0.0), ({root:?}, {root:?}, 0.0), (0.0, 0.0, 1.0)), \
         translation (0.0, 0.0, 0.0)"
        ),
    );
    let outcome = good(folder, &["inspect", "a.json", "--pose", "pose.json", "--turn", "x,90", "--move", "1,0,0"]);
    has(&outcome, "centre        (1.0, -5.0, 0.0)");
    has(&good(folder, &["inspect", "a.json", "--pose", "rows.csv"]), "centre        (1.0, 2.0, 3.0)");
    has(&good(folder, &["distance", "a.json", "b.csv", "--pose-b", "rows.csv"]), "distance      1.0");
    for (words, complaint) in [
        (["inspect", "a.json", "--move", "1,2"], "--move: 2 numbers for a body with 3 coordinates"),
        (["inspect", "a.json", "--turn", "30"], "--turn: in space a turn is about an axis: z,30 or 1,1,0,30"),
        (
            ["inspect", "a.json", "--pose", "absent.json"],
            "absent.json: cannot be read: No such file or directory (os error 2)",
        ),
        (
            ["inspect", "a.json", "--pose", "a.json"],
            "--pose a.json: extra field `center` in `pose`; a pose has `matrix`, `translation` or both",
        ),
    ] {
        let outcome = run(folder, &words);
        assert_eq!((outcome.status, outcome.stderr), (1, format!("zonobench: {complaint}\n")), "{words:?}");
    }
}

/// Numbers computed in doubles say so; those that are exact do not.
#[test]
fn a_body_whose_image_is_rounded_says_how_far_it_is_off() {
    let folder = folder(&[("a.json", r#"{"generators": [[1, 0, 0.1], [0, 1, 0.3], [1, 1, 0.4], [0.2, 0, 1]]}"#)]);
    let folder = folder.path();
    let plain = good(folder, &["inspect", "a.json"]);
    let turned = good(folder, &["inspect", "a.json", "--turn", "1,2,3,20"]);
    let row = |outcome: &Outcome, label: &str| {
        let line = outcome.stdout.lines().find(|line| line.starts_with(label)).map(str::to_owned);
        line.unwrap_or_else(|| panic!("{label}: {}", outcome.stdout))
    };
    for exact in ["generators", "dimension", "faces", "facets"] {
        assert_eq!(row(&plain, exact), row(&turned, exact));
    }
    assert!(row(&turned, "rounded").contains("taken in doubles, no point of it farther off than"));
    let reduced = good(folder, &["reduce", "a.json", "--count", "3", "--turn", "y,20"]);
    assert!(row(&reduced, "rounded").contains("farther off than"));
    let quarter = good(folder, &["reduce", "a.json", "--count", "3", "--turn", "y,90"]);
    assert!(!quarter.stdout.contains("farther off than"), "{}", quarter.stdout);
}

#[test]
fn fields_that_could_change_the_body_are_named() {
    let folder = folder(&[
        ("a.json", r#"{"c": [1, 2], "G": [[1, 0], [0, 1]], "A": [[1, 1]], "b": [0.5]}"#),
        ("b.json", SQUARE),
        ("p.csv", "0,0\n1,1\n"),
        ("d.json", r#"{"name": "d", "generators": [[1, 0], [0, 1]]}"#),
    ]);
    let folder = folder.path();
    let commands: [&[&str]; 6] = [
        &["inspect", "a.json"],
        &["intersect", "a.json", "b.json"],
        &["distance", "b.json", "a.json"],
        &["contains", "a.json", "p.csv"],
        &["reduce", "a.json", "--count", "2"],
        &["draw", "tiling", "a.json", "--svg", "a.svg"],
    ];
    for words in commands {
        let outcome = run(folder, words);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""), "{words:?}");
        assert!(outcome.stderr.starts_with("zonobench: a.json: A: this field could change the body"), "{words:?}");
        assert_eq!(outcome.stderr.lines().count(), 1);
    }
    let outcome = good(folder, &["inspect", "d.json"]);
    assert_eq!(outcome.stderr, "zonobench: d.json: the field `name` is not read\n");
}

/// A matrix [c, G] in a table.
#[test]
fn table_center_and_generators() {
    let folder = folder(&[
        ("named.csv", "center,g1,g2\n10,1,0\n0,0,1\n"),
        ("plain.csv", "10,1,0\n0,0,1\n"),
        ("list.json", "[[10,1,0],[0,0,1]]"),
        ("rows.csv", "10,0\n1,0\n0,1\n"),
        ("square.json", SQUARE),
    ]);
    let folder = folder.path();
    let meant = |words: &[&str]| {
        let outcome = good(folder, &[&["inspect"], words].concat());
        has(&outcome, "centre        (10.0, 0.0)");
        has(&outcome, "bounding box  [9.0, 11.0] × [-1.0, 1.0]");
        outcome.stderr
    };
    let told = meant(&["named.csv"]);
    assert_eq!(told, "zonobench: named.csv: its columns are read as the centre and generators, as their names say\n");
    for file in ["plain.csv", "list.json"] {
        assert_eq!(meant(&[file, "--columns-are-generators", "--center-first"]), "");
        let outcome = good(folder, &["inspect", file]);
        has(&outcome, "dimension     2 in 3: a flat zonogon");
        assert!(outcome.stderr.contains("--columns-are-generators reads the columns"), "{}", outcome.stderr);
        assert_eq!(outcome.stderr.lines().count(), 1);
    }
    assert_eq!(meant(&["rows.csv", "--center-first"]), "");
    let words = ["distance", "square.json", "plain.csv", "--columns-are-generators-b", "--center-first-b"];
    has(&good(folder, &words), "distance      8.0");
    let refused = run(folder, &["inspect", "square.json", "--center-first"]);
    assert!(refused.stderr.contains("--center-first are for tables, arrays and lists"), "{}", refused.stderr);
}

/// The Hausdorff distance is exact for bodies of few facets, says which body contains which, and is checked; a pose
/// that doubles do not hold is rounded, and the summary says by how much.
#[test]
fn hausdorff_distance_of_two_bodies() {
    let large = r#"{"c": [0, 0], "G": [[3, 0], [0, 1]]}"#;
    let folder = folder(&[("a.json", SQUARE), ("b.json", large)]);
    let folder = folder.path();
    let outcome = good(folder, &["hausdorff", "a.json", "b.json"]);
    has(&outcome, "distance      2.0, between 2.0 and 2.0: no point of one body is farther than that from the other");
    has(&outcome, "containment   b contains a");
    has(&outcome, "certificate   checked: containment; the distance is 2.0 to 2.0");
    has(&good(folder, &["hausdorff", "b.json", "a.json"]), "containment   b does not contain a");
    let same = good(folder, &["hausdorff", "a.json", "a.json"]);
    assert!(same.stdout.contains("distance      0.0, between 0.0 and 0.0: "), "{}", same.stdout);
    assert!(!same.stdout.contains("direction"), "equal bodies differ in no direction");
    let turned = good(folder, &["hausdorff", "a.json", "b.json", "--turn-b", "30"]);
    let rounded = "rounded b     the body under the pose is taken in doubles, no point of it farther off than ";
    assert!(turned.stdout.contains(rounded), "{}", turned.stdout);
}
