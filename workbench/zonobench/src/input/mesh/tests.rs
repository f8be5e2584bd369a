//! Meshes of every format, whole and broken.

mod declared;

use std::path::Path;

use super::{Format, Points, Reading, Skipping};

fn mesh(name: &str, content: impl AsRef<[u8]>) -> Result<Reading, String> {
    sieved(name, content, &mut Skipping::default())
}

fn sieved(name: &str, content: impl AsRef<[u8]>, skipping: &mut Skipping) -> Result<Reading, String> {
    let file = Path::new(name);
    let format = Format::of_extension(file).expect("the name tells the format");
    super::points(file, content.as_ref(), format, skipping).map_err(|error| error.to_string())
}

fn read(name: &str, content: impl AsRef<[u8]>) -> Result<Vec<[f64; 3]>, String> {
    mesh(name, content).map(vertices)
}

fn vertices(mesh: Reading) -> Vec<[f64; 3]> {
    match mesh.points {
        Points::Space(vertices) => vertices,
        other => panic!("{other:?} are not points of space"),
    }
}

/// The remarks on a mesh beside its vertices.
fn told(name: &str, content: impl AsRef<[u8]>) -> Option<String> {
    mesh(name, content).expect("the mesh is whole").in_words()
}

fn complaint(name: &str, content: impl AsRef<[u8]>) -> String {
    let text = String::from_utf8_lossy(content.as_ref()).into_owned();
    let complaint = read(name, content).expect_err(&text);
    assert!(!complaint.contains('\n'), "{complaint}");
    complaint
}

const CORNERS: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, -3.0]];

const OBJ: &str = "# a tetrahedron\nmtllib none.mtl\no t\nv 0 0 0\nv 2 0 0\nv 0 0.5 0\nv 0 0 -3e0\nusemtl m\n\
    f 1 3 2\nf 1/ 2/ 4/\nf 2 3 4\n";

const PLY: &str = "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\n\
    property double x\nproperty float y\nproperty double z\n\
    property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0 9\n2 0 0 9\n0 0.5 0 9\n0 0 -3 9\n3 0 1 2\n";

const OFF: &str = "OFF\n# counts\n4 1 6\n\n0 0 0\n2 0 0 255 0 0\n0 0.5 0\n0 0 -3 # the last\n3 0 1 2\n";

fn ascii_stl() -> String {
    let facet = |corners: [usize; 3]| {
        let lines: String = corners
            .iter()
            .map(|&c| format!("vertex {} {} {}\n", CORNERS[c][0], CORNERS[c][1], CORNERS[c][2]))
            .collect();
        format!("facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
    };
    format!("solid\n{}endsolid\nsolid second\n{}endsolid second\n", facet([0, 1, 2]), facet([0, 2, 3]))
}

fn binary_stl(header: &str) -> Vec<u8> {
    let mut content = format!("{header:<80}").into_bytes();
    content.extend(2_u32.to_le_bytes());
    for corners in [[0, 1, 2], [0, 2, 3]] {
        content.extend([0; 12]);
        for axis in corners.iter().flat_map(|&corner: &usize| CORNERS[corner]) {
            content.extend((axis as f32).to_le_bytes());
        }
        content.extend([0; 2]);
    }
    content
}

fn binary_ply(order: &str) -> Vec<u8> {
    let mut content = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 4\n\
         property float x\nproperty float y\nproperty float z\nend_header\n"
    )
    .into_bytes();
    for x in CORNERS.iter().flatten().map(|&x| x as f32) {
        content.extend(if order == "little" { x.to_le_bytes() } else { x.to_be_bytes() });
    }
    content
}

#[test]
fn every_format_holds_the_same_vertices() {
    let expected = Ok(CORNERS.to_vec());
    assert_eq!(read("t.obj", OBJ).map(sorted), expected.clone().map(sorted));
    assert_eq!(read("t.ply", PLY), expected);
    assert_eq!(read("t.ply", binary_ply("little")), expected);
    assert_eq!(read("t.ply", binary_ply("big")), expected);
    assert_eq!(read("t.off", OFF), expected);
    assert_eq!(read("t.off", OFF.replace("OFF\n", "COFF 4 1 0\n").replace("4 1 6\n", "")), expected);
    assert_eq!(read("t.stl", ascii_stl()), expected);
    assert_eq!(read("t.stl", binary_stl("made by hand")), expected);
    assert_eq!(read("t.stl", binary_stl("solid, in spite of its name")), expected);
}

