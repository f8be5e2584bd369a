//! The hull of points with its lines ℓ_t, as several pictures have it.

use serde_json::{Value, json};
use zonotope::enclosing::bisectors::Bisectors;
use zonotope::hull::antipodal::{FarthestVertex, farthest_vertices};
use zonotope::hull::{ConvexHull, HullError, convex_hull};

use super::picture::vectors;
use crate::fields::Fields;
use crate::refusal::{Code, Refusal};

/// A hull with the farthest vertex of each edge.
pub(super) struct Hull {
    pub(super) hull: ConvexHull,
    pub(super) farthest: Vec<FarthestVertex>,
}

impl Hull {
    /// The hull of the field `points`.
    pub(super) fn of(fields: &Fields<'_>) -> Result<Self, Refusal> {
        let points = fields.vectors::<2>("points")?;
        let hull = convex_hull(&points, &mut ()).map_err(|error| {
            let code = if error == HullError::Empty { Code::Empty } else { Code::TooLarge };
            Refusal::new(code, error.to_string())
        })?;
        let farthest = farthest_vertices(&hull, &mut ());
        Ok(Self { hull, farthest })
    }

    /// The lines ℓ_t.
    pub(super) fn bisectors(&self) -> Bisectors<'_> {
        Bisectors::new(&self.hull, &self.farthest)
    }

    /// The hull as positions of points, the farthest vertex of each edge as a position in the hull, and two points of
    /// each line ℓ_t.
    pub(super) fn to_json(&self) -> Value {
        let bisectors = self.bisectors();
        let lines: Vec<Value> = (0..self.hull.edge_count()).map(|t| vectors(&bisectors.midpoints(t))).collect();
        json!({
            "hull": self.hull.indices().iter().map(|index| index.get()).collect::<Vec<usize>>(),
            "farthest": self.farthest.iter().map(|farthest| farthest.vertex().get()).collect::<Vec<usize>>(),
            "lines": lines,
        })
    }
}
