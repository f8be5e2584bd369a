//! The doors: what is asked of bodies, as their methods, and the methods of collision by name.
//!
//! They hold no geometry of their own: each puts a question to a method, and nothing else of `collision` rests on them.
//!
//! | file | what it holds |
//! |---|---|
//! | [`Method`] | the methods by name, with the default of each dimension |
//! | `of_bodies` | the questions as methods of [`Zonotope`](crate::zonotope::Zonotope) |
//! | `of_placed_bodies` | the same in space for a body where it stands, [`Placed`](crate::Placed), and for a prepared one |
//! | [`PreparedFor`] | the same for a body that is prepared for a number of queries |
//! | [`Located`] | the answer of these: a status, with a proof that is written when it is asked for |
//! | `distance_of_bodies` | how near bodies are and how deep they overlap, as methods of [`Zonotope`](crate::zonotope::Zonotope) |

mod distance_of_bodies;
mod located;
mod method;
mod of_bodies;
mod of_placed_bodies;
mod prepared_for;

pub use located::Located;
pub use method::{Method, MethodError};
pub use prepared_for::PreparedFor;
