//! A family of lines as a value.

/// A line { x : a·x + b = 0 } as the pair (a, b), with a not zero.
pub type LineRow = ([f64; 2], f64);

/// A family of line sets in the plane.
#[derive(Clone, Copy, Debug)]
pub struct LineFamily {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// The lines, in a sentence.
    pub description: &'static str,
    /// The instance with `n` lines for a seed: a pure function.
    pub generate: fn(n: usize, seed: u64) -> Vec<LineRow>,
}

impl LineFamily {
    /// The instance with `n` lines that belongs to `seed`.
    pub fn generate(&self, n: usize, seed: u64) -> Vec<LineRow> {
        (self.generate)(n, seed)
    }
}
