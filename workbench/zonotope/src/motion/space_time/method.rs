//! The methods for swept volumes by name.

use super::{
    by_farthest_vertex, by_least_rectangle, by_least_zonogon, by_middle_placement, by_shadow, by_turned_generators,
};
use crate::motion::sweep::{Sweep, SweepError};
use crate::tables::methods;
use crate::zonotope::Zonotope;

methods! {
    /// A method that encloses all placements of a sweep.
    pub enum Method;
    /// The cost of a volume of a body with n generators.
    fn cost;

    /// [`by_farthest_vertex`], Theorem 6.1, the default.
    ByFarthestVertex => "by_farthest_vertex", "Theorem 6.1: a square around the circle of the farthest vertex",
        "O(n log n)";
    /// [`by_middle_placement`].
    ByMiddlePlacement => "by_middle_placement", "A square around the circle from the middle placement", "O(n log n)";
    /// [`by_least_rectangle`].
    ByLeastRectangle => "by_least_rectangle", "The least rectangle around the arcs", "O(n log n)";
    /// [`by_least_zonogon`].
    ByLeastZonogon => "by_least_zonogon", "The zonogon of least area around the arcs", "O(n log n)";
    /// [`by_shadow`].
    ByShadow => "by_shadow", "The shadow of the body, turned and scaled", "O(n)";
    /// [`by_turned_generators`].
    ByTurnedGenerators => "by_turned_generators", "Each generator turned", "O(n)";
}

impl Method {
    /// A zonotope around all placements.
    ///
    /// # Errors
    /// [`SweepError::OutOfRange`] if it leaves the range of doubles.
    pub fn volume(self, sweep: &Sweep, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
        match self {
            Self::ByFarthestVertex => by_farthest_vertex::volume(sweep, body, &mut ()),
            Self::ByMiddlePlacement => by_middle_placement::volume(sweep, body),
            Self::ByLeastRectangle => by_least_rectangle::volume(sweep, body),
            Self::ByLeastZonogon => by_least_zonogon::volume(sweep, body),
            Self::ByShadow => by_shadow::volume(sweep, body),
            Self::ByTurnedGenerators => by_turned_generators::volume(sweep, body),
        }
    }
}
