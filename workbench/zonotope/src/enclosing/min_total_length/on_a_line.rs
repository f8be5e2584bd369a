//! The shortest segment of doubles around points on a line: a zonotope of one generator.
//!
//! The optimum is half the difference of the two ends around their middle. Where both are doubles, that is the answer.
//! Else a centre of doubles is sought on the line near its middle, by lattice reduction, and the least multiple of a
//! vector along the line that reaches both ends from there and is a vector of doubles. The segment lies on the line
//! exactly and contains the points exactly. It is longer than the optimum by what the doubles on the line cost: most
//! often rounding, but twice the optimum where the line holds few of them.

use std::cmp::Ordering;

use dashu_int::ops::{Abs, BitTest};

use crate::enclosing::fixed_directions::cheapest_center_along;
use crate::numeric::Rational;
use crate::numeric::dyadic::{Dyadic, remove_common_factor};
use crate::numeric::exact_linear::{Span, doubles, rational};
use crate::zonotope::Zonotope;

/// The vector along the line is taken with its longest coordinate near this power of two: so its shortest coordinates
/// underflow only where no multiple of the vector is one of doubles.
const TOP_EXPONENT: i64 = 1000;

/// A segment of doubles around points on a line, and an upper bound of its half-length. `None` if the points are all
/// equal or not on a line, if the vectors along the line are none of doubles, or if the length leaves their range.
pub(super) fn segment_around<const D: usize>(points: &[[f64; D]]) -> Option<(Zonotope<D>, f64)> {
    if differences(points).rank() != 1 {
        return None;
    }
    // The order of the coordinates is the order along the line.
    let order = |a: &&[f64; D], b: &&[f64; D]| a.partial_cmp(b).unwrap_or(Ordering::Equal);
    let ends = [points.iter().min_by(order)?, points.iter().max_by(order)?];
    let exact = ends.map(|end| end.map(Dyadic::from_f64));
    let sum: [Dyadic; D] = std::array::from_fn(|c| &exact[1][c] + &exact[0][c]);
    let apart: [Dyadic; D] = std::array::from_fn(|c| &exact[1][c] - &exact[0][c]);
    let half = |v: &[Dyadic; D]| doubles(&v.clone().map(|c| c.scaled(-1)));
    let (center, generator) = match (half(&sum), half(&apart)) {
        (Some(center), Some(generator)) => (center, generator),
        _ => off_the_optimum(ends, &apart)?,
    };
    let segment = Zonotope::new(center, vec![generator]).ok()?;
    let length = segment.total_length();
    length.is_finite().then_some((segment, length))
}

/// The span of the differences of points, exactly.
pub(super) fn differences<const D: usize>(points: &[[f64; D]]) -> Span {
    let first = points.first().map_or([0.0; D], |first| *first);
    let difference =
        |p: &[f64; D]| -> [Dyadic; D] { std::array::from_fn(|c| Dyadic::from_f64(p[c]) - Dyadic::from_f64(first[c])) };
    Span::of(points.iter().map(difference), D)
}

/// A centre and a generator in doubles along the line through two ends, which are `apart`.
fn off_the_optimum<const D: usize>(ends: [&[f64; D]; 2], apart: &[Dyadic; D]) -> Option<([f64; D], [f64; D])> {
    let mut along = apart.clone();
    remove_common_factor(&mut along);
    let top = along.iter().filter_map(Dyadic::binary_exponent).max()?;
    let along = along.map(|c| c.scaled(TOP_EXPONENT - top));
    let exact = ends.map(|end| end.map(rational));
    let middle = std::array::from_fn(|c| (&exact[0][c] + &exact[1][c]) / Rational::from(2));
    let center = cheapest_center_along(&ends.map(|end| *end), &doubles(&along)?, &middle)?;
    let axis = (0..D).find(|&c| !along[c].is_zero())?;
    let multiple = |end: &[Rational; D]| ((&end[axis] - rational(center[axis])) / along[axis].to_rational()).abs();
    let least = multiple(&exact[0]).max(multiple(&exact[1]));
    // The fewer bits the multiple has, the fewer its products with the coordinates need.
    let multiples = (1..=f64::MANTISSA_DIGITS as i64).rev().map(|bits| of_bits_at_least(&least, bits));
    let generators = multiples.map(|factor| doubles(&along.each_ref().map(|c| c * &factor)));
    generators.flatten().next().map(|generator| (center, generator))
}

/// A number of about so many bits that is not below a positive fraction, and near it.
pub(super) fn of_bits_at_least(fraction: &Rational, bits: i64) -> Dyadic {
    let exponent = fraction.numerator().bit_len() as i64 - fraction.denominator().bit_len() as i64;
    let unit = Dyadic::new(1.into(), exponent - bits);
    let units = (fraction / unit.to_rational()).ceil();
    Dyadic::new(units, exponent - bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn around<const D: usize>(points: &[[f64; D]]) -> Option<([f64; D], Vec<[f64; D]>)> {
        let (body, length) = segment_around(points)?;
        assert!(points.iter().all(|&p| body.contains(p) == Ok(true)), "{points:?} {body:?}");
        assert!(length >= body.generators()[0].iter().fold(0.0, |most: f64, c| most.max(c.abs())));
        Some((body.center(), body.generators().to_vec()))
    }

    #[test]
    fn half_the_difference_around_the_middle_where_both_are_doubles() {
        assert_eq!(around(&[[0.0, 0.0], [1.0, 3.0]]), Some(([0.5, 1.5], vec![[0.5, 1.5]])));
        let collinear = [[2.0, -6.0, 4.0], [0.0, 0.0, 4.0], [1.0, -3.0, 4.0], [0.0, 0.0, 4.0]];
        assert_eq!(around(&collinear), Some(([1.0, -3.0, 4.0], vec![[1.0, -3.0, 0.0]])));
        let largest = [[f64::MAX, -f64::MAX], [-f64::MAX, f64::MAX]];
        // the half-length itself leaves the range of doubles
        assert_eq!(around(&largest), None);
        assert_eq!(around(&[[f64::MAX], [-f64::MAX]]), Some(([0.0], vec![[f64::MAX]])));
    }

    #[test]
    fn the_nearest_segment_of_doubles_elsewhere() {
        let least = f64::from_bits(1);
        assert_eq!(around(&[[3.0, 0.0], [3.0, least]]).map(|(_, g)| g), Some(vec![[0.0, least]]));
        // between neighbours there is no middle: the segment is twice as long as the optimum
        let near = [[1.0, 1.0], [1f64.next_up(), 1f64.next_up()]];
        assert_eq!(around(&near).map(|(_, g)| g), Some(vec![[f64::EPSILON, f64::EPSILON]]));
        let (_, generators) = around(&[[0.1], [0.7]]).expect("every vector of a line is along it");
        assert!((generators[0][0] - 0.3).abs() < 1e-16);
        let (_, generators) = around(&[[1.0, 0.3], [1.0, -0.1]]).expect("along an axis");
        assert!((generators[0][1].abs() - 0.2).abs() < 1e-16 && generators[0][0] == 0.0);
    }

    #[test]
    fn no_segment_where_no_vector_of_doubles_is_along_the_line() {
        assert_eq!(around(&[[0.1, 1.0], [1e17, 0.3]]), None);
        assert_eq!(around(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), None);
        assert_eq!(around(&[[1.0, 2.0]; 3]), None);
    }
}
