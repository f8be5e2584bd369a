//! The policy of random draws: every draw of the library comes from a seed, and no answer depends on it.
//!
//! A method that draws takes `seed: u64`, after the question and before the tally. The seed decides how long the search
//! takes and, where several optima are equally good, may decide which of them is found; never the optimum, its proof or
//! on which side of a boundary a point lies. The generator is `Pcg64Mcg`, whose stream is the same on every machine, so
//! the same seed gives the same bytes. Functions without a seed take [`DEFAULT_SEED`]; stages of the kernel that draw
//! on their own have another seed of this file, so that their draws are not those of the method that called them.

/// The seed of every function that does not ask for one.
pub const DEFAULT_SEED: u64 = 0;

/// The seed of the exact kernel where it solves what rounding left open.
pub(crate) const EXACT_STAGE_SEED: u64 = 0x5a;
