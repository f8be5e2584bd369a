//! Methods that are here only to be raced, or held, against the library's own.
//!
//! | problem | method | where it meets the library's |
//! |---|---|---|
//! | membership and intersection | [`by_gjk`], as physics engines do it | `wrong-answers`, `collision-scaling`, the peers |
//! | first contact of moving bodies | [`first_contact`], as motion planners do it | `motion-misses` |
//! | linear programs | `simplex`, the engine microlp (feature `linear-programming`) | `wrong-answers`, `collision-scaling` |
//! | the tiling of Q | [`tiling`], by a sweep, in general position | the conformance tests |

pub mod by_gjk;
pub mod first_contact;
mod products;
#[cfg(feature = "linear-programming")]
pub mod simplex;
pub mod tiling;
