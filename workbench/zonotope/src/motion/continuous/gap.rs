//! Bounds from below of the gap between two moving bodies along a direction that may turn with one of them: the
//! coefficients of a polynomial in the time of a stretch.
//!
//! Let |q_a|² and |q_b|² be the squares of both quaternions, positive polynomials. Times their product the gap
//! u · (c_b − c_a) − Σ |u · g| is a polynomial where generators keep their sign; where one changes its sign,
//! |Σ B_i x_i| ≤ Σ B_i |x_i| over the Bernstein polynomials B_i bounds it. So scaled Bernstein coefficients of degree 5
//! that are all positive, or those of its halves, prove that the bodies are disjoint during the whole stretch.
//!
//! | direction | at the time s | reaches of the first and the second body |
//! |---|---|---|
//! | fixed in space | u | 3 + 3 support values |
//! | fixed in the first body | R_a u | 1 + 5 |
//! | fixed in the second body | R_b u | 5 + 1 |
//! | normal to two edges | R_a e × R_b f | 5 + 5 |

use std::cell::OnceCell;
use std::ops::Deref;
use std::rc::Rc;

use super::SeparatingDirection;
use super::parts::body::{Body, Side};
use super::parts::margin::{self, Margin};
use super::parts::rates::Rates;
use crate::motion::arc::{Arc, displacement};
use crate::motion::bernstein::{convolution, difference, elevated, multiple, sum};
use crate::motion::quaternion::{image, transposed_image};
use crate::motion::scalar::ReachScalar;
use crate::numeric::bounded::Bounded;
use crate::numeric::linear::{cross, dot, sum_norm};

/// A direction leads away from the first body and to the second.
const SIDES: [Side; 2] = [Side::Away, Side::Toward];

/// A matrix by rows.
pub(super) type Matrix<T> = [[T; 3]; 3];

/// Two bodies on a stretch of their motions, with what does not depend on a direction. It is read as its
/// [`ArcPair`], too.
#[derive(Debug)]
pub(super) struct Stretch<'a, T> {
    pub(super) bodies: [Body<'a>; 2],
    /// A bound of the distance of the points of each body from their places on the stretch.
    pub(super) margins: [Margin; 2],
    pair: Rc<ArcPair<T>>,
}

/// The motions of two bodies on a stretch, with all that does not depend on the bodies: those of many bodies share it.
#[derive(Debug)]
pub(super) struct ArcPair<T> {
    pub(super) arcs: [Arc<T>; 2],
    /// |q_a|² and |q_b|².
    pub(super) squares: [[T; 3]; 2],
    /// Their product.
    pub(super) square: [T; 5],
    /// |q|² R of each body.
    pub(super) rotations: [[Matrix<T>; 3]; 2],
    /// The path from the first body's base to the second's, times both weights.
    pub(super) path: [[T; 3]; 2],
    /// |q_a|² |q_b|² R_a⁻¹ R_b, where it is asked for.
    seen: OnceCell<[Matrix<T>; 5]>,
}

/// A polynomial of degree 5 that bounds the gap times positive polynomials: its scaled Bernstein coefficients.
pub(super) type GapBound<T> = [T; 6];

impl<T> Deref for Stretch<'_, T> {
    type Target = ArcPair<T>;

    fn deref(&self) -> &ArcPair<T> {
        &self.pair
    }
}

impl<T: ReachScalar> ArcPair<T> {
    pub(super) fn new(arcs: [Arc<T>; 2]) -> Self {
        let squares = arcs.each_ref().map(Arc::square);
        Self {
            square: convolution(&squares[0], &squares[1]),
            squares,
            rotations: arcs.each_ref().map(Arc::rotations),
            path: displacement(&arcs[0], &arcs[1]),
            arcs,
            seen: OnceCell::new(),
        }
    }

    /// The rotations of the second body as the first one sees them, times both squares.
    pub(super) fn seen(&self) -> &[Matrix<T>; 5] {
        self.seen.get_or_init(|| self.arcs[0].rotations_seen(&self.arcs[1]))
    }
}

