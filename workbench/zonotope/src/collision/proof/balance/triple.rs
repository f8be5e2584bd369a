//! Three vectors whose coefficients absorb what all others leave of a displacement, by Cramer's rule over any numbers.
//!
//! The rest r is α a + β b + γ c with α = r · (b × c) / det(a, b, c), and with β and γ accordingly. So three numerators
//! and one determinant say whether the coefficients are in [−1, 1]: in doubles or pairs of doubles with bounds, which
//! say so where it is certain, or in exact numbers. Plain doubles guess.

use std::cmp::Ordering;

use crate::numeric::bounded::{self, Bounded};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::{self, Ring, dot};

/// Numbers in which coefficients are quotients.
pub(crate) trait Coefficients: Ring {
    /// a × b.
    #[inline(always)]
    fn cross(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        linear::cross(a, b)
    }

    /// The quotient with a divisor as a double of [−1, 1], if the exact quotient is certainly in [−1, 1].
    fn coefficient(&self, divisor: &Self) -> Option<f64>;
}

impl Coefficients for f64 {
    #[inline(always)]
    fn coefficient(&self, divisor: &Self) -> Option<f64> {
        (self.abs() < divisor.abs()).then_some(self / divisor)
    }
}

impl Coefficients for Bounded {
    #[inline(always)]
    fn cross(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        bounded::cross(a, b)
    }

    #[inline(always)]
    fn coefficient(&self, divisor: &Self) -> Option<f64> {
        let size = Self { value: divisor.value.abs(), ..*divisor };
        self.is_within(size).then_some(self.value / divisor.value)
    }
}

impl Coefficients for BoundedDoubleDouble {
    fn coefficient(&self, divisor: &Self) -> Option<f64> {
        let is_within = self.abs().certain_order(&divisor.abs()) == Some(Ordering::Less);
        is_within.then(|| (self.high / divisor.high).clamp(-1.0, 1.0))
    }
}

impl Coefficients for Dyadic {
    fn coefficient(&self, divisor: &Self) -> Option<f64> {
        let is_within = !divisor.is_zero() && self.clone().abs() <= divisor.clone().abs();
        is_within.then(|| self.rounded_ratio(divisor).clamp(-1.0, 1.0))
    }
}

/// Three vectors, as the quantities from which coefficients are read off.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Triple<T> {
    /// b × c, c × a and a × b.
    pub(crate) normals: [[T; 3]; 3],
    /// det(a, b, c).
    pub(crate) determinant: T,
}

impl<T: Coefficients> Triple<T> {
    #[inline(always)]
    pub(crate) fn new([a, b, c]: &[[T; 3]; 3]) -> Self {
        let normals = [T::cross(b, c), T::cross(c, a), T::cross(a, b)];
        let determinant = dot(c, &normals[2]);
        Self { normals, determinant }
    }

    /// The coefficients of a vector times the determinant.
    #[inline(always)]
    pub(crate) fn numerators(&self, rest: &[T; 3]) -> [T; 3] {
        // written out: a question about a box takes half as many steps as with a call for each of them
        let [first, second, third] = &self.normals;
        [dot(rest, first), dot(rest, second), dot(rest, third)]
    }

    /// The coefficients of a vector, each of them if it is certainly in [−1, 1].
    #[inline(always)]
    pub(crate) fn coefficients(&self, rest: &[T; 3]) -> [Option<f64>; 3] {
        let [first, second, third] = self.numerators(rest);
        [
            first.coefficient(&self.determinant),
            second.coefficient(&self.determinant),
            third.coefficient(&self.determinant),
        ]
    }

    /// The coefficients of a vector, if all of them are certainly in [−1, 1].
    #[inline(always)]
    pub(crate) fn absorb(&self, rest: &[T; 3]) -> Option<[f64; 3]> {
        let [first, second, third] = self.coefficients(rest);
        Some([first?, second?, third?])
    }
}

