//! Bounds from below of the gap between two moving bodies along a direction that may turn with one of them: the
//! coefficients of a polynomial in the time of a stretch.
//!
//! Let |q_a|² and |q_b|² be the squares of both quaternions, positive polynomials. Times their product the gap
//! u · (c_b − c_a) − Σ |u · g| is a polynomial where generators keep their sign; where one changes its sign,
//! |Σ B_i x_i| ≤ Σ B_i |x_i| over the Bernstein polynomials B_i bounds it. So scaled Bernstein coefficients of degree 5
//! that are all positive prove that the bodies are disjoint during the whole stretch.
//!
//! | direction | at the time s | reaches of the first and the second body |
//! |---|---|---|
//! | fixed in space | u | 3 + 3 support values |
//! | fixed in the first body | R_a u | 1 + 5 |
//! | fixed in the second body | R_b u | 5 + 1 |
//! | normal to two edges | R_a e × R_b f | 5 + 5 |

use super::SeparatingDirection;
use crate::motion::arc::{Arc, displacement};
use crate::motion::bernstein::{convolution, difference, elevated, multiple, sum};
use crate::motion::quaternion::{image, transposed_image};
use crate::motion::scalar::Scalar;
use crate::numeric::linear::{cross, dot};
use crate::zonotope::Zonotope;

/// Two bodies on a stretch of their motions.
pub(super) struct Stretch<'a, T> {
    pub(super) bodies: [&'a Zonotope<3>; 2],
    pub(super) arcs: [Arc<T>; 2],
    /// A bound of how far a point of either body is from its place on the stretch, both together.
    pub(super) margin: f64,
}

/// A polynomial of degree 5 that bounds the gap times positive polynomials: its scaled Bernstein coefficients.
pub(super) type GapBound<T> = [T; 6];

impl<T: Scalar> Stretch<'_, T> {
    /// Whether a direction proves that the bodies are disjoint during the stretch.
    pub(super) fn is_separated_by(&self, direction: &SeparatingDirection) -> bool {
        self.gap_along(direction).iter().all(T::is_certainly_positive)
    }

    /// The bound of the gap along a direction.
    pub(super) fn gap_along(&self, direction: &SeparatingDirection) -> GapBound<T> {
        let vector = |v: &[f64; 3]| v.map(T::of);
        match direction {
            SeparatingDirection::Space(u) => self.gap_in_space(&vector(u)),
            SeparatingDirection::First(u) => gap_in_frame(self.bodies, self.arcs.each_ref(), &vector(u), self.margin),
            SeparatingDirection::Second(u) => {
                // u in the second body's frame is −u in that of the first body of the same question asked the other way
                let ([a, b], [p, q]) = (self.bodies, self.arcs.each_ref());
                gap_in_frame([b, a], [q, p], &vector(&u.map(|c| -c)), self.margin)
            }
            SeparatingDirection::Edges([e, f]) => self.gap_of_edges(&vector(e), &vector(f)),
        }
    }

    fn gap_in_space(&self, u: &[T; 3]) -> GapBound<T> {
        let [a, b] = &self.arcs;
        let [toward, away] = [0, 1].map(|i| {
            let (arc, body) = (&self.arcs[i], self.bodies[i]);
            let pulled = directions_in(arc, u);
            let arm = arc.arm_of(&body.center());
            let arms = pulled.each_ref().map(|u| dot(u, &arm));
            let reaches = multiple(&arc.weight, &reaches(body, &pulled, arc.is_translation));
            if i == 0 { sum(&arms, &reaches) } else { difference(&arms, &reaches) }
        });
        let bases = difference(&multiple(&a.weight, &b.base_along(u)), &multiple(&b.weight, &a.base_along(u)));
        let squares: [T; 5] = convolution(&a.square(), &b.square());
        let apart: [T; 5] = convolution(&a.square(), &multiple(&a.weight, &away));
        let apart = difference(&apart, &convolution(&b.square(), &multiple(&b.weight, &toward)));
        let margin = margin_along(&squares, &[u], self.margin, [a, b]);
        sum(&convolution(&squares, &bases), &elevated(&difference(&apart, &margin)))
    }

    fn gap_of_edges(&self, e: &[T; 3], f: &[T; 3]) -> GapBound<T> {
        let [a, b] = &self.arcs;
        let [first, second] = self.bodies;
        let seen = a.rotations_seen(b);
        let of_first = seen.each_ref().map(|m| cross(e, &image(m, f)));
        let of_second = seen.each_ref().map(|m| cross(&transposed_image(m, e), f));
        let arms = |body: &Zonotope<3>, arc: &Arc<T>, other: &Arc<T>, pulled: &[[T; 3]; 5]| -> [T; 5] {
            let arm = arc.arm_of(&body.center()).map(|c| c.times(&other.weight));
            pulled.each_ref().map(|u| dot(u, &arm))
        };
        let weight = a.weight.times(&b.weight);
        let reaches = sum(&reaches_of(first, &of_first), &reaches_of(second, &of_second));
        let apart = difference(&arms(second, b, a, &of_second), &arms(first, a, b, &of_first));
        let apart = difference(&apart, &multiple(&weight, &reaches));
        let bases = displacement(a, b);
        let [es, fs] = [(a, e), (b, f)].map(|(arc, v)| arc.rotations().each_ref().map(|m| image(m, v)));
        // det(R_a e, R_b f, path): over each coordinate of the cross product
        let bases: GapBound<T> = (0..3).fold(std::array::from_fn(|_| T::ZERO), |total, k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let along = |list: &[[T; 3]; 3], axis: usize| list.each_ref().map(|v| v[axis].clone());
            let minor: [T; 5] =
                difference(&convolution(&along(&es, i), &along(&fs, j)), &convolution(&along(&es, j), &along(&fs, i)));
            sum(&total, &convolution(&minor, &bases.each_ref().map(|path| path[k].clone())))
        });
        let squares: [T; 5] = convolution(&a.square(), &b.square());
        let margin = margin_along(&squares, &[e, f], self.margin, [a, b]);
        sum(&bases, &elevated(&difference(&apart, &margin)))
    }
}

