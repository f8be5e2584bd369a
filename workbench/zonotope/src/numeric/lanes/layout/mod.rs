//! How vectors of space lie in memory for a pass, and the sums that do not depend on what is asked.
//!
//! | file | what it holds |
//! |---|---|
//! | [`octet`] | eight vectors of space side by side, and how rows are taken apart into them |
//! | [`blocks`] | the same laid out beforehand |
//! | [`octets`] | rows eight by eight, from blocks or not |
//! | [`body_sums`] | what every question about a body needs, whatever its direction |
//! | [`rows`] | what a pass takes: rows, with the blocks and sums of a body that was prepared |

pub(crate) mod blocks;
pub(crate) mod body_sums;
pub(crate) mod octet;
pub(crate) mod octets;
pub(crate) mod rows;
