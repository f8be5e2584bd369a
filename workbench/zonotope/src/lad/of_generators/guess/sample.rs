//! A part of the generators that stands for all of them.
//!
//! The sample is stratified: one generator is drawn from each of many stretches of equal length in the list. Bodies
//! are often built by a sweep or joined from parts, so that neighbours in the list resemble each other, and then a
//! stratified sample has the mean of all with a much smaller deviation than independent draws; where the order says
//! nothing it costs nothing. Where few long generators outweigh the others, stretches are equal in length of
//! generators instead of number.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::lad::of_generators::generators::{KernelQuery, generator_of};
use crate::numeric::linear::sum_norm;
use crate::numeric::reused::Reused;
use crate::seed::GUESS_SEED;
use crate::tally::{Operation, Tally};

/// The number of generators at the end of the list that are always in the sample: those of a prism, which alone lead
/// out of its plane, are the last.
const ALWAYS_TAKEN: usize = 2;

/// Lengths are uneven, and long generators more likely to be drawn, where the mean square of the lengths exceeds the
/// square of their mean by this factor.
const UNEVEN_SPREAD: f64 = 4.0;

/// Rounds in which the length of a stretch is corrected for the generators that are longer than a stretch.
const STRETCH_STEPS: usize = 8;

/// A sample: generators, or multiples of some of them.
pub(crate) struct Sample {
    pub(crate) vectors: Reused<[f64; 3]>,
    /// Generators longer than this stand for themselves alone; all others stand for those of their stretch.
    pub(crate) longest: f64,
}

impl Sample {
    /// A sample of some 6 √n generators, one from each of as many stretches of equal number; where lengths are very
    /// uneven, from stretches of equal length in all, which takes a second pass.
    pub(crate) fn of(query: &dyn KernelQuery, tally: &mut dyn Tally) -> Self {
        let n = query.len();
        let size = (6 * n.isqrt() + n / 128).min(n);
        tally.add(Operation::GeneratorRead, size as u64);
        let mut random = Pcg64Mcg::seed_from_u64(GUESS_SEED);
        // places in units of 2^-32, so that one division does for all
        let step = ((n as u64) << 32) / size as u64;
        let parts = query.parts();
        let picks = (0..size).map(|i| {
            let within = (u64::from(random.random::<u32>() >> 16) * step) >> 16;
            let place = ((i as u64 * step + within) >> 32) as usize;
            generator_of(&parts, if i + ALWAYS_TAKEN >= size { n - size + i } else { place })
        });
        let vectors: Reused<[f64; 3]> = picks.collect();
        let (mut sum, mut squares) = (0.0, 0.0);
        for v in &vectors[..size - ALWAYS_TAKEN] {
            let length = sum_norm(v);
            sum += length;
            squares += length * length;
        }
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

    /// What part of all generators the sample is.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::query::Query;

    #[test]
    fn even_lengths_are_sampled_by_place() {
        let body: Vec<[f64; 3]> = (0..4096).map(|i| [1.0, f64::from(i), 5000.0]).collect();
        let query = Query::new([0.0; 3], [1.0; 3], &body).expect("finite");
        let sample = Sample::of(&query, &mut ());
        assert_eq!((sample.vectors.len(), sample.longest), (6 * 64 + 32, f64::INFINITY));
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
