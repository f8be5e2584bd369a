//! Wavefront OBJ, by the crate `tobj`: the vertices that faces, lines or points use, part by part.

use std::path::Path;

use tobj::{LoadError, LoadOptions, MTLLoadResult};

use super::{Misplaced, broken, line_before, push};
use crate::input::error::Place;

pub(super) fn vertices(content: &[u8]) -> Result<Vec<[f64; 3]>, Misplaced> {
    let mut rest = content;
    let no_materials = |_: &Path| MTLLoadResult::Ok(Default::default());
    let loaded = tobj::load_obj_buf(&mut rest, &LoadOptions::default(), no_materials);
    // Lines are taken one at a time, so what is left begins behind the line that is wrong.
    let line = line_before(content, content.len() - rest.len());
    let (parts, _) = loaded.map_err(|error| (broken("OBJ", &error.to_string()), place(error, line)))?;
    let mut vertices = Vec::new();
    for part in &parts {
        for vertex in part.mesh.positions.as_chunks::<3>().0 {
            push(&mut vertices, *vertex, || first_non_finite(content))?;
        }
    }
    Ok(vertices)
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
