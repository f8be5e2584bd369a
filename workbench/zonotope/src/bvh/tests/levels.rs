//! The volumes of levels in the coordinates of their mesh hold their triangles, exactly.

use super::meshes::round;
use super::*;
use crate::zonotope::Zonotope;

/// The shape with its margin.
fn whole(node: &Enclosed) -> Zonotope<3> {
    let m = node.margin;
    let margins = [[m, 0.0, 0.0], [0.0, m, 0.0], [0.0, 0.0, m]];
    let generators = node.shape.generators().iter().copied().chain(margins).collect();
    Zonotope::new(node.shape.center(), generators).expect("a body")
}

fn sized(size: f64) -> Mesh {
    let mesh = round(5, 6, 1.5);
    mesh.with_vertices(mesh.vertices().iter().map(|v| v.map(|c| size * c)).collect()).expect("a mesh")
}

#[test]
fn each_triangle_is_in_one_volume_of_a_level() {
    for size in [1.0, 1e-3, 3e306, 1e-300, 1e-308, 1e-321] {
        let mesh = sized(size);
        for method in Method::SHAPED {
            for depth in [0, 1, 3, 60] {
                let level = method.level(&mesh, depth).expect("a zonotope").expect("a body of doubles");
                let mut triangles: Vec<usize> = level.iter().flat_map(|node| node.triangles.clone()).collect();
                triangles.sort_unstable();
                assert!(triangles.into_iter().eq(0..mesh.triangles().len()), "{method:?}");
                for node in &level {
                    let body = whole(node);
                    let corners = node.triangles.iter().flat_map(|&triangle| mesh.corners(triangle));
                    corners.for_each(|corner| assert_eq!(body.contains(corner), Ok(true), "{method:?}, {size}"));
                }
            }
        }
    }
}

#[test]
fn a_margin_takes_up_digits_that_are_lost_on_the_way_into_the_units() {
    let corners = vec![[1e300, 0.0, 0.0], [1e-300, 3e-310, 0.0], [0.0, 1e-20, 5e-324]];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [1, 2, 2]]).expect("a mesh");
    for method in Method::SHAPED {
        for node in method.level(&mesh, 1).expect("a zonotope").expect("a body of doubles") {
            let mut corners = node.triangles.iter().flat_map(|&triangle| mesh.corners(triangle));
            assert!(corners.all(|corner| whole(&node).contains(corner) == Ok(true)), "{method:?}");
        }
    }
}

#[test]
fn levels_are_those_of_the_tree() {
    let topology = Bvh::<Aabb>::build(&sized(1.0)).topology().clone();
    assert_eq!(topology.level(0), [0]);
    assert_eq!(topology.level(1), topology.nodes()[0].children(0).expect("children"));
    let leaves: Vec<usize> =
        (0..topology.nodes().len()).filter(|&at| topology.nodes()[at].children(at).is_none()).collect();
    assert_eq!(topology.level(usize::MAX), leaves);
}

#[test]
fn volumes_as_large_as_doubles_go_are_bodies() {
    let mesh = Mesh::new(vec![[f64::MAX; 3], [-f64::MAX; 3]], vec![[0, 1, 1]]).expect("a mesh");
    assert!(Method::Sphere.level(&mesh, 0).is_none() && Method::Dop26.level(&mesh, 0).is_none());
    for method in Method::SHAPED {
        match method.level(&mesh, 0).expect("a zonotope") {
            Ok(level) => assert_eq!(whole(&level[0]).contains([f64::MAX; 3]), Ok(true), "{method:?}"),
            Err(error) => assert_eq!(error, BeyondDoubles { node: 0 }),
        }
    }
}
