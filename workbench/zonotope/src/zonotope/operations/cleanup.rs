//! Generators put in order: zero ones left out, parallel ones merged. Nothing else in the library does this behind the
//! caller's back.

use crate::numeric::outward::Loss;
use crate::zonotope::directions::Directions;
use crate::zonotope::{Zonotope, ZonotopeError};

impl<const D: usize> Zonotope<D> {
    /// The same body without its zero generators. O(n).
    pub fn without_zero_generators(&self) -> Self {
        let generators = self.generators().iter().filter(|g| g.iter().any(|&c| c != 0.0)).copied().collect();
        Self { center: self.center(), generators }
    }

    /// The body with one generator a direction: zero generators left out, parallel ones added up, sorted by direction.
    /// Which generators are parallel is decided exactly. The same body if all sums are vectors of doubles; else it
    /// encloses it, with at most D more generators along the axes, as for the other [operations](Self::minkowski_sum).
    /// O(n log n).
    ///
    /// # Errors
    /// [`ZonotopeError::NonFinite`] if a sum leaves the range of doubles.
    pub fn with_parallel_generators_merged(&self) -> Result<Self, ZonotopeError> {
        let directions = Directions::of_finite(self.generators());
        let mut loss = Loss::none();
        let sums = (0..directions.len()).map(|class| loss.round(&directions.exact_sum(class, self.generators())));
        let generators = sums.collect();
        Self::enclosing_rounded(self.center(), generators, &loss)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_box_with_a_doubled_edge() {
        let body = Zonotope::new([7.0, 8.0], vec![[0.0, -1.0], [0.0, 0.0], [2.0, 0.0], [0.0, 0.5]]).expect("finite");
        assert_eq!(body.without_zero_generators().generators().len(), 3);
        let merged = body.with_parallel_generators_merged().expect("finite");
        assert_eq!((merged.center(), merged.generators()), ([7.0, 8.0], &[[2.0, 0.0], [0.0, 1.5]][..]));
    }

    #[test]
    fn a_sum_that_is_no_double_is_enclosed() {
        let body = Zonotope::new([0.0], vec![[1.0], [-1e-30]]).expect("finite");
        let merged = body.with_parallel_generators_merged().expect("finite");
        assert_eq!(merged.generators(), [[1.0], [1e-30]]);
        let huge = Zonotope::new([0.0], vec![[f64::MAX], [f64::MAX]]).expect("finite");
        assert!(huge.with_parallel_generators_merged().is_err());
    }

    properties! {
        #[test]
        fn merging_never_loses_a_point(
            generators in proptest::collection::vec(([-1i8..2, -1i8..2, -1i8..2], -1.0..1.0f64), 0..9),
            u in [-1.0..1.0f64, -1.0..1.0, -1.0..1.0],
        ) {
            let generators = generators.iter().map(|(g, factor)| g.map(|c| f64::from(c) * factor)).collect();
            let body = Zonotope::new([0.5; 3], generators).expect("finite");
            let merged = body.with_parallel_generators_merged().expect("finite");
            prop_assert!(merged.support(u).exact_value >= body.support(u).exact_value);
            prop_assert!(merged.support(u).value() - body.support(u).value() < 1e-13);
            prop_assert_eq!(body.without_zero_generators().support(u), body.support(u));
        }
    }
}
