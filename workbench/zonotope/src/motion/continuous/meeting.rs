//! The proof that two moving bodies have a common point at one time: coefficients for the bodies as they are rounded
//! there, held to the exact placements.

use crate::collision::Witness;
use crate::motion::arc::{Arc, displacement};
use crate::motion::bernstein::multiple;
use crate::motion::quaternion::{image, polar_rotation};
use crate::motion::scalar::Scalar;
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{cross, cyclic_cross_products, dot};
use crate::zonotope::Zonotope;

/// A generator joins a basis where it has more room than this, relative to its length: what is less may be rounding.
const LEAST_ROOM: f64 = 1e-9;

/// A linear system for the coefficients of a basis, all times a positive number.
struct System<T> {
    /// The generators of the basis and, where these are fewer than three, vectors orthogonal to them: the coefficients
    /// of these are 0 where the others solve the system.
    columns: [[T; 3]; 3],
    right: [T; 3],
    /// That number.
    scale: T,
}

/// Whether the coefficients prove a common point at the placements of a rational motion. Those that are not of the
/// basis are at most 1 in magnitude, as a location gives them.
pub(super) fn is_proved(bodies: [&Zonotope<3>; 2], arcs: [&Arc<Dyadic>; 2], witness: &Witness) -> bool {
    let Some(System { columns: [a, b, c], right, .. }) = system(bodies, arcs, witness) else { return false };
    let cross_products = cyclic_cross_products(&a, &b, &c);
    let determinant = dot(&a, &cross_products[0]).abs();
    let limit = |index: usize| if index < witness.basis.len() { determinant.clone() } else { Dyadic::zero() };
    let mut rows = cross_products.iter().enumerate();
    !determinant.is_zero() && rows.all(|(index, row)| dot(row, &right).abs() <= limit(index))
}

/// A bound above the distance of the points of both bodies that coefficients stand for.
pub(super) fn distance_above(bodies: [&Zonotope<3>; 2], arcs: [&Arc<Dyadic>; 2], coefficients: Vec<f64>) -> f64 {
    let coefficients = coefficients.into_iter().map(|c| c.clamp(-1.0, 1.0)).collect();
    // without a basis, what is left of the path between the centres is the vector from one point to the other
    let Some(System { right, scale, .. }) = system(bodies, arcs, &Witness { coefficients, basis: Vec::new() }) else {
        return f64::INFINITY;
    };
    let square = dot(&right, &right);
    if square.is_zero() {
        return 0.0;
    }
    // the quotient is off by little more than half a unit in its last place
    square.root_above().rounded_ratio(&scale).next_up().next_up()
}

/// The coefficients with those of the basis as they solve the system, rounded to nearest or beside that.
///
/// Pairs of doubles tell what most coefficients are rounded to, with less work than exact numbers.
pub(super) fn with_nearest_basis(bodies: [&Zonotope<3>; 2], arcs: [&Arc<Dyadic>; 2], mut witness: Witness) -> Witness {
    let solved = solved_in_pairs(bodies, arcs, &witness).or_else(|| solved_exactly(bodies, arcs, &witness));
    for (&index, coefficient) in witness.basis.iter().zip(solved.unwrap_or_default()) {
        witness.coefficients[index] = coefficient.clamp(-1.0, 1.0);
    }
    witness
}

/// The coefficients of a basis of three; `None` where pairs of doubles do not tell to which doubles they are rounded.
fn solved_in_pairs(bodies: [&Zonotope<3>; 2], arcs: [&Arc<Dyadic>; 2], witness: &Witness) -> Option<Vec<f64>> {
    if witness.basis.len() != 3 {
        return None;
    }
    let arcs = arcs.map(Arc::near::<BoundedDoubleDouble>);
    let System { columns: [a, b, c], right, .. } = system(bodies, arcs.each_ref(), witness)?;
    let cross_products = cyclic_cross_products(&a, &b, &c);
    let determinant = dot(&a, &cross_products[0]);
    cross_products.iter().map(|row| (dot(row, &right) / determinant).nearest_double()).collect()
}

/// The coefficients of a basis; `None` where its vectors are dependent.
fn solved_exactly(bodies: [&Zonotope<3>; 2], arcs: [&Arc<Dyadic>; 2], witness: &Witness) -> Option<Vec<f64>> {
    let System { columns: [a, b, c], right, .. } = system(bodies, arcs, witness)?;
    let cross_products = cyclic_cross_products(&a, &b, &c);
    let determinant = dot(&a, &cross_products[0]);
    if determinant.is_zero() {
        return None;
    }
    let (is_negative, magnitude) = (determinant.sign().is_lt(), determinant.abs());
    let solved = |row: &[Dyadic; 3]| {
        let ratio = dot(row, &right).rounded_ratio(&magnitude);
        if is_negative { -ratio } else { ratio }
    };
    Some(cross_products.iter().take(witness.basis.len()).map(solved).collect())
}