fn sorted(mut points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    points.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
    points
}

#[test]
fn complaints_name_the_line() {
    assert_eq!(complaint("t.obj", OBJ.replace("0.5", "half")), "t.obj: line 6, column 2: 'half' is not a number");
    let huge = "is outside the range of a double";
    assert_eq!(complaint("t.obj", OBJ.replace("0.5", "1e999")), format!("t.obj: vertex 3, line 6: '1e999' {huge}"));
    assert_eq!(complaint("t.obj", OBJ.replace("0.5", "nan")), "t.obj: vertex 3, line 6: 'nan' is not a finite number");
    assert_eq!(
        complaint("t.obj", OBJ.replace("f 2 3 4", "f 2 3 9")),
        "t.obj: line 11: is not OBJ: the vertex 9 is used, of 4"
    );
    for broken in ["f 2 0 4", "f 2 x 4", "f 2 -5 4"] {
        assert!(complaint("t.obj", OBJ.replace("f 2 3 4", broken)).starts_with("t.obj: line 11: is not OBJ: '"));
    }
    assert!(complaint("t.obj", OBJ.replace("v 0 0.5 0", "v 0 0.5")).starts_with("t.obj: line 6, column 3: is not OBJ"));
    assert_eq!(
        complaint("t.obj", OBJ.replace("0.5", "0,5")),
        "t.obj: line 6, column 2: '0,5' has a comma where a decimal point is expected"
    );
    assert_eq!(complaint("t.ply", PLY.replace("0 0.5 0", "0 x 0")), "t.ply: line 14, column 2: 'x' is not a number");
    let nan = "t.ply: vertex 3, line 14: 'nan' is not a finite number";
    assert_eq!(complaint("t.ply", PLY.replace("0 0.5 0", "0 nan 0")), nan);
    assert!(
        complaint("t.ply", PLY.replace("0 0.5 0", "0 0.5")).contains("line 14: is not PLY: vertex 3: the line has")
    );
    assert!(complaint("t.ply", PLY.replace("float y", "float w")).contains("no property `y`"));
    assert!(complaint("t.ply", PLY.replace("3 0 1 2", "3 0 1 4")).starts_with("t.ply: face 1: is not PLY: a face has"));
    assert!(complaint("t.ply", PLY.replace("3 0 1 2\n", "")).ends_with("ends after 0 of 1 elements `face`"));
    assert!(complaint("t.ply", "plx\n").starts_with("t.ply: line 1: "));
    assert!(complaint("t.ply", PLY.replace("end_header", "end")).starts_with("t.ply: line 11: is not PLY"));
    assert!(complaint("t.ply", &binary_ply("big")[..150]).ends_with("of 4 elements `vertex`"));
    assert_eq!(complaint("t.off", OFF.replace("0.5", "half")), "t.off: line 7, column 2: 'half' is not a number");
    assert_eq!(complaint("t.off", OFF.replace("0.5", "inf")), "t.off: vertex 3, line 7: 'inf' is not a finite number");
    assert!(complaint("t.off", OFF.replace("4 1 6", "40 1 6")).ends_with("ends after 5 of 40 vertices"));
    assert!(complaint("t.off", OFF.replace("4 1 6", "4 4 6")).ends_with("ends after 1 of 4 faces"));
    assert!(complaint("t.off", OFF.replace("3 0 1 2", "3 0 1 4")).starts_with("t.off: line 9: is not OFF: a face has"));
    assert!(
        complaint("t.off", OFF.replace("OFF", "4OFF")).starts_with("t.off: line 1: is not OFF: begins with '4OFF'")
    );
    assert!(complaint("t.off", "OFF BINARY\n4 2 0\n").contains("is binary"));
    assert_eq!(
        complaint("t.stl", ascii_stl().replacen("0.5", "half", 1)),
        "t.stl: line 6, column 2: 'half' is not a number"
    );
    assert!(
        complaint("t.stl", ascii_stl().replacen("solid", "", 1)).starts_with("t.stl: line 2: is not STL: expected")
    );
    assert!(
        complaint("t.stl", ascii_stl().replacen("endloop\n", "", 1)).contains("line 7: is not STL: expected `endloop`")
    );
    let cut = binary_stl("made by hand");
    assert!(complaint("t.stl", &cut[..cut.len() - 7]).ends_with("is not STL: ends within triangle 2 of 2"));
    let mut infinite = binary_stl("made by hand");
    infinite[96..100].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_eq!(complaint("t.stl", &infinite), "t.stl: corner 1 of triangle 1: 'inf' is not a finite number");
}

