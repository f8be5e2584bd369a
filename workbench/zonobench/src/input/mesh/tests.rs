use std::path::Path;

use super::{Format, Mesh};

fn mesh(name: &str, content: impl AsRef<[u8]>) -> Result<Mesh, String> {
    let file = Path::new(name);
    let format = Format::of_extension(file).expect("the name tells the format");
    super::read(file, content.as_ref(), format).map_err(|error| error.to_string())
}

fn read(name: &str, content: impl AsRef<[u8]>) -> Result<Vec<[f64; 3]>, String> {
    mesh(name, content).map(|mesh| mesh.vertices)
}

fn complaint(name: &str, content: impl AsRef<[u8]>) -> String {
    let complaint = read(name, content).expect_err("the mesh is broken");
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

const OFF: &str = "OFF\n# counts\n4 4 6\n\n0 0 0\n2 0 0 255 0 0\n0 0.5 0\n0 0 -3 # the last\n3 0 1 2\n";

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
    assert_eq!(read("t.off", OFF.replace("OFF\n", "COFF 4 1 0\n").replace("4 4 6\n", "")), expected);
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
    assert!(complaint("t.obj", OBJ.replace("0.5", "half")).starts_with("t.obj: line 6: is not OBJ: position"));
    assert_eq!(complaint("t.obj", OBJ.replace("0.5", "1e999")), "t.obj: line 6: 'inf' is not a finite number");
    assert!(complaint("t.obj", OBJ.replace("f 2 3 4", "f 2 3 9")).starts_with("t.obj: is not OBJ: face vertex"));
    assert!(complaint("t.ply", PLY.replace("0 0.5 0", "0 x 0")).starts_with("t.ply: line 14: is not PLY"));
    assert_eq!(complaint("t.ply", PLY.replace("0 0.5 0", "0 1e999 0")), "t.ply: line 14: 'inf' is not a finite number");
    assert!(complaint("t.ply", PLY.replace("float y", "float w")).contains("no property `y`"));
    assert!(complaint("t.ply", "plx\n").starts_with("t.ply: line 1: "));
    assert!(complaint("t.ply", &binary_ply("big")[..150]).contains("t.ply: "));
    assert_eq!(complaint("t.off", OFF.replace("0.5", "half")), "t.off: line 7, column 2: 'half' is not a number");
    assert_eq!(complaint("t.off", OFF.replace("0.5", "inf")), "t.off: line 7: 'inf' is not a finite number");
    assert!(complaint("t.off", OFF.replace("4 4 6", "40 4 6")).ends_with("ends after 5 of 40 vertices"));
    assert!(
        complaint("t.off", OFF.replace("OFF", "4OFF")).starts_with("t.off: line 1: is not OFF: begins with '4OFF'")
    );
    assert!(complaint("t.stl", ascii_stl().replacen("0.5", "half", 1)).starts_with("t.stl: line 6: is not STL"));
    assert!(complaint("t.stl", ascii_stl().replacen("endsolid\n", "", 1)).starts_with("t.stl: line 9: is not STL"));
    let cut = binary_stl("made by hand");
    assert!(complaint("t.stl", &cut[..cut.len() - 7]).starts_with("t.stl: triangle 2: is not STL"));
    let mut infinite = binary_stl("made by hand");
    infinite[96..100].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_eq!(complaint("t.stl", &infinite), "t.stl: triangle 1: 'inf' is not a finite number");
}

#[test]
fn nothing_is_no_mesh_or_has_no_vertices() {
    assert_eq!(read("t.obj", ""), Ok(vec![]));
    assert!(read("t.ply", "").is_err() && read("t.stl", "").is_err() && read("t.off", "").is_err());
}

#[test]
fn faces_are_read_with_their_corners_in_order() {
    let faces = |name: &str, content: &[u8]| -> Vec<Vec<[f64; 3]>> {
        let mesh = mesh(name, content).expect("the mesh is whole");
        mesh.faces.iter().map(|face| face.iter().map(|&corner| mesh.vertices[corner]).collect()).collect()
    };
    let corners = |places: &[usize]| places.iter().map(|&place| CORNERS[place]).collect::<Vec<_>>();
    assert_eq!(faces("a.obj", OBJ.as_bytes()), [&[0, 2, 1][..], &[0, 1, 3], &[1, 2, 3]].map(corners));
    assert_eq!(faces("a.ply", PLY.as_bytes()), [corners(&[0, 1, 2])]);
    assert_eq!(faces("a.off", OFF.as_bytes()), [corners(&[0, 1, 2])]);
    assert_eq!(faces("a.stl", ascii_stl().as_bytes()), [&[0, 1, 2][..], &[0, 2, 3]].map(corners));
    let square = "OFF\n4 2 0\n0 0 0\n2 0 0\n0 0.5 0\n0 0 -3\n4 0 1 2 3 255 0 0\n3 0 1 9\n2 0 1\n";
    assert_eq!(faces("a.off", square.as_bytes()), [corners(&[0, 1, 2, 3])], "others lack a corner");
    assert!(faces("a.ply", &binary_ply("little")).is_empty(), "there are none");
}
