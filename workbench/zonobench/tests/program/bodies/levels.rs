//! `mesh --level`: the volumes of a level as an answer that is checked and as meshes.

use std::fs;

use crate::run;

const L_SHAPED: &str = "OFF\n12 10 0\n\
    0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n\
    4 0 3 2 1\n4 0 5 4 3\n4 6 7 8 9\n4 6 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n\
    4 4 5 11 10\n4 5 0 6 11\n";

#[test]
fn volumes_of_a_level_are_written_checked_and_read_again() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("l.off"), L_SHAPED).expect("written");
    let level = |options: &[&str]| run(folder, &[&["mesh", "l.off", "--level"], options].concat());
    let files = ["--obj", "level.obj", "--json", "level.json", "--question", "q.json"];
    let found = level(&[&["2", "--volume", "obb"], files.as_slice()].concat());
    assert_eq!(found.status, 0, "{}", found.stderr);
    for line in [
        "mesh          20 triangles, 12 vertices in l.off\n",
        "level         2: 4 volumes, with at most ",
        "check         checked: each triangle is in one node, whose volume contains it\n",
        "volume        obb\n",
    ] {
        assert!(found.stdout.contains(line), "{line}: {}", found.stdout);
    }
    let obj = fs::read_to_string(folder.join("level.obj")).expect("written");
    let of = |first: &str| obj.lines().filter(|line| line.split(' ').next() == Some(first)).count();
    assert_eq!([of("o"), of("v"), of("f")], [4, 28, 20], "{obj}");
    let judged = run(folder, &["verify", "q.json", "level.json"]);
    assert!(judged.status == 0 && judged.stdout.contains("\tright\t"), "{}", judged.stdout);
    let within = run(folder, &["mesh", "l.off", "level.obj"]);
    assert_eq!(within.status, 0, "the volumes are a mesh: {}", within.stderr);

    let moved = level(&["0", "--move", "5,0,0", "--volume", "zonotope_4"]);
    assert!(moved.status == 0 && moved.stdout.contains("level         0: 1 volume, with at most 20 triangles each\n"));
}

#[test]
fn what_is_no_level_is_told() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    fs::write(folder.join("l.off"), L_SHAPED).expect("written");
    fs::write(folder.join("flat.off"), "OFF\n2 1 0\n1 1 1\n2 1 1\n3 0 1 1\n").expect("written");
    for (words, complaint) in [
        (&["mesh", "l.off", "--level", "1", "--volume", "sphere"][..], "`mesh_level` has no method `sphere`"),
        (&["mesh", "l.off", "--level", "21"], "level is 21, at most 20 is taken"),
        (&["mesh", "l.off", "flat.off", "--level", "1"], "cannot be used with"),
        (&["mesh", "l.off", "flat.off", "--obj", "x.obj"], "--obj writes the volumes of a level, which --level tells"),
        (&["mesh", "l.off"], "<B>"),
    ] {
        let outcome = run(folder, words);
        assert!(outcome.status != 0 && outcome.stderr.contains(complaint), "{words:?}: {}", outcome.stderr);
    }
    let flat = run(folder, &["mesh", "flat.off", "--level", "3", "--volume", "aabb", "--obj", "flat.obj"]);
    assert_eq!(flat.status, 0, "{}", flat.stderr);
    let obj = fs::read_to_string(folder.join("flat.obj")).expect("written");
    assert!(obj.starts_with("o node_1\nv ") && obj.contains("\nl 1 2\n"), "{obj}");
}
