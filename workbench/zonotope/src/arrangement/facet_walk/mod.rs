//! Problem: walking from facet to facet over the boundary of a zonotope that is given by its generators alone.
//!
//! A facet is the vertex of the dual arrangement where the lines of the generators along it meet, and its neighbours
//! are the next vertices along these lines: so this is a walk over the arrangement, and needs nothing but that. Closest
//! features of moving bodies stand on it.
//!
//! # Statement
//! Input: generators that span space, and a facet. Output: its neighbours across its edges, one after the other as the
//! walk goes on ([`FacetWalk`]). Zero generators are in no facet; parallel ones are along the same edges; coplanar ones
//! are along one facet, which has two edges for each class of parallel ones. Flat bodies are refused.
//!
//! # Shapes
//! `generators`: n × 3, any order, zero, parallel and coplanar ones allowed.
//!
//! # Errors
//! [`WalkError::Flat`] ⇔ the generators do not span space; [`WalkError::NonFinite`] ⇔ a coordinate is NaN or infinite;
//! [`WalkError::UnknownEdge`] ⇔ the facet has no edge of the number; [`WalkError::UnknownGenerator`],
//! [`WalkError::NotAscending`], [`WalkError::NoPlane`] ⇔ two indices name no facet; [`WalkError::NoDirection`] ⇔ a ray
//! has the direction zero.
//!
//! # Facets
//! A facet is a zonogon along k ≥ 2 classes of parallel generators; it has 2 k edges and as many neighbours. In general
//! position it is a parallelogram, and [i, j, s] ([`FacetName`]) names it: i < j are its generators, s · (v_i × v_j)
//! its outward normal. Any facet is named so by the least two generators that will do.
//!
//! # Special position
//! No coordinate is treated as a case of its own. The dual lines a x + b y + c = 0 of generators (a, b, c) are taken in
//! a plane that is tilted by less than any number: its shear has determinant 1, so no sign of a determinant of
//! generators changes, and in it no line is vertical and no two are parallel, those with b = 0 and the line at infinity
//! included. What is left of special position are the lines of parallel generators, which are one line, and those of
//! coplanar generators, which meet in one vertex. Zero generators have no line. Generators that span no more than a
//! plane are refused ([`WalkError::Flat`]): their body has no facets to walk on.
//!
//! The tilted plane has no vertex at infinity, so a line meets the others in points of the plane. Past the last one it
//! comes back from the other end, and the vertex belongs to the antipode of the facet then: the normal (x, y, 1) has
//! become −(x, y, 1).
//!
//! # The walk along a ray
//! A ray from the centre along p leaves the body where u · p / h(u) is largest over the normals u of facets, h the
//! support function of the centred body. Across an edge with direction w and middle x, counter-clockwise seen from
//! outside, the normal moves from u towards d = w × u and keeps the edge: h(u + t d) = (u + t d) · x. The derivative of
//! the quotient has the sign of (d · p) (u · x) − (u · p) (d · x) = |u|² det(w, x, p), as u × d = |u|² w. The quotient
//! of two linear functions is monotone, so it grows all the way to the next facet. [`FacetWalk::walk_to`] crosses edges
//! with a positive determinant: the quotient grows with every step, so no facet comes twice and the walk ends. It ends
//! where the ray leaves: at any other facet there is an edge to cross. If u · p > 0, the line of the ray meets the
//! plane of the facet at q = t p with t > 0, and the determinant is positive just if q is beyond the edge. If u · p <
//! 0, then t < 0 and it is positive just if q is inside of the edge's line, which holds for one of two parallel edges.
//! If u · p = 0, it has the sign of d · p, and p points out of the facet across one of them. Edges with a determinant
//! of zero are not crossed.
//!
//! | method | step | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(1) after O(n³), exact numbers | the list of all facets, the truth |
//! | [`by_dynamic_hull`] | O(log² n) | the hulls of the lines above and below the vertex; the default |
//! | [`by_scan`] | O(n) | one vector pass over the generators |
//!
//! n generators in general position.

pub mod brute_force;
pub mod by_dynamic_hull;
pub mod by_scan;
mod classes;
mod edge_cycle;
mod error;
mod facet;
mod general_position;
mod interface;
mod method;
mod tilted_line;
mod to_ray;

pub use by_dynamic_hull::HullWalk;
pub use by_scan::ScanWalk;
pub use error::WalkError;
pub use facet::{FacetEdge, FacetName, NormalSense};
pub use general_position::{GeneralPositionError, adjacent_facets};
pub use interface::FacetWalk;
pub use method::Method;

#[cfg(test)]
mod tests;
