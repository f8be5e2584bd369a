//! Exact results put into doubles such that the body encloses them: what rounding loses comes back as a box.

use super::{Zonotope, ZonotopeError};
use crate::numeric::dyadic::Dyadic;

/// Collects what was lost to rounding, coordinate by coordinate.
#[derive(Debug, Clone)]
pub(super) struct Loss<const D: usize>([Dyadic; D]);

impl<const D: usize> Loss<D> {
    pub(super) fn none() -> Self {
        Self(std::array::from_fn(|_| Dyadic::zero()))
    }

    /// Rounds a vector and adds up by how much; infinite coordinates where the range of doubles ends.
    pub(super) fn round(&mut self, exact: &[Dyadic; D]) -> [f64; D] {
        std::array::from_fn(|k| {
            let rounded = exact[k].to_f64();
            if rounded.is_finite() {
                self.0[k] = &self.0[k] + &(&exact[k] - &Dyadic::from_f64(rounded)).abs();
            }
            rounded
        })
    }

    /// The zonotope of rounded vectors and, along each axis that lost something, a generator that makes up for it.
    ///
    /// # Errors
    /// As [`Zonotope::new`], if a coordinate left the range of doubles.
    pub(super) fn enclose(self, center: [f64; D], mut generators: Vec<[f64; D]>) -> Result<Zonotope<D>, ZonotopeError> {
        for (axis, lost) in self.0.iter().enumerate().filter(|(_, lost)| !lost.is_zero()) {
            let mut generator = [0.0; D];
            generator[axis] = round_up(lost);
            generators.push(generator);
        }
        Zonotope::new(center, generators)
    }
}

/// The least double that is at least `exact`; infinite beyond the range of doubles.
pub(super) fn round_up(exact: &Dyadic) -> f64 {
    let mut rounded = exact.to_f64();
    if rounded.is_infinite() {
        return if rounded > 0.0 { rounded } else { f64::MIN };
    }
    while Dyadic::from_f64(rounded) < *exact {
        rounded = rounded.next_up();
        if rounded.is_infinite() {
            return rounded;
        }
    }
    while rounded > f64::MIN && Dyadic::from_f64(rounded.next_down()) >= *exact {
        rounded = rounded.next_down();
    }
    rounded
}
