//! The crate `parry3d-f64`: GJK on the library's fastest support map, and on explicit polyhedra.

use super::{Answer, Contender, Work};
use experiments::question::Question;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::details::intersection_test_support_map_support_map;
use parry3d_f64::shape::ConvexPolyhedron;
use parry3d_f64::transformation::try_convex_hull;
use zonotope::zonotope::{PreparedBody, Zonotope};

/// GJK on two zonotopes through their support maps, for which their generators are laid out beforehand.
pub const GJK: Contender = Contender { id: "parry_gjk", largest: usize::MAX, prepare: gjk };

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
