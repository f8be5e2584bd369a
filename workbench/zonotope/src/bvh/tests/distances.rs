//! Distances between their bounds, against the least of all pairs of triangles.

use super::meshes::{cube, degenerate, random_poses, round};
use super::triangles::{distance::exact_square, meet_exactly};
use super::*;
use crate::Pose;
use crate::numeric::dyadic::Dyadic;

/// The distance by all pairs, in doubles from exact squares.
fn least(a: PlacedMesh<'_>, b: PlacedMesh<'_>) -> f64 {
    let corners = |mesh: &PlacedMesh<'_>| -> Vec<_> {
        (0..mesh.mesh().triangles().len()).map(|triangle| mesh.exact_corners(triangle)).collect()
    };
    let (a, b) = (corners(&a), corners(&b));
    let of_pair = |(a, b)| {
        let square = exact_square(a, b);
        if meet_exactly(a, b) { 0.0 } else { square.numerator.ratio(&square.denominator).sqrt() }
    };
    a.iter().flat_map(|a| b.iter().map(move |b| (a, b))).map(of_pair).fold(f64::INFINITY, f64::min)
}

fn holds<V: BoundingVolume>(a: &Mesh, b: &Mesh, pose: &Pose, truth: f64) {
    let [first, second] = [a, b].map(Bvh::<V>::build);
    let found = first.distance(second.at(pose));
    let rounding = 1e-14 * truth;
    assert!(found.lower <= truth + rounding && truth - rounding <= found.upper, "{} {found:?} {truth}", V::NAME);
    assert!(found.upper - found.lower <= 1e-3 * found.upper, "{} {found:?} {truth}", V::NAME);
    assert!(is_within(a.at(&Pose::IDENTITY), b.at(pose), found), "{} {found:?} {pose:?}", V::NAME);
}

/// Whether the triangles that are told are no farther apart than the upper bound, exactly.
fn is_within(a: PlacedMesh<'_>, b: PlacedMesh<'_>, found: MeshDistance) -> bool {
    let [i, j] = found.nearest;
    let (a, b) = (a.exact_corners(i), b.exact_corners(j));
    let (square, upper) = (exact_square(&a, &b), Dyadic::from_f64(found.upper));
    meet_exactly(&a, &b) || square.numerator <= &(&upper * &upper) * &square.denominator
}

/// Two triangles that are points, at neighbouring heights just below a power of two above a third triangle: as bounds
/// in the frame both distances are one number.
#[test]
fn the_triangles_that_are_told_are_as_near_as_the_upper_bound() {
    let far = 2f64.powi(-40).next_down();
    for heights in [[far, far.next_down()], [far.next_down(), far]] {
        let a = Mesh::new(vec![[0.0; 3], [0.75, 0.0, 0.0], [0.0, 0.75, 0.0]], vec![[0, 1, 2]]).expect("a triangle");
        let points = vec![[0.1, 0.1, heights[0]], [0.3, 0.1, heights[1]]];
        let b = Mesh::new(points, vec![[0; 3], [1; 3]]).expect("two points");
        for_each_volume!(holds(&a, &b, &Pose::IDENTITY, far.next_down()));
    }
}

#[test]
fn distances_are_between_their_bounds() {
    let (cube, torus) = (cube(), round(5, 6, 1.25));
    for pose in random_poses(30, 6.0, 21) {
        let truth = least(cube.at(&Pose::IDENTITY), torus.at(&pose));
        for_each_volume!(holds(&cube, &torus, &pose, truth));
    }
}

#[test]
fn small_gaps_are_found_to_a_thousandth() {
    let cube = cube();
    for gap in [f64::EPSILON, 1e-12, 1e-9, 1e-3, 1e9, 1e200] {
        let pose = Pose::from_translation([2.0 + 2.0 * gap, 0.5, 0.25]).expect("finite");
        let truth = pose.translation()[0] - 2.0;
        for_each_volume!(holds(&cube, &cube, &pose, truth));
    }
}

#[test]
fn distances_of_degenerate_meshes_are_between_their_bounds() {
    let meshes = degenerate();
    for (_, a) in &meshes {
        for (_, b) in &meshes {
            for pose in random_poses(2, 8.0, 22) {
                let truth = least(a.at(&Pose::IDENTITY), b.at(&pose));
                for_each_volume!(holds(a, b, &pose, truth));
            }
        }
    }
}

#[test]
fn distances_above_the_largest_double_have_no_upper_bound() {
    let point = |x: f64| meshes::mesh(&[[x, x, x]], &[[0, 0, 0]]);
    let [first, second] = [-f64::MAX, f64::MAX].map(|x| Bvh::<Aabb>::build(&point(x)));
    let found = first.distance(&second);
    assert!(found.lower > 1e308 && found.upper == f64::INFINITY, "{found:?}");
    let [first, second] = [0.0, 5e-324].map(|x| Bvh::<Aabb>::build(&point(x)));
    let found = first.distance(&second);
    assert!(found.lower == 5e-324 && found.upper == 1e-323, "{found:?}");
}

#[test]
fn distances_up_to_the_largest_double_have_an_upper_bound() {
    let points = |list: &[[f64; 3]]| meshes::mesh(list, &[[0, 1, 1]]);
    let largest = f64::MAX;
    let far = [[0.0, -0.3 * largest, 0.3 * largest], [-2.0, -3.0, 0.5 * largest]];
    let [first, second] =
        [&[[0.0, largest.next_down(), 0.5 * largest]; 2], &far].map(|list| Bvh::<Aabb>::build(&points(list)));
    let found = first.distance(&second);
    assert!(0.999 * largest < found.lower && found.lower <= found.upper && found.upper <= largest, "{found:?}");
}
