//! The body as a mesh.

use anyhow::{Context, bail};
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::faces::{FaceLattice, Faces, faces};

use crate::input::Body;

/// Bodies with more generators have too many facets for a mesh: n (n − 1) of them.
const MESH_GENERATOR_LIMIT: usize = 4000;

/// The faces of a body of space that has facets and no vertex with a coordinate above `largest`.
pub(in crate::commands) fn mesh(name: &str, body: &Body, largest: f64) -> anyhow::Result<FaceLattice> {
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
