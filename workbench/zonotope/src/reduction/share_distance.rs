//! A bound on the Hausdorff distance of two bodies, from the shares that prove that one contains the other.
//!
//! With v = γ b + w for the generators v of the inner body, h(u) ≥ Σ |γ| |u · b| − Σ |u · w|. The outer body reaches
//! Σ |u · b| + Σ |u · f|, f its frame. So the distance is at most Σ (1 − Σ |γ|) |b| + Σ |w| + |f|, the last one the
//! length of the diagonal of an orthogonal frame. That takes one pass and no search.

use super::shares::{Share, Shares};
use crate::numeric::linear::{add_multiple, dot};
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, SQUARABLE_SIZES, UNIT};
use crate::zonotope::Zonotope;

/// Roundings of a term of the sums, of up to six coordinates.
const TERM_ROUNDINGS: f64 = 32.0;

/// The root of the sum of squares. Squares of short vectors leave the range of doubles, and their root is far longer
/// than what is lost of them, so these vectors are made longer first.
fn length(v: &[f64]) -> f64 {
    let square = |factor: i64| -> f64 {
        let scaled = v.iter().map(|&c| scale_by_power_of_two(c, factor));
        scaled.map(|c| c * c).sum()
    };
    match own_exponent(v) {
        Some(exponent) if largest_magnitude(v) < SQUARABLE_SIZES.start => {
            scale_by_power_of_two(square(-exponent).sqrt(), exponent)
        }
        _ => square(0).sqrt(),
    }
}

/// The exponent of the largest component; none of zero.
fn own_exponent(v: &[f64]) -> Option<i64> {
    binary_exponent(largest_magnitude(v)).map(i64::from)
}

/// The vector times a power of two that brings its largest component to magnitude 1.
fn of_ordinary_length<const D: usize>(v: &[f64; D]) -> [f64; D] {
    let exponent = own_exponent(v).unwrap_or(0);
    v.map(|c| scale_by_power_of_two(c, -exponent))
}

/// A bound on a distance beside the size of the inner body, both times a power of two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShareDistance {
    /// The distance is not above this.
    bound: f64,
    /// Σ |v| over the generators of the inner body, rounded.
    total_length: f64,
    /// The exponent of the power of two.
    exponent: i64,
}

impl ShareDistance {
    /// The bound that shares prove, of a body without its generators along the frame.
    pub(super) fn new<const D: usize>(shares: &Shares, inner: &Zonotope<D>, outer: &Zonotope<D>) -> Self {
        let largest = [inner, outer].map(|body| largest_magnitude(body.generators().as_flattened()));
        let exponent = -i64::from(binary_exponent(largest[0].max(largest[1])).unwrap_or(0));
        let scaled = |v: &[f64; D]| v.map(|c| scale_by_power_of_two(c, exponent));
        let outer: Vec<[f64; D]> = outer.generators().iter().map(scaled).collect();
        let length = |v: &[f64; D]| length(v);
        // what shares leave of each generator, and how many of them are not all of one
        let mut left = vec![1.0; outer.len()];
        let mut parts = vec![0u32; outer.len()];
        let (mut total_length, mut remainders, mut rounded) = (0.0, 0.0, 0.0);
        for (v, share) in inner.generators().iter().zip(&shares.shares) {
            let v = scaled(v);
            total_length += length(&v);
            let Some(Share { generator, coefficient }) = share else {
                remainders += length(&v);
                continue;
            };
            let b = &outer[*generator];
            left[*generator] -= coefficient.abs();
            if *coefficient != 1.0 || v != *b {
                let mut rest = v;
                add_multiple(&mut rest, -coefficient, b);
                remainders += length(&rest);
                rounded += length(&v) + coefficient.abs() * length(b);
                parts[*generator] += 1;
            }
        }
        let frame = &shares.frame;
        let axes: Vec<[f64; D]> = frame.iter().map(|&index| of_ordinary_length(&outer[index])).collect();
        let is_orthogonal = (0..axes.len()).all(|i| (0..i).all(|j| dot(&axes[i], &axes[j]) == 0.0));
        let lengths = || frame.iter().map(|&index| length(&outer[index]));
        let diagonal = if is_orthogonal { self::length(&lengths().collect::<Vec<_>>()) } else { lengths().sum() };
        let whole = (0..outer.len()).filter(|index| !frame.contains(index));
        // each part that is taken off costs a rounding
        let unshared: f64 =
            whole.map(|index| (left[index].max(0.0) + UNIT * f64::from(parts[index])) * length(&outer[index])).sum();
        let terms = (shares.shares.len() + outer.len()) as f64;
        let underflow = (terms + 1.0) * PRODUCT_UNDERFLOW;
        let bound = (remainders + diagonal + unshared + TERM_ROUNDINGS * UNIT * rounded) * LONG_SUM + underflow;
        Self { bound, total_length, exponent }
    }

