//! The methods for swept volumes by name.

use super::{
    Sweep, SweepError, by_farthest_vertex, by_least_rectangle, by_least_zonogon, by_middle_placement, by_shadow,
    by_turned_generators,
};
use crate::zonotope::Zonotope;

/// A method that encloses all placements of a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[non_exhaustive]
pub enum Method {
    /// [`by_farthest_vertex`], Theorem 6.1, the default.
    #[default]
    ByFarthestVertex,
    /// [`by_middle_placement`].
    ByMiddlePlacement,
    /// [`by_least_rectangle`].
    ByLeastRectangle,
    /// [`by_least_zonogon`].
    ByLeastZonogon,
    /// [`by_shadow`].
    ByShadow,
    /// [`by_turned_generators`].
    ByTurnedGenerators,
}

impl Method {
    /// Every method, the default first.
    pub const ALL: [Self; 6] = [
        Self::ByFarthestVertex,
        Self::ByMiddlePlacement,
        Self::ByLeastRectangle,
        Self::ByLeastZonogon,
        Self::ByShadow,
        Self::ByTurnedGenerators,
    ];

    /// The name of the method's file.
    pub const fn id(self) -> &'static str {
        match self {
            Self::ByFarthestVertex => "by_farthest_vertex",
            Self::ByMiddlePlacement => "by_middle_placement",
            Self::ByLeastRectangle => "by_least_rectangle",
            Self::ByLeastZonogon => "by_least_zonogon",
            Self::ByShadow => "by_shadow",
            Self::ByTurnedGenerators => "by_turned_generators",
        }
    }

    /// The method with a name.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The name for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::ByFarthestVertex => "Theorem 6.1: a square around the circle of the farthest vertex",
            Self::ByMiddlePlacement => "A square around the circle from the middle placement",
            Self::ByLeastRectangle => "The least rectangle around the arcs",
            Self::ByLeastZonogon => "The zonogon of least area around the arcs",
            Self::ByShadow => "The shadow of the body, turned and scaled",
            Self::ByTurnedGenerators => "Each generator turned",
        }
    }

    /// The cost of a volume of a body with n generators.
    pub fn cost(self) -> &'static str {
        match self {
            Self::ByFarthestVertex | Self::ByMiddlePlacement | Self::ByLeastRectangle | Self::ByLeastZonogon => {
                "O(n log n)"
            }
            Self::ByShadow | Self::ByTurnedGenerators => "O(n)",
        }
    }

    /// A zonotope around all placements.
    ///
    /// # Errors
    /// [`SweepError::OutOfRange`] if it leaves the range of doubles.
    pub fn volume(self, sweep: &Sweep, body: &Zonotope<3>) -> Result<Zonotope<3>, SweepError> {
        match self {
            Self::ByFarthestVertex => by_farthest_vertex::volume(sweep, body),
            Self::ByMiddlePlacement => by_middle_placement::volume(sweep, body),
            Self::ByLeastRectangle => by_least_rectangle::volume(sweep, body),
            Self::ByLeastZonogon => by_least_zonogon::volume(sweep, body),
            Self::ByShadow => by_shadow::volume(sweep, body),
            Self::ByTurnedGenerators => by_turned_generators::volume(sweep, body),
        }
    }
}