/// The gap along a direction that is fixed in the first body.
fn gap_in_frame<T: Scalar>(
    [first, second]: [&Zonotope<3>; 2],
    [a, b]: [&Arc<T>; 2],
    u: &[T; 3],
    margin: f64,
) -> GapBound<T> {
    let seen = a.rotations_seen(b).each_ref().map(|m| transposed_image(m, u));
    let weight = a.weight.times(&b.weight);
    let squares: [T; 5] = convolution(&a.square(), &b.square());
    let own = weight.times(&reach(first, u)).plus(&b.weight.times(&dot(u, &a.arm_of(&first.center()))));
    let arm = b.arm_of(&second.center()).map(|c| c.times(&a.weight));
    let arms = seen.each_ref().map(|u| dot(u, &arm));
    let apart = difference(&arms, &multiple(&weight, &reaches_of(second, &seen)));
    let apart = difference(&apart, &multiple(&own, &squares));
    let apart = difference(&apart, &margin_along(&squares, &[u], margin, [a, b]));
    let turned = a.rotations().each_ref().map(|m| image(m, u));
    let path = displacement(a, b);
    let bases: [T; 4] = (0..3).fold(std::array::from_fn(|_| T::ZERO), |total, k| {
        let along: [T; 3] = turned.each_ref().map(|v| v[k].clone());
        sum(&total, &convolution(&along, &path.each_ref().map(|path| path[k].clone())))
    });
    sum(&convolution(&b.square(), &bases), &elevated(&apart))
}

/// |q|² Rᵀ u for the rotations of a stretch, as scaled Bernstein coefficients.
pub(super) fn directions_in<T: Scalar>(arc: &Arc<T>, u: &[T; 3]) -> [[T; 3]; 3] {
    arc.rotations().each_ref().map(|m| transposed_image(m, u))
}

/// Σ |u · g| over a body's generators.
fn reach<T: Scalar>(body: &Zonotope<3>, u: &[T; 3]) -> T {
    body.generators().iter().fold(T::ZERO, |sum, g| sum.plus(&dot(u, &g.map(T::of)).magnitude()))
}

/// The reaches along each of several directions.
fn reaches_of<T: Scalar, const K: usize>(body: &Zonotope<3>, directions: &[[T; 3]; K]) -> [T; K] {
    directions.each_ref().map(|u| reach(body, u))
}

/// The reaches along the directions of a stretch; one that only translates has multiples of one direction.
fn reaches<T: Scalar>(body: &Zonotope<3>, directions: &[[T; 3]; 3], is_translation: bool) -> [T; 3] {
    if is_translation {
        let end = reach(body, &directions[0]);
        return [end.clone(), end.plus(&end), end];
    }
    reaches_of(body, directions)
}

/// The margin times the length of a direction, a product of vectors that turn, and the squares and weights of both
/// stretches.
fn margin_along<T: Scalar>(squares: &[T; 5], factors: &[&[T; 3]], margin: f64, [a, b]: [&Arc<T>; 2]) -> [T; 5] {
    if margin == 0.0 {
        return std::array::from_fn(|_| T::ZERO);
    }
    // the sum of the magnitudes of the coordinates is at least the length
    let length = |v: &&[T; 3]| v.iter().fold(T::ZERO, |sum, c| sum.plus(&c.magnitude()));
    let factor = factors.iter().map(length).fold(T::of(margin), |longest, length| longest.times(&length));
    multiple(&a.weight.times(&b.weight).times(&factor), squares)
}
