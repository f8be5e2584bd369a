//! Points from a JSON document: a list of rows, or an object with such a list under `points`; a GeoJSON object is read
//! as such.

use std::path::Path;

use super::body::could_change_points;
use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem, numbered};
use super::frame::{Frame, may_be_coordinates};
use super::geojson;
use super::names;
use super::points::{Points, Wanted};
use super::reading::{Reading, Skipping, columns_of};
use batch::json::Tree;

use super::parsed::parse_points;
pub(super) use super::parsed::{number, parse};
use super::table::Counting;

/// Reads the points of a document whose rows are `[x, y, …]` or `{"x": …, "y": …}`.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    wanted: Wanted,
    skipping: &mut Skipping,
) -> Result<Reading, InputError> {
    let document = parse_points(file, content)?;
    geojson::refuse_topology(file, &document)?;
    let (rows, path) = match (document.list(), document.field("points").and_then(Tree::list)) {
        (Some(rows), _) => (rows, String::new()),
        (None, Some(rows)) => (rows, "points".to_owned()),
        (None, None) if geojson::is_named(&document) => {
            return geojson::points_of(file, &document, columns, skipping);
        }
        (None, None) => {
            if holds_body(&document) {
                let problem = "holds a zonotope, not points; `inspect` and the other commands about bodies read it";
                return Err(Problem::Shape(problem.to_owned()).at(file, Place::File));
            }
            let frame = Frame::of(&document);
            if let Some(frame) = frame
                && let Some(mut reading) = frame.points(file, columns, wanted, skipping)?
            {
                reading.left_out.extend(other_fields(file, &document, |name| frame.holds(name))?);
                return Ok(reading);
            }
            let problem = Problem::Shape(format!(
                "expected a list of points, or an object with a list `points` or with columns `x` and `y`, found {}",
                document.describe()
            ));
            return Err(problem.at(file, Place::File));
        }
    };
    let others = other_fields(file, &document, |name| name == "points")?;
    let mut choice = Choice { columns, wanted, width: None, known: Vec::new(), names: Vec::new(), places: Vec::new() };
    choice.learn(rows);
    let mut counting = None;
    let mut points: Option<Points> = None;
    for (index, row) in rows.iter().enumerate() {
        let at = |(problem, cell): (Problem, String)| problem.at(file, Place::Path(format!("{path}[{index}]{cell}")));
        let point = match choice.coordinates(row) {
            Err((problem, _)) if skipping.passes_over(&problem, points.as_ref().map_or(0, Points::len)) => continue,
            read => read.map_err(at)?,
        };
        let dimension = points.as_ref().map_or(point.len(), Points::dimension);
        if point.len() != dimension {
            return Err(at((Problem::Ragged { found: point.len(), expected: dimension }, String::new())));
        }
        let is_list = row.list().is_some();
        let counting = counting.get_or_insert_with(|| {
            Counting::new(columns.is_some() || !is_list, false, &(0..dimension).collect::<Vec<_>>())
        });
        counting.note(if is_list { point[0] } else { f64::NAN });
        points
            .get_or_insert_with(|| {
                Points::of_dimension(dimension).expect("no more coordinates are taken than are read")
            })
            .push(&point)
            .map_err(|problem| at((problem, String::new())))?;
    }
    let points = points.unwrap_or(Points::Plane(Vec::new()));
    let is_mixed = rows.windows(2).any(|pair| pair[0].list().is_some() != pair[1].list().is_some());
    let (columns, mut left_out) = rows.first().and_then(|first| choice.parts(first)).unwrap_or_default();
    left_out.extend(others);
    let mut reading = Reading::of(points, (if is_mixed { Vec::new() } else { columns }, left_out));
    let all: Vec<usize> = (0..reading.points.dimension()).collect();
    reading.notes.extend(counting.and_then(|counting| counting.in_words(&all, true)));
    reading.notes.extend(choice.in_another_order());
    Ok(reading)
}

/// Whether an object is a zonotope, a question about one or an answer with one: it has generators by name, or their
/// coefficients.
fn holds_body(document: &Tree) -> bool {
    let parts = [Some(document), document.field("input"), document.field("result")];
    parts.into_iter().flatten().any(|part| part.field("generators").or(part.field("coefficients")).is_some())
}

