//! A mesh of a file as a question has it.

use std::path::Path;

use anyhow::{anyhow, bail};
use batch::json::vector_to_json;
use batch::placement::Placement;
use serde_json::{Value, json};

use super::faces::triangles_of;
use crate::commands::table::counted;
use crate::commands::usage::{read_telling, tell};
use crate::input::{Format, PointSource, Points, Wanted};

/// A mesh that was read.
pub(super) struct Read {
    pub(super) question: Value,
    pub(super) vertices: usize,
    pub(super) triangles: usize,
}

impl Read {
    /// Reads the vertices of a file and its faces, cut into triangles.
    pub(super) fn of(file: &Path, format: Option<Format>, pose: Option<Placement>) -> anyhow::Result<Self> {
        let source = PointSource { format, ..PointSource::of_file(file.to_path_buf()) };
        let reading = read_telling(&source, Wanted::Any)?;
        if let Some(remarks) = reading.remarks() {
            tell(&format!("{}: {remarks}", file.display()));
        }
        let Points::Space(vertices) = &reading.points else {
            bail!("{}: holds no mesh of space", file.display());
        };
        let mut overlapping = 0_usize;
        let mut cut = |face: &Box<[usize]>| {
            triangles_of(face, vertices).unwrap_or_else(|triangles| {
                overlapping += 1;
                triangles
            })
        };
        let triangles: Vec<[usize; 3]> = reading.faces.iter().flat_map(&mut cut).collect();
        if overlapping > 0 {
            let faces = counted(overlapping, "face is", "faces are");
            let why = "though no corner sees all of it, so triangles lie outside of it";
            tell(&format!("{}: {faces} cut into triangles from the first corner, {why}", file.display()));
        }
        if triangles.is_empty() {
            return Err(anyhow!("{}: holds no faces, only points", file.display()));
        }
        let vertices: Vec<Value> = vertices.iter().map(|vertex| vector_to_json(vertex)).collect();
        let mut question = json!({"vertices": vertices, "triangles": triangles});
        if let Some(pose) = pose {
            question["pose"] = pose.to_json();
        }
        Ok(Self { question, vertices: vertices.len(), triangles: triangles.len() })
    }
}
