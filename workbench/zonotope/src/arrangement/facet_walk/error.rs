//! Why a walk is refused.

use thiserror::Error;

use crate::arrangement::dynamic_hull::TooManySites;
use crate::numeric::non_finite::NonFinite;

/// Why there is no walk, or why it does not go where it was sent; the walk is then where it was.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum WalkError {
    /// A coordinate is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There are more generators than can be numbered.
    #[error(transparent)]
    TooMany(#[from] TooManySites),
    /// The generators do not span space: the body has no interior, and no facets to walk on.
    #[error("the generators span {rank} dimensions, not 3: the body is flat")]
    Flat {
        /// The dimension of the span: 0, 1 or 2.
        rank: usize,
    },
    /// A facet is named by a generator that is not there.
    #[error("there is no generator {generator}, only {count} of them")]
    UnknownGenerator {
        /// The index in the name.
        generator: usize,
        /// How many generators there are.
        count: usize,
    },
    /// A facet is named by two generators that are not in ascending order.
    #[error("the generators of a facet's name ascend, and {first} is not below {second}")]
    NotAscending {
        /// The first index.
        first: usize,
        /// The second one.
        second: usize,
    },
    /// A facet is named by two generators that span no plane.
    #[error("generators {first} and {second} are parallel or zero and span no facet")]
    NoPlane {
        /// The first index.
        first: usize,
        /// The second one.
        second: usize,
    },
    /// The facet has no edge of this number.
    #[error("there is no edge {edge}, the facet has {count} of them")]
    UnknownEdge {
        /// The number that was given.
        edge: usize,
        /// How many edges the facet has.
        count: usize,
    },
    /// A ray along the zero vector leaves the body nowhere.
    #[error("the direction of a ray is the zero vector")]
    NoDirection,
}
