//! Files of another kind than a command takes, points for a mesh and bodies of another dimension: told with what is
//! taken.

use std::fs;
use std::path::Path;

use crate::{run, run_with_input};

/// The last line of the complaint about a command that is refused.
fn complaint(folder: &Path, command: &str) -> String {
    let outcome = run(folder, &command.split(' ').collect::<Vec<_>>());
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""), "{command}");
    outcome.stderr.lines().last().unwrap_or_default().to_owned()
}

#[test]
fn points_are_no_mesh() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let rows = "0,0,0\n1,0,0\n0,1,0\n";
    let cloud = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
                 end_header\n0 0 0\n";
    for (name, text) in [
        ("space.csv", rows),
        ("plane.csv", "0,0\n1,0\n"),
        ("wide.txt", "0 0 0 0 0\n1 0 0 0 0\n"),
        ("rows.json", "[[0,0,0],[1,0,0]]"),
        ("body.json", "{\"c\":[0,0,0],\"G\":[[1,0,0],[0,1,0],[0,0,1]]}"),
        ("cloud.xyz", "0 0 0\n1 0 0\n"),
        ("points.geojson", "{\"type\":\"MultiPoint\",\"coordinates\":[[0,0],[1,0]]}"),
        ("cloud.ply", cloud),
        ("cloud.obj", "v 0 0 0\nv 1 0 0\n"),
        ("cloud.off", "OFF\n1 0 0\n0 0 0\n"),
        ("named.csv", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
    ] {
        fs::write(folder.join(name), text).expect("written");
    }
    let meshes = "a mesh is an OBJ, PLY, STL or OFF file with faces";
    for (name, format) in [
        ("space.csv", "csv"),
        ("plane.csv", "csv"),
        ("wide.txt", "csv"),
        ("rows.json", "json"),
        ("body.json", "json"),
        ("cloud.xyz", "xyz"),
        ("points.geojson", "geojson"),
    ] {
        let told = format!("zonobench: {name}: the format {format} holds no triangles; {meshes}");
        assert_eq!(complaint(folder, &format!("mesh {name} a.obj")), told);
        assert_eq!(complaint(folder, &format!("mesh a.obj {name}")), told);
        assert_eq!(complaint(folder, &format!("mesh {name} --level 1")), told);
    }
    for name in ["cloud.ply", "cloud.obj", "cloud.off"] {
        let enclose = "`zonobench enclose` makes a body around points";
        let told = format!("zonobench: {name}: holds vertices and no faces; {meshes}; {enclose}");
        assert_eq!(complaint(folder, &format!("mesh {name} a.obj")), told);
        assert_eq!(complaint(folder, &format!("collide {name} a.obj --translation 1,0,0")), told);
    }
    assert!(complaint(folder, "mesh named.csv a.obj").contains("--format off"), "a mesh under another name");
    assert!(complaint(folder, "mesh absent.csv a.obj").contains("cannot be read"));
}

#[test]
fn bodies_of_another_dimension_are_told_by_their_file() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    for dimension in [2, 4, 5, 7] {
        let zeros = ",0".repeat(dimension - 1);
        let body = format!("{{\"center\":[0{zeros}],\"generators\":[[1{zeros}]]}}");
        fs::write(folder.join(format!("{dimension}.json")), body).expect("written");
    }
    fs::write(folder.join("p.csv"), "0,0\n1,0\n").expect("written");
    for (command, file, told) in [
        ("collide 2.json 2.json --translation 1,0,0", "2.json", "has 2 coordinates; bodies of space, with three, are"),
        ("sweep 2.json --translation 1,0,0", "2.json", "has 2 coordinates; bodies of space, with three, are taken"),
        ("sweep 4.json --translation 1,0,0", "4.json", "has 4 coordinates; bodies of space, with three, are taken"),
        ("distance 4.json 4.json", "4.json", "has 4 coordinates; bodies with 1 to 3 are taken"),
        ("intersect 7.json 7.json", "7.json", "has 7 coordinates; bodies with 1 to 6 are taken"),
        ("hausdorff 7.json 7.json", "7.json", "has 7 coordinates; bodies with 1 to 6 are taken"),
        ("reduce 7.json --count 7", "7.json", "has 7 coordinates; bodies with 1 to 6 are taken"),
        ("inspect 7.json", "7.json", "has 7 coordinates; bodies with 1 to 6 are taken"),
        ("contains 5.json p.csv", "5.json", "has 5 coordinates; bodies with 1 to 4 are taken"),
    ] {
        let complaint = complaint(folder, command);
        assert!(complaint.starts_with(&format!("zonobench: {file}: {told}")), "{command}: {complaint}");
    }
}

#[test]
fn kinds_of_one_dimension_say_which_one() {
    let flat = r#"{"center":[0,0],"generators":[[1,0]]}"#;
    let mesh = r#"{"vertices":[[0,0]],"triangles":[[0,0,0]]}"#;
    let moved = r#"{"axis_point":[0,0,0],"axis":[0,0,1],"angle":1,"translation":[0,0,0]}"#;
    for (kind, input, told) in [
        ("collide", format!(r#""a":{flat},"b":{flat},"motion":{{"a":{moved}}}"#), "bodies and meshes of space"),
        ("mesh", format!(r#""a":{mesh},"b":{mesh}"#), "meshes of space"),
        ("mesh_level", format!(r#""a":{mesh},"level":1"#), "meshes of space"),
        (
            "sweep",
            r#""center":[0,0],"generators":[],"axis_point":[0,0],"axis":[1,0],"angle":1,"translation":[0,0]"#
                .to_owned(),
            "bodies of space",
        ),
        ("separator", r#""generators":[[1,0]],"k":1"#.to_owned(), "generators of space"),
        ("upper_hull", r#""generators":[[1,0]],"p0":[0,0]"#.to_owned(), "generators of space"),
        ("walk", r#""generators":[[1,0]],"facet":[0,1,1]"#.to_owned(), "generators of space"),
        ("slope_selection", r#""generators":[[1,0]],"k":[1]"#.to_owned(), "generators of space"),
        ("min_area", r#""points":[[0,0,0]]"#.to_owned(), "points of the plane"),
    ] {
        let question = format!(r#"{{"id":"q","kind":"{kind}","input":{{{input}}}}}"#);
        let outcome = run_with_input(Path::new("."), &["solve"], question.as_bytes());
        let told = format!(": `{kind}` takes {told}\"");
        assert!(outcome.stdout.contains("dimension_mismatch") && outcome.stdout.contains(&told), "{}", outcome.stdout);
    }
}
