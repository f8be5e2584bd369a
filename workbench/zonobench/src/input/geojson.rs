//! Points from GeoJSON: every position of every geometry, in the order of the document.

use std::path::Path;

use super::columns::{Column, Columns};
use super::error::{InputError, Place, Problem};
use super::format::Format;
use super::parsed::{number, parse};
use super::points::Points;
use super::reading::{Reading, Skipping, counted};
use batch::json::Tree;

/// The types that GeoJSON has.
const TYPES: [&str; 9] = [
    "FeatureCollection",
    "Feature",
    "GeometryCollection",
    "Point",
    "MultiPoint",
    "LineString",
    "MultiLineString",
    "Polygon",
    "MultiPolygon",
];

/// The names by which each number of a position is chosen.
const NAMES: [&[&str]; 3] = [
    &["lon", "lng", "long", "longitude", "x", "easting"],
    &["lat", "latitude", "y", "northing"],
    &["alt", "altitude", "z", "height", "elevation"],
];

/// Members that move or scale the positions in kin of GeoJSON, and that GeoJSON itself does not have.
pub(super) const MOVED_BY: [&str; 10] = [
    "transform",
    "transformation",
    "quantization",
    "scale",
    "translate",
    "translation",
    "offset",
    "shift",
    "rotation",
    "pose",
];

/// Reads the positions of a GeoJSON object: longitude and latitude, or the chosen numbers.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    columns: Option<&Columns>,
    skipping: &mut Skipping,
) -> Result<Reading, InputError> {
    let document = parse(file, content)?;
    refuse_topology(file, &document)?;
    points_of(file, &document, columns, skipping)
}

/// Refuses TopoJSON, whose positions are steps along arcs.
pub(super) fn refuse_topology(file: &Path, document: &Tree) -> Result<(), InputError> {
    if document.field("type").and_then(Tree::text) != Some("Topology") {
        return Ok(());
    }
    let problem = "is TopoJSON, which is not read; convert it to GeoJSON";
    Err(Problem::Shape(problem.to_owned()).at(file, Place::File))
}

/// Whether a document has a `type` of GeoJSON.
pub(super) fn is_named(document: &Tree) -> bool {
    document.field("type").and_then(Tree::text).is_some_and(|kind| TYPES.contains(&kind))
}

/// The positions of a GeoJSON object that is parsed already.
pub(super) fn points_of(
    file: &Path,
    document: &Tree,
    columns: Option<&Columns>,
    skipping: &mut Skipping,
) -> Result<Reading, InputError> {
    let axes = axes(columns).map_err(|problem| problem.at(file, Place::File))?;
    let points = Points::of_dimension(axes.len()).expect("no more numbers are chosen than a position has");
    let mut positions = Positions { axes, points, skipping, without_position: 0, longer: 0 };
    object(document, String::new(), &mut positions).map_err(|(problem, path)| {
        let place = if path.is_empty() { Place::File } else { Place::Path(path) };
        problem.at(file, place)
    })?;
    let has_altitudes = positions.axes.contains(&2);
    let longer = match (positions.longer, has_altitudes) {
        (0, _) => None,
        (1, false) => Some("the altitude of 1 position".to_owned()),
        (count, false) => Some(format!("the altitudes of {count} positions")),
        (count, true) => Some(format!("numbers behind the altitude of {count} position(s)")),
    };
    let nothing =
        counted(positions.without_position, "geometry that is null or empty", "geometries that are null or empty");
    let columns = columns.map_or_else(Vec::new, |Columns(columns)| columns.clone());
    let reading = Reading::of(positions.points, (columns, longer.into_iter().chain(nothing).collect()));
    Ok(Reading { format: Some(Format::Geojson), ..reading })
}

/// Which number of a position each coordinate is.
fn axes(columns: Option<&Columns>) -> Result<Vec<usize>, Problem> {
    let Some(Columns(columns)) = columns else { return Ok(vec![0, 1]) };
    let axis = |column: &Column| match column {
        Column::Number(number) if *number <= NAMES.len() => Ok(number - 1),
        Column::Number(number) => Err(Problem::NoColumnNumber { number: *number, cells: NAMES.len() }),
        Column::Name(name) => {
            let is_named = |names: &&[&str]| names.iter().any(|known| known.eq_ignore_ascii_case(name));
            NAMES
                .iter()
                .position(is_named)
                .ok_or_else(|| Problem::NoSuchColumn { name: name.clone(), available: "lon, lat, alt".to_owned() })
        }
    };
    columns.iter().map(axis).collect()
}

/// The positions met so far.
struct Positions<'a> {
    /// Which numbers of a position are taken.
    axes: Vec<usize>,
    points: Points,
    skipping: &'a mut Skipping,
    /// The number of geometries that are null or have no positions.
    without_position: usize,
    /// The number of positions with numbers behind those that can be taken: longitude and latitude, and the altitude
    /// where it is chosen.
    longer: usize,
}

type Misplaced = (Problem, String);

