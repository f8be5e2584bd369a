//! Meshes: Wavefront OBJ, PLY, STL and OFF. The vertices are the points that were asked for; faces are read for
//! pictures, and where they cannot be read a picture does without.

mod obj;
mod off;
mod ply;
mod stl;

use std::path::Path;

use super::error::{InputError, Place, Problem};
use super::{Format, push_limited};

/// What was read of a mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Mesh {
    /// The vertices, in the order of the file.
    pub(super) vertices: Vec<[f64; 3]>,
    /// The faces, each a list of three or more vertices.
    pub(super) faces: Vec<Box<[usize]>>,
}

impl Mesh {
    /// Adds a face; one of fewer than three corners, or with a corner that is not there, is left out.
    fn add_face(&mut self, corners: &[usize]) {
        let count = self.vertices.len();
        if corners.len() >= 3 && corners.iter().all(|&corner| corner < count) {
            self.faces.push(corners.into());
        }
    }
}

/// Reads a mesh.
pub(super) fn read(file: &Path, content: &[u8], format: Format) -> Result<Mesh, InputError> {
    let read = match format {
        Format::Obj => obj::read,
        Format::Ply => ply::read,
        Format::Stl => stl::read,
        _ => off::read,
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
