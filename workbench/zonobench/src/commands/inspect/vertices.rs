//! The vertices of a planar body, as a table or as GeoJSON.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use thiserror::Error;
use zonotope::zonotope::Zonotope;

use crate::input::Body;

/// Why vertices are not written.
#[derive(Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum VerticesError {
    /// The name of the file tells no format for vertices.
    #[error("{}: vertices are written as .csv or .geojson", .0.display())]
    UnknownFormat(PathBuf),
    /// The body is not in the plane.
    #[error(
        "{name}: has {dimension} coordinates; vertices are written of bodies with two, --obj writes those of space"
    )]
    NotPlanar {
        /// The body.
        name: String,
        /// The number of its coordinates.
        dimension: usize,
    },
}

/// A format that vertices are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum VertexFormat {
    /// A table with the columns x and y.
    Csv,
    /// A feature of GeoJSON: a polygon, or the segment or point that the body is.
    GeoJson,
}

impl VertexFormat {
    /// The format that the name of a file tells; a table on standard output.
    pub(super) fn of(file: &Path) -> Result<Self, VerticesError> {
        match file.extension().and_then(OsStr::to_str) {
            None if file.as_os_str() == "-" => Ok(Self::Csv),
            Some("csv") => Ok(Self::Csv),
            Some("geojson") => Ok(Self::GeoJson),
            _ => Err(VerticesError::UnknownFormat(file.to_path_buf())),
        }
    }

    /// The vertices of a body, counter-clockwise, their coordinates rounded to doubles. Of vertices that round to one
    /// point one is written, and their number is told.
    pub(super) fn text(self, name: &str, body: &Body, tell: impl FnOnce(&str)) -> Result<String, VerticesError> {
        let planar = |v: &Vec<f64>| <[f64; 2]>::try_from(v.as_slice()).ok();
        let (Some(center), Some(generators)) = (planar(&body.center), body.generators.iter().map(planar).collect())
        else {
            return Err(VerticesError::NotPlanar { name: name.to_owned(), dimension: body.center.len() });
        };
        let all = Zonotope::new(center, generators).expect("a body that was read is finite").vertices();
        let vertices = each_once(&all);
        if vertices.len() < all.len() {
            let [written, of] = [vertices.len(), all.len()];
            tell(&format!("{name}: {of} vertices round to {written} points of doubles, each of which is written once"));
        }
        Ok(match self {
            Self::Csv => table(&vertices),
            Self::GeoJson => format!("{}\n", feature(name, &vertices)),
        })
    }
}

/// The points in their order, each where it occurs first; zeros of either sign are one number.
fn each_once(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut seen = BTreeSet::new();
    points.iter().filter(|point| seen.insert(point.map(|x| (x + 0.0).to_bits()))).copied().collect()
}

fn table(vertices: &[[f64; 2]]) -> String {
    let mut table = "x,y\n".to_owned();
    for [x, y] in vertices {
        writeln!(table, "{x:?},{y:?}").expect("writing to a string does not fail");
    }
    table
}

/// A ring of a polygon ends where it begins.
fn feature(name: &str, vertices: &[[f64; 2]]) -> Value {
    let geometry = match vertices {
        [point] => json!({"type": "Point", "coordinates": point}),
        [from, to] => json!({"type": "LineString", "coordinates": [from, to]}),
        _ => {
            let ring: Vec<[f64; 2]> = vertices.iter().chain(vertices.first()).copied().collect();
            json!({"type": "Polygon", "coordinates": [ring]})
        }
    };
    json!({"type": "Feature", "properties": {"name": name}, "geometry": geometry})
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(generators: &[[f64; 2]]) -> Body {
        let generators = generators.iter().map(|g| g.to_vec()).collect();
        Body { center: vec![1.0, 2.0], generators, is_rounded: false }
    }

    #[test]
    fn a_square_a_segment_and_a_point() {
        let square = body(&[[1.0, 0.0], [0.0, 0.5]]);
        let [csv, geojson] = [VertexFormat::Csv, VertexFormat::GeoJson].map(|format| format.text("s", &square, |_| {}));
        assert_eq!(csv.as_deref(), Ok("x,y\n0.0,1.5\n2.0,1.5\n2.0,2.5\n0.0,2.5\n"));
        let ring = "[[0.0,1.5],[2.0,1.5],[2.0,2.5],[0.0,2.5],[0.0,1.5]]";
        let expected = format!(
            r#"{{"type":"Feature","properties":{{"name":"s"}},"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#
        );
        assert_eq!(geojson.as_deref(), Ok(format!("{expected}\n").as_str()));
        for (flat, geometry) in [
            (body(&[[1.0, 1.0]]), r#"{"type":"LineString","coordinates":[[0.0,1.0],[2.0,3.0]]}"#),
            (body(&[]), r#"{"type":"Point","coordinates":[1.0,2.0]}"#),
        ] {
            let text = VertexFormat::GeoJson.text("s", &flat, |_| {}).expect("a body of the plane");
            assert!(text.contains(geometry), "{text}");
        }
    }

    #[test]
    fn other_formats_and_other_bodies_are_refused() {
        for name in ["v.json", "v.obj", "v"] {
            let refused = VertexFormat::of(Path::new(name)).expect_err("no format of vertices").to_string();
            assert_eq!(refused, format!("{name}: vertices are written as .csv or .geojson"));
        }
        let solid = Body { center: vec![0.0; 3], generators: Vec::new(), is_rounded: false };
        let refused = VertexFormat::Csv.text("solid", &solid, |_| {}).expect_err("a body of space").to_string();
        assert!(refused.starts_with("solid: has 3 coordinates"), "{refused}");
    }
}