fn object(value: &Tree, path: String, met: &mut Positions) -> Result<(), Misplaced> {
    let kind = value.field("type").and_then(Tree::text).unwrap_or_default();
    let below = |field: &str| {
        if path.is_empty() { field.to_owned() } else { format!("{path}.{field}") }
    };
    let moving = MOVED_BY.into_iter().find(|name| value.field(name).is_some_and(|value| *value != Tree::Null));
    if let Some(name) = moving {
        let problem = "this field could change the points, and it is not read; leave out what says nothing about them";
        return Err((Problem::Shape(problem.to_owned()), below(name)));
    }
    let members = |field: &'static str| match value.field(field) {
        Some(Tree::List(members)) => Ok(members),
        _ => Err((Problem::Shape(format!("a {kind} needs a list `{field}`")), path.clone())),
    };
    match kind {
        "FeatureCollection" => each(members("features")?, &below("features"), met, object),
        "GeometryCollection" => each(members("geometries")?, &below("geometries"), met, object),
        "Feature" => match value.field("geometry") {
            None | Some(Tree::Null) => {
                met.without_position += 1;
                Ok(())
            }
            Some(geometry) => object(geometry, below("geometry"), met),
        },
        "Point" | "MultiPoint" | "LineString" | "MultiLineString" | "Polygon" | "MultiPolygon" => {
            let depth = match kind {
                "Point" => 0,
                "MultiPoint" | "LineString" => 1,
                "MultiLineString" | "Polygon" => 2,
                _ => 3,
            };
            let coordinates = value
                .field("coordinates")
                .ok_or_else(|| (Problem::Shape(format!("a {kind} needs `coordinates`")), path.clone()))?;
            if *coordinates == Tree::Null || coordinates.list().is_some_and(<[Tree]>::is_empty) {
                met.without_position += 1;
                return Ok(());
            }
            positions(coordinates, depth, below("coordinates"), met)
        }
        _ => Err((Problem::Shape("is no GeoJSON object: it has no `type` that GeoJSON knows".to_owned()), path)),
    }
}

fn each(
    members: &[Tree],
    path: &str,
    met: &mut Positions,
    read: impl Fn(&Tree, String, &mut Positions) -> Result<(), Misplaced>,
) -> Result<(), Misplaced> {
    members.iter().enumerate().try_for_each(|(index, member)| read(member, format!("{path}[{index}]"), met))
}

