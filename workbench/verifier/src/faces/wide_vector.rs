//! Vectors in floating point of which each component has an exponent of its own: inner products and sums of their
//! magnitudes, however far components are apart.

use crate::exact::linear::Vector;
use crate::exact::wide::{Wide, power_of_two};
use crate::faces::normals::MOST_COORDINATES;

/// At least what an inner product of two vectors may be off, in its unit: components are within a relative 2^-52,
/// products of them and the sum of four of those are rounded, and each product is less than a unit.
const DOT_ERROR: f64 = 1.0 / (1_u64 << 45) as f64;

/// The exponent of a component that is zero.
const OF_ZERO: i32 = i32::MIN / 4;

/// A vector of at most [`MOST_COORDINATES`] components, each within a relative 2^-52.
#[derive(Debug, Clone, Copy)]
pub(super) struct WideVector {
    mantissas: [f64; MOST_COORDINATES],
    exponents: [i32; MOST_COORDINATES],
}

impl WideVector {
    pub(super) fn of(vector: &Vector) -> Self {
        let mut wide = Self { mantissas: [0.0; MOST_COORDINATES], exponents: [OF_ZERO; MOST_COORDINATES] };
        for (k, component) in vector.iter().enumerate() {
            let number = Wide::of_whole(component);
            if number.mantissa() != 0.0 {
                wide.mantissas[k] = number.mantissa();
                wide.exponents[k] = i32::try_from(number.exponent()).expect("numbers of a check fit into memory");
            }
        }
        wide
    }

    /// The inner product in units of a power of two with this exponent, within [`DOT_ERROR`] units; 0 exactly where
    /// the exponent is that of zero.
    fn dot(&self, other: &Self) -> (f64, i32) {
        let exponents: [i32; MOST_COORDINATES] = std::array::from_fn(|k| self.exponents[k] + other.exponents[k]);
        let unit = exponents[0].max(exponents[1]).max(exponents[2].max(exponents[3]));
        if unit < OF_ZERO / 2 {
            return (0.0, OF_ZERO);
        }
        let mut sum = 0.0;
        for ((own, others), exponent) in self.mantissas.iter().zip(&other.mantissas).zip(exponents) {
            sum += own * others * power_of_two(i64::from(exponent - unit));
        }
        (sum, unit)
    }

    /// Bounds of the magnitude of the inner product.
    pub(super) fn along(&self, other: &Self) -> [Wide; 2] {
        let (value, unit) = self.dot(other);
        if unit == OF_ZERO {
            return [Wide::ZERO; 2];
        }
        let value = value.abs();
        [(value - DOT_ERROR).max(0.0), value + DOT_ERROR].map(|bound| Wide::new(bound, i64::from(unit)))
    }

    /// Bounds of the sum of the magnitudes of the inner products with all vectors but those that are `left_out`, which
    /// are ascending and orthogonal to this one.
    pub(super) fn reach(&self, vectors: &[Self], left_out: &[usize]) -> [Wide; 2] {
        let (mut sum, mut doubt, mut unit) = (0.0, 0.0, OF_ZERO);
        for (index, vector) in vectors.iter().enumerate() {
            if left_out.contains(&index) {
                continue;
            }
            let (value, own) = self.dot(vector);
            if own == OF_ZERO {
                continue;
            }
            let up = power_of_two(i64::from(unit.min(own) - unit.max(own)));
            if own > unit {
                (sum, doubt, unit) = (sum * up + value.abs(), doubt * up + DOT_ERROR, own);
            } else {
                (sum, doubt) = (sum + value.abs() * up, doubt + DOT_ERROR * up);
            }
        }
        if unit == OF_ZERO {
            return [Wide::ZERO; 2];
        }
        // Terms that are lost are below 2^-1022 units, far less than the doubt about one term.
        let doubt = 2.0 * doubt + sum * (vectors.len() + 8) as f64 * f64::EPSILON;
        [(sum - doubt).max(0.0), sum + doubt].map(|bound| Wide::new(bound, i64::from(unit)))
    }
}

#[cfg(test)]
mod tests {
    use dashu_int::IBig;
    use dashu_int::ops::Abs;

    use super::*;
    use crate::exact::linear::dot;

    #[test]
    fn bounds_hold_for_numbers_of_any_size() {
        let mut state = 5_u64;
        let mut next = |range: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % range
        };
        let mut narrow = 0;
        for round in 0..400 {
            let spread = [1, 60, 5_000][round % 3];
            let mut vector = || -> Vector {
                let mut component = || {
                    let whole = IBig::from(next(1 << 20) as i64 - (1 << 19)) * IBig::from(next(3));
                    whole << next(spread) as usize
                };
                (0..3).map(|_| component()).collect()
            };
            let (u, vectors): (Vector, Vec<Vector>) = (vector(), (0..4).map(|_| vector()).collect());
            let wide: Vec<WideVector> = vectors.iter().map(WideVector::of).collect();
            let exact: IBig = vectors.iter().map(|v| dot(&u, v).abs()).sum();
            let exact = Wide::of_whole(&exact);
            let [low, high] = WideVector::of(&u).reach(&wide, &[]);
            let slack = 4.0 * f64::EPSILON;
            assert!(low.moved(-slack).compare(exact).is_le() && exact.compare(high.moved(slack)).is_le(), "{round}");
            let [low, high] = WideVector::of(&u).along(&wide[0]);
            let exact = Wide::of_whole(&dot(&u, &vectors[0]).abs());
            assert!(low.moved(-slack).compare(exact).is_le() && exact.compare(high.moved(slack)).is_le(), "{round}");
            narrow += usize::from(low.moved(1e-9).compare(high).is_ge());
        }
        assert!(narrow > 300, "{narrow}");
    }

    fn of(rows: &[[i64; 3]]) -> Vec<WideVector> {
        rows.iter().map(|row| WideVector::of(&row.map(IBig::from).to_vec())).collect()
    }

    #[test]
    fn vectors_without_a_common_component_have_no_product() {
        let [first, second] = [[5, 0, 0], [0, -3, 8]].map(|row| of(&[row])[0]);
        assert_eq!((first.along(&second), first.reach(&[second], &[])), ([Wide::ZERO; 2], [Wide::ZERO; 2]));
    }

    /// Products of one that rounding loses whole: 2^60 + 1 − 2^60.
    #[test]
    fn bounds_of_a_reach_hold_for_vectors_that_are_almost_orthogonal() {
        let long = 1 << 60;
        let u = of(&[[long + 1, long, 0]])[0];
        for count in 1..4 {
            let [low, high] = u.reach(&of(&vec![[1, -1, 0]; count]), &[]);
            let exact = Wide::of_whole(&IBig::from(count));
            assert!(low.compare(exact).is_le() && exact.compare(high).is_le(), "{count} {low:?} {high:?}");
        }
    }

    #[test]
    fn bounds_of_a_reach_hold_for_hundreds_of_vectors() {
        let component = (1 << 20) - 1;
        let own = of(&[[component; 3]]);
        let [low, high] = own[0].reach(&own.repeat(200), &[]);
        let exact = Wide::of_whole(&(IBig::from(600) * IBig::from(component) * IBig::from(component)));
        assert!(low.compare(exact).is_le() && exact.compare(high).is_le(), "{low:?} {high:?}");
    }
}
