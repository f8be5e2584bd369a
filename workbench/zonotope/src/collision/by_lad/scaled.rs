//! Queries of extreme size, multiplied by a power of two that brings them where doubles have room.
//!
//! Products of three vectors leave the range of doubles where their sizes are beyond about 2^±200, and then only exact
//! arithmetic can answer. A power of two changes no digit, so a query about the multiplied generators has the same
//! answer, and a proof of one is a proof of the other. Where a multiplied coordinate would lose digits to underflow,
//! the query stays as it is.

use crate::numeric::scaling::{binary_exponent, power_of_two};
use crate::zonotope::query::Query;

/// Displacements up to 2^±128 are asked about as they are.
const ROOMY_EXPONENT: i32 = 128;

/// The multiples of the vectors of a query.
pub(super) struct Scaled<const D: usize> {
    from: [f64; D],
    to: [f64; D],
    generators: Vec<[f64; D]>,
}

impl<const D: usize> Scaled<D> {
    /// The vectors of a query multiplied such that the displacement has a size of about 1; none where it has room
    /// enough, where it is zero or beyond the range of doubles, and where digits would be lost. O(1) where there is
    /// room, else O(n).
    pub(super) fn of(query: &Query<'_, D>) -> Option<Self> {
        let (from, to) = (query.from(), query.to());
        let size = from.iter().zip(&to).fold(0.0f64, |m, (a, b)| m.max((b - a).abs()));
        let exponent = binary_exponent(size).filter(|exponent| exponent.abs() > ROOMY_EXPONENT && size.is_finite())?;
        // in two steps, as the factor may be beyond the range of doubles
        let half = -exponent / 2;
        let steps = [half, -exponent - half];
        let ([up, on], [back, down]) = (steps.map(power_of_two), steps.map(|step| power_of_two(-step)));
        let multiple = |v: &[f64; D]| v.map(|c| c * up * on);
        // infinity times a power of two is none of the numbers
        let is_same = |v: &[f64; D], scaled: &[f64; D]| v.iter().zip(scaled).all(|(c, s)| s * down * back == *c);
        let scaled =
            Self { from: multiple(&from), to: multiple(&to), generators: query.generators().map(multiple).collect() };
        let are_same = is_same(&from, &scaled.from)
            && is_same(&to, &scaled.to)
            && query.generators().zip(&scaled.generators).all(|(v, scaled)| is_same(v, scaled));
        are_same.then_some(scaled)
    }

    /// The query about the multiples.
    pub(super) fn query(&self) -> Query<'_, D> {
        Query::of_finite(self.from, self.to, &self.generators)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_kept_or_the_question_is() {
        let size = power_of_two(900);
        let generators = [[3.0 * size, 0.0, 1.0], [0.0, size, power_of_two(200)]];
        let query = Query::of_finite([0.0; 3], [5.0 * size, size, 0.0], &generators);
        let scaled = Scaled::of(&query).expect("no digit is lost");
        assert_eq!(scaled.query().to(), [1.25, 0.25, 0.0]);
        assert_eq!(scaled.query().generator(0), [0.75, 0.0, power_of_two(-902)]);
        // digits of the smallest would be lost
        let generators = [[size, 0.0, 0.0], [0.0, 1.0, power_of_two(-150) * (1.0 + f64::EPSILON)]];
        assert!(Scaled::of(&Query::of_finite([0.0; 3], [size, 0.0, 0.0], &generators)).is_none());
        // there is room
        assert!(Scaled::of(&Query::of_finite([0.0; 3], [power_of_two(100), 0.0, 0.0], &generators)).is_none());
        assert!(Scaled::of(&Query::of_finite([1.0; 3], [1.0; 3], &generators)).is_none());
        let tiny = [[f64::from_bits(1); 3]];
        let scaled = Scaled::of(&Query::of_finite([0.0; 3], tiny[0], &tiny)).expect("no digit is lost");
        assert_eq!((scaled.query().to(), scaled.query().generator(0)), ([1.0; 3], [1.0; 3]));
    }
}