impl<'a, T: ReachScalar> Stretch<'a, T> {
    pub(super) fn new(bodies: [Body<'a>; 2], pair: Rc<ArcPair<T>>, margins: [Margin; 2]) -> Self {
        Self { bodies, margins, pair }
    }

    /// A bound of the part of the gap along a direction that the stretch shows too much.
    pub(super) fn margin_along(&self, direction: &SeparatingDirection) -> f64 {
        margin::along(&self.margins, direction)
    }

    /// The number of values of support functions in the bound along a direction.
    pub(super) fn support_evaluations(&self, direction: &SeparatingDirection) -> u64 {
        match direction {
            SeparatingDirection::Space(_) => self.arcs.iter().map(|arc| if arc.is_translation { 1 } else { 3 }).sum(),
            SeparatingDirection::First(_) | SeparatingDirection::Second(_) => 6,
            SeparatingDirection::Edges(_) => 10,
        }
    }

    /// The bound of the gap along a direction.
    pub(super) fn gap_along(&self, direction: &SeparatingDirection) -> GapBound<T> {
        let vector = |v: &[f64; 3]| v.map(T::of);
        let margin = margin::along(&self.margins, direction);
        match direction {
            SeparatingDirection::Space(u) => self.gap_in_space(&vector(u), margin),
            SeparatingDirection::First(u) => self.gap_in_frame(0, &vector(u), margin),
            // the gap from the first body to the second along u is that from the second to the first along −u
            SeparatingDirection::Second(u) => self.gap_in_frame(1, &vector(&u.map(|c| -c)), margin),
            SeparatingDirection::Edges([e, f]) => self.gap_of_edges(&vector(e), &vector(f), margin),
        }
    }

    fn gap_in_space(&self, u: &[T; 3], margin: f64) -> GapBound<T> {
        let [a, b] = &self.arcs;
        let [(to_first, first), (to_second, second)] = [0, 1].map(|i| self.along(i, u));
        let end_of_first = sum(&to_first, &multiple(&a.weight, &first));
        let end_of_second = difference(&to_second, &multiple(&b.weight, &second));
        let bases = difference(&multiple(&a.weight, &b.base_along(u)), &multiple(&b.weight, &a.base_along(u)));
        let apart: [T; 5] = convolution(&self.squares[0], &multiple(&a.weight, &end_of_second));
        let apart = difference(&apart, &convolution(&self.squares[1], &multiple(&b.weight, &end_of_first)));
        let apart = self.without(margin, apart);
        sum(&convolution(&self.square, &bases), &elevated(&apart))
    }

    /// |q|² times u · R (c + w), times the weight, and |q|² times the reach of a body along u.
    fn along(&self, i: usize, u: &[T; 3]) -> ([T; 3], [T; 3]) {
        let (arc, body, rotations) = (&self.arcs[i], &self.bodies[i], &self.rotations[i]);
        let arm = arc.arm_of(&body.center());
        if arc.is_translation {
            let pulled = transposed_image(&rotations[0], u);
            let [reach] = body.reaches(SIDES[i], std::array::from_ref(&pulled));
            let constant = |end: T| [end.clone(), end.plus(&end), end];
            return (constant(dot(&pulled, &arm)), constant(reach));
        }
        let pulled = rotations.each_ref().map(|m| transposed_image(m, u));
        (pulled.each_ref().map(|u| dot(u, &arm)), body.reaches(SIDES[i], &pulled))
    }

    /// The gap along a direction that is fixed in one body, from that body to the other.
    fn gap_in_frame(&self, own: usize, u: &[T; 3], margin: f64) -> GapBound<T> {
        let other = 1 - own;
        let (a, b) = (&self.arcs[own], &self.arcs[other]);
        let pull = if own == 0 { transposed_image } else { image };
        let pulled = self.seen().each_ref().map(|m| pull(m, u));
        let weight = a.weight.times(&b.weight);
        let [reach] = self.bodies[own].reaches(Side::Away, std::array::from_ref(u));
        let own_end = weight.times(&reach).plus(&b.weight.times(&dot(u, &a.arm_of(&self.bodies[own].center()))));
        let arm = b.arm_of(&self.bodies[other].center()).map(|c| c.times(&a.weight));
        let arms = pulled.each_ref().map(|u| dot(u, &arm));
        let apart = difference(&arms, &multiple(&weight, &self.bodies[other].reaches(Side::Toward, &pulled)));
        let apart = self.without(margin, difference(&apart, &multiple(&own_end, &self.square)));
        let turned = self.rotations[own].each_ref().map(|m| image(m, u));
        let bases: [T; 4] = (0..3).fold(std::array::from_fn(|_| T::ZERO), |total, k| {
            let along = turned.each_ref().map(|v| v[k].clone());
            let term = convolution(&along, &self.path.each_ref().map(|path| path[k].clone()));
            if own == 0 { sum(&total, &term) } else { difference(&total, &term) }
        });
        sum(&convolution(&self.squares[other], &bases), &elevated(&apart))
    }

    fn gap_of_edges(&self, e: &[T; 3], f: &[T; 3], margin: f64) -> GapBound<T> {
        let [a, b] = &self.arcs;
        let [first, second] = &self.bodies;
        let of_first = self.seen().each_ref().map(|m| cross(e, &image(m, f)));
        let of_second = self.seen().each_ref().map(|m| cross(&transposed_image(m, e), f));
        let arms = |body: &Body<'_>, arc: &Arc<T>, other: &Arc<T>, pulled: &[[T; 3]; 5]| -> [T; 5] {
            let arm = arc.arm_of(&body.center()).map(|c| c.times(&other.weight));
            pulled.each_ref().map(|u| dot(u, &arm))
        };
        let weight = a.weight.times(&b.weight);
        let reaches = sum(&first.reaches(SIDES[0], &of_first), &second.reaches(SIDES[1], &of_second));
        let apart = difference(&arms(second, b, a, &of_second), &arms(first, a, b, &of_first));
        let apart = self.without(margin, difference(&apart, &multiple(&weight, &reaches)));
        let [es, fs] = [(0, e), (1, f)].map(|(i, v): (usize, _)| self.rotations[i].each_ref().map(|m| image(m, v)));
        // det(R_a e, R_b f, path): over each coordinate of the cross product
        let bases: GapBound<T> = (0..3).fold(std::array::from_fn(|_| T::ZERO), |total, k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let along = |list: &[[T; 3]; 3], axis: usize| list.each_ref().map(|v| v[axis].clone());
            let minor: [T; 5] =
                difference(&convolution(&along(&es, i), &along(&fs, j)), &convolution(&along(&es, j), &along(&fs, i)));
            sum(&total, &convolution(&minor, &self.path.each_ref().map(|path| path[k].clone())))
        });
        sum(&bases, &elevated(&apart))
    }

    /// The bound of a gap without a margin.
    fn without(&self, margin: f64, bound: [T; 5]) -> [T; 5] {
        if margin == 0.0 {
            return bound;
        }
        let [a, b] = &self.arcs;
        difference(&bound, &multiple(&a.weight.times(&b.weight).times(&T::of(margin)), &self.square))
    }
}

