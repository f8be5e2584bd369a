//! A mesh of a file as a question has it.

use std::path::Path;

use anyhow::bail;
use batch::json::vector_to_json;
use batch::placement::{Placement, nearest};
use serde_json::{Value, json};

use super::faces::triangles_of;
use crate::commands::asked::floats;
use crate::commands::table::counted;
use crate::commands::usage::{read_telling, tell};
use crate::input::{Format, Place, PointSource, Points, Problem, Wanted};

/// A mesh that was read.
pub(in crate::commands) struct Read {
    pub(in crate::commands) question: Value,
    pub(in crate::commands) vertices: usize,
    pub(in crate::commands) triangles: usize,
    pub(in crate::commands) format: Option<Format>,
    pub(in crate::commands) sha256: String,
}

impl Read {
    /// Reads the vertices of a file and its faces, cut into triangles.
    pub(in crate::commands) fn of(
        file: &Path,
        format: Option<Format>,
        pose: Option<Placement>,
    ) -> anyhow::Result<Self> {
        let source = PointSource { format, ..PointSource::of_file(file.to_path_buf()) };
        let no_triangles = source.known_format().filter(|format| !format.is_mesh());
        let reading = match (read_telling(&source, Wanted::Any), no_triangles) {
            (Err(error), Some(_)) if error.problem.is_of_file() => return Err(error.into()),
            (_, Some(format)) => return Err(Problem::NoTriangles(format.to_string()).at(file, Place::File).into()),
            (reading, None) => reading?,
        };
        if let Some(remarks) = reading.remarks() {
            tell(&format!("{}: {remarks}", file.display()));
        }
        let Points::Space(vertices) = &reading.points else {
            let coordinates = counted(reading.points.dimension(), "coordinate", "coordinates");
            bail!("{}: holds vertices with {coordinates}; meshes of space, with three, are taken", file.display());
        };
        let mut overlapping = 0_usize;
        let mut cut = |face: &[usize]| {
            triangles_of(face, vertices).unwrap_or_else(|triangles| {
                overlapping += 1;
                triangles
            })
        };
        let triangles: Vec<[usize; 3]> = reading.faces.iter().flat_map(|face| cut(face)).collect();
        if overlapping > 0 {
            let faces = counted(overlapping, "face is", "faces are");
            let why = "though no corner sees all of it, so triangles lie outside of it";
            tell(&format!("{}: {faces} cut into triangles from the first corner, {why}", file.display()));
        }
        if triangles.is_empty() {
            return Err(Problem::NoFaces.at(file, Place::File).into());
        }
        let vertices: Vec<Value> = vertices.iter().map(|vertex| vector_to_json(vertex)).collect();
        let mut question = json!({"vertices": vertices, "triangles": triangles});
        if let Some(pose) = pose {
            question["pose"] = pose.to_json();
        }
        let (vertices, triangles) = (vertices.len(), triangles.len());
        Ok(Self { question, vertices, triangles, format: reading.format, sha256: reading.sha256 })
    }

    /// The same with the vertices where a pose puts them, each rounded to the nearest doubles.
    pub(in crate::commands) fn in_doubles(
        file: &Path,
        format: Option<Format>,
        pose: Option<&Placement>,
    ) -> anyhow::Result<Self> {
        let mut read = Self::of(file, format, None)?;
        let Some(pose) = pose.map(Placement::exact) else { return Ok(read) };
        for vertex in read.question["vertices"].as_array_mut().into_iter().flatten() {
            let image = nearest(&pose.point(&floats(vertex)));
            if !image.iter().all(|c| c.is_finite()) {
                bail!("{}: the pose puts the mesh beyond the range of doubles", file.display());
            }
            *vertex = vector_to_json(&image);
        }
        Ok(read)
    }
}
