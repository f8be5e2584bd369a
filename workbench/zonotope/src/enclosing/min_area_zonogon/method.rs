//! The methods by name: one for each method of the kernel that takes any number of lines.

use super::answer::{MinAreaError, MinAreaZonogon};
use super::by_kernel::min_area_by_kernel;
use crate::lad;
use crate::tally::Tally;

/// A method whose answers contain the points exactly and prove their lower bounds: [`by_kernel`](super::by_kernel) with
/// a method of the kernel, after which it is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`lad::by_pruning`], the default.
    #[default]
    Pruning,
    /// [`lad::by_line_search`].
    LineSearch,
    /// [`lad::by_slope_selection`], the paper's search.
    SlopeSelection,
}

impl Method {
    /// Every method, the default first.
    pub const ALL: [Self; 3] = [Self::Pruning, Self::LineSearch, Self::SlopeSelection];

    /// The method of the kernel that minimises over the lines ℓ_t.
    pub const fn kernel(self) -> lad::Method {
        match self {
            Self::Pruning => lad::Method::Pruning,
            Self::LineSearch => lad::Method::LineSearch,
            Self::SlopeSelection => lad::Method::SlopeSelection,
        }
    }

    /// The name of the method where questions name one: that of the kernel's method.
    pub const fn id(self) -> &'static str {
        self.kernel().id()
    }

    /// The method of an id.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The method in a few words.
    pub const fn title(self) -> &'static str {
        self.kernel().title()
    }

    /// The cost for n points, h of them vertices of the hull.
    pub fn cost(self) -> &'static str {
        match self {
            Self::Pruning => "O(n log n) for the hull, then O(h) expected",
            Self::LineSearch => "O(n log n) for the hull, then O(h) a line search, few searches",
            Self::SlopeSelection => "O(n log n) for the hull, then O(h log² h) expected",
        }
    }

    /// Whether the method works in a dimension: all of them in the plane alone.
    pub fn works_in(self, dimension: usize) -> bool {
        dimension == 2
    }

    /// The zonogon of least area around points of the plane, counting operations. `seed` decides the time, never the
    /// area.
    ///
    /// # Errors
    /// When there are no points, too many, or one is not finite.
    pub fn solve(self, points: &[[f64; 2]], seed: u64, tally: &mut impl Tally) -> Result<MinAreaZonogon, MinAreaError> {
        min_area_by_kernel(self.kernel(), points, seed, tally)
    }
}
