//! Problem: the zonotope of least total length around a set of points, over all directions of generators.
//!
//! The total length is the sum of the half-lengths of the generators. It is monotone under inclusion, and in the plane
//! it is a quarter of the perimeter. The methods shorten a zonotope until a lower bound proves that it is within 1 + ε
//! of the least total length. The lower bound comes from the dual program, whose variables are multipliers λ_j of the
//! points with Σ λ_j = 0: while Σ_j |λ_j · v| ≤ 1 for every unit vector v, no zonotope around the points has a total
//! length below Σ λ_j · p_j. For if p_j = c + Σ_i δ_ij g_i with |δ_ij| ≤ 1, then Σ λ_j · p_j = Σ_i Σ_j δ_ij
//! λ_j · g_i ≤ Σ_i |g_i|.
//!
//! | method | time | notes |
//! |---|---|---|
//! | [`in_the_plane`] | about 3,800 convex hulls | D = 2; floating point without a proof, what the other methods are held to |
//! | [`by_direction_net`] | the time of [`fixed_directions`](super::fixed_directions) for O(ε^{−(d−1)}) or O(ε^{−(d−1)/2}) directions | Theorem 4.7, and a net with fewer directions |
//! | [`by_vertex_sets`] | ten to hundred Newton steps; in a plane some fifty convex hulls | directions are free; the default |
//!
//! Every answer contains the points exactly, proves the ratio of its length to its lower bound, and says whether that
//! ratio is at most 1 + ε ([`Outcome`]). The crate `verifier` checks all three. [`Method`] has the methods by name,
//! [`enclosing::min_length`](super::min_length) asks the default one; [`direction_net`] holds the nets.
//!
//! # The way from points to a zonotope
//! 1. `by_vertex_sets` is the default method; its `outer_points` leaves out points that lie in a simplex of others, its
//!    `set_generation` is the loop of steps 3 to 5.
//! 2. `on_a_line` answers for points on a line. For others `frame` takes coordinates of the points' affine hull, of
//!    ordinary size; `box_coordinates` stretches them until a thin body is no longer thin.
//! 3. `by_vertex_sets/vertex_sets` holds the second-order cone program so far, `by_vertex_sets/interior` takes a step
//!    of an interior-point method for it.
//! 4. `dual_zonotope` finds the vertices of Σ [−1, 1] λ_j outside the unit ball: constraints that the program lacks.
//! 5. `lower_bound` makes the multipliers feasible and computes the bound that they prove.
//! 6. `contain` rounds the generators to doubles and adds what makes the zonotope contain every point exactly;
//!    `conclude` puts the answer together.
//!
//! Generators of the answer are as many as the method leaves. [`few_generators`] makes them few within the same ratio,
//! or as few as they are asked to be; [`enclosing::min_length`](super::min_length) does.
//!
//! Points of a plane go to `in_the_plane/best_center` in place of steps 3 and 4. Where doubles do not reach 1 + ε, as
//! for needles and tight clusters of points, step 3 is taken again with pairs of doubles as its scalar; the other steps
//! work in doubles alone.

mod answer;
mod axis_box;
mod box_coordinates;
pub mod by_direction_net;
pub mod by_vertex_sets;
mod conclude;
mod contain;
pub mod direction_net;
mod dual_zonotope;
pub mod few_generators;
mod frame;
mod frame_zonotope;
pub mod in_the_plane;
mod lower_bound;
mod method;
mod on_a_line;
mod sheared_box;

pub use answer::{LengthMultiplier, LengthProof, MinLengthError, MinLengthZonotope, Outcome};
pub use direction_net::Net;
pub use method::Method;
