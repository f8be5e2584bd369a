//! Σ ± v over vectors of doubles, exactly.
//!
//! Few doubles of similar sizes are summed up as integers of 128 bits. Of more, a block is summed exactly by parts:
//! adding and subtracting a power of two σ far above them splits each into a multiple of σ's last place and a rest,
//! without error, and those multiples sum up in a double without error. Twice that, and only of doubles more than 2^30
//! times smaller than the block's largest a rest is left, for the accumulator.

use dashu_int::IBig;

use super::dyadic::Dyadic;
use super::exact_linear::ExactVector;
use super::exact_sum::ExactSum;
use super::scaling::{decompose, power_of_two, power_of_two_below};

/// Doubles summed at once.
const BLOCK: usize = 64;

/// Doubles side by side.
const LANES: usize = 4;

/// Bits of an integer that are left when mantissas of a block have been added up: 53 for a mantissa, 6 for their
/// number, one for the sign.
const SHIFT_LIMIT: i32 = 128 - 53 - 6 - 1;

/// Magnitudes of a block's largest double between which no σ overflows and no part is lost to underflow.
const SMALLEST: f64 = power_of_two(-900);
const LARGEST: f64 = power_of_two(1000);

/// Σ sign · v, exactly.
pub(crate) fn signed_sum(terms: impl Iterator<Item = ([f64; 3], i8)>) -> ExactVector {
    let mut sums: Option<[ExactSum; 3]> = None;
    let mut blocks = [[0.0; BLOCK]; 3];
    let mut count = 0;
    for (v, sign) in terms {
        if count == BLOCK {
            flush(sums.get_or_insert_default(), &mut blocks, BLOCK);
            count = 0;
        }
        for (block, coordinate) in blocks.iter_mut().zip(v) {
            block[count] = f64::from(sign) * coordinate;
        }
        count += 1;
    }
    if sums.is_none()
        && let [Some(x), Some(y), Some(z)] = blocks.each_ref().map(|block| short_sum(&block[..count]))
    {
        return [x, y, z];
    }
    let whole = count.next_multiple_of(LANES);
    for block in &mut blocks {
        block[count..whole].fill(0.0);
    }
    let sums = sums.get_or_insert_default();
    flush(sums, &mut blocks, whole);
    sums.each_ref().map(ExactSum::value)
}

/// The sum of at most [`BLOCK`] doubles as an integer times a power of two, if it is short enough.
fn short_sum(values: &[f64]) -> Option<Dyadic> {
    let mut exponents = [i32::MAX, i32::MIN];
    for value in values.iter().filter(|value| **value != 0.0) {
        let (_, exponent) = decompose(*value);
        exponents = [exponents[0].min(exponent), exponents[1].max(exponent)];
    }
    let [least, most] = exponents;
    if least > most {
        return Some(Dyadic::zero());
    }
    if most - least > SHIFT_LIMIT {
        return None;
    }
    let total: i128 = values.iter().filter(|value| **value != 0.0).fold(0, |total, value| {
        let (mantissa, exponent) = decompose(*value);
        total + (i128::from(mantissa) << (exponent - least))
    });
    Some(Dyadic::new(IBig::from(total), i64::from(least)))
}

fn flush(sums: &mut [ExactSum; 3], blocks: &mut [[f64; BLOCK]; 3], count: usize) {
    for (sum, block) in sums.iter_mut().zip(blocks) {
        add_block(sum, &mut block[..count]);
    }
}