#[test]
fn nothing_is_no_mesh_or_has_no_vertices() {
    assert_eq!(read("t.obj", ""), Ok(vec![]));
    assert!(read("t.ply", "").is_err() && read("t.off", "").is_err());
    assert_eq!(read("t.stl", ""), Ok(vec![]));
}

/// Lines and bytes behind the last element that is counted are told.
#[test]
fn surplus_is_told() {
    let behind = |what: &str| Some(format!("left out: {what}"));
    assert_eq!(told("t.off", OFF), behind("1 vertex's numbers behind the third"));
    assert_eq!(told("t.off", "OFF\n1 0 0\n0 0 0\n1 0 0\n"), behind("1 line behind the faces"));
    assert_eq!(told("t.ply", PLY), None);
    assert_eq!(told("t.ply", format!("{PLY}\n7\n")), behind("1 line behind the last element"));
    assert_eq!(told("t.ply", [&binary_ply("big")[..], b"ab"].concat()), behind("2 bytes behind the last element"));
    assert_eq!(told("t.stl", [&binary_stl("a")[..], b"abc"].concat()), behind("3 bytes behind the triangles"));
    assert_eq!(told("t.stl", ascii_stl().replacen("endsolid\n", "", 1)).as_deref(), Some("1 solid has no `endsolid`"));
}

/// Text and binary agree on what is not looked at: normals, names, capitals, attributes.
#[test]
fn texts_of_stl_may_be_written_in_many_ways() {
    let text = "solid a\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 2 0 0\n vertex 0 .5 0\n endloop\n \
        endfacet\nendsolid a\n";
    let expected = Ok(CORNERS[..3].to_vec());
    for (from, to) in [
        ("", ""),
        ("endsolid a", "end solid a"),
        ("endloop", "end loop"),
        ("endfacet", "end facet"),
        ("normal 0 0 1", "normal NaN NaN NaN"),
        ("normal 0 0 1", "normal -1.#IND -1.#IND -1.#IND"),
        ("normal 0 0 1", ""),
        ("solid a", "solid facet outer loop"),
        ("\n", "\r\n"),
        ("\n", "\r"),
        ("vertex 2 0 0\n", "vertex\n2\t0\n0\n"),
        ("0 .5 0", "0. 5.e-1 +0"),
        ("endsolid a\n", "endsolid"),
    ] {
        assert_eq!(read("t.stl", text.replace(from, to)), expected, "{from} {to}");
    }
    assert_eq!(read("t.stl", text.to_uppercase()), expected);
    assert_eq!(read("t.stl", text.replace("2 0 0", "0.1 0 0")).map(|vertices| vertices[1]), Ok([0.1, 0.0, 0.0]));
    let latin: Vec<u8> =
        text.replace("solid a", "solid \u{1}").bytes().map(|b| if b == 1 { 0xe9 } else { b }).collect();
    assert_eq!(read("t.stl", latin), expected);
    let mut binary = binary_stl("SOLID by name");
    binary[84..96].fill(0xff);
    binary[132..134].fill(0xff);
    assert_eq!(read("t.stl", &binary), Ok(CORNERS.to_vec()));
}