    /// Whether the distance is certainly at most this part of Σ |v|.
    pub(super) fn is_within(&self, part: f64) -> bool {
        self.bound * LONG_SUM <= part * self.total_length
    }

    /// The bound in the units of the input, not below it.
    pub(super) fn bound(&self) -> f64 {
        let value = scale_by_power_of_two(self.bound, -self.exponent);
        if value < f64::MIN_POSITIVE && self.bound > 0.0 { value.next_up() } else { value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::rational;
    use crate::reduction::by_patches::patches_within;
    use crate::reduction::hausdorff::brute_force::squared_excess;
    use crate::reduction::{Containment, Method, Problem};
    use proptest::prelude::*;

    #[test]
    fn a_square_around_an_octagon_by_hand() {
        let body = |list: &[[f64; 2]]| Zonotope::new([0.0; 2], list.to_vec()).expect("finite");
        let (octagon, square) =
            (body(&[[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -1.0]]), body(&[[3.0, 0.0], [0.0, 3.0]]));
        let shares = Shares { shares: vec![None; 4], frame: vec![0, 1] };
        let distance = ShareDistance::new(&shares, &octagon, &square);
        // all of the octagon's generators, and the diagonal of the square
        let exact = 2.0 + 2.0 * 2f64.sqrt() + 18f64.sqrt();
        assert!(distance.bound() > exact && distance.bound() < exact * 1.000_01, "{distance:?}");
        let own = ShareDistance::new(&Shares::each_its_own(2), &square, &square);
        assert!(own.bound() < 1e-200 && own.is_within(1e-200), "{own:?}");
    }

    /// Squares of the short generators beside a long one are below all doubles.
    #[test]
    fn short_generators_beside_a_long_one_count() {
        let on_an_axis = [0.75, 4.5e-56, -1e219, -0.96].map(|c| [c, 0.0]);
        let inner = Zonotope::new([0.0; 2], on_an_axis.to_vec()).expect("finite");
        let problem = Problem::new(&inner, 2).expect("two are enough");
        let reduced = Method::Combastel.reduce(&problem).expect("it is short");
        let Containment::Shares(shares) = &reduced.proof else { panic!("shares prove it") };
        let bound = ShareDistance::new(shares, &inner, &reduced.body).bound();
        assert!(squared_excess(&reduced.body, &inner) <= rational(bound) * rational(bound), "{bound}");
        assert!((length(&[3e-300, 4e-300]) - 5e-300).abs() < 1e-314 && length(&[0.0]) == 0.0);
    }

    properties! {
        #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

        #[test]
        fn the_distance_is_within_the_bound(
            generators in proptest::collection::vec(proptest::array::uniform2(-1.0..1.0f64), 1..5),
            epsilon in 0.05..0.9f64,
        ) {
            let body = Zonotope::new([0.0; 2], generators).expect("finite");
            let problem = Problem::new(&body, 3).expect("three are enough");
            let answers = [Method::Girard.reduce(&problem), patches_within(&body, epsilon, &mut ())];
            for reduced in answers.into_iter().flatten() {
                let Containment::Shares(shares) = &reduced.proof else { continue };
                let bound = ShareDistance::new(shares, &body, &reduced.body).bound();
                prop_assert!(squared_excess(&reduced.body, &body) <= rational(bound) * rational(bound));
            }
        }
    }
}
