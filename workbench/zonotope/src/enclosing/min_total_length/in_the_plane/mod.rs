//! The plane, where the total length of a zonogon is a quarter of its perimeter.
//!
//! With the centre O fixed the smallest zonogon is conv(P ∪ P'), P' the points reflected in O, and no convex set around P ∪ P' has a
//! smaller perimeter. The perimeter is a convex function of O, so only the best centre is sought; no linear program is needed.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`by_golden_section`] | some thousand convex hulls | the truth, in floating point, without a proof |
//! | `best_center` | some fifty convex hulls | cutting planes; what runs, with generators and multipliers |

mod best_center;
pub mod by_golden_section;

pub(super) use best_center::least_in_plane;
pub use by_golden_section::least_length;
