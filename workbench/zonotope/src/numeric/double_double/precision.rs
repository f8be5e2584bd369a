//! The precisions in which a sign is decided, each where the ones before leave a doubt: doubles with bounds, doubles
//! with an exponent of their own, pairs of doubles, exact numbers.

use std::cmp::Ordering;

use super::bounded::BoundedDoubleDouble;
use crate::numeric::bounded::Bounded;
use crate::numeric::bounded::wide::BoundedWide;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::Ring;

/// Numbers of one precision.
pub(crate) trait Precision: Ring {
    /// A finite double.
    fn of_double(value: f64) -> Self;
    /// The sum of two finite doubles, the second one no more than what rounding takes off the first.
    fn of_sum(parts: [f64; 2]) -> Self;
    /// An exact number.
    fn of(number: &Dyadic) -> Self;
    /// The sign of the exact value if it is certain; that of 0 is known of exact numbers alone.
    fn certain_sign(&self) -> Option<Ordering>;
}

/// Numbers with bounds, from the sum of two doubles and from an exact number.
macro_rules! precision_with_bounds {
    ($number:ty, |$parts:ident| $of_sum:expr, |$exact:ident| $of:expr) => {
        impl Precision for $number {
            fn of_double(value: f64) -> Self {
                Self::exact(value)
            }

            fn of_sum($parts: [f64; 2]) -> Self {
                $of_sum
            }

            fn of($exact: &Dyadic) -> Self {
                $of
            }

            fn certain_sign(&self) -> Option<Ordering> {
                self.sign().map(|sign| sign.cmp(&0))
            }
        }
    };
}

precision_with_bounds!(Bounded, |parts| Bounded { value: parts[0], error: parts[1].abs() }, |exact| {
    BoundedDoubleDouble::of(exact).rounded()
});
precision_with_bounds!(BoundedWide, |parts| BoundedWide::of_sum(parts), |exact| BoundedWide::of(exact));
precision_with_bounds!(BoundedDoubleDouble, |parts| BoundedDoubleDouble::of_parts(parts[0], parts[1], 0.0), |exact| {
    BoundedDoubleDouble::of(exact)
});

impl Precision for Dyadic {
    fn of_double(value: f64) -> Self {
        Self::from_f64(value)
    }

    fn of_sum([head, tail]: [f64; 2]) -> Self {
        Self::from_f64(head) + Self::from_f64(tail)
    }

    fn of(number: &Dyadic) -> Self {
        number.clone()
    }

    fn certain_sign(&self) -> Option<Ordering> {
        Some(self.sign())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The signs of sums that are certain in a precision.
    fn signs<T: Precision>(sums: &[[f64; 2]]) -> Vec<Option<Ordering>> {
        sums.iter().map(|sum| T::of_sum(*sum).certain_sign()).collect()
    }

    #[test]
    fn every_precision_tells_the_sign_of_sums_and_exact_numbers_tell_that_of_zero() {
        let rest = f64::EPSILON / 4.0;
        let sums = [[1.0, rest], [1.0, -rest], [-1.0, rest], [-1.0, 0.0]];
        let expected = [Ordering::Greater, Ordering::Greater, Ordering::Less, Ordering::Less].map(Some);
        assert_eq!(signs::<Bounded>(&sums), expected);
        assert_eq!(signs::<BoundedWide>(&sums), expected);
        assert_eq!(signs::<BoundedDoubleDouble>(&sums), expected);
        assert_eq!(signs::<Dyadic>(&sums), expected);
        let zero = [[0.0, 0.0]];
        assert_eq!(signs::<Dyadic>(&zero), [Some(Ordering::Equal)]);
        let rounded = [signs::<Bounded>(&zero), signs::<BoundedWide>(&zero), signs::<BoundedDoubleDouble>(&zero)];
        assert_eq!(rounded.concat(), [None; 3]);
    }

    #[test]
    fn the_second_double_of_a_sum_counts_where_the_first_one_cancels() {
        let rest = f64::EPSILON / 4.0;
        for (rest, sign) in [(rest, Ordering::Greater), (-rest, Ordering::Less)] {
            let one = |tail| <Dyadic as Precision>::of_sum([1.0, tail]);
            assert_eq!(one(rest).minus(&one(0.0)).certain_sign(), Some(sign));
            let one = |tail| <BoundedDoubleDouble as Precision>::of_sum([1.0, tail]);
            assert_eq!(one(rest).minus(&one(0.0)).certain_sign(), Some(sign));
            // A double alone does not tell it.
            let one = |tail| <Bounded as Precision>::of_sum([1.0, tail]);
            assert_eq!(one(rest).minus(&one(0.0)).certain_sign(), None);
        }
    }
}
