//! Instance families: deterministic generators of point sets in the plane, of point clouds in two to four dimensions in
//! [`clouds`], of line sets for the kernel in [`lines`], and of zonotopes with questions about them in [`bodies`].
//!
//! A family is a static value; the instance is a function of the family, the number of points and a seed.
//! Transcendental functions come from `libm`, so instances agree bit for bit on every machine.
//!
//! | family | points on the hull | what it is for |
//! | --- | --- | --- |
//! | `circle`, `ellipse`, `ellipse_thin` | nearly all | the whole cost after the hull shows |
//! | `random_convex` | all | as above, with irregular edges |
//! | `regular_polygon` | all | centrally symmetric: all lines of 4.1 meet in one point |
//! | `gaussian`, `disc`, `clustered` | few | the hull is the cost |
//! | `lattice` | few | many ties |
//! | `symmetric`, `duplicates`, `collinear` | varies | degenerate input |

pub mod bodies;
pub mod circle;
pub mod clouds;
pub mod clustered;
pub mod degenerate;
pub mod disc;
pub mod ellipse;
pub mod gaussian;
pub mod lattice;
pub mod lines;
pub mod random_convex;
pub mod regular_polygon;
pub mod source;

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

/// Every point family, in the order in which reports list them.
pub static FAMILIES: &[Family] = &[
    circle::CIRCLE,
    ellipse::ELLIPSE,
    ellipse::ELLIPSE_THIN,
    random_convex::RANDOM_CONVEX,
    regular_polygon::REGULAR_POLYGON,
    gaussian::GAUSSIAN,
    clustered::CLUSTERED,
    disc::DISC,
    lattice::LATTICE,
    degenerate::SYMMETRIC,
    degenerate::DUPLICATES,
    degenerate::COLLINEAR,
];

/// The family called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static Family> {
    FAMILIES.iter().find(|family| family.id == id)
}

#[cfg(test)]
mod tests;
