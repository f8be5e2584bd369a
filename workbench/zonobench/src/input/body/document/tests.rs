//! The fields of documents: read, refused by name, or told.

use std::path::Path;

use super::*;
use crate::input::Body;
use crate::input::document::parse;

/// The body with its pose, or the complaint, with the lines that are told.
fn read(content: &str) -> (Result<Placed, String>, Vec<String>) {
    let file = Path::new("z.json");
    let mut told = Vec::new();
    let mut tell = |line: &str| told.push(line.to_owned());
    let read = parse(file, content.as_bytes())
        .and_then(|tree| placed(file, &tree, Layout::default(), OptionNames::OF_FIRST, &mut tell));
    (read.map_err(|error| error.to_string()), told)
}

fn body(content: &str) -> Body {
    let (read, told) = read(content);
    assert_eq!(told, Vec::<String>::new(), "{content}");
    read.unwrap_or_else(|complaint| panic!("{content}: {complaint}")).body
}

fn refused(content: &str) -> String {
    read(content).0.expect_err(content)
}

#[test]
fn every_name_of_a_centre_goes_with_every_name_of_generators() {
    let meant = Body { center: vec![10.0, 5.0], generators: vec![vec![1.0, 0.0], vec![2.0, 3.0]], is_rounded: false };
    for center in ["center", "centre", "c"] {
        for point in ["[10,5]", "[[10],[5]]"] {
            for generators in [r#""generators":[[1,0],[2,3]]"#, r#""G":[[1,2],[0,3]]"#] {
                assert_eq!(body(&format!(r#"{{"{center}":{point},{generators}}}"#)), meant);
                assert_eq!(body(&format!(r#"{{{generators},"{center}":{point}}}"#)), meant);
            }
        }
    }
    assert_eq!(body(r#"{"x":[10,5],"G":[[1,2],[0,3]]}"#), meant, "pypolycontain");
    assert_eq!(body(r#"{"center":null,"c":[10,5],"G":[[1,2],[0,3]]}"#), meant);
}

/// MATLAB writes a matrix with one row or one column as a list of numbers.
#[test]
fn a_matrix_with_one_row_or_column_may_be_flat() {
    assert_eq!(body(r#"{"c":[10,5],"G":[1,2]}"#).generators, [[1.0, 2.0]]);
    assert_eq!(body(r#"{"c":[10],"G":[1,2]}"#).generators, [[1.0], [2.0]]);
    assert!(body(r#"{"c":[10,5],"G":[[],[]]}"#).generators.is_empty());
    assert!(body(r#"{"c":[10,5],"G":[]}"#).generators.is_empty());
    assert!(refused(r#"{"G":[1,2]}"#).starts_with("z.json: G[0]: expected a vector"));
}

#[test]
fn two_centres_and_two_lists_of_generators_are_named() {
    let twice = |content: &str, names: [&str; 2]| {
        let complaint = refused(content);
        assert!(names.iter().all(|name| complaint.contains(name)), "{complaint}");
    };
    twice(r#"{"center":[1,2],"c":[1,2],"generators":[[1,0]]}"#, ["`center`", "c: "]);
    twice(r#"{"centre":[1,2],"center":[3,4],"generators":[[1,0]]}"#, ["`center`", "centre: "]);
    twice(r#"{"x":[1,2],"c":[1,2],"G":[[1],[0]]}"#, ["`c`", "x: "]);
    twice(r#"{"c":[1,2],"G":[[1],[0]],"generators":[[1,0]]}"#, ["`generators`", "G: "]);
    twice(r#"{"result":{"center":[1,2],"c":[1,2],"generators":[[1,0]]}}"#, ["`center`", "result.c: "]);
}

/// A field that would make another body of it is refused by its name, wherever the zonotope stands.
#[test]
fn fields_that_could_change_the_body_are_named() {
    let names = "\
        A b Ac Ab bc Gc Gb GI Grest E expMat Aeq H h Center CENTRE C centroid origin offset translation position \
        Position mid_point t X Generators g gens rotation R quaternion transform scale Pose poses motion Zentrum";
    for name in names.split_whitespace() {
        for value in ["[7,8]", "[[7,8],[9,1]]"] {
            for content in [
                format!(r#"{{"{name}":{value},"c":[1,2],"G":[[1,0],[0,1]]}}"#),
                format!(r#"{{"generators":[[1,0],[0,1]],"{name}":{value}}}"#),
                format!(r#"{{"id":"q","kind":"member","input":{{"generators":[[1,0],[0,1]],"{name}":{value}}}}}"#),
                format!(r#"{{"body":{{"generators":[[1,0],[0,1]],"{name}":{value}}}}}"#),
            ] {
                let complaint = refused(&content);
                assert!(complaint.contains(&format!("{name}: this field could change the body")), "{complaint}");
            }
        }
        if name != "Zentrum" {
            let answer =
                format!(r#"{{"result":{{"center":[1,2],"generators":[[1,0]],"{name}":[7,8]}},"request":{{}}}}"#);
            assert!(refused(&answer).contains(&format!("result.{name}: this field")), "{answer}");
            let beside = format!(r#"{{"result":{{"center":[1,2],"generators":[[1,0]]}},"{name}":[7,8]}}"#);
            assert!(refused(&beside).contains(&format!("{name}: this field")), "{beside}");
        }
    }
    assert!(refused(r#"{"x":[1,2],"generators":[[1,0]]}"#).starts_with("z.json: x: this field"));
    let hybrid = r#"{"Gc":[[1],[0]],"Gb":[[0],[1]],"c":[1,2],"Ac":[[1]],"Ab":[[1]],"b":[0]}"#;
    assert!(refused(hybrid).starts_with("z.json: Gc: this field"), "zonoLAB");
    let of_cora = refused(r#"{"Z":[[1,1,0],[2,0,1]]}"#);
    assert!(of_cora.starts_with("z.json: Z: this is the matrix [c G] of CORA"), "{of_cora}");
    assert!(["`c`", "`G`", "--columns-are-generators", "--center-first"].iter().all(|name| of_cora.contains(name)));
    assert!(refused(r#"{"generators":[[1,0]],"radius":3}"#).starts_with("z.json: radius: this field"));
    assert!(refused(r#"{"kind":"gauge","input":{"p":[1,2],"q":[3,4],"generators":[[1,0]]}}"#).contains("input.p: "));
    // A constraint that is none changes nothing.
    let (unconstrained, told) = read(r#"{"c":[1,2],"G":[[1],[0]],"A":[],"b":[[]],"Gb":null}"#);
    assert_eq!(unconstrained.map(|placed| placed.body.generators), Ok(vec![vec![1.0, 0.0]]));
    assert_eq!(told, ["the fields `A`, `b` are not read"]);
}

/// A number under a name that says a turn, a move or a scale is refused, whatever the rest of the name is.
#[test]
fn names_of_motions_and_sizes_are_known_by_their_words() {
    let names = "theta yaw pitch heading roll rotation_deg quaternion orientation position mesh_scale meshScale s size \
        half_lengths halfspace angle scale box-size Length yaw_deg rotationAngle euler unit pose2d offsets";
    for name in names.split_whitespace() {
        for value in ["1.5", "[1,2,3]", r#"{"w":1}"#, r#""90 deg""#, r#""rotate(90)""#] {
            for content in [
                format!(r#"{{"generators":[[1,0],[0,1]],"{name}":{value}}}"#),
                format!(r#"{{"body":{{"generators":[[1,0],[0,1]]}},"{name}":{value}}}"#),
            ] {
                assert!(refused(&content).contains(&format!("{name}: this field could change the body")), "{content}");
            }
        }
    }
    for name in ["triangles", "purpose", "composition", "parent", "comment"] {
        let (square, told) = read(&format!(r#"{{"generators":[[1,0],[0,1]],"{name}":3}}"#));
        assert!(square.is_ok(), "{name}");
        assert_eq!(told, [format!("the field `{name}` is not read")]);
    }
}

/// A text is a label, which moves nothing, under whatever name it stands.
#[test]
fn labels_earn_one_line() {
    for name in ["frame", "frame_id", "parent", "unit", "order", "pose_frame", "scale"] {
        for label in ["base_link", "mm", "/map", "left arm 2"] {
            let (square, told) = read(&format!(r#"{{"generators":[[1,0],[0,1]],"{name}":"{label}"}}"#));
            assert!(square.is_ok(), "{name} {label}");
            assert_eq!(told, [format!("the field `{name}` is not read")]);
        }
    }
}

#[test]
fn other_fields_earn_one_line() {
    let (square, told) = read(r#"{"generators":[[1,0],[0,1]],"name":"a square","color":[1,2],"n":7,"tags":["a"]}"#);
    assert!(square.is_ok());
    assert_eq!(told, ["the fields `name`, `color`, `n`, `tags` are not read"]);
    let (nested, told) = read(r#"{"a":{"generators":[[1,0]],"name":"a\nb"},"author":"x"}"#);
    assert!(nested.is_ok());
    assert_eq!(told, ["the fields `author`, `a.name` are not read"]);
}

#[test]
fn a_body_is_read_with_its_pose_wherever_it_stands() {
    let own = r#""center":[1,2],"generators":[[1,0],[0,1]],"pose":{"translation":[10,0]}"#;
    for content in [
        format!("{{{own}}}"),
        format!(r#"{{"request":{{}},{own}}}"#),
        format!(r#"{{"id":"q","kind":"member","input":{{"point":[7,7],{own}}}}}"#),
        format!(r#"{{"id":"q","kind":"member_batch","method":"by_lad","input":{{"points":[],{own}}}}}"#),
        format!(r#"{{"a":{{{own}}}}}"#),
        format!(r#"{{"input":{{"a":{{{own}}}}}}}"#),
        format!(r#"{{"id":"q","kind":"reduce","result":{{{own}}},"request":{{"count":2}}}}"#),
    ] {
        let (placed, told) = read(&content);
        let placed = placed.unwrap_or_else(|complaint| panic!("{content}: {complaint}"));
        assert_eq!(told, Vec::<String>::new(), "{content}");
        assert_eq!(placed.center(), (vec![11.0, 2.0], true), "{content}");
    }
    let along =
        r#"{"request":{"directions":[[1,0]]},"result":{"c":[1,2],"coefficients":[3],"pose":{"translation":[1,1]}}}"#;
    let placed = read(along).0.expect("a body along directions");
    assert_eq!(placed.center(), (vec![2.0, 3.0], true));
}

#[test]
fn a_pose_that_cannot_be_taken_is_named() {
    let posed = |pose: &str| refused(&format!(r#"{{"center":[1,2],"generators":[[1,0]],"pose":{pose}}}"#));
    assert_eq!(posed("{}"), "z.json: `pose` has neither `matrix` nor `translation`");
    assert_eq!(posed(r#"{"matrix":[[1,0,0],[0,1,0],[0,0,1]]}"#), "z.json: pose, matrix has 3 rows, not 2");
    let known = "; a pose has `matrix`, `translation` or both";
    assert_eq!(posed(r#"{"rotation":[[1,0],[0,1]]}"#), format!("z.json: extra field `rotation` in `pose`{known}"));
    assert_eq!(
        posed(r#"{"translation":[1,"NaN"]}"#),
        "z.json: pose, translation, coordinate 2 is a string, not a number"
    );
    assert_eq!(posed("[[1,0],[0,1]]"), "z.json: `pose` is a list, not an object");
    let beside = r#"{"a":{"generators":[[1,0]]},"pose":{"translation":[1,2]}}"#;
    assert!(refused(beside).starts_with("z.json: pose: this field could change the body"));
}

#[test]
fn several_bodies_are_named() {
    let body = r#"{"generators":[[1,0]]}"#;
    let complaint = refused(&format!(r#"{{"id":"q","kind":"intersect","input":{{"a":{body},"b":{body}}}}}"#));
    assert!(complaint.contains("holds several bodies, `input.a`, `input.b`"), "{complaint}");
    assert!(refused(&format!(r#"{{"first":{body},"second":{body}}}"#)).contains("`first`, `second`"));
    assert!(refused(r#"{"points":[[1,2]]}"#).contains("expected a list of generators"));
}

#[test]
fn vectors_of_another_dimension_say_what_the_other_name_means() {
    let wide = refused(r#"{"center":[1,2],"generators":[[1,0,1],[0,1,1]]}"#);
    assert!(wide.starts_with("z.json: generators: ") && wide.contains("named `G`"), "{wide}");
    let tall = refused(r#"{"c":[1,2],"G":[[1,0],[0,1],[1,1]]}"#);
    assert!(tall.starts_with("z.json: G: ") && tall.contains("named `generators`"), "{tall}");
}
