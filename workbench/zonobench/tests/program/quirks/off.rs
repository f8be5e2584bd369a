//! OFF by its other first words: those whose vertices have more numbers than coordinates, or other than three of them.

use std::fs;

use super::{read, refused};
use crate::run;

const FACE: &str = "3 0 1 2\n";

/// The text of four vertices with these numbers behind each, and a face.
fn tetrahedron(first: &str, behind: &str) -> String {
    let vertex = |xyz: &str| format!("{xyz}{behind}\n");
    format!("{first}4 1 0\n{}{FACE}", ["0 0 0", "2 0 0", "0 2 0", "0 0 2"].map(vertex).concat())
}

#[test]
fn numbers_behind_the_coordinates_are_no_coordinates() {
    let plain = read("t.off", tetrahedron("OFF\n", ""), &[], 4, "");
    for (first, behind) in [
        ("COFF\n", " 255 0 0 255"),
        ("COFF\n", " 0.5 0.5 0.5"),
        ("NOFF\n", " 0 0 9"),
        ("noff\n", " 0 0 9"),
        ("STOFF\n", " 7 7"),
        ("CNOFF\n", " 0 0 9 255 0 0 255"),
        ("STCNOFF\n", " 0 0 9 255 0 0 255 7 7"),
        ("nOFF\n3\n", ""),
        ("nOFF 3 ", ""),
        ("NnOFF\n3\n", " 0 0 9"),
        ("STnOFF 3\n", " 7 7"),
    ] {
        assert_eq!(read("t.off", tetrahedron(first, behind), &[], 4, "").stdout, plain.stdout, "{first}");
    }
    let in_a_row = tetrahedron("nOFF\n3\n", "").replace('\n', " ");
    assert_eq!(read("t.off", in_a_row, &[], 4, "").stdout, plain.stdout);
}

#[test]
fn vertices_of_other_dimensions_are_points() {
    let square = format!("nOFF\n2\n4 1 0\n0 0\n2 0\n2 1\n0 1\n{FACE}");
    let outcome = read("t.off", &square, &["--objective", "area"], 4, "left out: 1 face");
    assert!(outcome.stdout.contains("area 2.0"), "{}", outcome.stdout);
    read("t.off", "nOFF 1\n3 0 0\n5\n6\n9\n", &[], 3, "");
    read("t.off", format!("nOFF\n4\n4 1 0\n0 0 0 0\n1 0 0 1\n0 1 0 1\n0 0 1 1\n{FACE}"), &[], 4, "left out: 1 face");
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("flat.off"), square).expect("written");
    let outcome = run(folder.path(), &["mesh", "flat.off", "--level", "0"]);
    let told = "zonobench: flat.off: holds vertices with 2 coordinates; meshes of space, with three, are taken\n";
    assert!(outcome.status == 1 && outcome.stderr.ends_with(told), "{}", outcome.stderr);
}

#[test]
fn what_may_be_meant_in_two_ways_is_refused_by_its_name() {
    for first in ["4OFF", "4nOFF", "C4OFF"] {
        let told = format!(
            "line 1: is not OFF: begins with '{first}', whose last number is a weight to some programs and a \
             coordinate to others; write OFF, or nOFF and 4"
        );
        refused("t.off", tetrahedron(&format!("{first}\n"), " 1"), &[], &told);
    }
    refused("t.off", "OFF BINARY\n4 1 0\n", &[], "line 1: is not OFF: is binary; the text form is read");
    let many = "line 2: is not OFF: has vertices of 5 coordinates; one to 4 are read";
    refused("t.off", "nOFF\n5\n1 0 0\n0 0 0 0 0\n", &[], many);
    // normals and a dimension: were it read as NOFF with 3 vertices and 4 faces, all of it would fit
    let mistaken = "NOFF\n3\n4 1\n0 0 0\n1 0 0\n1 1 0\n1 0 0\n1 0 1\n1 1 1\n1 0 1\n3 0 1 2\n";
    refused("t.off", mistaken, &[], "line 4: is not OFF: the first word tells of 6 numbers a vertex, and here are 3");
}
