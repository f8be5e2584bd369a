//! Problem: the zonotope of least total length around a set of points, over all directions of generators.
//!
//! The total length is the sum of the half-lengths of the generators; it is monotone under inclusion, and in the plane a quarter of
//! the perimeter. A zonotope along finitely many directions comes near the optimum; the dual program proves how near. Its variables are
//! multipliers λ_j of the points with Σ λ_j = 0: while Σ_j |λ_j · v| ≤ 1 for every unit vector v, no zonotope around the points is
//! shorter than Σ λ_j · p_j.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`in_the_plane`] | some thousand convex hulls | D = 2: the truth, in floating point |
//! | [`by_direction_net`] | fixed directions, O(ε^{−(d−1)}) or O(ε^{−(d−1)/2}) of them | Theorem 4.7, and a better net |
//! | [`by_vertex_sets`] | ten to hundred Newton steps; in a plane some fifty hulls | directions are free; the default |
//!
//! Every answer contains the points exactly, proves its ratio and says whether that is what was asked for ([`Outcome`]); [`verify`]
//! checks it. [`Method`] has the methods by name, [`direction_net`] holds the nets.
//!
//! # The way from points to a zonotope
//! 1. `by_vertex_sets`: the default; `outer_points` leaves out what cannot matter, `set_generation` is the loop.
//! 2. `frame`: coordinates of the affine hull, of ordinary size; `box_coordinates`: those in which the body is not thin.
//! 3. `by_vertex_sets/vertex_sets`: the cone program so far; `by_vertex_sets/interior`: a step of the interior-point method for it.
//! 4. `dual_zonotope`: the vertices that the multipliers leave too far out, which are the sets to add.
//! 5. `lower_bound`: the bound that the multipliers prove.
//! 6. `contain` and `conclude`: generators in doubles around every point, exactly, and the answer with its ratio.
//!
//! In a plane `in_the_plane/best_center` takes the place of 3 and 4. Needles and clusters that doubles cannot resolve are solved again
//! with pairs of doubles as the scalar of the interior-point method; nothing else knows of them.

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
mod method;
pub mod verify;

pub use answer::{LengthMultiplier, MinLengthError, MinLengthZonotope, Outcome};
pub use by_vertex_sets::{min_length_enclosing, min_length_enclosing_counted};
pub use direction_net::Net;
pub use method::Method;

#[cfg(test)]
mod tests;