/// The fields beside those that hold the points, in words; one that could change the points is refused by name.
fn other_fields(file: &Path, document: &Tree, holds_points: impl Fn(&str) -> bool) -> Result<Vec<String>, InputError> {
    let Tree::Object(fields) = document else { return Ok(Vec::new()) };
    let others = || fields.iter().filter(|(name, _)| !holds_points(name));
    if let Some((name, _)) = others().find(|(name, value)| could_change_points(name, value)) {
        let problem = "this field could change the points, and it is not read; leave out what says nothing about them";
        return Err(Problem::Shape(problem.to_owned()).at(file, Place::Path(name.clone())));
    }
    Ok(others().map(|(name, _)| format!("the field {name}")).collect())
}

type Misplaced = (Problem, String);

/// The choice of the coordinates of a row.
struct Choice<'a> {
    columns: Option<&'a Columns>,
    wanted: Wanted,
    /// The length of the rows that are lists.
    width: Option<usize>,
    /// The names of the coordinates of the first row that is an object and has them.
    known: Vec<String>,
    /// The names of the last row that was an object.
    names: Vec<String>,
    /// The places of the coordinates among these names.
    places: Vec<usize>,
}

impl Choice<'_> {
    fn coordinates(&mut self, row: &Tree) -> Result<Vec<f64>, Misplaced> {
        match row {
            Tree::List(cells) => {
                let expected = *self.width.get_or_insert(cells.len());
                if cells.len() != expected {
                    return Err((Problem::Ragged { found: cells.len(), expected }, String::new()));
                }
                let places = self.places_in_list(cells.len()).map_err(|problem| (problem, String::new()))?;
                let coordinate =
                    |place: usize| number(&cells[place]).map_err(|problem| (problem, format!("[{place}]")));
                places.into_iter().map(coordinate).collect()
            }
            Tree::Object(fields) => {
                let is_known = self.names.len() == fields.len()
                    && self.names.iter().zip(fields).all(|(known, (name, _))| known == name);
                if self.names.is_empty() || !is_known {
                    self.names = fields.iter().map(|(name, _)| name.clone()).collect();
                    self.places = self.places_in_object(fields).map_err(|problem| {
                        // The next row is looked at anew.
                        self.names.clear();
                        (problem, String::new())
                    })?;
                }
                let coordinate = |&place: &usize| {
                    let (name, value) = &fields[place];
                    number(value).map_err(|problem| (problem, format!(".{name}")))
                };
                self.places.iter().map(coordinate).collect()
            }
            other => Err((Problem::Shape(format!("expected a point, found {}", other.describe())), String::new())),
        }
    }

    fn places_in_list(&self, cells: usize) -> Result<Vec<usize>, Problem> {
        match self.columns {
            Some(columns) => names::chosen(&vec![String::new(); cells], columns, &format!("numbered 1 to {cells}")),
            None if self.wanted.takes_all(cells, false) => Ok((0..cells).collect()),
            None => Err(Problem::ChooseColumns { cells, wanted: self.wanted.in_words(), columns: numbered(cells) }),
        }
    }

    /// Learns the names of the coordinates from the first row that has them, so that a row without one is known.
    fn learn(&mut self, rows: &[Tree]) {
        for row in rows {
            if !self.known.is_empty() {
                break;
            }
            if let Tree::Object(fields) = row {
                self.names = fields.iter().map(|(name, _)| name.clone()).collect();
                let places = self.places_in_object(fields).unwrap_or_default();
                self.known = places.iter().map(|&place| self.names[place].clone()).collect();
            }
        }
        self.names.clear();
    }

    /// The places of the coordinates in a row; an error by the name of one that other rows have.
    fn places_in_object(&self, fields: &[(String, Tree)]) -> Result<Vec<usize>, Problem> {
        let places = self.places_by_names(fields);
        let is_short = match &places {
            Ok(places) => places.len() < self.known.len(),
            Err(problem) => matches!(problem, Problem::NoSuchColumn { .. }),
        };
        let has = |known: &&String| self.names.iter().any(|name| name.eq_ignore_ascii_case(known));
        match self.known.iter().find(|known| is_short && !has(known)) {
            Some(name) => Err(Problem::NoField(name.clone())),
            None => places,
        }
    }

    /// The remark on fields that are read as they stand, under names that say nothing about their order.
    fn in_another_order(&self) -> Option<String> {
        self.columns.is_none().then(|| names::in_another_order(&self.known)).flatten()
    }

    fn places_by_names(&self, fields: &[(String, Tree)]) -> Result<Vec<usize>, Problem> {
        let available = self.names.join(", ");
        match self.columns {
            // A number is the name of a field here.
            Some(Columns(columns)) => {
                let by_name: Vec<Column> = columns.iter().map(|column| Column::Name(column.to_string())).collect();
                names::chosen(&self.names, &Columns(by_name), &available)
            }
            None => names::of_coordinates(&self.names, self.wanted)?
                .or_else(|| self.all_of_numbers(fields))
                .ok_or_else(|| {
                    let has_x = self.names.iter().any(|name| name.eq_ignore_ascii_case("x"));
                    Problem::NoSuchColumn { name: if has_x { "y" } else { "x" }.to_owned(), available }
                }),
        }
    }

    /// All fields where they are as many numbers as a table of coordinates has columns.
    fn all_of_numbers(&self, fields: &[(String, Tree)]) -> Option<Vec<usize>> {
        let are_numbers = fields.iter().all(|(_, value)| matches!(value, Tree::Number(_)));
        (are_numbers && may_be_coordinates(&self.names, self.wanted)).then(|| (0..fields.len()).collect())
    }

    /// The parts of a row that hold the coordinates, and the others.
    fn parts(&mut self, row: &Tree) -> Option<(Vec<Column>, Vec<String>)> {
        Some(match row {
            Tree::List(cells) => columns_of(&vec![String::new(); cells.len()], &self.places_in_list(cells.len()).ok()?),
            _ => {
                // A point that is left out has its names all the same.
                self.coordinates(row).ok().or_else(|| (!self.names.is_empty()).then(Vec::new))?;
                columns_of(&self.names, &self.places)
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(content: &str, columns: Option<&str>) -> Result<Vec<[f64; 2]>, String> {
        let columns = columns.map(|columns| columns.parse().expect("the test's columns are well formed"));
        let points =
            points(Path::new("p.json"), content.as_bytes(), columns.as_ref(), Wanted::Planar, &mut Skipping::default());
        match points.map_err(|error| error.to_string())?.points {
            Points::Plane(points) => Ok(points),
            other => panic!("{other:?} are not points of the plane"),
        }
    }

    const TWO_NAMES: &str = "p.json: [0]: two columns are named 'x'; choose with --columns by number";

    #[test]
    fn geojson_under_another_name_is_read_as_such() {
        assert_eq!(
            read(r#"{"type":"MultiPoint","coordinates":[[1,2],[3,4]]}"#, None),
            Ok(vec![[1.0, 2.0], [3.0, 4.0]])
        );
        let topology = read(r#"{"type":"Topology","arcs":[]}"#, None).expect_err("not read");
        assert!(topology.contains("is TopoJSON, which is not read"), "{topology}");
    }

    #[test]
    fn missing_numbers_are_left_out_where_that_is_asked() {
        let mut skipping = Skipping::new(true);
        let content = br#"[{"x":null,"y":2},{"x":1,"y":2},{"x":1,"y":"NaN"}]"#;
        let reading = points(Path::new("p.json"), content, None, Wanted::Any, &mut skipping).expect("one point");
        assert_eq!((reading.points, skipping.count()), (Points::Plane(vec![[1.0, 2.0]]), 2));
        let bare = br#"[{"x":1,"y":NaN,"name":"a \"NaN"},{"x":-Infinity,"y":2},{"x":1,"y":2}]"#;
        let mut skipping = Skipping::new(true);
        let reading = points(Path::new("p.json"), bare, None, Wanted::Any, &mut skipping).expect("one point");
        assert_eq!((reading.points, skipping.count()), (Points::Plane(vec![[1.0, 2.0]]), 2));
        assert_eq!(read("[[1,NaN]]", None), Err("p.json: [0][1]: 'NaN' is not a finite number".to_owned()));
        assert!(read("[[1,NaN]", None).expect_err("cut").contains("is not JSON: EOF"));
        assert!(read("[[1,nan]]", None).expect_err("no word of Python").contains("is not JSON"));
    }

    #[test]
    fn numbers_may_be_written_as_strings() {
        let expected = Ok(vec![[1.0, 2.5], [3.0, 4.0]]);
        assert_eq!(read(r#"[["1","2.5"],["3",4]]"#, None), expected);
        assert_eq!(read(r#"[{"x":" 1","y":"2.5"},{"x":"3","y":"4e0"}]"#, None), expected);
        assert!(read(r#"[["1","2,5"]]"#, None).expect_err("a comma").contains("has a comma where a decimal point"));
        assert_eq!(read(r#"[["1","north"]]"#, None), Err("p.json: [0][1]: 'north' is not a number".to_owned()));
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
        assert_eq!(read("{\"x\":[1,3],\"y\":[2,4]}", None), expected);
        assert_eq!(read("[{\"Lat\":2,\"LON\":1},{\"lon\":3,\"lat\":4,\"id\":7}]", None), expected);
        assert_eq!(read("[{\"northing\":2,\"easting\":1},{\"easting\":3,\"northing\":4}]", None), expected);
        assert_eq!(read("[{\"x\":1,\"X\":1,\"y\":2}]", None).expect_err("two names"), TWO_NAMES);
    }

    #[test]
    fn a_field_that_could_change_the_points_is_refused_by_name() {
        for field in [
            r#""offset":[5,5]"#,
            r#""scale":0.001"#,
            r#""pose":{"translation":[1,2]}"#,
            r#""origin":[1,2]"#,
            r#""points2":[[1,2]]"#,
            r#""transform":{"scale":[2,2]}"#,
            r#""columns":["y","x"]"#,
        ] {
            let name = field.split('"').nth(1).expect("a name");
            let refused = format!("p.json: {name}: this field could change the points");
            let complaint = read(&format!("{{\"points\":[[1,2],[3,4]],{field}}}"), None).expect_err(field);
            assert!(complaint.starts_with(&refused), "{complaint}");
        }
        for table in [r#""columns":["x","y"],"data":[[1,2],[3,4]]"#, r#""x":[1,3],"y":[2,4]"#] {
            for field in [r#""offset":[5,5]"#, r#""scale":[2,2]"#] {
                let complaint = read(&format!("{{{table},{field}}}"), None).expect_err(field);
                assert!(complaint.contains("this field could change the points"), "{complaint}");
            }
        }
        let numbered = r#"{"columns":["x","y"],"index":[0,1],"data":[[1,2],[3,4]],"name":"n"}"#;
        assert_eq!(read(numbered, None), Ok(vec![[1.0, 2.0], [3.0, 4.0]]));
        let content = br#"{"name":"n","points":[[1,2]]}"#;
        let reading = points(Path::new("p.json"), content, None, Wanted::Any, &mut Skipping::default());
        assert_eq!(reading.expect("a point").in_words().as_deref(), Some("1, 2; left out: the field name"));
    }

    #[test]
    fn any_number_of_coordinates() {
        let read = |content: &str| {
            points(Path::new("p.json"), content.as_bytes(), None, Wanted::Any, &mut Skipping::default())
                .map(|reading| reading.points)
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
            points(Path::new("p.json"), content, columns.as_ref(), wanted, &mut Skipping::default())
                .map_err(|error| error.to_string())
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
        assert_eq!(complaint("[[1,null]]", None), "p.json: [0][1]: 'null' is not a finite number");
        assert_eq!(
            complaint("[[1,2,3]]", None),
            "p.json: [0]: has 3 column(s); choose two with --columns, such as --columns 1,2"
        );
        assert_eq!(complaint("[[1,1e999]]", None), "p.json: [0][1]: '1e999' is outside the range of a double");
        assert!(complaint("[[1,2],\n[3,", None).starts_with("p.json: line 2, column 3: is not JSON: EOF"));
        assert!(complaint("7", None).contains("expected a list of points"));
    }
}
