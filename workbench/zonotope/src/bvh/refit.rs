//! The volumes of all nodes of a tree, from the leaves up: for a build and after a deformation.

use super::build::Topology;
use super::volume::BoundingVolume;
use super::volumes::aabb::Aabb;
use crate::hull::in_space::hull_corners;
use crate::numeric::linear::euclidean_norm;

/// Fewer points than this go to a fit as they are: their hull would cost more than it spares.
const FEWEST_POINTS_OF_A_HULL: usize = 20;

/// The volume of each node that `fit` makes of its points and its position, and half the diagonal of its box.
///
/// A volume that is fitted to the hull gets the corners of the hull of both children's corners: they have the hull of
/// all points below.
pub(super) fn volumes<V: BoundingVolume>(
    topology: &Topology,
    points: &[[f64; 3]],
    triangles: &[[u32; 3]],
    fit: impl Fn(&[[f64; 3]], usize) -> V,
) -> (Vec<V>, Vec<f64>) {
    let count = topology.nodes.len();
    let mut fitted: Vec<Option<V>> = vec![None; count];
    let mut sizes = vec![0.0; count];
    // corners of the hulls of nodes whose parents are still to come
    let mut hulls: Vec<Vec<[f64; 3]>> = vec![Vec::new(); if V::IS_FITTED_TO_HULL { count } else { 0 }];
    for at in (0..count).rev() {
        let node = &topology.nodes[at];
        let corners = match node.children(at).filter(|_| V::IS_FITTED_TO_HULL) {
            Some([left, right]) => {
                let mut corners = std::mem::take(&mut hulls[left]);
                corners.append(&mut std::mem::take(&mut hulls[right]));
                corners
            }
            None => {
                let below = topology.order[node.range()].iter().flat_map(|&triangle| triangles[triangle as usize]);
                below.map(|vertex| points[vertex as usize]).collect()
            }
        };
        let corners = if V::IS_FITTED_TO_HULL { on_hull(corners) } else { corners };
        sizes[at] = euclidean_norm(&Aabb::around(&corners, 0).half());
        fitted[at] = Some(fit(&corners, at));
        if V::IS_FITTED_TO_HULL {
            hulls[at] = corners;
        }
    }
    (fitted.into_iter().map(|volume| volume.expect("every node was fitted")).collect(), sizes)
}

/// Points with the hull of all, each once.
fn on_hull(mut points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    points.sort_unstable_by(|a, b| {
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
