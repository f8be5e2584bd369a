//! Why the faces of a zonotope are not listed.

use thiserror::Error;

/// The greatest number of directions whose faces have 32-bit indices.
pub const MAX_DIRECTIONS: usize = 46_000;

/// Why faces are not listed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FacesError {
    /// The faces are so many that their indices would not fit 32 bits.
    #[error(
        "{directions} directions of generators are more than {}, the most whose faces have 32-bit indices",
        MAX_DIRECTIONS
    )]
    TooManyDirections {
        /// The number of directions.
        directions: usize,
    },
}
