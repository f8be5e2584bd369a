//! The bounding volumes that a hierarchy may have.
//!
//! | file | volume | directions of a test |
//! |---|---|---|
//! | [`aabb`] | box along the axes of the mesh | 6 faces |
//! | [`sphere`] | sphere around the middle of the box | 1 |
//! | [`oriented_box`] | box along orthogonal directions that a search finds | 6 faces, 9 pairs of edges |
//! | [`discrete_polytope`] | polytope of 18 or 26 fixed normals | 18 or 26 faces |
//! | [`zonotope`] | zonotope of 3 to 8 generators | its own facets and the other one's; pairs of long edges where these overlap little |
//! | [`zonotope_by_cost`] | zonotope of 3 to 6 generators, as many as cost least at the node | the same, pairs of edges of 3 alone |
//!
//! [`shape`] has those that are zonotopes in the coordinates of their mesh. `fitting` finds directions of generators;
//! [`least_volume`] asks it for little volume in place of few tests.

pub mod aabb;
pub mod discrete_polytope;
mod fitting;
pub mod least_volume;
pub mod oriented_box;
pub mod shape;
pub mod sphere;
pub mod zonotope;
pub mod zonotope_by_cost;
