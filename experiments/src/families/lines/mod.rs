//! Families of lines a·x + b = 0 in the plane: inputs of the least absolute deviations kernel and of slope selection.
//!
//! | family | what is hard about it |
//! | --- | --- |
//! | `random_lines` | nothing: the reference |
//! | `lattice_lines` | few directions, many concurrent and parallel lines |
//! | `near_parallel_lines` | directions agree to 1e-12: vertices are far away or badly conditioned |
//! | `concurrent_lines` | all vertices are one point |
//! | `symmetric_lines` | vertices come in pairs with one x; the optimum is not unique |

mod concurrent;
mod lattice;
mod near_parallel;
mod random;
mod symmetric;

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

/// Every line family, in the order in which reports list them.
pub static LINE_FAMILIES: &[LineFamily] = &[
    random::RANDOM_LINES,
    lattice::LATTICE_LINES,
    near_parallel::NEAR_PARALLEL_LINES,
    concurrent::CONCURRENT_LINES,
    symmetric::SYMMETRIC_LINES,
];

/// The line family called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static LineFamily> {
    LINE_FAMILIES.iter().find(|family| family.id == id)
}