impl Triple<Bounded> {
    /// The coefficients of a vector with bounds of their errors, infinite ones where the three vectors may be dependent.
    #[inline(always)]
    pub(crate) fn bounded_coefficients(&self, rest: &[Bounded; 3]) -> [Bounded; 3] {
        self.numerators(rest).map(|numerator| numerator / self.determinant)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![3 => -1.0..1.0f64, 2 => (-2i32..3).prop_map(f64::from), 1 => Just(1e-9), 1 => Just(1e150)]
    }

    fn vector() -> impl Strategy<Value = [f64; 3]> {
        proptest::array::uniform3(number())
    }

    /// The coefficients over some numbers.
    fn absorbed<T: Coefficients>(vectors: &[[f64; 3]; 3], rest: [f64; 3], of: impl Fn(f64) -> T) -> Option<[f64; 3]> {
        Triple::new(&vectors.map(|v| v.map(&of))).absorb(&rest.map(&of))
    }

    proptest! {
        #![proptest_config(crate::property_cases::config(1000))]

        #[test]
        fn what_rounded_numbers_absorb_exact_ones_absorb_as_well(
            vectors in proptest::array::uniform3(vector()), rest in vector(),
        ) {
            let truth = absorbed(&vectors, rest, Dyadic::from_f64);
            let in_doubles = absorbed(&vectors, rest, Bounded::exact);
            let in_pairs = absorbed(&vectors, rest, BoundedDoubleDouble::exact);
            for own in [in_doubles, in_pairs].into_iter().flatten() {
                let truth = truth.expect("the exact coefficients are in [−1, 1]");
                prop_assert!(own.iter().zip(truth).all(|(own, truth)| (own - truth).abs() <= 2.0));
            }
            if let Some(own) = in_pairs {
                let truth = truth.expect("the exact coefficients are in [−1, 1]");
                prop_assert!(own.iter().zip(truth).all(|(own, truth)| (own - truth).abs() <= 1e-9));
            }
        }

        #[test]
        fn bounds_of_coefficients_hold(vectors in proptest::array::uniform3(vector()), rest in vector()) {
            let triple = Triple::new(&vectors.map(bounded::exact));
            let exact = Triple::new(&vectors.map(exact_linear::exact));
            let numerators = exact.numerators(&exact_linear::exact(rest));
            for (own, numerator) in triple.bounded_coefficients(&bounded::exact(rest)).iter().zip(numerators) {
                if own.error.is_finite() {
                    // |numerator − value · determinant| ≤ error · |determinant|
                    let off = (&numerator - &(&Dyadic::from_f64(own.value) * &exact.determinant)).abs();
                    prop_assert!(off <= &Dyadic::from_f64(own.error) * &exact.determinant.clone().abs());
                }
            }
        }
    }

    #[test]
    fn coefficients_by_hand_over_all_numbers() {
        let vectors = [[1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, -4.0]];
        // (1, 1, 1) = a / 2 + b / 2 − c / 4
        let expected = Some([0.5, 0.5, -0.25]);
        assert_eq!(absorbed(&vectors, [1.0; 3], |c| c), expected);
        assert_eq!(absorbed(&vectors, [1.0; 3], Bounded::exact), expected);
        assert_eq!(absorbed(&vectors, [1.0; 3], BoundedDoubleDouble::exact), expected);
        assert_eq!(absorbed(&vectors, [1.0; 3], Dyadic::from_f64), expected);
        // −4 is the end of the third one's range, which rounded numbers leave to exact ones
        let rest = [1.0, 1.0, -4.0];
        assert_eq!(absorbed(&vectors, rest, Bounded::exact), None);
        assert_eq!(absorbed(&vectors, rest, BoundedDoubleDouble::exact), None);
        assert_eq!(absorbed(&vectors, rest, Dyadic::from_f64), Some([0.5, 0.5, 1.0]));
        // dependent vectors
        let flat = [[1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [0.0, 4.0, 0.0]];
        assert_eq!(absorbed(&flat, [0.0; 3], Bounded::exact), None);
        assert_eq!(absorbed(&flat, [0.0; 3], BoundedDoubleDouble::exact), None);
        assert_eq!(absorbed(&flat, [0.0; 3], Dyadic::from_f64), None);
    }
}
