//! A family of point sets as a value.

/// The number of points of an instance that lie on its convex hull.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HullSize {
    /// All of them, or all but a few that rounding pushes inside.
    NearlyAll,
    /// A vanishing fraction.
    Few,
    /// None in the usual sense: the hull is a segment.
    Flat,
}

/// A family of point sets in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// The points, in a sentence.
    pub description: &'static str,
    /// The number of points that lie on the hull.
    pub hull_size: HullSize,
    /// Whether the seed matters; if not, there is one instance of each size.
    pub is_random: bool,
    /// The instance with `n` points for a seed: a pure function.
    pub generate: fn(n: usize, seed: u64) -> Vec<[f64; 2]>,
}

impl Family {
    /// The instance with `n` points that belongs to `seed`.
    pub fn generate(&self, n: usize, seed: u64) -> Vec<[f64; 2]> {
        (self.generate)(n, seed)
    }
}