#[test]
fn texts_of_ply_may_be_written_in_many_ways() {
    let text = "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\n\
        property float z\nproperty float nx\nend_header\n0 0 0 1\n2 0 0 1\n0 .5 0 1\n";
    let expected = Ok(CORNERS[..3].to_vec());
    for (from, to) in [
        ("", ""),
        (".5", "5.e-1"),
        ("2 0 0 1", "2. 0. -0 nan"),
        ("\n2 0", "\n\n 2 0"),
        ("comment c\n", "comment c\n\nobj_info x y\n"),
        ("\n", "\r\n"),
        ("\n", "\r"),
        ("float x", "float32 x"),
        ("element vertex", "element camera 1\nproperty list uchar int a\nelement vertex"),
    ] {
        let text = text.replace(from, to);
        let text = if text.contains("camera") { text.replace("end_header\n", "end_header\n2 7 8\n") } else { text };
        assert_eq!(read("t.ply", &text).map(plus_zero), expected, "{from} {to}");
    }
    let tenth = text.replace("2 0 0 1", "0.1 0 0 1");
    assert_eq!(read("t.ply", tenth).map(|vertices| vertices[1]), Ok([0.1, 0.0, 0.0]), "all digits are kept");
    let latin: Vec<u8> =
        text.replace("comment c", "comment \u{1}").bytes().map(|b| if b == 1 { 0xe9 } else { b }).collect();
    assert_eq!(read("t.ply", latin), expected);
}

fn plus_zero(vertices: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    vertices.into_iter().map(|vertex| vertex.map(|x| x + 0.0)).collect()
}

#[test]
fn points_lines_and_faces_of_obj_use_vertices() {
    let vertices = "v 0 0 0\nv 2 0 0\nv 0 0.5 0\nv 0 0 -3\n";
    let with = |rest: &str| format!("{vertices}{rest}");
    let expected = Ok(CORNERS.to_vec());
    for content in [
        with("f 1 2 3 4\n"),
        with("p 1 2\np 3 4\nl 1 2\n"),
        with("l 1/7 2/7\np 3//1 4\n"),
        with("f -4 -3 -2\nf -1/1/1 -2/2/2 -3\n"),
        with("fo 1 2 3 4\n"),
        with(""),
        with("f 1 2 \\\n3 4\n"),
        with("f 1 2 \\\r\n3 4 # no \\\n"),
        with("f 1 2 3 4").replace("2 0 0", "2 0 0 # the second"),
        with("f 1 2 3 4").replace("2 0 0", "4 0 0 2"),
        with("f 1 2 3 4").replace("2 0 0", "2 0 0 1"),
        with("f 1 2 3 4").replace("2 0 0", "2 0 0 255 0 0"),
        with("f 1 2 3 4").replace("2 0 0", "2 \\\n 0 \\\n0"),
        format!("f 1 2 3 4\n{vertices}"),
        with("f 1 2 3 4\n").replace('\n', "\r"),
    ] {
        assert_eq!(read("t.obj", &content), expected, "{content}");
    }
    let latin = [b"# Gr\xfc\xdfe\no \xe9\n", with("usemtl \u{e9}\nf 1 2 3 4").as_bytes()].concat();
    assert_eq!(read("t.obj", latin), expected);
    assert_eq!(told("t.obj", with("f 1 2 3\n")).as_deref(), Some("left out: 1 vertex that nothing uses"));
    assert_eq!(told("t.obj", with("f 1 2 3 4\n")), None);
    let weighted = with("f 1 2 3 4\n").replace("2 0 0", "4 0 0 2");
    assert_eq!(told("t.obj", weighted).as_deref(), Some("1 vertex divided by its weight"));
    let unused = with("f 1 2 3\n").replace("0 0 -3", "0 0 nan");
    assert_eq!(read("t.obj", unused), Ok(CORNERS[..3].to_vec()), "only vertices that are used are looked at");
    assert!(complaint("t.obj", with("f 1 2 3\\\n4\n")).contains("a backslash between two characters"));
    assert!(complaint("t.obj", with("").replace("2 0 0", "2 0 0 0")).contains("weight 0 lies at infinity"));
}