/// Adds the doubles of a block, exactly, and leaves what it has not room for.
fn add_block(sum: &mut ExactSum, block: &mut [f64]) {
    let largest = block.iter().fold(0.0f64, |m, v| if v.abs() > m { v.abs() } else { m });
    if largest == 0.0 {
        return;
    }
    if !(SMALLEST..LARGEST).contains(&largest) {
        block.iter().for_each(|&v| sum.add(v));
        return;
    }
    // the power of two not above the largest, times 2^10: BLOCK multiples below 2^1 times the power stay below σ
    let power = power_of_two_below(largest);
    let coarse = power * 1024.0;
    sum.add(extract(block, coarse));
    // what is left is at most half of σ's last place, 2^-53 σ: 2^-44 times the power
    let fine = coarse * (1024.0 * f64::EPSILON);
    sum.add(extract(block, fine));
    block.iter().filter(|v| **v != 0.0).for_each(|&v| sum.add(v));
}

/// Takes the multiples of the last place of σ out of the doubles, and returns their sum.
fn extract(block: &mut [f64], sigma: f64) -> f64 {
    let mut sums = [0.0; LANES];
    for row in block.as_chunks_mut::<LANES>().0 {
        for (sum, value) in sums.iter_mut().zip(row) {
            let part = (sigma + *value) - sigma;
            *sum += part;
            *value -= part;
        }
    }
    sums.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    fn value() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => -1.0..1.0f64,
            2 => -1e-12..1e-12f64,
            1 => any::<u64>().prop_map(|bits| Some(f64::from_bits(bits)).filter(|v| v.is_finite()).unwrap_or(f64::MAX)),
            1 => (-9i32..9).prop_map(|i| f64::from(i) * f64::from_bits(1)),
        ]
    }

    properties! {
        #![proptest_config(crate::property_cases::config(300))]

        #[test]
        fn sums_are_exact(values in proptest::collection::vec((value(), -1i8..2), 0..600)) {
            let sum = signed_sum(values.iter().map(|&(v, sign)| ([v, 1.0, -v], sign)));
            let truth =
                values.iter().fold(Dyadic::zero(), |sum, &(v, sign)| sum + Dyadic::from_f64(f64::from(sign) * v));
            prop_assert_eq!(&sum[0], &truth);
            prop_assert_eq!(&sum[2], &-truth);
            let count = values.iter().map(|(_, sign)| f64::from(*sign)).sum();
            prop_assert_eq!(&sum[1], &Dyadic::from_f64(count));
        }
    }

    #[test]
    fn few_doubles_of_similar_sizes_are_summed_up_as_integers() {
        let one = |value: f64| Dyadic::from_f64(value);
        assert_eq!([short_sum(&[]), short_sum(&[0.0, -0.0])], [Some(Dyadic::zero()), Some(Dyadic::zero())]);
        assert_eq!(short_sum(&[3.0, 0.0, 2.5, -1.25]), Some(one(4.25)));
        assert_eq!(short_sum(&[1.5, 1.25]), Some(one(2.75)));
        // the most that an integer has room for, and one place more
        let largest = power_of_two(53) - 1.0;
        let mut block = [largest * power_of_two(SHIFT_LIMIT - 52); BLOCK];
        block[7] = 1.0;
        let sum = (0..BLOCK).fold(Dyadic::zero(), |sum, k| sum + one(block[k]));
        assert_eq!(short_sum(&block), Some(sum));
        block[7] = 0.5;
        assert_eq!(short_sum(&block), None);
        // the sum is in units of the last place of the least
        let [x, ..] = signed_sum([([4.0, 1.0, 1.0], 1), ([1.0; 3], -1)].into_iter());
        assert_eq!((x.exponent(), x), (-52, one(3.0)));
    }

    #[test]
    fn two_steps_take_all_of_the_doubles_that_are_not_far_smaller_than_the_largest() {
        let mut sum = ExactSum::default();
        let mut block: [f64; BLOCK] = std::array::from_fn(|k| {
            let digits = (k as f64 + 1.5).sqrt();
            if k % 2 == 0 { digits } else { -digits * power_of_two(-26) }
        });
        let truth = block.iter().fold(Dyadic::zero(), |sum, v| sum + Dyadic::from_f64(*v));
        add_block(&mut sum, &mut block);
        assert_eq!((sum.value(), block), (truth, [0.0; BLOCK]));
    }
}
