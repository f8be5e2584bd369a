//! What is asked of a displacement or of bodies, and what is answered.
//!
//! | file | what it holds |
//! |---|---|
//! | [`Location`] | where the end of a displacement lies, with its proof |
//! | [`Gauge`] | how many times the zonotope must be taken to hold a displacement |
//! | `of_bodies` | the questions as methods of [`Zonotope`](crate::zonotope::Zonotope) |
//! | `of_prepared_bodies` | the same in space for a [`PreparedBody`](crate::zonotope::PreparedBody) |
//! | `of_posed_bodies` | the same in space for a body under a pose, [`PosedZonotope`] |

mod gauge;
mod location;
mod of_bodies;
mod of_posed_bodies;
mod of_prepared_bodies;

pub use gauge::Gauge;
pub use location::{Location, Separation, Status, Witness};
pub use of_posed_bodies::PosedZonotope;
