//! The plane, where the total length of a zonogon is a quarter of its perimeter.
//!
//! For a fixed centre O the smallest zonogon is conv(P ∪ P'), where P' are the points reflected in O, and no convex set
//! around P ∪ P' has a smaller perimeter. The perimeter is a convex function of O. So the problem is one of two
//! variables, the centre, and needs no linear program.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`by_golden_section`] | about 3,800 convex hulls | in floating point, without a proof; what the other methods are held to |
//! | `best_center` | some fifty convex hulls | cutting planes, with generators and multipliers; what `by_vertex_sets` calls |

mod best_center;
pub mod by_golden_section;

pub(super) use best_center::min_length_in_plane;
pub use by_golden_section::least_length;
