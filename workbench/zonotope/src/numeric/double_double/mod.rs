//! Numbers of two doubles, for what one double cannot tell apart and exact arithmetic is too slow for.
//!
//! | file | what it holds |
//! |---|---|
//! | `plain` | the sum of two doubles as one number, 104 bits, without a bound on its error |
//! | `bounded` | the same with a bound on the distance from the exact value, 98 bits: comparisons know whether they are certain |
//! | `precision` | the precisions in which a sign is decided, one after another |
//! | `direction` | an exact direction of space, and the signs of its products with vectors |

mod bounded;
mod direction;
mod plain;
mod precision;

pub(crate) use bounded::BoundedDoubleDouble;
pub(crate) use direction::DoubleDoubleDirection;
pub(crate) use plain::DoubleDouble;
pub(crate) use precision::Precision;
