//! Problem: a zonotope of few generators around a zonotope of many.
//!
//! A bounding volume is as cheap as it has few generators. Given a zonotope A and a number k, or a precision ε, a rule
//! of order reduction finds a zonotope B around A with at most k generators, or with H(A, B) ≤ ε D(A), where H is the
//! Hausdorff distance and D the diameter. B contains A exactly, has its centre, and comes with the proof: shares
//! ([`Shares`]), which write every generator of A in terms of B's, or the facet normals of B.
//!
//! | method | cost for n generators | error, in space |
//! |---|---|---|
//! | [`by_clusters`] | O(n k) for each of some dozen rounds, C(k, D − 1) passes to prove containment | fitted; the default |
//! | [`by_patches`] | O(n) for a precision, O(n log n) for a count | the paper's, Lemma 5.5: O(1 / √k) |
//! | [`keeping`], five rules in use | O(n log n), one O(n (n − k)) | no bound |
//!
//! [`contains`] decides whether a zonotope contains another one; [`brute_force`] does in rationals: the truth that all
//! rules are held to. [`Method`] has them by name, and the best of all; [`hausdorff`] bounds what they cost.

mod answer;
pub mod brute_force;
pub mod by_clusters;
pub mod by_patches;
mod cells;
mod containment;
mod contains;
mod distance;
mod frame_cover;
pub mod hausdorff;
pub mod keeping;
mod method;
mod share_distance;
mod shares;

pub use answer::{Containment, Problem, Reduced, ReductionError};
pub use contains::contains;
pub use method::Method;
pub use shares::{Share, ShareFlaw, Shares};
