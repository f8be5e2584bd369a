//! A mesh with what all volumes are asked about: searched boxes and the poses, made once and kept.
//!
//! The poses are found by distances through the boxes, which take longer than the questions; every volume of a mesh is
//! asked about the same ones. What is kept depends on the name, the number of poses and the seed alone, so that answers
//! are the same whichever volume comes first.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use zonotope::bvh::{Bvh, Mesh, OrientedBox};

use super::approach::{Placed, poses};
use super::meshes::mesh;

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hierarchies::{Asked, DISTANCES};

    #[test]
    fn a_scene_is_made_once_and_poses_are_at_their_distances() {
        let [first, again] = [0; 2].map(|_| scene("torus", 2, 7).expect("it is a mesh"));
        assert!(Arc::ptr_eq(&first, &again));
        assert!(scene("cube", 2, 7).is_err());
        for asked in Asked::all() {
            assert!(asked.tests(&first.boxes, &first.placed).is_ok(), "{}", asked.name());
        }
        let (low, high) = first.mesh.vertices().iter().fold(([f64::MAX; 3], [f64::MIN; 3]), |(low, high), v| {
            (std::array::from_fn(|k| v[k].min(low[k])), std::array::from_fn(|k| v[k].max(high[k])))
        });
        let size = (0..3).map(|k: usize| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
        for (placed, (at, wanted)) in
            first.placed.iter().flat_map(|p| DISTANCES.iter().enumerate().map(move |d| (p, d)))
        {
            let distance = first.boxes.distance(first.boxes.at(&placed.apart[at]));
            let share = [distance.lower, distance.upper].map(|d| d / (size * wanted));
            assert!(share[0] > 0.99 && share[1] < 1.01, "{share:?} of {wanted}");
        }
    }
}
