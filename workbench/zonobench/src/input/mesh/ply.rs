//! PLY in text or binary of either byte order, by the crate `ply-rs-bw`.

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Encoding, Property, PropertyAccess, PropertyAccessResult};

use super::{Mesh, Misplaced, broken, push};
use crate::input::MAX_POINTS;
use crate::input::error::{Place, Problem};

/// Of an element of the file, the coordinates of a vertex.
#[derive(Debug)]
struct Corner([f64; 3]);

impl PropertyAccess for Corner {
    fn new() -> Self {
        Self([f64::NAN; 3])
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let Some(axis) = AXES.iter().position(|axis| *axis == name) else {
            return PropertyAccessResult::Ignored;
        };
        self.0[axis] = match property {
            Property::Char(x) => x.into(),
            Property::UChar(x) => x.into(),
            Property::Short(x) => x.into(),
            Property::UShort(x) => x.into(),
            Property::Int(x) => x.into(),
            Property::UInt(x) => x.into(),
            Property::Float(x) => x.into(),
            Property::Double(x) => x,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// Of an element of the file, the corners of a face.
#[derive(Debug)]
struct Side(Vec<usize>);

impl PropertyAccess for Side {
    fn new() -> Self {
        Self(Vec::new())
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !["vertex_index", "vertex_indices"].contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        fn places<T: TryInto<usize>>(list: Vec<T>) -> Vec<usize> {
            // A negative corner is none of the vertices.
            list.into_iter().map(|corner| corner.try_into().unwrap_or(usize::MAX)).collect()
        }
        self.0 = match property {
            Property::ListChar(list) => places(list),
            Property::ListUChar(list) => places(list),
            Property::ListShort(list) => places(list),
            Property::ListUShort(list) => places(list),
            Property::ListInt(list) => places(list),
            Property::ListUInt(list) => places(list),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

pub(super) fn read(content: &[u8]) -> Result<Mesh, Misplaced> {
    let parser = Parser::<Corner>::new();
    let mut reader = Reader::new(content);
    let header = parser.read_header(&mut reader).map_err(|error| complaint(&error))?;
    for (number, (name, element)) in header.elements.iter().enumerate() {
        let is_vertex = name == "vertex";
        if is_vertex && let Some(missing) = AXES.iter().find(|axis| !element.properties.contains_key(**axis)) {
            return Err((broken("PLY", &format!("vertices have no property `{missing}`")), Place::File));
        }
        if element.count > MAX_POINTS {
            return Err((Problem::TooMany { what: "elements", limit: MAX_POINTS }, Place::File));
        }
        let first_line = reader.line() as u64;
        let corners =
            parser.read_payload_for_element(&mut reader, element, &header).map_err(|error| complaint(&error))?;
        if !is_vertex {
            continue;
        }
        let mut vertices = Vec::with_capacity(corners.len());
        for (index, Corner(vertex)) in (0..).zip(corners) {
            let place = || match header.encoding {
                Encoding::Ascii => Place::Line(first_line + index),
                _ => Place::Path(format!("vertex {}", index + 1)),
            };
            push(&mut vertices, vertex, place)?;
        }
        let mut read = Mesh { vertices, faces: Vec::new() };
        // Faces are read where they stand right behind the vertices; a fault there leaves the points as they are.
        if let Some(("face", element)) = header.elements.get_index(number + 1).map(|(name, face)| (&**name, face))
            && element.count <= MAX_POINTS
            && let Ok(sides) = Parser::<Side>::new().read_payload_for_element(&mut reader, element, &header)
        {
            sides.iter().for_each(|Side(corners)| read.add_face(corners));
        }
        return Ok(read);
    }
    Ok(Mesh::default())
}

fn complaint(error: &ParseError) -> Misplaced {
    let place = error.line().map_or(Place::File, |line| Place::Line(line as u64));
    let text = error.to_string();
    let text = text.strip_prefix("Line ").and_then(|rest| rest.split_once(": ")).map_or(&*text, |(_, rest)| rest);
    // What follows the first line repeats the file's.
    (broken("PLY", text.lines().next().unwrap_or_default()), place)
}
