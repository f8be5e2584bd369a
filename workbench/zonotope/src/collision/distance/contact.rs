//! Where bodies meet that are not disjoint: a point of both, and the faces that touch there.

use std::array;
use std::ops::Range;

use super::answer::{Feature, FeatureKind, Proximity};
use crate::collision::Witness;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::span::prism::Prism;
use crate::lad::of_generators::{ladder, solve};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, Span, dot, solve as solve_exactly};
use crate::zonotope::pose::Standing;
use crate::zonotope::query::Query;

/// Where two bodies meet.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact<const D: usize> {
    /// A point of both bodies, rounded: that of the first body with the coefficients of the witness.
    pub point: [f64; D],
    /// How they touch; none where the interiors meet.
    pub touching: Option<Touching<D>>,
}

/// A supporting hyperplane between two bodies that touch, and the faces that lie in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Touching<const D: usize> {
    /// The normal u of the hyperplane, exactly, of any length: u · p = h(u) for the displacement p of the centres and
    /// the support function h of the sum of the bodies. It points from the first body to the second.
    pub normal: [Rational; D],
    /// The face of the first body in the direction u and that of the second one in the direction −u: of bodies whose
    /// sum is flat, the whole bodies.
    pub features: [Feature; 2],
}

/// Where the bodies of a query meet, of which the proximity is known; none for disjoint ones. O(n), and the exact
/// optimum of the kernel for bodies that touch.
pub fn contact<const D: usize, P: Standing>(query: &Query<'_, D, P>, proximity: &Proximity<D>) -> Option<Contact<D>> {
    let witness = witness(proximity)?;
    let generators: Vec<[Dyadic; D]> = query.exact_generators().collect();
    let count = query.runs()[0].len();
    let [from, to] = query.ends();
    let p = array::from_fn(|k| &to[k] - &from[k]);
    let point = point(&from, &p, witness, &generators, count);
    let touching = is_touching(proximity).then(|| {
        let normal = || match (query.in_dimension::<3>(), query.at_rest()) {
            (Some(query), _) => facet_normal(&query),
            (None, query) => facet_normal(&Prism::over(&query?).query()),
        };
        touching(&generators, count, || normal().map(|normal| array::from_fn(|k| normal[k].clone())))
    });
    Some(Contact { point, touching })
}

fn witness<const D: usize>(proximity: &Proximity<D>) -> Option<&Witness> {
    match proximity {
        Proximity::Disjoint(_) => None,
        Proximity::Touching(witness) | Proximity::Overlapping(witness) => Some(witness),
    }
}

fn is_touching<const D: usize>(proximity: &Proximity<D>) -> bool {
    matches!(proximity, Proximity::Touching(_))
}

/// The point of the first body that the witness has for the displacement p, rounded once: center + Σ δ_i g_i over its
/// generators, the first so many, with the exact coefficients of the basis. Those in doubles would not do: a long
/// generator takes the point as far away as the last place of its coefficient.
fn point<const D: usize>(
    center: &[Dyadic; D],
    p: &[Dyadic; D],
    witness: &Witness,
    generators: &[[Dyadic; D]],
    count: usize,
) -> [f64; D] {
    let Witness { coefficients, basis } = witness;
    let (mut own, mut rest) = (center.clone(), p.clone());
    for (index, (&coefficient, g)) in coefficients.iter().zip(generators).enumerate() {
        if coefficient == 0.0 || basis.contains(&index) {
            continue;
        }
        let factor = Dyadic::from_f64(coefficient);
        for k in 0..D {
            let term = &factor * &g[k];
            rest[k] = &rest[k] - &term;
            if index < count {
                own[k] = &own[k] + &term;
            }
        }
    }
    let rational = |v: &[Dyadic; D]| -> Vec<Rational> { v.iter().map(Dyadic::to_rational).collect() };
    let columns: Vec<Vec<Rational>> = basis.iter().map(|&index| rational(&generators[index])).collect();
    let solved =
        solve_exactly(&columns, &rational(&rest)).expect("the basis of a witness makes up what the others leave");
    let mut point = own.map(|c| c.to_rational());
    for (&index, coefficient) in basis.iter().zip(solved).filter(|(index, _)| **index < count) {
        for (c, g) in point.iter_mut().zip(&generators[index]) {
            *c += &coefficient * g.to_rational();
        }
    }
    point.map(|c| c.to_f64().value())
}

/// How the bodies touch whose generators are given, those of the first body first; `facet_normal` finds the normal
/// where their sum is not flat.
fn touching<const D: usize>(
    generators: &[[Dyadic; D]],
    count: usize,
    facet_normal: impl FnOnce() -> Option<[Dyadic; D]>,
) -> Touching<D> {
    let is_zero = |v: &[Dyadic; D]| v.iter().all(Dyadic::is_zero);
    let span = Span::of(generators.iter().cloned(), D);
    let facet = if span.rank() < D { None } else { facet_normal() };
    let is_orthogonal = |v: &[Dyadic; D]| facet.as_ref().is_none_or(|u| dot(v, u).is_zero());
    let orthogonal: Vec<usize> =
        (0..generators.len()).filter(|&i| !is_zero(&generators[i]) && is_orthogonal(&generators[i])).collect();
    let feature = |range: Range<usize>| {
        let own: Vec<usize> = orthogonal.iter().copied().filter(|index| range.contains(index)).collect();
        let dimension = Span::of(own.iter().map(|&index| generators[index].clone()), D).rank();
        let generators = own.into_iter().map(|index| index - range.start).collect();
        Feature { kind: FeatureKind::of_dimension(dimension), generators }
    };
    let features = [feature(0..count), feature(count..generators.len())];
    let normal = match facet {
        Some(normal) => normal.map(|c| c.to_rational()),
        None => {
            let normal =
                span.annihilators().into_iter().next().and_then(|normal| <[Rational; D]>::try_from(normal).ok());
            normal.expect("vectors that do not span their space are all orthogonal to one")
        }
    };
    Touching { normal, features }
}

