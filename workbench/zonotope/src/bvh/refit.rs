//! The volumes of all nodes of a tree, from the leaves up: for a build and after a deformation.

use super::build::{Node, Topology};
use super::volume::BoundingVolume;
use super::volumes::aabb::Aabb;
use crate::hull::in_space::hull_corners;
use crate::numeric::linear::euclidean_norm;

/// Fewer points than this go to a fit as they are: their hull would cost more than it spares.
const FEWEST_POINTS_OF_A_HULL: usize = 20;

/// Nodes of fewer triangles than this are fitted by one thread.
#[cfg(feature = "parallel")]
const FEWEST_TRIANGLES_OF_A_TASK: usize = 64;

/// The volume of each node that `fit` makes of its points and its position, and half the diagonal of its box.
///
/// A volume that is fitted to the hull gets the corners of the hull of both children's corners: they have the hull of
/// all points below.
pub(super) fn volumes<V: BoundingVolume>(
    topology: &Topology,
    points: &[[f64; 3]],
    triangles: &[[u32; 3]],
    fit: impl Fn(&[[f64; 3]], usize) -> V + Sync,
) -> (Vec<V>, Vec<f64>) {
    let mut fitted: Vec<Option<(V, f64)>> = vec![None; topology.nodes.len()];
    Nodes { topology, points, triangles, fit }.fit_from(0, &mut fitted);
    fitted.into_iter().map(|volume| volume.expect("every node was fitted")).unzip()
}

/// The nodes of a tree with the points of its triangles.
struct Nodes<'a, F> {
    topology: &'a Topology,
    points: &'a [[f64; 3]],
    triangles: &'a [[u32; 3]],
    fit: F,
}

impl<F> Nodes<'_, F> {
    /// Fits a node and all below it, for which there is a place each in the order of the nodes, and returns corners
    /// with the hull of the node's points.
    fn fit_from<V: BoundingVolume>(&self, at: usize, places: &mut [Option<(V, f64)>]) -> Vec<[f64; 3]>
    where
        F: Fn(&[[f64; 3]], usize) -> V + Sync,
    {
        let node = &self.topology.nodes[at];
        let below = match node.children(at) {
            Some([left, right]) => {
                let (of_left, of_right) = places[1..].split_at_mut(right - left);
                let (mut corners, mut others) =
                    join(node.range().len(), || self.fit_from(left, of_left), || self.fit_from(right, of_right));
                corners.append(&mut others);
                corners
            }
            None => self.corners_below(node),
        };
        let corners = match V::IS_FITTED_TO_HULL {
            true => on_hull(below),
            false => below,
        };
        let size = euclidean_norm(&Aabb::around(&corners, 0).half());
        places[0] = Some(((self.fit)(&corners, at), size));
        corners
    }

    fn corners_below(&self, node: &Node) -> Vec<[f64; 3]> {
        let below = self.topology.order[node.range()].iter().flat_map(|&triangle| self.triangles[triangle as usize]);
        below.map(|vertex| self.points[vertex as usize]).collect()
    }
}

/// Two tasks over the two parts of so many triangles, side by side where the crate is built for that and they are
/// worth it. The results do not depend on it.
fn join<A: Send, B: Send>(triangles: usize, a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    #[cfg(feature = "parallel")]
    if triangles >= FEWEST_TRIANGLES_OF_A_TASK {
        return rayon::join(a, b);
    }
    let _ = triangles;
    (a(), b())
}

/// Points with the hull of all, each once.
fn on_hull(mut points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    // the corners of each child are in order already: a stable sort merges both runs in one pass
    points.sort_by(|a, b| {
        let by_axis = |k: usize| a[k].total_cmp(&b[k]);
        by_axis(0).then_with(|| by_axis(1)).then_with(|| by_axis(2))
    });
    points.dedup();
    if points.len() < FEWEST_POINTS_OF_A_HULL {
        return points;
    }
    match hull_corners(&points) {
        Ok(corners) => corners.into_iter().map(|corner| points[corner]).collect(),
        // more points than a hull is taken of: all of them have it
        Err(_) => points,
    }
}
