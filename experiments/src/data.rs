//! Real inputs, compiled into the program: country outlines and airports in the plane, meshes in space, flowers in four
//! dimensions. Sources and licences: `data/SOURCES.md`.

use std::sync::{LazyLock, OnceLock};

use thiserror::Error;

use families::clouds::Cloud;

/// A country's largest ring, as plane points (longitude, latitude) in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Stable name: the file `data/outline_<name>.csv`.
    pub name: &'static str,
    /// The ring's corners in order, the first not repeated at the end unless the file does.
    pub points: Vec<[f64; 2]>,
}

/// A triangle mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Stable name: the file `data/<name>.obj`.
    pub name: &'static str,
    /// The vertices of its parts, one part after the other.
    pub vertices: Vec<[f64; 3]>,
    /// Three vertices a triangle, from 0.
    pub triangles: Vec<[usize; 3]>,
}

macro_rules! outline_files {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../data/outline_", $name, ".csv")))),*]
    };
}

static OUTLINE_FILES: [(&str, &str); 10] = outline_files![
    "australia",
    "canada",
    "chile",
    "croatia",
    "france",
    "iceland",
    "italy",
    "new_zealand",
    "norway",
    "vietnam",
];

static AIRPORTS_FILE: &str = include_str!("../data/airports.csv");

static OUTLINES: LazyLock<Vec<Outline>> = LazyLock::new(|| {
    OUTLINE_FILES.iter().map(|&(name, text)| Outline { name, points: columns(text, ["lon", "lat"]) }).collect()
});

static AIRPORTS: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| columns(AIRPORTS_FILE, ["longitude", "latitude"]));

macro_rules! mesh_files {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../data/", $name, ".obj")))),*]
    };
}

static MESH_FILES: [(&str, &str); 5] =
    mesh_files!["assimp_spider", "assimp_wuson", "cgal_cow", "cgal_fandisk", "teapot"];

static MESHES: LazyLock<Vec<Mesh>> =
    LazyLock::new(|| MESH_FILES.iter().map(|&(name, text)| mesh_of(name, text)).collect());

static IRIS_FILE: &str = include_str!("../data/iris.csv");

static IRIS: LazyLock<Vec<[f64; 4]>> = LazyLock::new(|| {
    let mut reader = csv::Reader::from_reader(IRIS_FILE.as_bytes());
    let rows = reader.records().map(|record| record.expect("an embedded file is rectangular"));
    rows.map(|row| [0, 1, 2, 3].map(|c| row[c].parse().expect("an embedded column is numeric"))).collect()
});

/// The ten country outlines, in alphabetical order.
pub fn outlines() -> &'static [Outline] {
    &OUTLINES
}

/// The outline called `name`, if there is one.
pub fn outline(name: &str) -> Option<&'static Outline> {
    outlines().iter().find(|outline| outline.name == name)
}

/// 3,376 airports of the United States, as plane points (longitude, latitude) in degrees.
pub fn airports() -> &'static [[f64; 2]] {
    &AIRPORTS
}

/// Points that a run brings along.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnInput {
    /// The name of the input, which no other input and no family has.
    pub name: String,
    /// The points.
    pub points: Cloud,
}

/// A run has brought its own inputs already: they are told to the process once, like those that are part of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("inputs were added already")]
pub struct InputsAdded;

static OWN_INPUTS: OnceLock<Vec<OwnInput>> = OnceLock::new();

/// Adds inputs to the real ones, for the rest of the process.
///
/// # Errors
/// If that was done before.
pub fn add_inputs(inputs: Vec<OwnInput>) -> Result<(), InputsAdded> {
    OWN_INPUTS.set(inputs).map_err(|_| InputsAdded)
}

/// The input called `name` among those that were added, if there is one.
pub fn own_input(name: &str) -> Option<&'static Cloud> {
    let inputs = OWN_INPUTS.get()?;
    inputs.iter().find(|input| input.name == name).map(|input| &input.points)
}

/// The number of points of the real input called `name`, in the plane or beyond: `iris`, a mesh, one of those of
/// [`points`], or one that was added.
pub fn size(name: &str) -> Option<usize> {
    if let Some(own) = own_input(name) {
        return Some(own.len());
    }
    match name {
        "iris" => Some(iris().len()),
        _ => mesh(name).map(|mesh| mesh.vertices.len()).or_else(|| points(name).map(<[_]>::len)),
    }
}