/// The outer normal of the facet of the sum that holds the displacement, which is on the boundary of a body that is not
/// flat.
fn facet_normal(query: &dyn KernelQuery) -> Option<ExactVector> {
    match solve(query, Goal::Gauge, &mut ()) {
        Optimum::Rounded(decided) => Some(ladder::exact_of(query, &query.exact(), &decided, &mut ()).direction),
        Optimum::Exact(exact) => Some(exact.direction),
        Optimum::Center | Optimum::Separated(_) | Optimum::Ended | Optimum::Flat(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::distance::FeatureKind::{Edge, Facet, Vertex};
    use crate::collision::distance::brute_force;
    use crate::collision::distance::by_support_simplex::proximity;
    use crate::numeric::exact_linear::rational;
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;

    const CUBE: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

    fn meeting<const D: usize>(a: &Zonotope<D>, b: &Zonotope<D>) -> Option<([f64; D], Option<[FeatureKind; 2]>)> {
        let query = Query::between(a, b);
        let contact = contact(&query, &proximity(&query, &mut ()))?;
        for body in [a, b] {
            let query = Query::of_point(contact.point, body).expect("finite");
            let off = brute_force::nearest_point(&query).squared_distance;
            assert!(off < rational(1e-30), "{:?} is no point of a body", contact.point);
        }
        let touching = contact.touching.map(|Touching { normal, features }| {
            let product =
                |v: &[f64; D]| v.iter().zip(&normal).fold(Rational::ZERO, |sum, (&c, u)| sum + rational(c) * u);
            let along = query.exact().iter().zip(&normal).fold(Rational::ZERO, |sum, (c, u)| sum + c.to_rational() * u);
            let magnitude = |x: Rational| if x < Rational::ZERO { -x } else { x };
            let reach = query.generators().fold(Rational::ZERO, |sum, g| sum + magnitude(product(g)));
            assert!(along == reach && normal.iter().any(|u| *u != Rational::ZERO));
            features.map(|feature| feature.kind)
        });
        Some((contact.point, touching))
    }

    fn body<const D: usize>(center: [f64; D], generators: &[[f64; D]]) -> Zonotope<D> {
        Zonotope::new(center, generators.to_vec()).expect("finite")
    }

    #[test]
    fn cubes_that_touch_by_hand() {
        let cube = body([0.0; 3], &CUBE);
        let kinds = |center, generators: &[[f64; 3]]| meeting(&cube, &body(center, generators)).map(|found| found.1);
        assert_eq!(kinds([2.0, 0.5, 0.25], &CUBE), Some(Some([Facet, Facet])));
        assert_eq!(kinds([1.0, 0.5, 0.25], &[]), Some(Some([Facet, Vertex])));
        assert_eq!(kinds([2.0, 0.5, 0.25], &[[1.0, 0.0, 0.0]]), Some(Some([Facet, Vertex])));
        assert_eq!(kinds([1.0, 0.5, 0.25], &[[0.0, 0.0, 1.0]]), Some(Some([Facet, Edge])));
        assert_eq!(kinds([0.5, 0.5, 0.25], &CUBE), Some(None), "the interiors meet");
        assert_eq!(kinds([3.0, 0.5, 0.25], &CUBE), None);
    }

    #[test]
    fn flat_sums_touch_with_all_of_the_bodies() {
        let [square, segment] = [body([0.0; 3], &CUBE[..2]), body([0.5, 0.25, 0.0], &CUBE[..1])];
        assert_eq!(meeting(&square, &segment).map(|found| found.1), Some(Some([Facet, Edge])));
        let point = body([0.5, 0.25, 0.0], &[]);
        assert_eq!(meeting(&point, &point), Some(([0.5, 0.25, 0.0], Some([Vertex, Vertex]))));
        let [interval, end] = [body([1.0], &[[2.0]]), body([3.0], &[])];
        assert_eq!(meeting(&interval, &end), Some(([3.0], Some([Vertex, Vertex]))));
    }

    #[test]
    fn in_the_plane_and_under_poses() {
        let square = body([0.0; 2], &[[1.0, 0.0], [0.0, 1.0]]);
        let diamond = body([2.0, 0.25], &[[0.5, 0.5], [0.5, -0.5]]);
        assert_eq!(meeting(&square, &diamond), Some(([1.0, 0.25], Some([Edge, Vertex]))));
        let cube = body([0.0; 3], &CUBE);
        let turned = Pose::new([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [2.0, 0.5, 0.0]).expect("finite");
        let query = Query::of_placed(cube.at(&Pose::IDENTITY), cube.at(&turned));
        let contact = contact(&query, &proximity(&query, &mut ())).expect("they touch");
        assert_eq!(contact.point[0], 1.0);
        let kinds = contact.touching.map(|touching| touching.features.map(|feature| feature.kind));
        assert_eq!(kinds, Some([Facet, Facet]));
    }
}
