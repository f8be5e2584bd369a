//! Points from GeoJSON: every position of every geometry, in the order of the document.

use std::path::Path;

use super::document::{number, parse};
use super::error::{InputError, Place, Problem};
use super::points::Points;
use super::push_limited;
use super::reading::Reading;
use batch::json::Tree;

/// Reads the positions (longitude, latitude; altitudes are left out) of a GeoJSON object.
pub(super) fn points(file: &Path, content: &[u8]) -> Result<Reading, InputError> {
    let document = parse(file, content)?;
    let mut positions = Positions::default();
    object(&document, String::new(), &mut positions).map_err(|(problem, path)| {
        let place = if path.is_empty() { Place::File } else { Place::Path(path) };
        problem.at(file, place)
    })?;
    let left_out = match positions.altitudes {
        0 => Vec::new(),
        1 => vec!["the altitude of 1 position".to_owned()],
        count => vec![format!("the altitudes of {count} positions")],
    };
    Ok(Reading::without_columns(Points::Plane(positions.points), left_out))
}

/// The positions met so far.
#[derive(Default)]
struct Positions {
    points: Vec<[f64; 2]>,
    /// How many of them have more than two coordinates.
    altitudes: usize,
}

type Misplaced = (Problem, String);

fn object(value: &Tree, path: String, met: &mut Positions) -> Result<(), Misplaced> {
    let kind = value.field("type").and_then(Tree::text).unwrap_or_default();
    let below = |field: &str| {
        if path.is_empty() { field.to_owned() } else { format!("{path}.{field}") }
    };
    let members = |field: &'static str| match value.field(field) {
        Some(Tree::List(members)) => Ok(members),
        _ => Err((Problem::Shape(format!("a {kind} needs a list `{field}`")), path.clone())),
    };
    match kind {
        "FeatureCollection" => each(members("features")?, &below("features"), met, object),
        "GeometryCollection" => each(members("geometries")?, &below("geometries"), met, object),
        "Feature" => match value.field("geometry") {
            Some(Tree::Null) => Ok(()),
            Some(geometry) => object(geometry, below("geometry"), met),
            None => Err((Problem::Shape("a Feature needs a `geometry`".to_owned()), path)),
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
    let coordinate = |index: usize| number(&members[index]).map_err(|problem| (problem, format!("{path}[{index}]")));
    let point = [coordinate(0)?, coordinate(1)?];
    met.altitudes += usize::from(members.len() > 2);
    push_limited(&mut met.points, point).map_err(|problem| (problem, path))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(content: &str) -> Result<Vec<[f64; 2]>, String> {
        match points(Path::new("p.geojson"), content.as_bytes()).map_err(|error| error.to_string())?.points {
            Points::Plane(points) => Ok(points),
            other => panic!("{other:?} are not points of the plane"),
        }
    }

    #[test]
    fn altitudes_are_left_out_and_said_to_be() {
        let left_out = |content: &str| {
            points(Path::new("p.geojson"), content.as_bytes()).map(|reading| reading.left_out).expect("GeoJSON")
        };
        assert_eq!(left_out(r#"{"type":"MultiPoint","coordinates":[[1,2]]}"#), Vec::<String>::new());
        assert_eq!(left_out(r#"{"type":"MultiPoint","coordinates":[[1,2,3],[4,5]]}"#), ["the altitude of 1 position"]);
        let two = r#"{"type":"MultiPoint","coordinates":[[1,2,3],[4,5,6]]}"#;
        assert_eq!(left_out(two), ["the altitudes of 2 positions"]);
    }

    #[test]
    fn every_geometry_gives_its_positions() {
        let content = r#"{"type":"FeatureCollection","features":[
            {"type":"Feature","properties":null,"geometry":null},
            {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,0]],[[2,2,9]]]}},
            {"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[
                {"type":"Point","coordinates":[3,4]},
                {"type":"MultiPolygon","coordinates":[[[[5,6]]]]},
                {"type":"LineString","coordinates":[[7,8]]}]}}]}"#;
        let expected = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [2.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]];
        assert_eq!(read(content), Ok(expected));
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