/// The points of the real input called `name`: `airports`, an outline, or one in the plane that was added.
pub fn points(name: &str) -> Option<&'static [[f64; 2]]> {
    if let Some(Cloud::Plane(points)) = own_input(name) {
        return Some(points);
    }
    match name {
        "airports" => Some(airports()),
        _ => outline(name).map(|outline| outline.points.as_slice()),
    }
}

/// The five meshes, in alphabetical order.
pub fn meshes() -> &'static [Mesh] {
    &MESHES
}

/// The mesh called `name`, if there is one.
pub fn mesh(name: &str) -> Option<&'static Mesh> {
    meshes().iter().find(|mesh| mesh.name == name)
}

/// Fisher's iris: length and width of sepal and petal of 150 flowers, in centimetres.
pub fn iris() -> &'static [[f64; 4]] {
    &IRIS
}

/// The triangles of an OBJ text. The files are part of the program, so a broken one is a broken build.
fn mesh_of(name: &'static str, text: &str) -> Mesh {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &std::path::Path| tobj::MTLLoadResult::Ok(Default::default());
    let (parts, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials).expect("an embedded mesh is OBJ");
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for part in parts {
        let first = vertices.len();
        vertices.extend(part.mesh.positions.as_chunks().0);
        let corners = part.mesh.indices.as_chunks::<3>().0;
        triangles.extend(corners.iter().map(|t| t.map(|corner| first + corner as usize)));
    }
    Mesh { name, vertices, triangles }
}

/// Two named columns of a CSV text. The files are part of the program, so a broken one is a broken build.
fn columns(text: &str, names: [&str; 2]) -> Vec<[f64; 2]> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().expect("an embedded file has a header line").clone();
    let positions =
        names.map(|name| headers.iter().position(|header| header == name).expect("an embedded file has its columns"));
    reader
        .records()
        .map(|record| {
            let record = record.expect("an embedded file is rectangular");
            positions.map(|column| record[column].parse().expect("an embedded column is numeric"))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_read_whole() {
        let sizes: Vec<_> = outlines().iter().map(|o| (o.name, o.points.len())).collect();
        let expected = [
            ("australia", 1153),
            ("canada", 3316),
            ("chile", 1144),
            ("croatia", 230),
            ("france", 533),
            ("iceland", 452),
            ("italy", 382),
            ("new_zealand", 323),
            ("norway", 993),
            ("vietnam", 554),
        ];
        assert_eq!(sizes, expected);
        assert_eq!(airports().len(), 3376);
    }

    #[test]
    fn meshes_and_flowers_are_read_whole() {
        let sizes: Vec<_> = meshes().iter().map(|m| (m.name, m.vertices.len(), m.triangles.len())).collect();
        let expected = [
            ("assimp_spider", 762, 1368),
            ("assimp_wuson", 3205, 3732),
            ("cgal_cow", 2904, 5804),
            ("cgal_fandisk", 6475, 12946),
            ("teapot", 792, 992),
        ];
        assert_eq!(sizes, expected);
        assert_eq!(mesh("teapot").expect("listed").vertices[0], [5.929688, 4.125, 0.0]);
        for mesh in meshes() {
            assert!(mesh.triangles.iter().flatten().all(|&corner| corner < mesh.vertices.len()), "{}", mesh.name);
        }
        assert_eq!(iris().len(), 150);
        assert_eq!((iris()[0], iris()[149]), ([5.1, 3.5, 1.4, 0.2], [5.9, 3.0, 5.1, 1.8]));
    }

    #[test]
    fn points_are_longitude_then_latitude() {
        assert_eq!(airports()[0], [-89.23450472, 31.95376472]);
        assert_eq!(outline("iceland").expect("listed").points[0], [-15.543155431554311, 66.22915881643195]);
        for point in outlines().iter().flat_map(|o| &o.points).chain(airports()) {
            assert!(point[0].abs() <= 180.0 && point[1].abs() <= 90.0, "{point:?}");
        }
    }
}
