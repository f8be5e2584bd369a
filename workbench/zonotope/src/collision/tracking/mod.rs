//! Problem: how two moving bodies meet, frame by frame, where each frame is near the one before.
//!
//! A tracker carries what one frame found out to the next one. Each answer is exact, has a proof, and is that of a
//! fresh query: what is carried over saves time and decides nothing.
//!
//! | method | motions | a frame | what it carries |
//! |---|---|---|---|
//! | [`by_warm_kernel`] (default) | any matrix | O(1) while the last proof holds, else few generators | a proof with its room, the sums near the optimum |
//! | [`by_walking`] | translations | O(log² n) for each edge crossed | a facet of the sum of both bodies (Lemma 5.6) |
//!
//! A fresh query ([`Placed`](crate::Placed)) is O(n) for n generators of both bodies; the truth of any frame is that of
//! [`brute_force`](super::brute_force).

pub mod by_walking;
pub mod by_warm_kernel;

pub use by_walking::{Walked, WalkingTracker};
pub use by_warm_kernel::{Tracked, WarmTracker};
