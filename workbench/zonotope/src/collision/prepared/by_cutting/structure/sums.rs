//! Exact sums of generators in bulk: as pairs of doubles where all of them are, else as long numbers.
//!
//! The sums of a body whose coordinates are within some forty powers of two of each other have at most 106 bits, and
//! two doubles hold them exactly. So the usual body takes 48 bytes a sum, and a sum that is equal to a coordinate of a
//! query is known to be so.

use crate::numeric::double_double::Precision;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;

/// A coordinate as the sum of two doubles.
type Pair = [f64; 2];

/// A list of exact vectors.
#[derive(Debug)]
pub(crate) enum Sums {
    /// Each coordinate is the sum of two doubles.
    Pairs(Vec<[Pair; 3]>),
    /// Coordinates of any length.
    Long(Vec<ExactVector>),
}

impl Sums {
    pub(crate) fn new() -> Self {
        Self::Pairs(Vec::new())
    }

    /// How many vectors there are.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::Pairs(list) => list.len(),
            Self::Long(list) => list.len(),
        }
    }

    /// Adds a vector; all become long numbers when one has a coordinate that two doubles do not hold.
    pub(crate) fn push(&mut self, sum: ExactVector) {
        if let Self::Pairs(list) = self {
            if let [Some(x), Some(y), Some(z)] = sum.each_ref().map(pair) {
                list.push([x, y, z]);
                return;
            }
            *self = Self::Long((0..list.len()).map(|index| self.exact(index)).collect());
        }
        if let Self::Long(list) = self {
            list.push(sum);
        }
    }

    /// Gives back the memory that is held for more vectors.
    pub(crate) fn shrink_to_fit(&mut self) {
        match self {
            Self::Pairs(list) => list.shrink_to_fit(),
            Self::Long(list) => list.shrink_to_fit(),
        }
    }

    /// A vector in one precision.
    pub(crate) fn over<N: Precision>(&self, index: usize) -> [N; 3] {
        match self {
            Self::Pairs(list) => list[index].map(N::of_sum),
            Self::Long(list) => list[index].each_ref().map(N::of),
        }
    }

    /// A vector, exactly.
    pub(crate) fn exact(&self, index: usize) -> ExactVector {
        self.over(index)
    }

    /// How many bytes the vectors take.
    pub(crate) fn bytes(&self) -> u64 {
        let mantissa = |c: &Dyadic| c.binary_exponent().map_or(0, |top| (top - c.exponent()).unsigned_abs() / 8 + 1);
        match self {
            Self::Pairs(list) => list.capacity() as u64 * size_of::<[Pair; 3]>() as u64,
            Self::Long(list) => {
                list.capacity() as u64 * size_of::<ExactVector>() as u64
                    + list.iter().flatten().map(mantissa).sum::<u64>()
            }
        }
    }
}

/// Two doubles whose sum is a number, if there are such near it.
fn pair(number: &Dyadic) -> Option<Pair> {
    let head = number.to_f64();
    let rest = head.is_finite().then(|| number - &Dyadic::from_f64(head))?;
    let tail = rest.to_f64();
    (Dyadic::from_f64(tail) == rest).then_some([head, tail])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::bounded::Bounded;
    use crate::numeric::exact_linear::exact;

    #[test]
    fn sums_are_held_exactly_whatever_their_length() {
        let short = exact([1.0, -0.1, 3e-300]);
        let two = Dyadic::from_f64(1.0) + Dyadic::from_f64(f64::EPSILON * f64::EPSILON / 3.0);
        let long = &two + &Dyadic::from_f64(f64::from_bits(1));
        let mut sums = Sums::new();
        sums.push(short.clone());
        sums.push([two.clone(), Dyadic::zero(), Dyadic::zero()]);
        assert!(matches!(sums, Sums::Pairs(_)));
        assert_eq!(sums.bytes() % 48, 0);
        sums.push([Dyadic::zero(), long.clone(), Dyadic::zero()]);
        assert!(matches!(sums, Sums::Long(_)));
        assert_eq!((sums.len(), sums.exact(0)), (3, short));
        assert_eq!((&sums.exact(1)[0], &sums.exact(2)[1]), (&two, &long));
        assert_eq!(sums.over::<Bounded>(2)[1].value, 1.0);
        assert!(sums.bytes() > 3 * size_of::<ExactVector>() as u64);
    }
}
