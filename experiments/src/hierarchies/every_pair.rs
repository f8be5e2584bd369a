//! The triangles of two copies of a mesh that meet, found by a look at every pair: what hierarchies are held to on
//! whole meshes.
//!
//! Each pair whose boxes, rounded and widened by more than the rounding, have a common point is decided by
//! [`zonotope::bvh::brute_force::all_pairs`], exactly and without a hierarchy. The boxes leave out what cannot meet, so
//! that a mesh of thousands of triangles takes seconds instead of days.

use zonotope::Pose;
use zonotope::bvh::{Mesh, brute_force};

/// Boxes are widened by this part of the largest coordinate that placing a corner adds up: more than its rounding.
const WIDENING: f64 = 1e-12;

/// The pairs of triangles of a mesh and of its placed copy that meet, in increasing order.
///
/// # Errors
/// A sentence, if corners of a triangle are no mesh.
pub fn pairs_by_every_pair(mesh: &Mesh, pose: &Pose) -> Result<Vec<[usize; 2]>, String> {
    let still = boxes(mesh, &Pose::IDENTITY);
    let moved = boxes(mesh, pose);
    let mut pairs = Vec::new();
    for (i, [low, high]) in still.iter().enumerate() {
        let is_near = |[from, to]: &[[f64; 3]; 2]| (0..3).all(|k| low[k] <= to[k] && from[k] <= high[k]);
        let near: Vec<usize> = (0..moved.len()).filter(|j| is_near(&moved[*j])).collect();
        if near.is_empty() {
            continue;
        }
        let (one, others) = (part(mesh, &[i])?, part(mesh, &near)?);
        pairs.extend(brute_force::all_pairs(&one, others.at(pose)).into_iter().map(|[_, at]| [i, near[at]]));
    }
    Ok(pairs)
}

/// Some triangles of a mesh as a mesh of their own.
fn part(mesh: &Mesh, triangles: &[usize]) -> Result<Mesh, String> {
    let vertices: Vec<[f64; 3]> = triangles.iter().flat_map(|triangle| mesh.corners(*triangle)).collect();
    let corners = (0..triangles.len() as u32).map(|triangle| [3 * triangle, 3 * triangle + 1, 3 * triangle + 2]);
    Mesh::new(vertices, corners.collect()).map_err(|error| error.to_string())
}

/// The widened box of each placed triangle.
fn boxes(mesh: &Mesh, pose: &Pose) -> Vec<[[f64; 3]; 2]> {
    let (matrix, translation) = (pose.matrix(), pose.translation());
    let placed = |v: &[f64; 3]| {
        [0, 1, 2].map(|i| {
            let terms = [matrix[i][0] * v[0], matrix[i][1] * v[1], matrix[i][2] * v[2], translation[i]];
            (terms.iter().sum::<f64>(), terms.iter().map(|term| term.abs()).sum::<f64>() * WIDENING)
        })
    };
    let corners: Vec<[(f64, f64); 3]> = mesh.vertices().iter().map(placed).collect();
    let of_triangle = |triangle: &[u32; 3]| {
        let end = |choose: fn(f64, f64) -> f64, from: f64, sign: f64| {
            [0, 1, 2].map(|axis| {
                let ends = triangle.iter().map(|corner| corners[*corner as usize][axis]);
                ends.map(|(at, width)| at + sign * width).fold(from, choose)
            })
        };
        [end(f64::min, f64::INFINITY, -1.0), end(f64::max, f64::NEG_INFINITY, 1.0)]
    };
    mesh.triangles().iter().map(of_triangle).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hierarchies::{TouchingPoses, mesh};

    #[test]
    fn leaving_out_far_boxes_changes_no_pair() {
        let whole = mesh("spring").expect("it is a mesh");
        let some = part(&whole, &(0..whole.triangles().len()).step_by(40).collect::<Vec<_>>()).expect("a mesh");
        for touching in TouchingPoses::of(&some, 6, 2) {
            for pose in [touching.at_contact, touching.one_step_apart] {
                let truth = brute_force::all_pairs(&some, some.at(&pose));
                assert_eq!(pairs_by_every_pair(&some, &pose).expect("pairs"), truth);
            }
        }
    }
}
