//! Norms of vectors of space in doubles.

use super::dot;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::MODERATE_SIZES;

/// The Euclidean length √(a · a).
#[inline(always)]
pub(crate) fn euclidean_norm(a: &[f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The Euclidean norm of coordinates of any size, whose squares may leave the range of doubles.
#[inline]
pub(crate) fn norm_of_any_size(a: &[f64; 3]) -> f64 {
    let square = dot(a, a);
    if MODERATE_SIZES.contains(&square) { square.sqrt() } else { norm_by_exponent(a) }
}

#[cold]
fn norm_by_exponent(a: &[f64; 3]) -> f64 {
    match binary_exponent(max_norm(a)) {
        Some(exponent) if a.iter().all(|c| c.is_finite()) => {
            let scaled = a.map(|c| scale_by_power_of_two(c, -i64::from(exponent)));
            scale_by_power_of_two(euclidean_norm(&scaled), i64::from(exponent))
        }
        // zero, infinite or NaN
        _ => euclidean_norm(a),
    }
}

/// The sum of the magnitudes of the coordinates, |a|_1.
#[inline(always)]
pub(crate) fn sum_norm([x, y, z]: &[f64; 3]) -> f64 {
    x.abs() + y.abs() + z.abs()
}

/// The largest magnitude of a coordinate, |a|_∞; coordinates that are NaN do not count.
#[inline(always)]
pub(crate) fn max_norm(a: &[f64; 3]) -> f64 {
    a.iter().fold(0.0f64, |largest, c| largest.max(c.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn norms_worked_out_by_hand() {
        let v = [2.0, -3.0, 6.0];
        assert_eq!([euclidean_norm(&v), sum_norm(&v), max_norm(&v)], [7.0, 11.0, 6.0]);
        for size in [1e-320, 1e-200, 1.0, 1e200, 1e306] {
            let norm = norm_of_any_size(&v.map(|c| c * size));
            assert!((norm / size - 7.0).abs() < if size < 1e-300 { 0.01 } else { 1e-14 }, "{size}: {norm}");
        }
        let infinite = [f64::INFINITY, 1.0, 0.0];
        assert_eq!([norm_of_any_size(&[0.0; 3]), norm_of_any_size(&infinite)], [0.0, f64::INFINITY]);
        assert!(norm_of_any_size(&[f64::NAN, 0.0, 0.0]).is_nan());
        assert_eq!(max_norm(&[f64::NAN, -1.0, 0.5]), 1.0);
        assert!(sum_norm(&[f64::NAN, 0.0, 0.0]).is_nan());
    }
}
