//! Points from a JSON document: a list of rows, or an object with such a list under `points`.

use std::path::Path;

use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::points::{Points, Wanted};
use super::reading::{Reading, columns_of};
use batch::json::{self, MAX_VALUES, NonFinite, ReadError, Tree};

/// Reads the points of a document whose rows are `[x, y, …]` or `{"x": …, "y": …}`.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    wanted: Wanted,
) -> Result<Reading, InputError> {
    let document = parse(file, content)?;
    let (rows, path) = match (document.list(), document.field("points").and_then(Tree::list)) {
        (Some(rows), _) => (rows, String::new()),
        (None, Some(rows)) => (rows, "points".to_owned()),
        (None, None) => {
            let problem = Problem::Shape(format!(
                "expected a list of points, or an object with a list `points`, found {}",
                document.describe()
            ));
            return Err(problem.at(file, Place::File));
        }
    };
    let mut width = None;
    let mut points: Option<Points> = None;
    for (index, row) in rows.iter().enumerate() {
        let at = |(problem, cell): (Problem, String)| problem.at(file, Place::Path(format!("{path}[{index}]{cell}")));
        let point = coordinates(row, columns, wanted, &mut width).map_err(at)?;
        let dimension = points.as_ref().map_or(point.len(), Points::dimension);
        if point.len() != dimension {
            return Err(at((Problem::Ragged { found: point.len(), expected: dimension }, String::new())));
        }
        points
            .get_or_insert_with(|| {
                Points::of_dimension(dimension).expect("no more coordinates are taken than are read")
            })
            .push(&point)
            .map_err(|problem| at((problem, String::new())))?;
    }
    let points = points.unwrap_or(Points::Plane(Vec::new()));
    let (columns, left_out) =
        rows.first().map_or_else(Default::default, |first| parts(first, columns, points.dimension()));
    let is_mixed = rows.windows(2).any(|pair| pair[0].list().is_some() != pair[1].list().is_some());
    let columns = if is_mixed { Vec::new() } else { columns };
    Ok(Reading::of(points, (columns, left_out)))
}

/// The parts of a row that hold the coordinates, and the others.
fn parts(row: &Tree, columns: Option<&Columns>, dimension: usize) -> (Vec<Column>, Vec<String>) {
    if let Tree::Object(fields) = row {
        let names = names(columns, dimension);
        let left_out = fields.iter().map(|(name, _)| name.clone()).filter(|name| !names.contains(name)).collect();
        return (names.into_iter().map(Column::Name).collect(), left_out);
    }
    let cells = row.list().map_or(0, <[Tree]>::len);
    let chosen: Vec<usize> = match columns {
        Some(Columns(chosen)) => chosen.iter().filter_map(|column| position(column, cells).ok()).collect(),
        None => (0..cells).collect(),
    };
    columns_of(&vec![String::new(); cells], &chosen)
}

/// The names of an object's fields that hold its coordinates.
fn names(columns: Option<&Columns>, dimension: usize) -> Vec<String> {
    match columns {
        Some(Columns(chosen)) => chosen.iter().map(Column::to_string).collect(),
        None => ["x", "y", "z"].iter().take(dimension).map(|&name| name.to_owned()).collect(),
    }
}

/// Parses a document, with the parser's complaints placed in the file.
pub(super) fn parse(file: &Path, content: &[u8]) -> Result<Tree, InputError> {
    json::read(content, MAX_VALUES).map_err(|error| match error {
        ReadError::TooManyValues { limit } => Problem::TooMany { what: "values", limit }.at(file, Place::File),
        ReadError::OutOfRange { line, column } => {
            Problem::Shape(ReadError::OutOfRange { line, column }.to_string()).at(file, cell(line, column))
        }
        ReadError::RepeatedField { ref field, line, column } => {
            Problem::Shape(format!("the field `{field}` occurs twice in one object")).at(file, cell(line, column))
        }
        ReadError::Syntax { line, column, message } => Problem::NotJson(message).at(file, cell(line, column)),
        other => Problem::NotJson(other.to_string()).at(file, Place::File),
    })
}

fn cell(line: usize, column: usize) -> Place {
    Place::Cell { line: line as u64, column: column as u64 }
}

type Misplaced = (Problem, String);

fn coordinates(
    row: &Tree,
    columns: Option<&Columns>,
    wanted: Wanted,
    width: &mut Option<usize>,
) -> Result<Vec<f64>, Misplaced> {
    match row {
        Tree::List(cells) => {
            let expected = *width.get_or_insert(cells.len());
            if cells.len() != expected {
                let found = cells.len();
                return Err((Problem::Ragged { found, expected }, String::new()));
            }
            let positions: Vec<usize> = match columns {
                Some(Columns(chosen)) => {
                    chosen.iter().map(|column| position(column, cells.len())).collect::<Result<_, _>>()?
                }
                None if wanted.takes_all(cells.len()) => (0..cells.len()).collect(),
                None => {
                    let problem = Problem::ChooseColumns { cells: cells.len(), wanted: wanted.in_words() };
                    return Err((problem, String::new()));
                }
            };
            let coordinate =
                |position: usize| number(&cells[position]).map_err(|problem| (problem, format!("[{position}]")));
            positions.into_iter().map(coordinate).collect()
        }
        Tree::Object(fields) => {
            let in_space = ["x", "y", "z"].iter().all(|name| row.field(name).is_some());
            if in_space && wanted == Wanted::Planar && columns.is_none() {
                return Err((Problem::ThirdCoordinate, String::new()));
            }
            let names = names(columns, if in_space { 3 } else { 2 });
            let coordinate = |name: &String| {
                let value = row.field(name).ok_or_else(|| {
                    let available: Vec<_> = fields.iter().map(|(field, _)| field.as_str()).collect();
                    let problem = Problem::NoSuchColumn { name: name.clone(), available: available.join(", ") };
                    (problem, String::new())
                })?;
                number(value).map_err(|problem| (problem, format!(".{name}")))
            };
            names.iter().map(coordinate).collect()
        }
        other => {
            let problem = Problem::Shape(format!("expected a point, found {}", other.describe()));
            Err((problem, String::new()))
        }
    }
}

