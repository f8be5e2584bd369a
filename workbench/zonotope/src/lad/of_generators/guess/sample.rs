//! A part of the generators that stands for all of them.
//!
//! The sample is stratified: one run of neighbours is drawn from each of many stretches of equal length in the list.
//! Bodies are often built by a sweep or joined from parts, so that stretches differ from each other, and then a
//! stratified sample has the mean of all with a much smaller deviation than independent draws; where the order says
//! nothing it costs nothing. Runs are drawn and not single generators because a run of eight is copied in the time of
//! two that are picked. Where few long generators outweigh the others, stretches are equal in length of generators
//! instead of number.

use std::ops::Range;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, total};
use crate::numeric::lanes::octets::Octets;
use crate::numeric::linear::sum_norm;
use crate::numeric::reused::Reused;
use crate::tally::{Operation, Tally};

/// The number of generators at the end of the list that are always in the sample: those of a prism, which alone lead
/// out of its plane, are the last.
const ALWAYS_TAKEN: usize = 2;

/// The size of a sample, in terms of √n.
const SAMPLE_FACTOR: usize = 6;

/// Generators drawn side by side.
const RUN: usize = LANES;

/// Lengths are uneven, and long generators more likely to be drawn, where the mean square of the lengths exceeds the
/// square of their mean by this factor.
const UNEVEN_SPREAD: f64 = 4.0;

/// Rounds in which the length of a stretch is corrected for the generators that are longer than a stretch.
const STRETCH_STEPS: usize = 8;

/// The golden ratio's fraction in units of 2^-32: its multiples spread evenly over the unit interval and keep step with
/// no period of a list, as equal places in all stretches would.
const GOLDEN_FRACTION: u32 = 0x9e37_79b9;

/// A sample: generators, or multiples of some of them.
pub(crate) struct Sample {
    pub(crate) vectors: Reused<[f64; 3]>,
    /// Generators longer than this stand for themselves alone; all others stand for those of their stretch.
    pub(crate) longest: f64,
}

impl Sample {
    /// A sample of some 6 √n generators, from stretches of equal number; where lengths are very uneven, from stretches
    /// of equal length in all, which takes a second pass.
    pub(crate) fn of(query: &dyn KernelQuery, tally: &mut dyn Tally) -> Self {
        let n = query.len();
        let runs = ((SAMPLE_FACTOR * n.isqrt() + n / 128) / RUN).clamp(1, n.div_ceil(RUN));
        let mut vectors = Reused::with_capacity(RUN * runs + ALWAYS_TAKEN);
        let parts = query.parts();
        // places in units of 2^-32, so that one division does for all
        let step = ((n as u64) << 32) / runs as u64;
        let room = step.saturating_sub((RUN as u64) << 32) >> 16;
        for i in 0..runs {
            let within = u64::from((i as u32).wrapping_mul(GOLDEN_FRACTION) >> 16) * room;
            let start = ((i as u64 * step + within) >> 32) as usize;
            copy_range(&parts, start..(start + RUN).min(n), &mut vectors);
        }
        let size = vectors.len();
        copy_range(&parts, n - ALWAYS_TAKEN.min(n)..n, &mut vectors);
        tally.add(Operation::GeneratorRead, vectors.len() as u64);
        let [sum, squares] = dispatch!(level(), simd => lengths_and_squares(simd, &vectors[..size]));
        let is_uneven = squares * size as f64 > UNEVEN_SPREAD * sum * sum;
        if !is_uneven {
            return Self { vectors, longest: f64::INFINITY };
        }
        tally.add(Operation::GeneratorRead, n as u64);
        let lengths: Reused<f64> = vectors.iter().map(sum_norm).collect();
        let share = n as f64 / (size * size) as f64;
        // a generator that is longer counts for one stretch
        let shorter = |stretch: f64| lengths.iter().map(|length| length.min(stretch)).sum::<f64>() * share;
        let stretch = (0..STRETCH_STEPS).fold(sum * share, |stretch, _| shorter(stretch));
        Self::by_length(query, stretch, size)
    }

