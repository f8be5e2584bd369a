//! The vertices of meshes: Wavefront OBJ, PLY, STL and OFF.

mod obj;
mod off;
mod ply;
mod stl;

use std::path::Path;

use super::error::{InputError, Place, Problem};
use super::{Format, push_limited};

/// Reads the vertices of a mesh, in the order of the file.
pub(super) fn vertices(file: &Path, content: &[u8], format: Format) -> Result<Vec<[f64; 3]>, InputError> {
    let read = match format {
        Format::Obj => obj::vertices,
        Format::Ply => ply::vertices,
        Format::Stl => stl::vertices,
        _ => off::vertices,
    };
    read(content).map_err(|(problem, place)| problem.at(file, place))
}

/// What the vertices that were read leave out, in words.
pub(super) fn left_out(content: &[u8], vertices: &[[f64; 3]], format: Format) -> Vec<String> {
    let unused = if format == Format::Obj { obj::unused_vertices(content, vertices) } else { 0 };
    match unused {
        0 => Vec::new(),
        1 => vec!["1 vertex that nothing uses".to_owned()],
        count => vec![format!("{count} vertices that nothing uses")],
    }
}

/// What is wrong, and where in the file.
type Misplaced = (Problem, Place);

/// Adds a vertex unless a coordinate is not finite or the limit is reached.
fn push(vertices: &mut Vec<[f64; 3]>, vertex: [f64; 3], place: impl Fn() -> Place) -> Result<(), Misplaced> {
    if let Some(wrong) = vertex.iter().find(|x| !x.is_finite()) {
        return Err((Problem::NotFinite(wrong.to_string()), place()));
    }
    push_limited(vertices, vertex).map_err(|problem| (problem, place()))
}

/// A reader's complaint.
fn broken(format: &str, complaint: &str) -> Problem {
    Problem::Mesh { format: format.to_owned(), complaint: complaint.to_owned() }
}

/// The number of the line on which the byte before `end` stands.
fn line_before(content: &[u8], end: usize) -> u64 {
    let read = &content[..end.min(content.len())];
    let ends = read.iter().filter(|&&byte| byte == b'\n').count() as u64;
    if read.ends_with(b"\n") { ends } else { ends + 1 }
}

#[cfg(test)]
mod tests;
