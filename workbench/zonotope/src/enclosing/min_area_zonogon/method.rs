//! The methods by name: one for each method of the kernel that takes any number of lines.

use super::answer::{MinAreaError, MinAreaZonogon};
use super::by_kernel::min_area_by_kernel;
use crate::lad;
use crate::tables::methods;
use crate::tally::Tally;

methods! {
    /// A method whose answers contain the points exactly and prove their lower bounds: [`by_kernel`](super::by_kernel)
    /// with a method of the kernel, after which it is called.
    pub enum Method;
    /// The cost for n points, h of them vertices of the hull.
    fn cost;

    /// [`lad::by_pruning`], the default.
    Pruning => lad::Method::Pruning.id(), lad::Method::Pruning.title(), "O(n log n) for the hull, then O(h) expected";
    /// [`lad::by_line_search`].
    LineSearch => lad::Method::LineSearch.id(), lad::Method::LineSearch.title(),
        "O(n log n) for the hull, then O(h) a line search, few searches";
    /// [`lad::by_slope_selection`], the paper's search.
    SlopeSelection => lad::Method::SlopeSelection.id(), lad::Method::SlopeSelection.title(),
        "O(n log n) for the hull, then O(h log² h) expected";
}

impl Method {
    /// The method of the kernel that minimises over the lines ℓ_t.
    pub const fn kernel(self) -> lad::Method {
        match self {
            Self::Pruning => lad::Method::Pruning,
            Self::LineSearch => lad::Method::LineSearch,
            Self::SlopeSelection => lad::Method::SlopeSelection,
        }
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
