//! Answers with the bounding volumes of a level of a mesh's hierarchy: each triangle is in one of them, exactly.
//!
//! There is no certificate: every corner is held against the facets of the volume.

use std::collections::BTreeSet;

use super::check::Surface;
use crate::collision::placed::{Body, Frame};
use crate::exact::linear::Vector;
use crate::faces::containment::one_outside;
use crate::verdict::{Proved, Stop, Verdict};

/// A node of an answer: the zonotope of `center` and `generators` with the cube [−margin, margin]³ added to it is said
/// to contain the triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct ClaimedNode {
    /// The centre.
    pub center: Vec<f64>,
    /// The generators.
    pub generators: Vec<Vec<f64>>,
    /// The half-length of the cube.
    pub margin: f64,
    /// The triangles, by their positions from 0.
    pub triangles: Vec<usize>,
}

/// Checks that the nodes are no more than a level of a binary tree has, that each triangle is in one of them, and that
/// their volumes contain the triangles.
pub fn check_mesh_level(mesh: &Surface<'_>, level: usize, nodes: &[ClaimedNode]) -> Verdict<Proved> {
    check(mesh, level, nodes).into()
}

fn check(mesh: &Surface<'_>, level: usize, nodes: &[ClaimedNode]) -> Result<Proved, Stop> {
    let most = u32::try_from(level).ok().and_then(|level| 1_usize.checked_shl(level)).unwrap_or(usize::MAX);
    if nodes.len() > most || nodes.iter().any(|node| node.triangles.is_empty()) {
        return Err("there are more nodes than a level has, or nodes without triangles".into());
    }
    let mut triangles: Vec<usize> = nodes.iter().flat_map(|node| node.triangles.iter().copied()).collect();
    triangles.sort_unstable();
    if !triangles.into_iter().eq(0..mesh.triangles.len()) {
        return Err("not every triangle is in one node".into());
    }
    (1..).zip(nodes).try_for_each(|(number, node)| contains(mesh, number, node))?;
    Ok(Proved("each triangle is in one node, whose volume contains it"))
}

fn contains(mesh: &Surface<'_>, number: usize, node: &ClaimedNode) -> Result<(), Stop> {
    if node.margin.is_nan() || node.margin < 0.0 {
        return Err(format!("the margin of node {number} is below zero").into());
    }
    let corners: BTreeSet<usize> = node.triangles.iter().flat_map(|&at| mesh.triangles[at].iter().copied()).collect();
    let broken = || Stop::from("answered a question with a triangle whose corners are not there");
    let points = corners.into_iter().map(|at| mesh.vertices.get(at).map(Vec::as_slice));
    let points: Vec<&[f64]> = points.collect::<Option<_>>().ok_or_else(broken)?;
    let margins = (0..3).map(|axis| (0..3).map(|k| if k == axis { node.margin } else { 0.0 }).collect());
    let generators: Vec<Vec<f64>> = node.generators.iter().cloned().chain(margins).collect();
    let body = Body { center: &node.center, generators: &generators, pose: None };
    body.check_dimension(3)?;
    if points.iter().any(|point| point.len() != 3) {
        return Err("answered a question whose dimensions do not agree".into());
    }
    let frame = Frame::of(&[&body], &points)?;
    let center = frame.center(&body);
    let from_center =
        |point: &&[f64]| -> Vector { frame.point(point).iter().zip(&center).map(|(p, c)| p - c).collect() };
    let points: Vec<Vector> = points.iter().map(from_center).collect();
    let too_many = |_| Stop::Unchecked(format!("node {number} has too many facets and corners"));
    match one_outside(3, &frame.generators(&body), &points).map_err(too_many)? {
        None => Ok(()),
        Some(_) => Err(format!("node {number} does not contain its triangles").into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_in_a_box_by_hand() {
        let vertices = [vec![0.0; 3], vec![2.0, 2.0, 1.0]];
        let mesh = Surface { vertices: &vertices, triangles: &[vec![0, 1, 1]], pose: None };
        let node = ClaimedNode {
            center: vec![1.0, 1.0, 0.5],
            generators: vec![vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 0.5]],
            margin: 0.0,
            triangles: vec![0],
        };
        let verdict = |change: fn(&mut ClaimedNode)| {
            let mut node = node.clone();
            change(&mut node);
            check_mesh_level(&mesh, 0, &[node])
        };
        assert!(verdict(|_| ()).is_right());
        assert!(verdict(|node| node.generators[2][2] = 0.5f64.next_down()).is_wrong());
        assert!(verdict(|node| (node.generators[2][2], node.margin) = (0.25, 0.25)).is_right());
        assert!(verdict(|node| (node.generators[2][2], node.margin) = (0.25, 0.2)).is_wrong());
        assert!(verdict(|node| node.margin = -1.0).is_wrong());
        assert!(verdict(|node| node.margin = f64::INFINITY).is_wrong());
        assert!(verdict(|node| node.triangles = vec![1]).is_wrong());
        assert!(verdict(|node| node.triangles = vec![]).is_wrong());
        assert!(verdict(|node| node.center = vec![1.0]).is_wrong());
        assert!(check_mesh_level(&mesh, 0, &[node.clone(), node]).is_wrong());
    }

    #[test]
    fn a_level_has_at_most_its_number_of_nodes_and_none_of_them_is_empty() {
        let vertices = [vec![0.0; 3], vec![1.0, 0.0, 0.0]];
        let mesh = Surface { vertices: &vertices, triangles: &[vec![0, 0, 1], vec![0, 1, 1]], pose: None };
        let node = |triangles: &[usize]| ClaimedNode {
            center: vec![0.5, 0.0, 0.0],
            generators: vec![vec![0.5, 0.0, 0.0]],
            margin: 0.0,
            triangles: triangles.to_vec(),
        };
        let (both, apart) = ([node(&[0, 1])], [node(&[0]), node(&[1])]);
        assert!((0..3).all(|level| check_mesh_level(&mesh, level, &both).is_right()));
        assert!(check_mesh_level(&mesh, 0, &apart).is_wrong() && check_mesh_level(&mesh, 1, &apart).is_right());
        assert!(check_mesh_level(&mesh, 1, &[node(&[0, 1]), node(&[])]).is_wrong());
    }

    /// The vertex lies beyond a facet by less than 2^-960, where the generators are as long as 1.
    #[test]
    fn a_vertex_beyond_a_facet_by_far_less_than_the_body_is_large_is_outside() {
        let power = |exponent: i32| 2.0f64.powi(exponent);
        let y = 1.96875 * power(-959);
        let vertices = [vec![power(-45), y, y], vec![0.0, 0.0, f64::from_bits(1)]];
        let mesh = Surface { vertices: &vertices, triangles: &[vec![0, 1, 1]], pose: None };
        let node = |margin: f64| ClaimedNode {
            center: vec![0.0; 3],
            generators: vec![
                vec![1.0, -power(-916), 0.0],
                vec![0.0, power(-920), -power(-920)],
                vec![power(-41), 0.0, 0.0],
            ],
            margin,
            triangles: vec![0],
        };
        assert!(check_mesh_level(&mesh, 0, &[node(0.0)]).is_wrong());
        assert!(check_mesh_level(&mesh, 0, &[node(power(-957))]).is_right());
    }
}
