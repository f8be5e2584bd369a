//! Files with a body of space as a mesh.

use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::Args;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, faces};

use crate::input::Body;
use crate::output::Results;

/// Bodies with more generators have too many facets for a mesh: n (n − 1) of them.
const MESH_GENERATOR_LIMIT: usize = 4000;

/// The meshes that are written, by format.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub(super) struct MeshFiles {
    /// Write a body of space as a mesh, Wavefront OBJ.
    #[arg(long, value_name = "FILE")]
    obj: Option<PathBuf>,
    /// Write a body of space as a mesh, PLY in text form.
    #[arg(long, value_name = "FILE")]
    ply: Option<PathBuf>,
    /// Write a body of space as a mesh of triangles, binary STL.
    #[arg(long, value_name = "FILE")]
    stl: Option<PathBuf>,
}

impl MeshFiles {
    /// The names of the formats, each with the file that is written in it.
    pub(super) fn named(&self) -> [(&'static str, Option<&PathBuf>); 3] {
        [("OBJ", self.obj.as_ref()), ("PLY", self.ply.as_ref()), ("STL", self.stl.as_ref())]
    }

    /// The files that are written.
    pub(super) fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.named().into_iter().filter_map(|(_, file)| file)
    }

    /// Adds the meshes of a body to the results of a command.
    pub(super) fn add_to<'a>(&'a self, results: &mut Results<'a>, name: &str, body: &Body) {
        let formats: [fn(&FaceLattice) -> Vec<u8>; 3] =
            [|mesh| mesh.to_obj().into_bytes(), |mesh| mesh.to_ply().into_bytes(), FaceLattice::to_stl];
        let largest = [f64::MAX, f64::MAX, f64::from(f32::MAX)];
        for (((_, file), content), largest) in self.named().into_iter().zip(formats).zip(largest) {
            results.add(file, || Ok(content(&mesh(name, body, largest)?)));
        }
    }
}

/// The faces of a body of space that has facets and no vertex with a coordinate above `largest`.
pub(super) fn mesh(name: &str, body: &Body, largest: f64) -> anyhow::Result<FaceLattice> {
    let space = |v: &Vec<f64>| <[f64; 3]>::try_from(v.as_slice()).ok();
    let (Some(center), Some(generators)) = (space(&body.center), body.generators.iter().map(space).collect()) else {
        bail!("{name}: only a body with three coordinates is written as a mesh");
    };
    if body.generators.len() > MESH_GENERATOR_LIMIT {
        bail!("{name}: {} generators, at most {MESH_GENERATOR_LIMIT} are written as a mesh", body.generators.len());
    }
    let body = Zonotope::new(center, generators)?;
    match faces(&body, &mut ()).with_context(|| name.to_owned())? {
        Faces::Flat(lattice) | Faces::Solid(lattice) => {
            let is_in_range = |coordinate: &f64| coordinate.abs() <= largest;
            if !lattice.points().iter().flatten().all(is_in_range) {
                bail!("{name}: a vertex has a coordinate above {largest:e}, the largest number of the mesh format");
            }
            Ok(lattice)
        }
        Faces::Point(_) | Faces::Segment(_) => bail!("{name}: a point or a segment has no facets to be written"),
    }
}
