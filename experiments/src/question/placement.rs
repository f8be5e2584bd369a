//! The place of a question's point: clearly in, clearly out, near the boundary on either side, or on it.

use families::source::RandomSource;
use zonotope::numeric::dyadic::Dyadic;

/// The place of the point relative to the boundary of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Stable name.
    pub id: &'static str,
    wanted: Wanted,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Wanted {
    /// A gauge from a range, clearly away from 1.
    Between(f64, f64),
    /// A gauge of 1 plus this, within a tenth of it.
    Near(f64),
    /// A gauge of exactly 1.
    Exactly,
}

/// Every placement, in the order in which reports list them.
pub static PLACEMENTS: [Placement; 11] = [
    Placement { id: "overlapping", wanted: Wanted::Between(0.25, 0.75) },
    Placement { id: "separated", wanted: Wanted::Between(1.5, 4.0) },
    near("inside_1e-3", -1e-3),
    near("outside_1e-3", 1e-3),
    near("inside_1e-6", -1e-6),
    near("outside_1e-6", 1e-6),
    near("inside_1e-9", -1e-9),
    near("outside_1e-9", 1e-9),
    near("inside_1e-12", -1e-12),
    near("outside_1e-12", 1e-12),
    Placement { id: "touching", wanted: Wanted::Exactly },
];

const fn near(id: &'static str, excess: f64) -> Placement {
    Placement { id, wanted: Wanted::Near(excess) }
}

impl Placement {
    /// The placement called `id`, if there is one.
    pub fn find(id: &str) -> Option<Self> {
        PLACEMENTS.into_iter().find(|placement| placement.id == id)
    }

    /// Whether the point lies on the boundary exactly.
    pub fn is_touching(&self) -> bool {
        self.wanted == Wanted::Exactly
    }

    /// Whether the point is far from the boundary.
    pub fn is_clear(&self) -> bool {
        matches!(self.wanted, Wanted::Between(..))
    }

    /// The relative gap between the point and the boundary, if it is near it.
    pub fn gap(&self) -> Option<f64> {
        match self.wanted {
            Wanted::Near(excess) => Some(excess.abs()),
            Wanted::Between(..) | Wanted::Exactly => None,
        }
    }

    /// The factor that takes a point of the boundary to a point of this placement.
    pub(super) fn factor(&self, source: &mut RandomSource) -> Dyadic {
        let one = Dyadic::from_f64(1.0);
        match self.wanted {
            Wanted::Between(low, high) => Dyadic::from_f64(low + (high - low) * source.unit()),
            Wanted::Near(excess) => one + Dyadic::from_f64(excess),
            Wanted::Exactly => one,
        }
    }

    /// Whether certified bounds of the gauge less 1 are those of this placement.
    pub(super) fn accepts(&self, [low, high]: [f64; 2]) -> bool {
        match self.wanted {
            Wanted::Between(smallest, largest) => smallest - 1.001 <= low && high <= largest - 0.999,
            Wanted::Near(excess) => {
                let near = |bound: f64| (bound - excess).abs() <= 0.1 * excess.abs();
                near(low) && near(high)
            }
            Wanted::Exactly => low == 0.0 && high == 0.0,
        }
    }
}
