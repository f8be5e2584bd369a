//! The enclosing zonotope of a proof by shares: what shares leave of the generators becomes a parallelepiped along a
//! frame of directions.
//!
//! Coordinates in the frame are computed in doubles. What they miss of a vector is known exactly, and an upper bound on
//! the entries of the inverse matrix, rounded up once from rationals, turns it into a bound on the coordinates. So the
//! half-lengths are never too short, and no rational is computed for each generator.

use super::answer::{Containment, Reduced, ReductionError};
use super::shares::{Share, Shares};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, exact, rational};
use crate::numeric::linear::{dot, inverse};
use crate::numeric::outward::{at_least, axis_generators, fraction_at_least, fraction_at_most};
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::zonotope::Zonotope;

/// Bits of the coordinates of a frame's directions and of the half-lengths along them: few enough that their products
/// are doubles.
const SHORT_BITS: i64 = 26;

/// The edges of the parallelepiped that takes what shares leave.
#[derive(Debug, Clone, Copy)]
pub(super) enum Frame<const D: usize> {
    /// The coordinate axes.
    Axes,
    /// Directions of any length.
    Along([[f64; D]; D]),
}

/// The enclosing zonotope: given generators, and a parallelepiped as large as it has to be for what `shares` leave of
/// the body's generators. A frame that is singular, or too small for short numbers, gives way to the axes. O(n D²).
pub(super) fn covered<const D: usize>(
    body: &Zonotope<D>,
    mut generators: Vec<[f64; D]>,
    shares: Vec<Option<Share>>,
    frame: Frame<D>,
) -> Result<Reduced<D>, ReductionError> {
    let remainders = || remainders(body, &generators, &shares);
    let along = match frame {
        Frame::Axes => None,
        Frame::Along(directions) => edges_along(directions, remainders()),
    };
    let edges = along.unwrap_or_else(|| edges_along_axes(remainders()));
    let first = generators.len();
    generators.extend(edges);
    let frame = (first..generators.len()).collect();
    let body = Zonotope::new(body.center(), generators).map_err(|_| ReductionError::OutOfRange)?;
    Ok(Reduced { body, proof: Containment::Shares(Shares { shares, frame }) })
}

/// What the shares leave of the generators, exactly, without those of which they leave nothing.
fn remainders<'a, const D: usize>(
    body: &'a Zonotope<D>,
    generators: &'a [[f64; D]],
    shares: &'a [Option<Share>],
) -> impl Iterator<Item = [Dyadic; D]> + 'a {
    body.generators().iter().zip(shares).filter_map(|(v, share)| match share {
        None => Some(exact(*v)),
        Some(Share { generator, coefficient }) => {
            let b = &generators[*generator];
            let factor = Dyadic::from_f64(*coefficient);
            let left = |k: usize| &Dyadic::from_f64(v[k]) - &(&factor * &Dyadic::from_f64(b[k]));
            (*coefficient != 1.0 || b != v).then(|| std::array::from_fn(left))
        }
    })
}

fn edges_along_axes<const D: usize>(remainders: impl Iterator<Item = [Dyadic; D]>) -> Vec<[f64; D]> {
    let mut half_lengths: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    for left in remainders {
        add_magnitudes(&mut half_lengths, left);
    }
    axis_generators(half_lengths.each_ref().map(at_least)).collect()
}

fn add_magnitudes<const D: usize>(sums: &mut [Dyadic; D], terms: [Dyadic; D]) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum = &*sum + &term.abs();
    }
}

/// The edges along given directions; `None` if they are dependent or doubles do not hold the edges exactly.
fn edges_along<const D: usize>(
    directions: [[f64; D]; D],
    remainders: impl Iterator<Item = [Dyadic; D]>,
) -> Option<Vec<[f64; D]>> {
    let frame = directions.map(shortened);
    let by_rows: [[f64; D]; D] = std::array::from_fn(|k| std::array::from_fn(|l| frame[l][k]));
    let to_frame = inverse(D, &by_rows)?;
    let exact_rows = by_rows.map(|row| row.map(rational).to_vec()).to_vec();
    let exact_inverse = exact_linear::inverse(exact_rows)?;
    let exact_frame = frame.map(exact);
    let [mut coordinates, mut missed]: [[Dyadic; D]; 2] =
        std::array::from_fn(|_| std::array::from_fn(|_| Dyadic::zero()));
    for left in remainders {
        let rounded = left.each_ref().map(Dyadic::to_f64);
        let near = to_frame.map(|row| dot(&row, &rounded));
        if near.iter().any(|c| !c.is_finite()) {
            return None;
        }
        let near = near.map(Dyadic::from_f64);
        let rest = std::array::from_fn(|k| {
            let terms = exact_frame.iter().zip(&near).filter(|(_, c)| !c.is_zero());
            terms.fold(left[k].clone(), |rest, (direction, c)| &rest - &(&direction[k] * c))
        });
        add_magnitudes(&mut coordinates, near);
        add_magnitudes(&mut missed, rest);
    }
    let mut edges = Vec::with_capacity(D);
    for (l, direction) in frame.iter().enumerate() {
        let mut half_length = coordinates[l].clone();
        for (miss, entry) in missed.iter().zip(&exact_inverse[l]) {
            let magnitude = fraction_at_least(entry).max(-fraction_at_most(entry));
            if !magnitude.is_finite() {
                return None;
            }
            half_length = &half_length + &(miss * &Dyadic::from_f64(magnitude));
        }
        let half_length = short_at_least(&half_length)?;
        let edge = direction.map(|c| c * half_length);
        let is_exact = |k: usize| {
            edge[k].is_finite()
                && &Dyadic::from_f64(direction[k]) * &Dyadic::from_f64(half_length) == Dyadic::from_f64(edge[k])
        };
        if !(0..D).all(is_exact) {
            return None;
        }
        if half_length != 0.0 {
            edges.push(edge);
        }
    }
    Some(edges)
}

/// The direction of a vector in short numbers, the largest coordinate between 1/2 and 1 in magnitude.
fn shortened<const D: usize>(direction: [f64; D]) -> [f64; D] {
    let Some(exponent) = binary_exponent(largest_magnitude(&direction)) else { return direction };
    let short = |c: f64| scale_by_power_of_two(c, SHORT_BITS - 1 - i64::from(exponent)).round();
    direction.map(|c| scale_by_power_of_two(short(c), -SHORT_BITS))
}

/// A short number that is not below an exact one that is not negative; `None` beyond the doubles.
fn short_at_least(exact: &Dyadic) -> Option<f64> {
    let value = at_least(exact);
    let Some(exponent) = binary_exponent(value) else { return Some(0.0) };
    if !value.is_finite() {
        return None;
    }
    let shift = SHORT_BITS - 1 - i64::from(exponent);
    let short = scale_by_power_of_two(scale_by_power_of_two(value, shift).ceil(), -shift);
    (short.is_finite() && short >= value).then_some(short)
}
