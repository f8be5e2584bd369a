//! A family of generators as a value.

/// A family of generators in R^D.
#[derive(Clone, Copy, Debug)]
pub struct BodyFamily<const D: usize> {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// The generators, in a sentence.
    pub description: &'static str,
    /// Whether the seed matters; if not, there is one body of each size.
    pub is_random: bool,
    /// `n` generators for a seed: a pure function.
    pub generate: fn(n: usize, seed: u64) -> Vec<[f64; D]>,
}

impl<const D: usize> BodyFamily<D> {
    /// The `n` generators that belong to `seed`.
    pub fn generate(&self, n: usize, seed: u64) -> Vec<[f64; D]> {
        (self.generate)(n, seed)
    }
}