/// The same coefficients with a basis of three, to which generators are added that have room to either side and lead
/// away from those that are there; `None` where there are none.
pub(super) fn completed(bodies: [&Zonotope<3>; 2], arcs: [&Arc<f64>; 2], mut witness: Witness) -> Option<Witness> {
    let rotations = arcs.map(|arc| polar_rotation(&arc.turns[0], &arc.turns[0]));
    let placed = |(body, own): (usize, usize)| image(&rotations[body], &bodies[body].generators()[own]);
    let generators: Vec<[f64; 3]> = [0, 1]
        .into_iter()
        .flat_map(|body| (0..bodies[body].generators().len()).map(move |own| (body, own)))
        .map(placed)
        .collect();
    let mut span: Vec<[f64; 3]> = Vec::new();
    // Gram and Schmidt: unit vectors that span what the basis does
    let rest = |span: &[[f64; 3]], v: &[f64; 3]| {
        span.iter().fold(*v, |rest, unit| {
            let along = dot(unit, &rest);
            [0, 1, 2].map(|k| rest[k] - along * unit[k])
        })
    };
    let add = |span: &mut Vec<[f64; 3]>, v: &[f64; 3]| {
        let off = rest(span, v);
        let length = dot(&off, &off).sqrt();
        span.push(off.map(|c| c / length));
    };
    for &index in &witness.basis {
        add(&mut span, &generators[index]);
    }
    while witness.basis.len() < 3 {
        let room = |index: usize| {
            let off = rest(&span, &generators[index]);
            (1.0 - witness.coefficients[index].abs()) * dot(&off, &off).sqrt()
        };
        let best = (0..generators.len()).max_by(|&i, &j| room(i).total_cmp(&room(j)))?;
        let size = dot(&generators[best], &generators[best]).sqrt();
        if room(best).is_nan() || room(best) <= LEAST_ROOM * size {
            return None;
        }
        add(&mut span, &generators[best]);
        witness.basis.push(best);
    }
    witness.basis.sort_unstable();
    Some(witness)
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
    if witness.basis.len() != 3 {
        return false;
    }
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
/// one centre to the other. `None` where the basis has more than three.
fn system<T: Scalar>(bodies: [&Zonotope<3>; 2], arcs: [&Arc<T>; 2], witness: &Witness) -> Option<System<T>> {
    let basis = &witness.basis;
    if basis.len() > 3 {
        return None;
    }
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
    let column = |&index: &usize| {
        let (body, own) = if index < first { (0, index) } else { (1, index - first) };
        placed(body, &bodies[body].generators()[own].map(T::of))
    };
    let columns = filled_up(basis.iter().map(column).collect());
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

/// Up to three vectors, followed by vectors orthogonal to those before them: three in all.
fn filled_up<T: Scalar>(columns: Vec<[T; 3]>) -> [[T; 3]; 3] {
    let axes = [0, 1, 2].map(|axis| [0, 1, 2].map(|k| if k == axis { T::ONE } else { T::ZERO }));
    let mut columns = columns.into_iter();
    match [columns.next(), columns.next(), columns.next()] {
        [Some(a), Some(b), Some(c)] => [a, b, c],
        [Some(a), Some(b), _] => {
            let normal = cross(&a, &b);
            [a, b, normal]
        }
        [Some(a), ..] => {
            // an axis that the vector is not parallel to
            let is_along = |axis: &[T; 3]| cross(&a, axis).iter().all(|c| !c.magnitude().is_certainly_positive());
            let axis = axes.iter().find(|axis| !is_along(axis)).unwrap_or(&axes[0]);
            let normal = cross(&a, axis);
            let other = cross(&a, &normal);
            [a, normal, other]
        }
        _ => axes,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Motion;
    use crate::motion::constant_rate::Timing;

    #[test]
    fn pairs_of_doubles_solve_for_the_doubles_that_exact_numbers_solve_for() {
        let cube = Zonotope::new([0.1; 3], vec![[1.0, 0.2, 0.0], [0.0, 1.0, 0.3], [0.1, 0.0, 1.0]]).expect("finite");
        let other = cube.translated([1.0, 0.7, -0.4]).expect("finite");
        let turn = Motion::constant_rate([0.3, 0.0, 1.0], [1.0, 2.0, 3.0], 8.0, [0.5, 0.0, 0.1]).expect("an axis");
        let mut solved = 0;
        for step in 0..64 {
            let time = f64::from(step) / 63.0;
            let arcs = [&turn, &Motion::rest()].map(|motion| motion.exact_arc([time; 2], Timing::Timed));
            let coefficients = (0..6).map(|i| f64::from((step * 7 + i * 5) % 13) / 6.5 - 1.0).collect();
            let basis = [[0, 1, 2], [0, 2, 4], [1, 3, 5], [3, 4, 5]][step as usize % 4].to_vec();
            let witness = Witness { coefficients, basis };
            let exactly = solved_exactly([&cube, &other], arcs.each_ref(), &witness);
            if let Some(in_pairs) = solved_in_pairs([&cube, &other], arcs.each_ref(), &witness) {
                assert_eq!(Some(in_pairs), exactly, "{time}");
                solved += 1;
            }
        }
        assert!(solved > 60, "{solved}");
    }
}
