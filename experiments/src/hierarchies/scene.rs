//! A mesh with what all volumes are asked about: searched boxes and the poses, made once and kept.
//!
//! The poses are found by distances through the boxes, which take longer than the questions; every volume of a mesh is
//! asked about the same ones. What is kept depends on the name, the number of poses and the seed alone, so that answers
//! are the same whichever volume comes first.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use zonotope::bvh::{Bvh, Mesh, OrientedBox};

use super::approach::{Placed, poses};
use super::mesh;

/// A mesh and the poses of its copy.
#[derive(Debug)]
pub struct Scene {
    /// The mesh.
    pub mesh: Mesh,
    /// Its hierarchy of searched boxes, with which the others are compared.
    pub boxes: Bvh<OrientedBox>,
    /// The poses.
    pub placed: Vec<Placed>,
}

type Kept = BTreeMap<(String, usize, u64), Arc<Scene>>;

static KEPT: Mutex<Kept> = Mutex::new(BTreeMap::new());

/// The mesh called `name` with `count` poses of its copy.
///
/// # Errors
/// If there is no such mesh.
pub fn scene(name: &str, count: usize, seed: u64) -> Result<Arc<Scene>, String> {
    let key = (name.to_owned(), count, seed);
    let kept = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(scene) = kept().get(&key) {
        return Ok(Arc::clone(scene));
    }
    // not under the lock: a build shares its work with other threads, and one of them may wait for the lock
    let mesh = mesh(name)?;
    let boxes = Bvh::<OrientedBox>::build(&mesh);
    let placed = poses(&boxes, count, seed);
    let made = Arc::new(Scene { mesh, boxes, placed });
    Ok(Arc::clone(kept().entry(key).or_insert(made)))
}
