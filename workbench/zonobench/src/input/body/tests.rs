//! Bodies of every shape of file.

use std::path::Path;

use super::*;
use crate::input::names::Order;

fn read(name: &str, content: &str) -> Result<Body, String> {
    let file = Path::new(name);
    let read = match Format::of_extension(file) {
        Some(Format::Csv) => table::rows(file, content.as_bytes(), Order::Coordinates, None)
            .and_then(|rows| body(file, None, rows.numbers)),
        _ => parse(file, content.as_bytes())
            .and_then(|tree| document::placed(file, &tree, Layout::default(), OptionNames::OF_FIRST, &mut |_| ()))
            .map(|placed| placed.body),
    };
    read.map_err(|error| error.to_string())
}

#[test]
fn tables_and_documents_hold_the_same_body() {
    let generators = vec![vec![1.0, 0.0], vec![0.0, 2.0]];
    let square = Body { center: vec![0.0, 0.0], generators, is_rounded: false };
    assert_eq!(read("z.csv", "1,0\n0,2\n"), Ok(square.clone()));
    assert_eq!(read("z.csv", "x;y\n1;0\n\n0;2"), Ok(square.clone()));
    assert_eq!(read("z.json", "[[1,0],[0,2]]"), Ok(square.clone()));
    assert_eq!(read("z.json", r#"{"generators":[[1,0],[0,2]],"name":"a square"}"#), Ok(square.clone()));
    let moved = read("z.json", r#"{"center":[5,6],"generators":[[1,0],[0,2]]}"#);
    assert_eq!(moved, Ok(Body { center: vec![5.0, 6.0], ..square.clone() }));
    let point = read("z.json", r#"{"center":[5,6,7],"generators":[]}"#);
    assert_eq!(point, Ok(Body { center: vec![5.0, 6.0, 7.0], generators: vec![], is_rounded: false }));
    let matrix = read("z.json", r#"{"c":[5,6],"G":[[1,0],[0,2]]}"#);
    assert_eq!(matrix, Ok(Body { center: vec![5.0, 6.0], ..square }));
    let wide = read("z.json", r#"{"G":[[1,2,3],[4,5,6]]}"#).map(|body| body.generators);
    assert_eq!(wide, Ok(vec![vec![1.0, 4.0], vec![2.0, 5.0], vec![3.0, 6.0]]));
    assert_eq!(read("z.csv", "7\n8\n").map(|body| body.generators), Ok(vec![vec![7.0], vec![8.0]]));
}

#[test]
fn a_row_that_is_called_a_centre_is_the_centre() {
    let read = |content: &str, layout: Layout| {
        let source = BodySource { file: "z.csv".into(), format: None, layout, options: OptionNames::OF_FIRST };
        let mut told = String::new();
        let placed = source.placed(Format::Csv, content.as_bytes(), &mut |line| told.push_str(line)).expect(content);
        (placed.body, told)
    };
    for (content, place) in [("name,x,y\ncenter,5,6\ng1,1,0\n", 1), ("name,x,y\ng1,1,0\nCentre,5,6\n", 2)] {
        let (body, told) = read(content, Layout::default());
        assert_eq!((body.center, body.generators), (vec![5.0, 6.0], vec![vec![1.0, 0.0]]), "{content}");
        assert!(told.contains(&format!("row {place} of numbers is read as the centre, as it is called")), "{told}");
    }
    assert_eq!(read("name,x,y\ng1,5,6\ng2,1,0\n", Layout::default()).0.center, [0.0, 0.0]);
}

#[test]
fn answers_hold_bodies() {
    let zonogon = r#"{"id":"p","kind":"min_area","result":{"area":4,"center":[1,1],"generators":[[1,0],[0,1]]}}"#;
    let square = Body { center: vec![1.0, 1.0], generators: vec![vec![1.0, 0.0], vec![0.0, 1.0]], is_rounded: false };
    assert_eq!(read("a.json", zonogon), Ok(square.clone()));
    let along = |coefficients: &str| {
        let result = format!(r#"{{"status":"optimal","center":[1,1],"coefficients":{coefficients}}}"#);
        let request = r#"{"directions":[[1,0],[3,3],[0,0.1]]}"#;
        format!(r#"{{"kind":"min_length_dirs","request":{request},"result":{result}}}"#)
    };
    let exact = Body { generators: vec![vec![1.0, 0.0], vec![6.0, 6.0]], ..square.clone() };
    assert_eq!(read("a.json", &along("[1,2,0]")), Ok(exact));
    let rounded = Body { generators: vec![vec![1.0, 0.0], vec![0.0, 0.1 * 3.0]], is_rounded: true, ..square };
    assert_eq!(read("a.json", &along("[1,0,3]")), Ok(rounded));
}

#[test]
fn answers_without_a_body_say_so() {
    let answers = [
        (
            r#"{"result":{"status":"infeasible","certificate":{}}}"#,
            "no zonotope along the directions contains the points",
        ),
        (r#"{"error":{"code":"empty","message":"there are no points"}}"#, "is a refusal: there are no points"),
        (r#"{"result":{"member":true}}"#, "holds no zonotope"),
        (r#"{"result":{"center":[0],"coefficients":[1]}}"#, "names no directions"),
        (r#"{"request":{"directions":[[1]]},"result":{"center":[0],"coefficients":[1,2]}}"#, "2 coefficients"),
        (r#"{"result":{"center":[0],"generators":[["x"]]}}"#, "result.generators[0][0]: 'x' is not a number"),
        (
            r#"{"input":{"generators":[[1,0]]},"pose":{"translation":[1,2]}}"#,
            "pose: stands beside `input`, and the pose of a body is a field of the body",
        ),
        (r#"{"c":[0,0],"G":[[1,2],[3]]}"#, "G[1]: the row has 1 cells, not 2"),
        (r#"{"c":[0,0,0],"G":[[1,2],[3,4]]}"#, "G: the matrix has 2 rows, not 3"),
    ];
    for (answer, complaint) in answers {
        let found = read("a.json", answer).expect_err("there is no body");
        assert!(found.starts_with("a.json: ") && found.contains(complaint), "{found}");
    }
}

#[test]
fn complaints_name_the_place() {
    assert_eq!(read("z.csv", "1,0\n0,north\n"), Err("z.csv: line 2, column 2: 'north' is not a number".into()));
    assert_eq!(read("z.csv", "1,0\n2\n"), Err("z.csv: line 2, column 2: the row has 1 cells, not 2".into()));
    assert_eq!(read("z.csv", ""), Err("z.csv: holds no zonotope".into()));
    assert_eq!(read("z.json", r#"{"generators":[]}"#), Err("z.json: holds no zonotope".into()));
    assert_eq!(
        read("z.json", r#"{"center":[1,2],"generators":[[1,2],[1,2,3]]}"#),
        Err("z.json: generators[1]: the row has 3 cells, not 2".into())
    );
    assert_eq!(
        read("z.json", r#"{"generators":[[1,"NaN"]]}"#),
        Err("z.json: generators[0][1]: 'NaN' is not a finite number".into())
    );
    assert_eq!(read("z.json", "[7]"), Err("z.json: [0]: expected a vector, found a number".into()));
}