/// The positions under `depth` levels of lists.
fn positions(value: &Tree, depth: u32, path: String, met: &mut Positions) -> Result<(), Misplaced> {
    let Tree::List(members) = value else {
        let problem = Problem::Shape(format!("expected a list, found {}", value.describe()));
        return Err((problem, path));
    };
    if depth > 0 {
        return each(members, &path, met, |member, path, met| positions(member, depth - 1, path, met));
    }
    if members.len() < 2 {
        return Err((Problem::Shape("a position needs two coordinates".to_owned()), path));
    }
    let coordinate = |&axis: &usize| match members.get(axis) {
        Some(member) => number(member).map_err(|problem| (problem, format!("{path}[{axis}]"))),
        None => Err((Problem::Shape("the position has no altitude".to_owned()), path.clone())),
    };
    let point = match met.axes.iter().map(coordinate).collect::<Result<Vec<f64>, _>>() {
        Err((problem, _)) if met.skipping.passes_over(&problem, met.points.len()) => return Ok(()),
        point => point?,
    };
    let most = if met.axes.contains(&2) { 3 } else { 2 };
    met.longer += usize::from(members.len() > most);
    met.points.push(&point).map_err(|problem| (problem, path))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(content: &str) -> Result<Vec<[f64; 2]>, String> {
        match points(Path::new("p.geojson"), content.as_bytes(), None, &mut Skipping::default())
            .map_err(|error| error.to_string())?
            .points
        {
            Points::Plane(points) => Ok(points),
            other => panic!("{other:?} are not points of the plane"),
        }
    }

    #[test]
    fn altitudes_are_left_out_and_said_to_be() {
        let left_out = |content: &str| {
            points(Path::new("p.geojson"), content.as_bytes(), None, &mut Skipping::default())
                .map(|reading| reading.left_out)
                .expect("GeoJSON")
        };
        assert_eq!(left_out(r#"{"type":"MultiPoint","coordinates":[[1,2]]}"#), Vec::<String>::new());
        assert_eq!(left_out(r#"{"type":"MultiPoint","coordinates":[[1,2,3],[4,5]]}"#), ["the altitude of 1 position"]);
        let two = r#"{"type":"MultiPoint","coordinates":[[1,2,3],[4,5,6]]}"#;
        assert_eq!(left_out(two), ["the altitudes of 2 positions"]);
    }

    #[test]
    fn altitudes_are_chosen_as_a_column() {
        let content = r#"{"type":"MultiPoint","coordinates":[[1,2,3],[4,5,6,7]]}"#;
        let read = |content: &str, columns: &str| {
            let columns = columns.parse().expect("well formed");
            let reading = points(Path::new("p.geojson"), content.as_bytes(), Some(&columns), &mut Skipping::default());
            reading.map(|reading| (reading.points.clone(), reading.in_words())).map_err(|error| error.to_string())
        };
        let space = Points::Space(vec![[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
        let told = |columns: &str| Some(format!("{columns}; left out: numbers behind the altitude of 1 position(s)"));
        assert_eq!(read(content, "lon,lat,alt"), Ok((space.clone(), told("lon, lat, alt"))));
        assert_eq!(read(content, "X,2,Height"), Ok((space, told("X, 2, Height"))));
        let swapped = Points::Plane(vec![[2.0, 1.0], [5.0, 4.0]]);
        let altitudes = Some("lat, lon; left out: the altitudes of 2 positions".to_owned());
        assert_eq!(read(content, "lat,lon"), Ok((swapped, altitudes)));
        let flat = r#"{"type":"MultiPoint","coordinates":[[1,2,3],[4,5]]}"#;
        let refused = "p.geojson: coordinates[1]: the position has no altitude";
        assert_eq!(read(flat, "lon,lat,alt"), Err(refused.to_owned()));
        let unknown = "p.geojson: there is no column 'depth'; the columns are lon, lat, alt";
        assert_eq!(read(content, "lon,lat,depth"), Err(unknown.to_owned()));
        assert!(read(content, "1,4").is_err());
    }

    #[test]
    fn geometries_without_positions_are_counted() {
        let content = r#"{"type":"FeatureCollection","features":[
            {"type":"Feature","properties":null,"geometry":null},
            {"type":"Feature","geometry":{"type":"Point","coordinates":[]}},
            {"type":"Feature","properties":{}},
            {"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]}}]}"#;
        let reading = points(Path::new("p.geojson"), content.as_bytes(), None, &mut Skipping::default());
        let reading = reading.expect("one position");
        assert_eq!(reading.in_words().as_deref(), Some("left out: 3 geometries that are null or empty"));
        assert_eq!(reading.points, Points::Plane(vec![[1.0, 2.0]]));
    }

    #[test]
    fn every_geometry_gives_its_positions() {
        let content = r#"{"type":"FeatureCollection","features":[
            {"type":"Feature","properties":null,"geometry":null},
            {"type":"Feature","properties":{},"geometry":
                {"type":"Polygon","coordinates":[[[0,0],[1,0],[0,0]],[[2,2,9]]]}},
            {"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[
                {"type":"Point","coordinates":[3,4]},
                {"type":"MultiPolygon","coordinates":[[[[5,6]]]]},
                {"type":"LineString","coordinates":[[7,8]]}]}}]}"#;
        let expected = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [2.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]];
        assert_eq!(read(content), Ok(expected));
    }

    #[test]
    fn members_that_move_the_positions_are_refused_by_name() {
        for name in MOVED_BY {
            let moving = format!(r#""{name}":{{"scale":[2,2]}}"#);
            let refused = |complaint: String, path: &str| {
                let expected = format!("p.geojson: {path}{name}: this field could change the points");
                assert!(complaint.starts_with(&expected), "{complaint}");
            };
            let point = r#"{"type":"Point","coordinates":[1,2]}"#;
            let whole = format!(r#"{{"type":"GeometryCollection",{moving},"geometries":[{point}]}}"#);
            refused(read(&whole).expect_err("moved"), "");
            let inner = format!(r#"{{"type":"Feature","geometry":{{"type":"Point",{moving},"coordinates":[1,2]}}}}"#);
            refused(read(&inner).expect_err("moved"), "geometry.");
            let property = format!(r#"{{"type":"Feature","properties":{{{moving}}},"geometry":{point}}}"#);
            assert_eq!(read(&property), Ok(vec![[1.0, 2.0]]), "a property of what stands at the position");
        }
        let topology = r#"{"type":"Topology","transform":{"scale":[1,1]},"objects":{},"arcs":[[[0,0],[1,1]]]}"#;
        assert_eq!(read(topology), Err("p.geojson: is TopoJSON, which is not read; convert it to GeoJSON".to_owned()));
    }

    #[test]
    fn complaints_name_the_path() {
        let complaint = |content| read(content).expect_err("the document is wrong");
        assert_eq!(
            complaint(r#"{"type":"Polygon","coordinates":[[[0,0],[1,"a"]]]}"#),
            "p.geojson: coordinates[0][1][1]: 'a' is not a number"
        );
        assert_eq!(
            complaint(r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Circle"}}]}"#),
            "p.geojson: features[0].geometry: is no GeoJSON object: it has no `type` that GeoJSON knows"
        );
        assert_eq!(
            complaint(r#"{"type":"MultiPoint","coordinates":[[1]]}"#),
            "p.geojson: coordinates[0]: a position needs two coordinates"
        );
        assert!(complaint("[1,2]").contains("no GeoJSON object"));
        assert!(complaint(r#"{"type":"Polygon"}"#).contains("needs `coordinates`"));
    }
}
