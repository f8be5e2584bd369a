//! Refusals name the place of what they refuse.

/// The place that the refusal of a question names, with the complaint.
fn refusal(kind: &str, input: &str) -> String {
    let question = format!(r#"{{"id":"q","kind":"{kind}","input":{input}}}"#);
    let answer: serde_json::Value = serde_json::from_str(&batch::answer(&question)).expect("answers are JSON");
    answer["error"]["message"].as_str().expect("the question is refused").to_owned()
}

#[test]
fn places_read_as_words() {
    let names = |kind: &str, input: &str, place: &str| {
        let message = refusal(kind, input);
        assert!(message.contains(place), "{message}");
    };
    names("min_area", r#"{"points":[[0,0],[1,0],[0,1],[0,"x"]]}"#, "point 4, coordinate 2");
    names("support", r#"{"direction":[1,2],"center":["x",5],"generators":[]}"#, "center, coordinate 1");
    names("approx", r#"{"generators":[[1,0,0]],"epsilon":"x"}"#, "epsilon");
    let body = r#"{"center":[0,0,0],"generators":[[1,0,0]]}"#;
    let of_bodies = |a: &str, b: &str| format!(r#"{{"a":{a},"b":{b}}}"#);
    names("intersect", &of_bodies(&body.replace("1,0,0", "1,0,\"x\""), body), "a, generator 1, coordinate 3");
    let posed = |matrix| {
        format!(r#"{{"center":[0,0,0],"generators":[[1,0,0]],"pose":{{"matrix":{matrix},"translation":[0,0,0]}}}}"#)
    };
    names("intersect", &of_bodies(body, &posed("[[1,0,0],5,[0,0,1]]")), "b, pose, matrix, row 2");
    names("intersect", &of_bodies(body, &posed("[[1,0,0],[0,1,\"x\"],[0,0,1]]")), "b, pose, matrix, row 2, entry 3");
    let mesh = |vertices, triangles| format!(r#"{{"vertices":{vertices},"triangles":{triangles}}}"#);
    let whole = mesh("[[0,0,0]]", "[[0,0,0]]");
    for (vertices, triangles, place) in [
        ("[[0,0,0],[0,\"x\",0]]", "[[0,1,0]]", "a, vertex 2, coordinate 2"),
        ("[[0,0,0],[0,1]]", "[[0,1,0]]", "a, vertex 2 has 2 coordinates, not 3"),
        ("[[0,0,0]]", "[[0,0,0],[0,0,1]]", "a, triangle 2, corner 3 is 1: there are 1 vertices"),
        ("[[0,0,0]]", "[[0,-1,0]]", "a, triangle 1, corner 2 is -1.0, not a whole number from 0"),
        ("[[0,0,0]]", "[[0,0,5000000000]]", "a, triangle 1, corner 3 is 5000000000, above all positions"),
        ("[[0,0,0]]", "[[0,0]]", "a, triangle 1 has 2 corners, not 3"),
        ("[[0,0,0]]", "[]", "a has no triangles"),
    ] {
        names("mesh", &of_bodies(&mesh(vertices, triangles), &whole), place);
    }
    let flagged = of_bodies(&whole, &whole).replacen('{', r#"{"pairs":1,"#, 1);
    names("mesh", &flagged, "`pairs` is a number, not true or false");
}
