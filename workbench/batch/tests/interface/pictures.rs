//! Data for pictures agree with the answers of the kinds, for generators and points in any position.

use batch::{PICTURES, answer, hold, locate_in_columns, picture, picture_in_columns};
use serde_json::{Value, json};

const EGG: [[f64; 2]; 7] = [[0.0, 8.0], [2.0, 2.0], [16.0, 0.0], [21.0, 5.0], [17.0, 15.0], [9.0, 16.0], [10.0, 10.0]];

fn asked(respond: fn(&str) -> String, kind: &str, input: &Value) -> Value {
    let question = json!({"id": "q", "kind": kind, "input": input});
    let content: Value = serde_json::from_str(&respond(&question.to_string())).expect("an answer is JSON");
    assert_eq!((content["id"].as_str(), content["kind"].as_str()), (Some("q"), Some(kind)));
    content
}

fn drawn(kind: &str, input: &Value) -> Value {
    let content = asked(picture, kind, input);
    assert!(content["error"].is_null(), "{kind}: {}", content["error"]);
    content["result"].clone()
}

fn solved(kind: &str, input: &Value) -> Value {
    asked(answer, kind, input)["result"].clone()
}

/// Bodies in space: in general position, degenerate in each way, flat, a segment and a point.
fn bodies() -> Vec<Vec<[f64; 3]>> {
    let diagonals = vec![[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];
    let coplanar = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1.0], [2.0, 0.0, 0.0], [0.0; 3]];
    let flat = vec![[1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0]];
    let upright = vec![[1.0, 0.0, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let general = vec![[3.0, 1.0, 0.5], [1.0, 4.0, -1.0], [-2.0, 1.0, 1.5], [0.5, -1.0, 3.0], [1.0, 1.0, 1.0]];
    vec![general, diagonals, coplanar, flat, upright, vec![[1.0, 2.0, 3.0], [2.0, 4.0, 6.0]], vec![]]
}

#[test]
fn pictures_of_points_agree_with_the_zonogon_of_least_area() {
    let best = solved("min_area", &json!({"points": EGG}));
    let at_best = drawn("centered_zonogon", &json!({"points": EGG, "center": best["center"]}));
    let [at, least] = [&at_best["area"], &best["area"]].map(|area| area.as_f64().expect("a number"));
    assert!((at - least).abs() <= 1e-14 * least, "the answer is rounded outward: {at} and {least}");
    assert_eq!(at_best["hull"], best["certificate"]["hull"]);
    let zonogon = drawn("zonogon", &json!({"center": best["center"], "generators": best["generators"]}));
    let generators = best["generators"].as_array().map_or(0, Vec::len);
    assert_eq!(zonogon["vertices"].as_array().map(Vec::len), Some(2 * generators));

    let search = drawn("search_of_theorem_4_5", &json!({"points": EGG}));
    let steps = search["steps"].as_array().expect("steps");
    assert_eq!(steps[0]["candidates"].as_u64(), search["vertices"].as_array().map(|all| all.len() as u64));
    let last = steps.last().expect("a step");
    assert_eq!((&last["side"], last["left"].as_u64()), (&json!("optimal"), Some(0)));
    let at_minimum = drawn("centered_zonogon", &json!({"points": EGG, "center": last["minimum"]}));
    let found = at_minimum["area"].as_f64().expect("a number");
    assert!((found - least).abs() <= 1e-12 * least);

    let along = drawn("area_along", &json!({"points": EGG, "from": [0, 0], "to": best["center"]}));
    let end = along["area"].as_array().and_then(|areas| areas.last()?.as_f64()).expect("the end");
    assert!((end - least).abs() <= 1e-12 * least);
    let sets = drawn("level_sets", &json!({"points": EGG, "levels": [0.9 * least, 2.0 * least]}));
    assert_eq!(sets["polygons"][0], json!([]));
    assert!(sets["polygons"][1].as_array().is_some_and(|polygon| polygon.len() > 4));
}

#[test]
fn points_without_area_have_pictures_too() {
    for points in [json!([[1, 2]]), json!([[0, 0], [2, 1], [4, 2]])] {
        let at = drawn("centered_zonogon", &json!({"points": points, "center": [3, 3]}));
        let along = drawn("area_along", &json!({"points": points, "from": [3, 3], "to": [0, 1]}));
        assert_eq!(along["area"][0], at["area"]);
        assert_eq!(drawn("search_of_theorem_4_5", &json!({"points": points}))["steps"], json!([]));
        assert_eq!(drawn("pruning", &json!({"points": points, "line_search_limit": 4}))["cells"], json!([]));
        assert_eq!(drawn("level_sets", &json!({"points": points, "levels": [5]}))["polygons"], json!([[]]));
    }
}

#[test]
fn faces_are_as_many_as_are_counted_and_tiles_are_facets() {
    for generators in bodies() {
        let counted = solved("combinatorics", &json!({"generators": generators}));
        let faces = drawn("faces", &json!({"center": [1, 2, 3], "generators": generators}));
        let length = |name: &str| faces[name].as_array().map(Vec::len);
        assert_eq!(faces["dimension"], counted["affine_dim"], "{generators:?}");
        assert_eq!(length("vertices").map(Into::into), Some(counted["vertices"].clone()), "{generators:?}");
        assert_eq!(length("edges").map(Into::into), Some(counted["edges"].clone()), "{generators:?}");
        let tiling = drawn("tiling", &json!({"generators": generators}));
        let tiles = tiling["tiles"].as_array().expect("a list").len();
        let vertical = tiling["vertical_facets"].as_u64().expect("a number") as usize;
        assert_eq!(length("facets"), Some(2 * tiles + vertical), "{generators:?}");
        let classes = tiling["classes"].as_array().expect("a list").iter();
        let in_classes: usize = classes.map(|class| class["generators"].as_array().map_or(0, Vec::len)).sum();
        let zero = tiling["zero"].as_array().map_or(0, Vec::len);
        assert_eq!(in_classes + zero, generators.len(), "{generators:?}");
    }
}

#[test]
fn searches_and_planes_agree_with_locations_and_gauges() {
    for generators in bodies() {
        for point in [[0.5, 0.25, 0.5], [9.0, 1.0, -2.0], [1.0, 2.0, 3.0]] {
            let input = json!({"point": point, "center": [0, 0, 0], "generators": generators});
            let search = drawn("search_of_theorem_5_2", &input);
            assert_eq!(search["status"], solved("member", &input)["status"], "{input}");
            let plane = drawn("plane_of_directions", &input);
            let gauge = solved("gauge", &json!({"p": [0, 0, 0], "q": point, "generators": generators}));
            let [drawn, exact] = [&plane["gauge"], &gauge["gauge"]].map(Value::as_f64);
            assert_eq!(drawn.is_some(), exact.is_some(), "{input}");
            if let (Some(drawn), Some(exact)) = (drawn, exact) {
                assert!((drawn - exact).abs() <= 1e-12 * exact, "{input}");
            }
            let rows =
                |field: &str| -> Vec<Vec<f64>> { serde_json::from_value(plane[field].clone()).expect("numbers") };
            let lines = rows("lines");
            assert_eq!(lines.len(), generators.len());
            let support = |[x, y]: [f64; 2]| lines.iter().map(|l| (l[0] * x + l[1] * y + l[2]).abs()).sum::<f64>();
            let optimum: Option<[f64; 2]> = serde_json::from_value(plane["optimum"].clone()).expect("a point or none");
            if let (Some([x, y]), Some(gauge)) = (optimum, drawn) {
                assert!((support([x, y]) * gauge - 1.0).abs() < 1e-12, "{input}");
                let nearby = [[x + 0.01, y], [x - 0.01, y], [x, y + 0.01], [x, y - 0.01]];
                assert!(nearby.iter().all(|beside| support(*beside) * gauge >= 1.0 - 1e-12), "{input}");
            }
            let (origin, axes) = (plane["origin"].clone(), rows("axes"));
            let origin: [f64; 3] = serde_json::from_value(origin).expect("a vector");
            let [x, y] = [0.5, -2.0];
            let u = [0, 1, 2].map(|k| origin[k] + x * axes[0][k] + y * axes[1][k]);
            let times = |v: [f64; 3]| v[0] * u[0] + v[1] * u[1] + v[2] * u[2];
            assert!((times(point) - 1.0).abs() < 1e-12, "{input}");
            for (generator, line) in generators.iter().zip(&lines) {
                assert!((times(*generator) - (line[0] * x + line[1] * y + line[2])).abs() < 1e-12, "{input}");
            }
        }
    }
}

#[test]
fn the_optimum_of_a_plane_of_directions_is_strict_in_general_position_and_zero_beside_a_flat_body() {
    let generators = &bodies()[0];
    for point in [[1.0, 2.0, 0.5], [-3.0, 0.25, 1.0], [0.5, -0.5, -4.0]] {
        let input = json!({"point": point, "center": [0, 0, 0], "generators": generators});
        let plane = drawn("plane_of_directions", &input);
        let lines: Vec<[f64; 3]> = serde_json::from_value(plane["lines"].clone()).expect("lines");
        let [x, y]: [f64; 2] = serde_json::from_value(plane["optimum"].clone()).expect("the body spans space");
        let support = |[x, y]: [f64; 2]| lines.iter().map(|[a, b, c]| (a * x + b * y + c).abs()).sum::<f64>();
        let nearby = [[x + 0.01, y], [x - 0.01, y], [x, y + 0.01], [x, y - 0.01]];
        assert!(nearby.iter().all(|beside| support(*beside) > support([x, y])), "{input}");
    }
    let square = json!({"point": [0, 0, 2], "center": [0, 0, 0], "generators": [[1, 0, 0], [0, 1, 0]]});
    let beside = drawn("plane_of_directions", &square);
    assert_eq!((&beside["optimum"], &beside["gauge"]), (&json!([0.0, 0.0]), &json!("Infinity")));
    let nothing = json!({"point": [1, 0, 0], "center": [0, 0, 0], "generators": []});
    assert!(drawn("plane_of_directions", &nothing)["optimum"].is_null());
}

#[test]
fn what_is_no_picture_is_refused_like_a_question() {
    let refusal = |question: &Value| {
        let content: Value = serde_json::from_str(&picture(&question.to_string())).expect("JSON");
        (content["error"]["code"].as_str().map(str::to_owned), content["error"]["message"].to_string())
    };
    let asked = |kind: &str, input: Value| refusal(&json!({"id": "q", "kind": kind, "input": input}));
    let (code, message) = asked("tilings", json!({}));
    assert_eq!(code.as_deref(), Some("unknown_kind"));
    assert!(PICTURES.iter().all(|picture| message.contains(picture.name)) && message.contains("tiling"), "{message}");
    assert_eq!(asked("tiling", json!({})).0.as_deref(), Some("bad_input"));
    assert_eq!(asked("tiling", json!({"generators": [["NaN", 0, 0]]})).0.as_deref(), Some("non_finite"));
    assert_eq!(asked("level_sets", json!({"points": [], "levels": []})).0.as_deref(), Some("empty"));
    assert_eq!(asked("faces", json!({"center": [0, 0], "generators": []})).0.as_deref(), Some("dimension_mismatch"));
    let many = vec![[1.0, 0.0, 0.0]; 501];
    assert_eq!(asked("tiling", json!({"generators": many})).0.as_deref(), Some("too_large"));
    let centre = json!({"point": [1, 1, 1], "center": [1, 1, 1], "generators": [[1, 0, 0]]});
    assert_eq!(asked("plane_of_directions", centre).0.as_deref(), Some("bad_input"));
    let by_method = json!({"id": "q", "kind": "tiling", "method": "by_sweep", "input": {"generators": []}});
    assert_eq!(refusal(&by_method).0.as_deref(), Some("unknown_method"));
}

#[test]
fn each_corner_of_a_tile_lies_in_a_trapezoid_of_a_cutting() {
    for generators in bodies() {
        let tiling = drawn("tiling", &json!({"generators": generators}));
        let tiles = tiling["tiles"].as_array().expect("a list");
        for r in [1, 2, 4] {
            let cutting = drawn("cutting", &json!({"generators": generators, "r": r}));
            let count = cutting["trapezoids"].as_array().map_or(0, Vec::len);
            let images = cutting["images"].as_array().expect("a list");
            assert_eq!(images.len(), tiles.len(), "{generators:?}");
            for (image, tile) in images.iter().zip(tiles) {
                let image = image.as_array().expect("a list");
                assert_eq!(image.len(), 2 * tile["classes"].as_array().map_or(0, Vec::len), "{generators:?}");
                let is_one = |place: &Value| place.as_u64().is_some_and(|place| (place as usize) < count);
                assert!(image.iter().all(is_one), "{generators:?}");
            }
            if r == 1 && !tiles.is_empty() {
                assert_eq!(count, 1, "all lines may cross one cell: {generators:?}");
                assert_eq!(cutting["trapezoids"][0].as_array().map(Vec::len), Some(4), "the whole window");
            }
        }
    }
    let refused = json!({"id": "q", "kind": "cutting", "input": {"generators": [], "r": 0}});
    assert!(picture(&refused.to_string()).contains("bad_input"));
}

#[test]
fn each_generator_is_in_one_leaf_of_the_tree() {
    let many: Vec<[f64; 3]> =
        (0..200_i32).map(|i| [f64::from(i % 7 - 3), f64::from(i % 11), f64::from(i) - 90.0]).collect();
    for generators in bodies().into_iter().chain([many]) {
        let tree = drawn("direction_tree", &json!({"generators": generators}));
        let leaves = tree["leaves"].as_array().expect("a list").iter();
        let mut found: Vec<u64> =
            leaves.flat_map(|leaf| leaf.as_array().expect("a list").iter().filter_map(Value::as_u64)).collect();
        found.sort_unstable();
        let nonzero = (0..generators.len()).filter(|&index| generators[index] != [0.0; 3]).map(|index| index as u64);
        assert_eq!(found, nonzero.collect::<Vec<_>>(), "{generators:?}");
    }
}

#[test]
fn a_hierarchy_ends_with_the_body_and_decides_as_the_kind_does() {
    for generators in bodies() {
        for at in [[0.5, 0.25, 0.5], [9.0, 1.0, -2.0]] {
            let [a, b] = [[0.0; 3], at].map(|center| json!({"center": center, "generators": generators}));
            let input = json!({"a": a, "b": b});
            let descent = drawn("hierarchy", &input);
            assert_eq!(descent["status"], solved("intersect", &input)["status"], "{input}");
            let levels = descent["a"].as_array().expect("a list");
            let finest = &levels[levels.len() - 1];
            assert_eq!(finest["generators"].as_array().map(Vec::len), Some(generators.len()), "{input}");
            assert!(descent["levels"][0].as_u64().is_some_and(|level| (level as usize) < levels.len()), "{input}");
        }
    }
}

/// The data of an answer in columns, put together again.
fn folded(bytes: &[u8]) -> Value {
    let end = bytes.iter().position(|&byte| byte == b'\n').expect("a line comes first") + 1;
    assert_eq!(end % 8, 0);
    let mut content: Value = serde_json::from_slice(&bytes[..end]).expect("the line is JSON");
    let mut at = end;
    let tables = content["tables"].as_array().cloned().unwrap_or_default();
    for table in &tables {
        let columns: Vec<Vec<Value>> = table["columns"]
            .as_array()
            .expect("columns")
            .iter()
            .map(|column| {
                let (of, length) =
                    (column[0].as_str().expect("a type"), column[1].as_u64().expect("a length") as usize);
                let column = &bytes[at..at + length];
                at += length;
                match of {
                    "f64" => column.as_chunks().0.iter().map(|&number| json!(f64::from_le_bytes(number))).collect(),
                    _ => column
                        .as_chunks()
                        .0
                        .iter()
                        .map(|&index| match u32::from_le_bytes(index) {
                            u32::MAX => Value::Null,
                            index => json!(index),
                        })
                        .collect(),
                }
            })
            .collect();
        let rows: Vec<Value> = match table["width"].as_u64() {
            Some(0) => columns[0].clone(),
            Some(width) => columns[0].chunks(width as usize).map(|row| row.to_vec().into()).collect(),
            None => {
                let ends = columns[0].iter().map(|end| end.as_u64().expect("an end") as usize);
                let begins = std::iter::once(0).chain(ends.clone());
                begins.zip(ends).map(|(begin, end)| columns[1][begin..end].to_vec().into()).collect()
            }
        };
        match (&table["at"][0], &table["at"][1]) {
            (Value::String(name), Value::Null) => content["result"][name] = rows.into(),
            (Value::String(name), Value::String(field)) => {
                let objects = &mut content["result"][name];
                if objects.is_null() {
                    *objects = vec![json!({}); rows.len()].into();
                }
                let objects = objects.as_array_mut().expect("a list").iter_mut();
                objects.zip(rows).for_each(|(object, value)| object[field] = value);
            }
            other => panic!("{other:?} is no place"),
        }
    }
    assert_eq!(at, bytes.len(), "every byte belongs to a column");
    content
}

#[test]
fn data_in_columns_are_the_data_in_lines() {
    let center = [0.5, -1.0, 0.0];
    let of_points = json!({"points": EGG, "center": [3, 3]});
    let mut asked = vec![("centered_zonogon", of_points), ("faces", json!({})), ("tilings", json!({}))];
    for generators in bodies() {
        asked.push(("faces", json!({"center": center, "generators": generators})));
        asked.push(("tiling", json!({"generators": generators})));
    }
    for (kind, input) in asked {
        let question = json!({"id": "q", "kind": kind, "input": input}).to_string();
        let mut found = folded(&picture_in_columns(&question));
        found.as_object_mut().expect("an object").remove("tables");
        let expected: Value = serde_json::from_str(&picture(&question)).expect("JSON");
        assert_eq!(found, expected, "{question}");
    }
}

#[test]
fn a_body_that_is_held_gives_the_answers_of_the_kind() {
    for generators in bodies() {
        let question = json!({"id": "q", "kind": "body", "input": {"center": [1, 0, 0], "generators": generators}});
        let body = hold(&question.to_string()).expect("a body");
        for point in [[1.5, 0.25, 0.5], [9.0, 1.0, -2.0], [2.0, 2.0, 3.0], [1.0, 0.0, 0.0]] {
            let member = json!({"point": point, "center": [1, 0, 0], "generators": generators});
            let mut expected = solved("member", &member);
            let mut found = folded(&locate_in_columns(&body, point))["result"].clone();
            let proof = expected["certificate"].take();
            expected.as_object_mut().expect("an object").remove("certificate");
            for (name, value) in proof.as_object().expect("a proof") {
                assert_eq!(&found[name].take(), value, "{name} of {member}");
            }
            let kept = found.as_object_mut().expect("an object");
            kept.retain(|name, value| name != "basis" && !value.is_null());
            assert_eq!(found, expected, "{member}");
        }
        let refused = folded(&locate_in_columns(&body, [f64::NAN, 0.0, 0.0]));
        assert_eq!(refused["error"]["code"], "non_finite");
    }
    let refused = |question: Value| hold(&question.to_string()).expect_err("no body");
    assert!(refused(json!({"id": "q", "kind": "bodies", "input": {}})).contains("unknown_kind"));
    assert!(refused(json!({"id": "q", "kind": "body", "input": {"center": [0, 0, 0]}})).contains("generators"));
}
