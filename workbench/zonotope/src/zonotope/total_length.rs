//! The total length of generators, the sum of their half-lengths.

use super::Zonotope;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;
use crate::numeric::outward::at_least;
use crate::numeric::tolerance::UNIT;

impl<const D: usize> Zonotope<D> {
    /// The total length Σ |g_i| of the generators, rounded up: at most a relative 10^-14 above the exact one.
    pub fn total_length(&self) -> f64 {
        length_above(self.generators())
    }
}

/// The total length Σ |g_i|, rounded up.
pub(crate) fn length_above<const D: usize>(generators: &[[f64; D]]) -> f64 {
    let lengths = generators.iter().map(|g| {
        let largest = g.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        let axes = g.iter().filter(|c| **c != 0.0).count();
        if axes <= 1 {
            return Dyadic::from_f64(largest);
        }
        let unit = g.map(|c| c / largest);
        let factor = dot(&unit, &unit).sqrt() * (1.0 + 8.0 * D as f64 * UNIT);
        // The product is exact: as a double it might be denormal, with few bits.
        &Dyadic::from_f64(largest) * &Dyadic::from_f64(factor)
    });
    let length = at_least(&lengths.fold(Dyadic::zero(), |sum, length| sum + length));
    if length < f64::MIN_POSITIVE { tiny_length_above(generators) } else { length }
}

/// The total length rounded up, for generators as short as the least doubles: these are so far apart that a factor
/// above 1 may cost a whole step between them, so each length is the root of an exact square.
fn tiny_length_above<const D: usize>(generators: &[[f64; D]]) -> f64 {
    let square = |g: &[f64; D]| g.iter().map(|c| Dyadic::from_f64(*c)).fold(Dyadic::zero(), |sum, c| sum + &c * &c);
    let length = generators.iter().map(|g| square(g).root_above()).fold(Dyadic::zero(), |sum, length| sum + length);
    at_least(&length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_total_length_is_never_below_the_exact_one() {
        let body = Zonotope::new([0.0, 0.0], vec![[3.0, 4.0], [0.0, -2.0], [0.0, 0.0]]).expect("finite numbers");
        assert!((7.0..7.0 * (1.0 + 1e-14)).contains(&body.total_length()), "{}", body.total_length());
        let axes = Zonotope::new([5.0, 0.0], vec![[1.0, 0.0], [0.0, 0.5]]).expect("finite numbers");
        assert_eq!(axes.total_length(), 1.5);
        let tiny = Zonotope::new([0.0, 0.0], vec![[5e-324, 0.0]; 3]).expect("finite numbers");
        assert_eq!(tiny.total_length(), 1.5e-323);
    }
}
