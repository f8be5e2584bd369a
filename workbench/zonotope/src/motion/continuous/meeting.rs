//! The proof that two moving bodies have a common point at one time: coefficients for the bodies as they are rounded
//! there, held to the exact placements.

use crate::collision::Witness;
use crate::motion::arc::{Arc, displacement};
use crate::motion::bernstein::multiple;
use crate::motion::quaternion::{image, polar_rotation};
use crate::motion::scalar::Scalar;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{cyclic_cross_products, dot};
use crate::zonotope::Zonotope;

/// A linear system for three coefficients, all times a positive number.
struct System<T> {
    columns: [[T; 3]; 3],
    right: [T; 3],
    /// That number.
    scale: T,
}

/// Whether the coefficients prove a common point at the placements of a rational motion.
pub(super) fn is_proved(bodies: [&Zonotope<3>; 2], arcs: [&Arc<Dyadic>; 2], witness: &Witness) -> bool {
    let Some(System { columns: [a, b, c], right, .. }) = system(bodies, arcs, witness) else { return false };
    let cross_products = cyclic_cross_products(&a, &b, &c);
    let determinant = dot(&a, &cross_products[0]).abs();
    !determinant.is_zero() && cross_products.iter().all(|row| dot(row, &right).abs() <= determinant)
}

/// Whether they prove it with room to spare in doubles, for placements of which the angles are off by at most so much
/// and all points of both bodies together by at most so much.
pub(super) fn is_certain(
    bodies: [&Zonotope<3>; 2],
    arcs: [&Arc<Bounded>; 2],
    witness: &Witness,
    angles_off: [f64; 2],
    margin: f64,
) -> bool {
    let Some(System { mut columns, mut right, scale }) = system(bodies, arcs, witness) else { return false };
    let first = bodies[0].generators().len();
    for (column, &index) in columns.iter_mut().zip(&witness.basis) {
        let off = angles_off[usize::from(index >= first)];
        // the vector's length is at most the sum of the coordinates' magnitudes
        let length: f64 = column.iter().map(|c| Bounded::magnitude(*c)).sum();
        column.iter_mut().for_each(|c| c.error += 2.0 * off * length);
    }
    right.iter_mut().for_each(|c| c.error += margin * Bounded::magnitude(scale));
    let cross_products = cyclic_cross_products(&columns[0], &columns[1], &columns[2]);
    let determinant = dot(&columns[0], &cross_products[0]);
    let limit = Scalar::magnitude(&determinant);
    limit.is_positive() && cross_products.iter().all(|row| dot(row, &right).is_within(limit))
}

/// The system of the basis: its generators as they are placed, and what the other coefficients leave of the path from
/// one centre to the other. `None` where the basis is not of three.
fn system<T: Scalar>(bodies: [&Zonotope<3>; 2], arcs: [&Arc<T>; 2], witness: &Witness) -> Option<System<T>> {
    let basis: [usize; 3] = witness.basis.as_slice().try_into().ok()?;
    let [a, b] = arcs;
    let squares = arcs.map(|arc| dot(&arc.turns[0], &arc.turns[0]));
    let rotations = arcs.map(|arc| polar_rotation(&arc.turns[0], &arc.turns[0]));
    let weight = a.weight.times(&b.weight);
    let scale = squares[0].times(&squares[1]).times(&weight);
    // a vector of one body is turned with its own square, and times the other's
    let factors = [squares[1].times(&weight), squares[0].times(&weight)];
    let first = bodies[0].generators().len();
    let mut sums: [[T; 3]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| T::ZERO));
    let coefficients = witness.coefficients.iter().enumerate().filter(|(i, _)| !basis.contains(i));
    for (index, coefficient) in coefficients {
        let (body, own) = if index < first { (0, index) } else { (1, index - first) };
        let generator = bodies[body].generators()[own];
        for (sum, c) in sums[body].iter_mut().zip(generator) {
            *sum = sum.plus(&T::of(*coefficient).times(&T::of(c)));
        }
    }
    let placed = |body: usize, v: &[T; 3]| multiple(&factors[body], &image(&rotations[body], v));
    let columns = basis.map(|index| {
        let (body, own) = if index < first { (0, index) } else { (1, index - first) };
        placed(body, &bodies[body].generators()[own].map(T::of))
    });
    // the arms are times their own weight already
    let arm = |body: usize, other: &T| {
        let arm = arcs[body].arm_of(&bodies[body].center());
        let square = &squares[1 - body];
        multiple(&square.times(other), &image(&rotations[body], &arm))
    };
    let path = multiple(&squares[0].times(&squares[1]), &displacement(a, b)[0]);
    let [from, to] = [arm(0, &b.weight), arm(1, &a.weight)];
    let [own, others] = [placed(0, &sums[0]), placed(1, &sums[1])];
    let right = std::array::from_fn(|k| path[k].plus(&to[k]).minus(&from[k]).minus(&own[k]).minus(&others[k]));
    Some(System { columns, right, scale })
}
