//! Norms of vectors of space in doubles.

use super::dot;

/// The Euclidean length √(a · a).
#[inline(always)]
pub(crate) fn euclidean_norm(a: &[f64; 3]) -> f64 {
    dot(a, a).sqrt()
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
        assert_eq!(max_norm(&[f64::NAN, -1.0, 0.5]), 1.0);
        assert!(sum_norm(&[f64::NAN, 0.0, 0.0]).is_nan());
    }
}