#[test]
fn words_of_off_may_stand_on_any_lines() {
    let expected = Ok(CORNERS.to_vec());
    let vertices = "0 0 0\n2 0 0\n0 0.5 0\n0 0 -3\n";
    let faces = "3 0 1 2\n3 0 1 3\n";
    for content in [
        format!("OFF\n4 2 0\n{vertices}{faces}"),
        format!("OFF4 2 0\n{vertices}{faces}"),
        format!("OFF 4 2 0\n{vertices}{faces}"),
        format!("off\n4 2\n{vertices}{faces}"),
        format!("4 2 0\n{vertices}{faces}"),
        format!("OFF\n4\n2\n0\n{vertices}{faces}"),
        format!("OFF\n4 2 0\n{vertices}{faces}").replace(' ', "\n"),
        format!("OFF 4 2 0 {vertices}{faces}").replace('\n', " "),
        format!("OFF\n4 2 0\n{vertices}{faces}").replace('\n', "\r\n"),
        format!("# a\nCOFF # b\n4 2 0\n{vertices}{faces}").replace("2 0 0\n", "2 0 0 255 0 0 255\n"),
        format!("NOFF4 2 0\n{}{faces}", vertices.replace('\n', " 0 0 1\n")),
        format!("NOFF\n4 2 0\n{}{faces}", vertices.replace('\n', " 0 0 1 ").replace(' ', "\n")),
        format!("STOFF\n4 2 0\n{}{faces}", vertices.replace('\n', " 0.5 nan\n")),
        format!("OFF\n4 2 0\n{vertices}{}", faces.replace('\n', " 0.5 0.5 0.5\n")),
        format!("OFF\n4 0 0\n{vertices}"),
    ] {
        assert_eq!(read("t.off", &content), expected, "{content}");
    }
}

#[test]
fn vertices_that_are_not_finite_are_left_out_with_their_faces() {
    let cases: [(&str, Vec<u8>); 4] = [
        ("t.obj", OBJ.replace("0.5", "nan").into()),
        ("t.ply", PLY.replace("0.5", "inf").into()),
        ("t.off", OFF.replace("0.5", "-nan").into()),
        ("t.stl", ascii_stl().replace("0.5", "-1.#IND").into()),
    ];
    for (name, content) in cases {
        let mut skipping = Skipping::new(true);
        let mesh = sieved(name, content, &mut skipping).expect("three vertices");
        assert!(mesh.faces.iter().flat_map(|face| face.iter()).all(|&corner| corner < 3), "{name}");
        assert_eq!(mesh.faces.len(), usize::from(name == "t.obj"), "{name}");
        let left = if name == "t.stl" { (3, 2) } else { (3, 1) };
        assert_eq!((vertices(mesh).len(), skipping.count()), left, "{name}");
    }
}

#[test]
fn faces_are_read_with_their_corners_in_order() {
    let faces = |name: &str, content: &[u8]| -> Vec<Vec<[f64; 3]>> {
        let mesh = mesh(name, content).expect("the mesh is whole");
        let faces = mesh.faces.clone();
        let vertices = vertices(mesh);
        faces.iter().map(|face| face.iter().map(|&corner| vertices[corner]).collect()).collect()
    };
    let corners = |places: &[usize]| places.iter().map(|&place| CORNERS[place]).collect::<Vec<_>>();
    assert_eq!(faces("a.obj", OBJ.as_bytes()), [&[0, 2, 1][..], &[0, 1, 3], &[1, 2, 3]].map(corners));
    assert_eq!(faces("a.ply", PLY.as_bytes()), [corners(&[0, 1, 2])]);
    assert_eq!(faces("a.off", OFF.as_bytes()), [corners(&[0, 1, 2])]);
    assert_eq!(faces("a.stl", ascii_stl().as_bytes()), [&[0, 1, 2][..], &[0, 2, 3]].map(corners));
    let square = "OFF\n4 2 0\n0 0 0\n2 0 0\n0 0.5 0\n0 0 -3\n4 0 1 2 3 255 0 0\n2 0 1\n";
    assert_eq!(faces("a.off", square.as_bytes()), [corners(&[0, 1, 2, 3])], "an edge is no face");
    assert!(faces("a.ply", &binary_ply("little")).is_empty(), "there are none");
}