fn position(column: &Column, cells: usize) -> Result<usize, Misplaced> {
    match column {
        Column::Number(number) if *number <= cells => Ok(number - 1),
        Column::Number(number) => {
            let number = *number;
            Err((Problem::NoColumnNumber { number, cells }, String::new()))
        }
        Column::Name(name) => {
            let problem = Problem::NoSuchColumn { name: name.clone(), available: format!("numbered 1 to {cells}") };
            Err((problem, String::new()))
        }
    }
}

/// A finite number; strings are no numbers here, except that the non-finite ones are named for what they are.
pub(super) fn number(value: &Tree) -> Result<f64, Problem> {
    match value {
        Tree::Number(number) => Ok(*number),
        Tree::Text(text) if NonFinite::spelled(text).is_some() => Err(Problem::NotFinite(text.clone())),
        Tree::Text(text) => Err(Problem::NotANumber(text.clone())),
        other => Err(Problem::Shape(format!("expected a number, found {}", other.describe()))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(content: &str, columns: Option<&str>) -> Result<Vec<[f64; 2]>, String> {
        let columns = columns.map(|columns| columns.parse().expect("the test's columns are well formed"));
        let points = points(Path::new("p.json"), content.as_bytes(), columns.as_ref(), Wanted::Planar);
        match points.map_err(|error| error.to_string())?.points {
            Points::Plane(points) => Ok(points),
            other => panic!("{other:?} are not points of the plane"),
        }
    }

    #[test]
    fn rows_may_be_lists_or_objects() {
        let expected = Ok(vec![[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(read("[[1,2],[3,4]]", None), expected);
        assert_eq!(read("{\"name\":\"n\",\"points\":[[1,2],[3,4]]}", None), expected);
        assert_eq!(read("[[2,0,1],[4,0,3]]", Some("3,1")), expected);
        assert_eq!(read("[{\"x\":1,\"y\":2},{\"y\":4,\"x\":3}]", None), expected);
        assert_eq!(read("[{\"a\":1,\"b\":2},{\"a\":3,\"b\":4}]", Some("a,b")), expected);
        assert_eq!(read("[]", None), Ok(vec![]));
    }

    #[test]
    fn any_number_of_coordinates() {
        let read = |content: &str| {
            points(Path::new("p.json"), content.as_bytes(), None, Wanted::Any).map(|reading| reading.points)
        };
        let space = Points::Space(vec![[1.0, 2.0, 3.0]]);
        assert_eq!(read("[[1,2,3]]").expect("points"), space);
        assert_eq!(read("[{\"z\":3,\"x\":1,\"y\":2}]").expect("points"), space);
        assert_eq!(read("[[1]]").expect("points"), Points::Line(vec![[1.0]]));
        let mixed = read("[[1,2,3],{\"x\":1,\"y\":2}]").expect_err("two dimensions");
        assert_eq!(mixed.to_string(), "p.json: [1]: the row has 2 cells, not 3");
    }

    #[test]
    fn a_third_coordinate_is_not_dropped_in_silence() {
        let read = |columns: Option<&str>, wanted: Wanted| {
            let columns = columns.map(|columns| columns.parse().expect("well formed"));
            let content = br#"[{"id":"a","x":1,"y":2,"z":3}]"#;
            points(Path::new("p.json"), content, columns.as_ref(), wanted).map_err(|error| error.to_string())
        };
        let reading = read(None, Wanted::PlaneOrSpace).expect("points of space");
        assert_eq!(reading.points, Points::Space(vec![[1.0, 2.0, 3.0]]));
        assert_eq!(reading.in_words().as_deref(), Some("x, y, z; left out: id"));
        assert!(read(None, Wanted::Planar).expect_err("in space").contains("[0]: has the columns x, y and z"));
        let chosen = read(Some("z,x"), Wanted::Planar).expect("points of the plane");
        assert_eq!(chosen.points, Points::Plane(vec![[3.0, 1.0]]));
        assert_eq!(chosen.in_words().as_deref(), Some("z, x; left out: id, y"));
    }

    #[test]
    fn complaints_name_the_place() {
        let complaint = |content, columns| read(content, columns).expect_err("the document is wrong");
        assert_eq!(complaint("[[1,2],[3,\"NaN\"]]", None), "p.json: [1][1]: 'NaN' is not a finite number");
        assert_eq!(complaint("{\"points\":[[1,2],[3]]}", None), "p.json: points[1]: the row has 1 cells, not 2");
        assert_eq!(complaint("[{\"x\":1}]", None), "p.json: [0]: there is no column 'y'; the columns are x");
        assert_eq!(complaint("[[1,null]]", None), "p.json: [0][1]: expected a number, found null");
        assert_eq!(complaint("[[1,2,3]]", None), "p.json: [0]: has 3 column(s); choose two with --columns");
        assert_eq!(
            complaint("[[1,1e999]]", None),
            "p.json: line 1, column 9: a number is outside the range of a double"
        );
        assert!(complaint("[[1,2],\n[3,", None).starts_with("p.json: line 2, column 3: is not JSON: EOF"));
        assert!(complaint("7", None).contains("expected a list of points"));
    }
}