    /// The share of the sample in all generators.
    pub(crate) fn part_of(&self, query: &dyn KernelQuery) -> f64 {
        self.vectors.len() as f64 / query.len() as f64
    }

    /// One generator for each `stretch` of summed-up length, made as long as a stretch; a longer generator is taken
    /// as it is.
    fn by_length(query: &dyn KernelQuery, stretch: f64, expected: usize) -> Self {
        let mut vectors = Reused::with_capacity(2 * expected);
        let mut missing = stretch / 2.0;
        for v in query.generators().take(query.len() - ALWAYS_TAKEN) {
            let length = sum_norm(&v);
            missing -= length;
            if missing <= 0.0 {
                let factor = stretch / length;
                vectors.push(if factor > 1.0 { v.map(|c| factor * c) } else { v });
                missing = if missing > -stretch { missing + stretch } else { missing.rem_euclid(stretch) };
            }
        }
        vectors.extend((query.len() - ALWAYS_TAKEN..query.len()).map(|i| query.generator(i)));
        Self { vectors, longest: stretch }
    }
}

/// Adds the generators of a range to a list, in doubles.
fn copy_range([first, second]: &[Part<'_>; 2], range: Range<usize>, list: &mut Vec<[f64; 3]>) {
    let middle = first.rows.len();
    let own = range.start.min(middle)..range.end.min(middle);
    let others = range.start.max(middle) - middle..range.end.max(middle) - middle;
    for (part, range) in [(first, own), (second, others)] {
        part.copy(&part.rows.list()[range], list);
    }
}

/// Σ |v|_1, and the sum of the squares.
#[inline(always)]
fn lengths_and_squares<S: Simd>(simd: S, vectors: &[[f64; 3]]) -> [f64; 2] {
    let octets = Octets::new(vectors, &[]);
    let (mut sum, mut squares) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 0.0));
    for k in 0..octets.len() {
        let [x, y, z] = octets.load(simd, k);
        let length = x.abs() + y.abs() + z.abs();
        sum += length;
        squares += length * length;
    }
    [total(sum), total(squares)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::query::Query;

    #[test]
    fn even_lengths_are_sampled_by_place() {
        let body: Vec<[f64; 3]> = (0..4096).map(|i| [1.0, f64::from(i), 5000.0]).collect();
        let query = Query::new([0.0; 3], [1.0; 3], &body).expect("finite");
        let sample = Sample::of(&query, &mut ());
        assert_eq!((sample.vectors.len(), sample.longest), (6 * 64 + 32 + ALWAYS_TAKEN, f64::INFINITY));
        assert!(sample.vectors.is_sorted_by(|a, b| a[1] < b[1]));
        assert_eq!(sample.vectors[sample.vectors.len() - 1], body[4095]);
    }

    #[test]
    fn uneven_lengths_are_sampled_by_length() {
        // one in a hundred is a thousand times as long as the others
        let length = |i: usize| if i.is_multiple_of(100) { 1000.0 } else { 1.0 };
        let body: Vec<[f64; 3]> = (0..10_000).map(|i| [length(i), 0.0, 0.0]).collect();
        let query = Query::new([0.0; 3], [1.0; 3], &body).expect("finite");
        let sample = Sample::of(&query, &mut ());
        assert!((60..1400).contains(&sample.vectors.len()), "{}", sample.vectors.len());
        let total: f64 = body.iter().map(|v| v[0]).sum();
        let own: f64 = sample.vectors.iter().map(|v| v[0]).sum();
        assert!((own / total - 1.0).abs() < 0.05, "{own} for {total}");
        assert!(sample.longest < 1000.0 && sample.vectors.iter().filter(|v| v[0] == 1000.0).count() == 100);
    }
}
