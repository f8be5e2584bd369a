//! Meshes: Wavefront OBJ, PLY, STL and OFF. The vertices are the points that were asked for; faces are read for
//! pictures, and because a face that is cut off or names a vertex that is not there says that the file is broken.

mod content;
mod obj;
mod off;
mod ply;
mod stl;
mod words;

use self::content::Mesh;
pub(super) use self::obj::Keyword;
pub(super) use self::stl::binary_length as binary_stl_length;
use std::path::Path;

use super::Format;
use super::error::InputError;
use super::points::Points;
use super::reading::{Reading, Skipping};

/// Reads the vertices and faces of a mesh.
pub(super) fn points(
    file: &Path,
    content: &[u8],
    format: Format,
    skipping: &mut Skipping,
) -> Result<Reading, InputError> {
    let read = match format {
        Format::Obj => obj::read(content, skipping).map(Mesh::into_reading),
        Format::Ply => ply::read(content, skipping).map(Mesh::into_reading),
        Format::Stl => stl::read(content, skipping).map(Mesh::into_reading),
        _ => off::read(content, skipping),
    };
    read.map_err(|(problem, place)| problem.at(file, place))
}

impl Mesh {
    /// The vertices of a mesh of space, with its faces.
    fn into_reading(self) -> Reading {
        self.read_as(Points::Space)
    }
}

impl<const D: usize> Mesh<D> {
    /// The vertices as points, with the faces.
    fn read_as(self, points: fn(Vec<[f64; D]>) -> Points) -> Reading {
        let Self { vertices, faces, left_out, notes, losses } = self.finish();
        let losses = losses.in_words();
        Reading { faces, notes, losses, ..Reading::without_columns(points(vertices), left_out) }
    }
}

#[cfg(test)]
mod tests;
