//! Passes over generators in plain doubles, with bounds on their errors.
//!
//! A pass decides nothing by itself. [`Extents`] are read off once a body; with them every later pass has a bound on
//! its error, and only where that bound leaves a doubt is exact arithmetic needed.

use super::Zonotope;
use super::faces::Estimate;
use crate::numeric::bounded::finite_or_infinity;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{LONG_SUM, UNIT};

pub use crate::numeric::lanes::{Extents, absolute_sum, extreme_sum};

impl<const D: usize> Zonotope<D> {
    /// The support function in a direction of finite coordinates by one pass in doubles, with a bound on its error;
    /// `extents` are those of the generators. O(n). [`support`](Self::support) is exact.
    pub fn support_estimate(&self, direction: &[f64; D], extents: &Extents<D>) -> Estimate {
        let width = absolute_sum(self.generators(), direction);
        let center = self.center();
        let magnitude: f64 = center.iter().zip(direction).map(|(c, u)| (c * u).abs()).sum();
        let value = dot(&center, direction) + width;
        let of_center = UNIT * (D as f64 + 2.0) * magnitude + UNIT * width + f64::from_bits(1) * (D as f64 + 2.0);
        let error = (extents.error(direction, width) + of_center) * LONG_SUM;
        Estimate { value, error: if value.is_finite() { finite_or_infinity(error) } else { f64::INFINITY } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::test_vectors::vectors;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(crate::property_cases::config(3000))]

        #[test]
        fn an_estimate_keeps_its_bound((generators, direction) in vectors()) {
            let exact = |v: f64| Dyadic::from_f64(v);
            let extents = Extents::new(&generators);
            for center in [[0.0; 3], [1e16, -3.0, 0.1], generators.first().copied().unwrap_or_default()] {
                let body = Zonotope::new(center, generators.clone()).expect("finite");
                let estimate = body.support_estimate(&direction, &extents);
                let off = || (exact(estimate.value) - body.support(direction).exact_value).abs();
                prop_assert!(estimate.error == f64::INFINITY || off() <= exact(estimate.error));
            }
        }
    }
}
