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
        Format::Obj => obj::read,
        Format::Ply => ply::read,
        Format::Stl => stl::read,
        _ => off::read,
    };
    let mesh = read(content, skipping).map_err(|(problem, place)| problem.at(file, place))?;
    let Mesh { vertices, faces, left_out, notes, losses } = mesh.finish();
    Ok(Reading {
        faces,
        notes,
        losses: losses.in_words(),
        ..Reading::without_columns(Points::Space(vertices), left_out)
    })
}

#[cfg(test)]
mod tests;