impl Stretch<'_, Bounded> {
    /// The rates at which the bodies turn and go.
    pub(super) fn rates(&self) -> [Rates; 2] {
        [0, 1].map(|i| Rates::of(&self.arcs[i].rounded(), &self.bodies[i]))
    }

    /// A bound below the lesser of the gaps along a direction at both ends, or a number that is not positive.
    pub(super) fn least_end_gap(&self, direction: &SeparatingDirection) -> f64 {
        let gap = self.gap_along(direction);
        let weight = self.arcs[0].weight * self.arcs[1].weight;
        let at = |gap: Bounded, square: Bounded| (gap.value - gap.error) / (square * weight).magnitude();
        let [begin, end] = [at(gap[0], self.square[0]), at(gap[5], self.square[4])];
        // each bound went through a difference and a quotient
        if begin > 0.0 && end > 0.0 { begin.min(end).next_down().next_down() } else { 0.0 }
    }

    /// About how large the numbers are of which the places of a body's points are made, whatever of them cancels.
    pub(super) fn size_of(&self, i: usize) -> f64 {
        let (arc, body) = (self.arcs[i].rounded(), &self.bodies[i]);
        body.magnitude() + (arc.base_size + sum_norm(&arc.arm)) / arc.weight + sum_norm(&body.center())
    }
}
