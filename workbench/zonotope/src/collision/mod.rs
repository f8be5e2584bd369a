//! Collision: where a point lies relative to a zonotope given by its generators, and so whether two zonotopes meet.
//!
//! Lemma 5.1 turns every question into one: where is the exact difference of two points relative to the zonotope of
//! some generators centred at the origin? [`Query`] is that question, [`Location`] its answer with a proof.
//!
//! - membership: the displacement from the centre to the point;
//! - intersection: the displacement between the centres, relative to the generators of both bodies;
//! - gauge: the least t ≥ 0 for which t times the zonotope holds the displacement.
//!
//! | method | dimensions | cost for n generators | what it is |
//! |---|---|---|---|
//! | [`by_lad`] (default) | 1 to 4 | O(n) expected | the kernel on the plane of directions with u · p = 1 |
//! | [`by_slope_selection`] | 1 to 3 | O(n log² n) expected | the paper's search over separators (Theorem 5.2) |
//! | [`by_lad_in_r4`] | 4 | O(n) a step, few steps | the kernel in three variables; the default there |
//! | [`brute_force`] | any D | O(n^D), exact rationals | the truth: every facet normal |
//! | [`by_explicit_faces`] | 1 to 3 | Ω(n²) | every facet of the explicit body |
//! | [`by_linear_program`] | any D | the engine's | floating point, proved exactly or not answered |
//!
//! [`Method`] names them, for callers that choose one when they run, and says the default of each dimension. The
//! methods of [`Zonotope`](crate::zonotope::Zonotope) (`contains`, `locate`, `gauge`, `intersects`, `intersection`) ask
//! that default; in space those of [`Placed`] ask about a body under a pose, or about one that was prepared.
//!
//! An answer of a body, [`Located`], has constant size near the boundary; expanded it goes straight to a verifier.
//! Answers of a single method do so by [`Location::with_nearest_basis`].
//!
//! [`prepared`] has structures for a body that is asked again and again. [`hierarchy`] has bodies around and within a
//! body, from coarse to fine, which tell whether two bodies meet from few generators unless they nearly touch.
//! [`tracking`] follows two bodies that move.
//!
//! [`distance`] is what more there is to say: how far apart bodies are, where they are nearest, how deep they overlap.
//! [`upper_hull`] is the part of membership that Section 5.1 begins with: how high the zonotope reaches over a point of
//! the plane. The crate `verifier` checks an answer exactly and shares nothing with the methods.
//!
//! Sets are closed: a point of the boundary belongs to the body, bodies that touch intersect.

pub mod brute_force;
pub mod by_explicit_faces;
pub mod by_lad;
pub mod by_lad_in_r4;
#[cfg(feature = "linear-programming")]
pub mod by_linear_program;
pub mod by_slope_selection;
pub mod distance;
mod doors;
pub mod hierarchy;
pub mod prepared;
pub(crate) mod proof;
pub mod tracking;
pub mod upper_hull;

pub use by_lad::{gauge, locate};

pub use crate::zonotope::location::{Gauge, Location, Separation, SignRule, Status, Witness};
pub use crate::zonotope::pose::{AtRest, Standing};
pub use crate::zonotope::query::{Placed, Query};
pub use doors::{Located, Method, MethodError, PreparedFor};
