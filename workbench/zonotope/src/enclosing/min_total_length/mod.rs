//! Problem: the zonotope of least total length around a set of points, over all directions of generators.
//!
//! The total length is the sum of the half-lengths of the generators; it is monotone under inclusion, and in the plane a quarter of the perimeter. A
//! zonotope along finitely many directions comes near the optimum; multipliers at the points prove how near.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`in_the_plane`] | about 10^4 convex hulls | D = 2: the truth, in floating point |
//! | [`by_direction_net`] | fixed directions, O(ε^{−(d−1)}) or O(ε^{−(d−1)/2}) of them | Theorem 4.7, and a better net |
//! | [`by_vertex_sets`] | some ten to hundred Newton steps; in a plane some fifty convex hulls | generators as they are needed, their directions free; the default |
//!
//! Every answer contains the points exactly, proves its ratio and says whether that is what was asked for ([`Outcome`]); [`verify`] checks it. [`direction_net`] holds the nets.

mod answer;
mod box_coordinates;
pub mod by_direction_net;
pub mod by_vertex_sets;
mod conclude;
mod contain;
pub mod direction_net;
mod dual_zonotope;
mod frame;
mod frame_zonotope;
pub mod in_the_plane;
mod lower_bound;
pub mod verify;

pub use answer::{LengthMultiplier, MinLengthError, MinLengthZonotope, Outcome};
pub use by_vertex_sets::{min_length_enclosing, min_length_enclosing_counted};
pub use direction_net::Net;

#[cfg(test)]
mod tests;
