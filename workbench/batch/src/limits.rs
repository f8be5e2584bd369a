//! The most that one line of a batch may hold.

/// The longest line that is read, in bytes.
pub const MAX_LINE_BYTES: usize = 128 << 20;

/// The largest number of points, or of generators, in one question.
pub const MAX_VECTORS: usize = 2_000_000;
