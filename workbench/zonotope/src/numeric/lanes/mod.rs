//! Passes over vectors: many terms summed up side by side in doubles, the same on every machine.
//!
//! | file | what it computes |
//! |---|---|
//! | `absolute_sum` | the support function of a centred zonotope |
//! | [`bit_places`] | the places of the bits that are set in a word |
//! | `bounded_sum` | the same in space, with a bound on its error from the same pass |
//! | `extreme_sum` | an extreme vertex of a centred zonotope |
//! | `first_orthogonal` | the vectors that may be the first to be orthogonal to a direction that turns |
//! | `extents` | the sums of magnitudes along the axes, which bound the errors of these passes |
//! | [`level`] | the vector instructions of the machine, chosen when the program runs |
//! | [`number`] | what the steps of a pass compute with: one number, or eight |
//! | `row_products` | dot products of rows of any length |
//! | `signed_factors` | the coefficients of an extreme point, made smaller |
//! | `bounded_sum/along` | support functions and extreme vertices along a few directions at once |
//! | `sum_in_pairs` | the support function and extreme vertices to twice the digits of a double, or exactly |
//! | [`layout`] | how vectors lie in memory: rows, eights of them, blocks |
//! | `partial_sums` | how many sums are kept side by side, and how they are joined |

mod absolute_sum;
pub(crate) mod bit_places;
mod bounded_sum;
mod extents;
mod extreme_sum;
mod first_orthogonal;
pub(crate) mod layout;
pub(crate) mod level;
pub(crate) mod number;
mod partial_sums;
mod row_products;
mod signed_factors;
mod sum_in_pairs;
#[cfg(test)]
pub(crate) mod test_vectors;

pub(crate) use layout::{blocks, body_sums, octet, octets, rows};
pub(crate) use sum_in_pairs::pair_lanes;

pub use absolute_sum::absolute_sum;
pub(crate) use absolute_sum::absolute_sum_of;
pub(crate) use bounded_sum::along::{absolute_sums, bounded_sums, extreme_sums};
pub(crate) use bounded_sum::{bounded_sum, bounded_sum_near};
pub use extents::Extents;
pub use extreme_sum::extreme_sum;
pub(crate) use extreme_sum::extreme_sum_of;
pub(crate) use first_orthogonal::first_orthogonal;
pub(crate) use row_products::{product_in_eights, product_in_fours, products_of_four_rows};
pub(crate) use signed_factors::signed_factors;
pub(crate) use sum_in_pairs::{Along, absolute_sum_in_pairs, add_extreme_exactly, extreme_sum_in_pairs};
