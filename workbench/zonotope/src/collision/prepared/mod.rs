//! Repeated queries: one body of space that is asked again and again, and what is built once so that a query reads a
//! part of the generators only (Lemma 5.3, Corollary 5.4).
//!
//! A single query about n generators has to read each of them at least once. Where the body stays and the points
//! change, a structure pays for itself after a number of queries; what it may cost in space is the caller's choice.
//!
//! | method | space | built in | a query | what it is |
//! |---|---|---|---|---|
//! | [`PreparedBody`](crate::zonotope::PreparedBody) | O(n) | O(n) | O(n) | the linear scan: passes over blocks |
//! | [`by_direction_tree`] | O(n) | O(n log n) | O(√n) on random bodies, above n on thin ones | sums of neighbours |
//! | [`by_cutting`] | O(m), n ≤ m ≤ n² | O(m log n) and the cutting | O(n²/m + log² n) | Lemma 5.3 and Corollary 5.4 |
//! | [`by_facets`] | O(n²) | O(n³), exact numbers | O(n²) | all facets written down, for small n |
//! | [`choice`] | within a budget | | | the one of these that costs least for so many queries |
//!
//! [`Zonotope::prepared_for`](crate::Zonotope::prepared_for) asks the last one, and has the methods of a body.
//!
//! Every answer is exact, and so is its proof, which has constant size until it is [written
//! out](by_direction_tree::Located::expand).
//! [`Explicit faces`](crate::collision::by_explicit_faces) answer a single query from the face lattice.

pub mod by_cutting;
pub mod by_direction_tree;
pub mod by_facets;
pub mod choice;

pub use by_direction_tree::DirectionTree;
pub use by_facets::PreparedByFacets;
pub use choice::QueryStructure;
