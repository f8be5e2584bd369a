//! The crate `parry3d-f64`: GJK on the library's fastest support map, and on explicit polyhedra.

use super::{Answer, Contender, Work};
use experiments::question::{Question, TURNS};
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query::details::{
    contact_support_map_support_map, distance_support_map_support_map, intersection_test_support_map_support_map,
};
use parry3d_f64::shape::ConvexPolyhedron;
use parry3d_f64::transformation::try_convex_hull;
use std::hint::black_box;
use zonotope::zonotope::{PreparedBody, Zonotope};

/// GJK on two zonotopes through their support maps, for which their generators are laid out beforehand.
pub const GJK: Contender = Contender { id: "parry_gjk", largest: usize::MAX, prepare: gjk };

/// GJK on two zonotopes in frames of their own, which are turned against each other.
pub const GJK_POSED: Contender = Contender { id: "parry_gjk_posed", largest: usize::MAX, prepare: gjk_posed };

/// The distance of two disjoint zonotopes, by GJK.
pub const DISTANCE: Contender = Contender { id: "parry_distance", largest: usize::MAX, prepare: distance };

/// The penetration depth of two overlapping zonotopes, by GJK and the expanding polytope algorithm.
pub const PENETRATION: Contender = Contender { id: "parry_epa", largest: usize::MAX, prepare: penetration };

/// GJK on two polyhedra made beforehand from all vertices.
pub const POLYHEDRON: Contender = Contender { id: "parry_polyhedron", largest: 20, prepare: polyhedron };

/// The two bodies around the origin, and where the second lies relative to the first.
fn placed(question: &Question) -> ([Zonotope<3>; 2], Pose) {
    let centred = question
        .bodies()
        .map(|body| Zonotope::new([0.0; 3], body.generators().to_vec()).expect("the body was valid where it lay"));
    let offset: [f64; 3] = std::array::from_fn(|i| question.to[i] - question.from[i]);
    (centred, Pose::from_translation(Vector::from_array(offset)))
}

fn gjk(question: &Question) -> Option<Work<'_>> {
    let (bodies, pose) = placed(question);
    let [a, b] = bodies.map(PreparedBody::new);
    Some(Box::new(move || Answer::Member(intersection_test_support_map_support_map(&pose, &a, &b))))
}

fn gjk_posed(question: &Question) -> Option<Work<'_>> {
    let [a, b] = question.turned().map(|(body, _)| PreparedBody::new(body));
    let offset: [f64; 3] = std::array::from_fn(|i| question.to[i] - question.from[i]);
    let [first, second] = TURNS.map(|[w, x, y, z]| Rotation::from_xyzw(x, y, z, w));
    let first = Pose::from_rotation(first);
    let second = Pose::from_parts(Vector::from_array(offset), second);
    Some(Box::new(move || {
        let pose = black_box(&first).inv_mul(black_box(&second));
        Answer::Member(intersection_test_support_map_support_map(&pose, &a, &b))
    }))
}

fn distance(question: &Question) -> Option<Work<'_>> {
    let (bodies, pose) = question.are_disjoint().then(|| placed(question))?;
    let [a, b] = bodies.map(PreparedBody::new);
    Some(Box::new(move || Answer::Member(distance_support_map_support_map(&pose, &a, &b) == 0.0)))
}

fn penetration(question: &Question) -> Option<Work<'_>> {
    let (bodies, pose) = question.overlap().then(|| placed(question))?;
    let [a, b] = bodies.map(PreparedBody::new);
    Some(Box::new(move || match contact_support_map_support_map(&pose, &a, &b, 0.0) {
        Some(contact) => Answer::Member(black_box(contact).dist < 0.0),
        None => Answer::Failed,
    }))
}

fn polyhedron(question: &Question) -> Option<Work<'_>> {
    let ([a, b], pose) = placed(question);
    let (a, b) = (explicit(&a)?, explicit(&b)?);
    Some(Box::new(move || Answer::Member(intersection_test_support_map_support_map(&pose, &a, &b))))
}

/// The convex hull of all sums ± g_1 ± … ± g_n; none where the other library finds no polyhedron.
fn explicit(body: &Zonotope<3>) -> Option<ConvexPolyhedron> {
    let mut sums = vec![Vector::ZERO];
    for g in body.generators() {
        let g = Vector::from_array(*g);
        sums = sums.iter().flat_map(|&sum| [sum + g, sum - g]).collect();
    }
    let (vertices, triangles) = try_convex_hull(&sums).ok()?;
    ConvexPolyhedron::from_convex_mesh(vertices, &triangles)
}
