//! Values beyond what a mesh declares, words that its format does not have, and numbers that doubles do not hold.

use super::*;

#[test]
fn values_of_ply_beyond_their_declared_type_are_refused_by_element_row_and_property() {
    let refused = |content: String, row: &str, complaint: &str| {
        let found = self::complaint("t.ply", &content);
        assert!(found.contains(&format!("is not PLY: {row}: {complaint}")), "{found}");
    };
    for (value, kind) in [("300", "uchar"), ("-1", "uchar"), ("2.5", "uchar"), ("nan", "uchar"), ("1e12", "int")] {
        let content = PLY.replace("uchar red", &format!("{kind} red")).replace("2 0 0 9", &format!("2 0 0 {value}"));
        refused(content, "vertex 2", &format!("`red` is of the type {kind}, which '{value}' is not"));
    }
    for (kind, value) in [("char", "128"), ("short", "-32769"), ("ushort", "65536"), ("uint", "4294967296")] {
        let content = PLY.replace("uchar red", &format!("{kind} red")).replace("2 0 0 9", &format!("2 0 0 {value}"));
        refused(content, "vertex 2", &format!("`red` is of the type {kind}, which '{value}' is not"));
    }
    let corner = |value: &str| PLY.replace("3 0 1 2", &format!("3 0 1 {value}"));
    refused(corner("2.5"), "face 1", "`vertex_indices` is of the type int, which '2.5' is not");
    refused(corner("-1"), "face 1", "the corner '-1' is no vertex");
    let of_floats = corner("2.5").replace("uchar int vertex", "uchar float vertex");
    refused(of_floats, "face 1", "the corner '2.5' is no vertex");
    let whole = PLY.replace("2 0 0 9", "2 0 0 255").replace("uchar int vertex", "uchar float vertex");
    assert_eq!(read("t.ply", whole), Ok(CORNERS.to_vec()));
    let other = "element camera 1\nproperty uchar a\nend_header\n";
    let content = PLY.replace("end_header\n", other);
    refused(format!("{content}256\n"), "camera 1", "`a` is of the type uchar, which '256' is not");
}

#[test]
fn corners_of_binary_ply_that_are_no_whole_numbers_are_refused() {
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar float vertex_indices\nend_header\n";
    let content = |corner: f32| -> Vec<u8> {
        let vertices = CORNERS[..3].iter().flatten().flat_map(|&x| (x as f32).to_le_bytes());
        let corners = [0.0, 1.0, corner].into_iter().flat_map(f32::to_le_bytes);
        header.bytes().chain(vertices).chain([3]).chain(corners).collect()
    };
    assert_eq!(read("t.ply", content(2.0)), Ok(CORNERS[..3].to_vec()));
    for wrong in [1.5, -1.0, f32::NAN] {
        let found = complaint("t.ply", content(wrong));
        assert!(found.starts_with("t.ply: face 1: is not PLY: the corner"), "{found}");
    }
}

#[test]
fn words_that_obj_does_not_have_earn_one_line() {
    let told = |more: &str| told("t.obj", format!("{OBJ}{more}"));
    assert_eq!(told("vn 0 0 1\nvt 0 0\ns off\ncstype bezier\ndeg 2\nparm u 0 1\nend\n"), None);
    let one = "left out: 1 line that begins with a word that OBJ does not have ('foo', line 12)";
    assert_eq!(told("foo 1 2\n").as_deref(), Some(one));
    let two = "left out: 2 lines that begin with words that OBJ does not have ('0.5', line 12)";
    assert_eq!(told("0.5 1 2\nV 1 2 3\n").as_deref(), Some(two));
    let table = complaint("t.obj", "1 2 3\n4 5 6\n");
    assert_eq!(table, "t.obj: line 1: is not OBJ: '1' is no word with which its lines begin");
}

#[test]
fn control_points_of_curves_and_surfaces_are_read_and_told() {
    let vertices = "v 0 0 0\nv 2 0 0\nv 0 0.5 0\nv 0 0 -3\n";
    let note = "vertices are control points of curves or surfaces, which are not read themselves";
    for (elements, count, left_out) in [
        ("curv 0 1 1 2 3 4\n", 4, ""),
        ("curv 0.0 1.0 -4 -3 -2\n", 3, "left out: 1 vertex that nothing uses; "),
        ("surf 0 1 0 1 1/1 2/2 3/3 4/4/4\n", 4, ""),
        ("curv 0 1 1 2\nf 2 3 4\n", 2, ""),
    ] {
        let mesh = mesh("t.obj", format!("{vertices}{elements}")).expect("a mesh");
        assert_eq!(mesh.in_words(), Some(format!("{left_out}{count} {note}")), "{elements}");
    }
    assert!(complaint("t.obj", format!("{vertices}curv 0 1 1 9\n")).contains("the vertex 9 is used, of 4"));
    assert!(complaint("t.obj", format!("{vertices}surf 0 1 0 1 1 2.5\n")).contains("'2.5' is no vertex"));
}

#[test]
fn numbers_of_every_text_of_a_mesh_that_doubles_do_not_hold_are_counted() {
    let contents =
        [("t.obj", OBJ.to_owned()), ("t.ply", PLY.to_owned()), ("t.off", OFF.to_owned()), ("t.stl", ascii_stl())];
    for (name, content) in contents {
        assert_eq!(mesh(name, &content).expect("whole").losses, None, "{name}");
        let large = mesh(name, content.replacen("0.5", "9007199254740993", 1)).expect("whole").losses;
        assert!(large.expect(name).starts_with("1 whole number has more digits than a double holds"), "{name}");
        let small = mesh(name, content.replacen("0.5", "-1e-400", 1)).expect("whole").losses;
        let small = small.expect(name);
        assert!(small.contains("is read as 0 (-1e-400, line ") && small.contains("column 2)"), "{name}: {small}");
    }
    let in_a_row = OFF.replace("0.5", "1e-400").replace("2 0 0 255 0 0", "2 0 0").replace(" # the last", "");
    let in_a_row = in_a_row.replace("# counts\n", "").replace('\n', " ");
    assert!(mesh("t.off", in_a_row).expect("whole").losses.is_some());
    let weight = OBJ.replace("v 2 0 0", "v 2 0 0 9007199254740993");
    assert!(mesh("t.obj", weight).expect("whole").losses.is_some());
}
