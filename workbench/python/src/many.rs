//! The same question about many vectors, on as many threads as pay.

use rayon::prelude::*;

/// Readings of a generator below which one thread answers all: about a fifth of a millisecond of work.
const READINGS_OF_ONE_THREAD: usize = 1 << 18;

/// Vectors that a thread takes at a time.
const VECTORS_AT_A_TIME: usize = 256;

/// The answers about vectors, in their order, when each reads so many generators. The first error is that of the first
/// vector that has one, whatever the threads do.
pub(crate) fn each<const D: usize, T: Send, E: Send>(
    vectors: &[[f64; D]],
    readings: usize,
    ask: impl Fn([f64; D]) -> Result<T, E> + Sync,
) -> Result<Vec<T>, (usize, E)> {
    let asked = |(index, &vector): (usize, &[f64; D])| ask(vector).map_err(|error| (index, error));
    if vectors.len().saturating_mul(readings) < READINGS_OF_ONE_THREAD || vectors.len() <= VECTORS_AT_A_TIME {
        return vectors.iter().enumerate().map(asked).collect();
    }
    let answers: Vec<_> = vectors.par_iter().enumerate().with_min_len(VECTORS_AT_A_TIME).map(asked).collect();
    answers.into_iter().collect()
}
