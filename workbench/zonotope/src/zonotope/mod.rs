//! Zonotopes by their generators: the implicit form { center + Σ δ_i g_i : |δ_i| ≤ 1 }, never the explicit polytope.
//!
//! | file | what it holds |
//! |---|---|
//! | [`Zonotope`] | centre and generators, validated; support function and extreme vertex; total length |
//! | [`combinatorics()`] | counts of faces and exact volume, in any dimension |
//! | [`Directions`] | parallel generators together, zero ones left out |
//! | [`faces`] | what only space allows: the face lattice |
//! | `location` | what is answered about a displacement: where it lies, with its proof, and its gauge |
//! | `operations` | Minkowski sums, reflection, linear maps, projections, boxes; zero and parallel generators |
//! | `matrices` | generators as rows and as matrices |
//! | [`passes`] | support function and extreme vertex in doubles: one vectorised pass, with error bounds |
//! | [`pose`] | a matrix and a translation, and whether a body stands under them or as it is stored |
//! | [`prepared`] | a body prepared for many questions |
//! | [`query`] | what membership, intersection and gauge ask: a displacement between placed bodies, and their generators |
//! | `ray_exit` | where a ray from the centre leaves, in floating point |
//! | [`zonogon`] | what only the plane allows: vertices in order, exact area |

mod combinatorics;
pub mod directions;
pub mod faces;
mod implicit;
pub(crate) mod location;
mod matrices;
mod operations;
pub mod passes;
pub mod pose;
pub mod prepared;
pub mod query;
pub(crate) mod ray_exit;
pub mod zonogon;

pub use combinatorics::{Combinatorics, combinatorics};
pub use directions::Directions;
pub use implicit::{Support, Zonotope, ZonotopeError, support_of};
pub use operations::BoundingBox;
pub use pose::{AtRest, Standing};
pub use prepared::PreparedBody;
pub use query::Placed;
