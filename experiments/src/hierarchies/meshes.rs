//! The meshes of which hierarchies are measured, by name.

use families::meshes;
use zonotope::bvh::Mesh;

use crate::data;

/// The meshes: those of the data, and made ones.
pub const MESHES: [&str; 11] = [
    "teapot",
    "assimp_spider",
    "assimp_wuson",
    "cgal_cow",
    "cgal_fandisk",
    "torus",
    "knot",
    "bumps",
    "terrain",
    "spring",
    "needles",
];

/// The mesh called `name`.
///
/// # Errors
/// If there is none.
pub fn mesh(name: &str) -> Result<Mesh, String> {
    let (vertices, triangles) = if let Some(made) = meshes::find(name) {
        let surface = (made.make)();
        (surface.vertices, surface.triangles)
    } else {
        let found = data::mesh(name).ok_or_else(|| format!("no mesh is called {name}"))?;
        (found.vertices.clone(), found.triangles.iter().map(|t| t.map(|corner| corner as u32)).collect())
    };
    Mesh::new(vertices, triangles).map_err(|error| error.to_string())
}
