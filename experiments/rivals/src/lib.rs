//! Methods that are here only to be raced against the library's own: none of them proves what it answers.
//!
//! | problem | method | it is raced in |
//! |---|---|---|
//! | membership and intersection | [`by_gjk`], as physics engines do it | `wrong-answers`, `collision-scaling`, the peers |
//! | first contact of moving bodies | [`first_contact`], as motion planners do it | `motion-misses` |
//! | linear programs | `simplex`, the engine microlp (feature `linear-programming`) | `wrong-answers`, `collision-scaling` |

pub mod by_gjk;
pub mod first_contact;
mod products;
#[cfg(feature = "linear-programming")]
pub mod simplex;
