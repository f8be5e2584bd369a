//! Problem: the tiling of Q, which the facets of the upper hull project to, and its isomorphism with the dual
//! arrangement (Section 3, Figure 1).
//!
//! Q is the projection of a zonotope in space, a zonogon. Each facet of the upper hull projects to a tile, and these
//! tile Q: in general position a parallelogram T_ij = { c + s v'_i + t v'_j : |s|, |t| ≤ 1 }, else a zonogon along all
//! generators of the facet. In the dual arrangement the tile is the vertex where the lines of its generators cross, an
//! edge of the tiling is a piece of its generator's line, and a vertex of the tiling is a face.
//!
//! Zero and vertical generators have no line: the former take no part, the latter raise the hull. Generators with
//! parallel projections have no tile in common. A level generator (y = 0) has a vertical line. Tiles are numbered by
//! the x of their vertices, then by y.
//!
//! | method | cost for n generators | what it is |
//! |---|---|---|
//! | [`by_face_lattice`] | O(n² log n) | the facets of the upper hull, for generators in any position |

pub mod by_face_lattice;

pub use by_face_lattice::{FacetTiling, facet_tiling};
