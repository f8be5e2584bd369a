//! Tables that name a centre by any spelling, as a column, as a row or in a comment: it is read as the centre, or the
//! name is refused, and never is it a coordinate or left out in silence.

use super::{folder, good, has};
use crate::run;

#[test]
fn a_column_that_is_named_as_a_centre_is_no_coordinate() {
    for (content, name) in [
        ("c,x1\n10,1\n0,0\n", "c"),
        ("C,A1\n10,1\n0,0\n", "C"),
        ("mean,pc1\n10,1\n0,0\n", "mean"),
        ("midpoint,x1\n10,1\n0,0\n", "midpoint"),
        ("center,a\n10,1\n0,0\n", "center"),
        ("c,v1\n10,1\n0,0\n", "c"),
        ("c,x1,x2\n10,1,0\n0,0,1\n0,0,1\n", "c"),
        ("# c,x1\n10,1\n0,0\n", "c"),
    ] {
        let folder = folder(&[("a.csv", content)]);
        let outcome = run(folder.path(), &["inspect", "a.csv"]);
        let complaint = format!("zonobench: a.csv: line 1: the column '{name}' is named as a centre or a generator, ");
        assert!(outcome.status == 1 && outcome.stderr.starts_with(&complaint), "{content}: {}", outcome.stderr);
        assert!(outcome.stderr.contains("--columns-are-generators and --center-first say"), "{}", outcome.stderr);
    }
    let folder = folder(&[("a.csv", "a,b,c\n1,0,0\n0,1,0\n0,0,1\n"), ("b.csv", "centroid,g\n10,1\n0,0\n")]);
    has(&good(folder.path(), &["inspect", "a.csv"]), "centre        (0.0, 0.0, 0.0)");
    let outcome = good(folder.path(), &["inspect", "b.csv"]);
    has(&outcome, "centre        (10.0, 0.0)");
    assert!(outcome.stderr.contains("read as the centre and generators, as their names say"), "{}", outcome.stderr);
}

#[test]
fn a_row_that_is_called_a_centre_by_any_spelling_is_the_centre() {
    for content in [
        "name,x,y\nc,10,0\ng1,1,0\n",
        "type;x;y\nc;10;0\ng;1;0\n",
        ",x,y\ncentroid,10,0\na,1,0\n",
        ",0,1\nc,10.0,0.0\ng1,1.0,0.0\n",
        "name,x,y\ng1,1,0\nMean,10,0\n",
    ] {
        let folder = folder(&[("a.csv", content)]);
        let outcome = good(folder.path(), &["inspect", "a.csv"]);
        has(&outcome, "centre        (10.0, 0.0)");
        assert!(outcome.stderr.contains("of numbers is read as the centre, as it is called"), "{}", outcome.stderr);
    }
    let folder = folder(&[("a.csv", "name,x,y\na,1,0\nb,0,1\nc,1,1\n")]);
    has(&good(folder.path(), &["inspect", "a.csv"]), "generators    3 directions");
}

#[test]
fn two_rows_that_are_called_a_centre_are_an_error() {
    for content in [
        "name,x,y\ncenter,10,0\ncenter,20,0\ng,0,1\n",
        "name,x,y\nCenter,10,0\nCentre,20,0\ng,0,1\n",
        "name,x,y\nc,10,0\ncenter,20,0\ng,0,1\n",
    ] {
        let folder = folder(&[("a.csv", content)]);
        let outcome = run(folder.path(), &["inspect", "a.csv"]);
        let complaint = "a.csv: line 3: this row and that of line 2 are called a centre, and a body has one";
        let is_told = outcome.stderr.lines().last() == Some(&format!("zonobench: {complaint}"));
        assert!(outcome.status == 1 && is_told, "{content}: {}", outcome.stderr);
    }
}

/// A comment above the rows is their header for bodies as it is for points.
#[test]
fn a_comment_that_names_the_columns_is_their_header() {
    for content in [
        "# center,g1\n10,1\n0,0\n",
        "// center,g1\n10,1\n0,0\n",
        "%center g1\n10 1\n0 0\n",
        "# center,g1\n1.0e+01 1.0e+00\n0.0e+00 0.0e+00\n",
        "# center g1\n10,1\n0,0\n",
        "# the center and a generator\n# center,g1\n10,1\n0,0\n",
    ] {
        let folder = folder(&[("a.csv", content)]);
        let outcome = good(folder.path(), &["inspect", "a.csv"]);
        has(&outcome, "centre        (10.0, 0.0)");
        has(&outcome, "generators    1 direction");
    }
    for content in [
        "# center\n10,0\n# generators\n1,0\n0,1\n",
        "1,0\n0,1\n% c\n10,0\n",
        "# c = 10, 0\n1,0\n0,1\n",
        "# the center is (10, 0)\n1,0\n0,1\n",
    ] {
        let folder = folder(&[("a.csv", content)]);
        let outcome = run(folder.path(), &["inspect", "a.csv"]);
        let tells = outcome.stderr.contains("speaks of a centre, and comments are not read; name the columns");
        assert!(outcome.status == 1 && tells, "{content}: {}", outcome.stderr);
    }
    let folder = folder(&[("a.csv", "# center\n10,0\n# generators\n1,0\n"), ("b.csv", "# center: the origin\n1,0\n")]);
    has(&good(folder.path(), &["inspect", "a.csv", "--center-first"]), "centre        (10.0, 0.0)");
    has(&good(folder.path(), &["inspect", "b.csv"]), "centre        (0.0, 0.0)");
}

/// A first row of two whole numbers above a few rows is no size of the table, for points, bodies, directions and poses.
#[test]
fn the_first_of_a_few_rows_is_data() {
    let told = "the first row (1, 2) is read as data, though it may say the sizes of the table";
    let folder = folder(&[
        ("p.txt", "1 2\n3 4\n"),
        ("p.xyz", "1 2\n3 4\n"),
        ("p.csv", "1 2\n3 4\n"),
        ("square.json", super::SQUARE),
    ]);
    let folder = folder.path();
    for name in ["p.txt", "p.xyz", "p.csv"] {
        let outcome = good(folder, &["enclose", name, "--objective", "length"]);
        has(&outcome, &format!("points        2 in {name}, with 2 coordinates"));
        assert!(outcome.stdout.contains(told), "{}", outcome.stdout);
    }
    let outcome = good(folder, &["inspect", "p.csv"]);
    has(&outcome, "generators    2 directions");
    assert!(outcome.stderr.contains(told), "{}", outcome.stderr);
    let outcome = good(folder, &["inspect", "square.json", "--pose", "p.csv"]);
    assert!(outcome.stderr.contains(told), "{}", outcome.stderr);
    let outcome = good(folder, &["enclose", "p.txt", "--directions", "p.csv", "--no-header"]);
    assert!(outcome.stderr.contains(told) && !outcome.stderr.contains("--"), "{}", outcome.stderr);
}

/// The sign # as the name of a column that counts the rows.
#[test]
fn a_column_named_by_a_hash_counts_the_rows() {
    for content in ["#,x,y\n1,5,6\n2,7,8\n", "#;x;y\n1;5;6\n2;7;8\n", "#\tx\ty\n1\t5\t6\n2\t7\t8\n"] {
        let folder = folder(&[("p.csv", content)]);
        let outcome = good(folder.path(), &["enclose", "p.csv", "--objective", "length"]);
        has(&outcome, "points        2 in p.csv, with 2 coordinates");
        has(&outcome, "columns       x, y; left out: column 1, which counts the rows");
    }
}
