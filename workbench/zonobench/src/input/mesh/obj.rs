//! Wavefront OBJ, by the crate `tobj`: the vertices that faces, lines or points use, part by part, and the faces.

use std::collections::BTreeSet;
use std::path::Path;

use tobj::{LoadError, LoadOptions, MTLLoadResult};

use super::{Mesh, Misplaced, broken, line_before, push};
use crate::input::error::Place;

pub(super) fn read(content: &[u8]) -> Result<Mesh, Misplaced> {
    let mut rest = content;
    let no_materials = |_: &Path| MTLLoadResult::Ok(Default::default());
    let loaded = tobj::load_obj_buf(&mut rest, &LoadOptions::default(), no_materials);
    // Lines are taken one at a time, so what is left begins behind the line that is wrong.
    let line = line_before(content, content.len() - rest.len());
    let (parts, _) = loaded.map_err(|error| (broken("OBJ", &error.to_string()), place(error, line)))?;
    let mut read = Mesh::default();
    for part in &parts {
        let first = read.vertices.len();
        for vertex in part.mesh.positions.as_chunks::<3>().0 {
            push(&mut read.vertices, *vertex, || first_non_finite(content))?;
        }
        let corners: Vec<usize> = part.mesh.indices.iter().map(|&index| first + index as usize).collect();
        let mut rest = &corners[..];
        // Without a list of them all faces are triangles; points and lines have fewer corners.
        let arities = part.mesh.face_arities.iter().map(|&arity| arity as usize).chain(std::iter::repeat(3));
        for arity in arities {
            let Some((face, others)) = rest.split_at_checked(arity).filter(|(face, _)| !face.is_empty()) else { break };
            read.add_face(face);
            rest = others;
        }
    }
    Ok(read)
}

/// How many vertices of the file have coordinates that are not among those of the vertices which were read: no face,
/// line or point uses them.
pub(super) fn unused_vertices(content: &[u8], read: &[[f64; 3]]) -> usize {
    let bits = |vertex: [f64; 3]| vertex.map(f64::to_bits);
    let read: BTreeSet<[u64; 3]> = read.iter().map(|&vertex| bits(vertex)).collect();
    let vertex = |line: &[u8]| -> Option<[f64; 3]> {
        let text = std::str::from_utf8(line).ok()?;
        let mut words = text.split_whitespace();
        let coordinates = (words.next() == Some("v")).then_some(words)?.take(3).map(str::parse::<f64>);
        coordinates.collect::<Result<Vec<_>, _>>().ok()?.try_into().ok()
    };
    let vertices = content.split(|&byte| byte == b'\n').filter_map(vertex);
    vertices.filter(|&vertex| !read.contains(&bits(vertex))).count()
}

/// Indices are looked up at the end of a part, which says nothing about the line.
fn place(error: LoadError, line: u64) -> Place {
    match error {
        LoadError::FaceVertexOutOfBounds
        | LoadError::FaceTexCoordOutOfBounds
        | LoadError::FaceNormalOutOfBounds
        | LoadError::FaceColorOutOfBounds
        | LoadError::InvalidPolygon => Place::File,
        _ => Place::Line(line),
    }
}

/// The first line with a vertex that has a coordinate which is not finite.
fn first_non_finite(content: &[u8]) -> Place {
    let is_wrong = |line: &[u8]| {
        let text = String::from_utf8_lossy(line);
        let mut words = text.split_whitespace();
        words.next() == Some("v") && words.any(|word| word.parse::<f64>().is_ok_and(|x| !x.is_finite()))
    };
    let line = content.split(|&byte| byte == b'\n').position(is_wrong);
    line.map_or(Place::File, |line| Place::Line(line as u64 + 1))
}
