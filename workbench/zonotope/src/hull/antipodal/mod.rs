//! Problem: for each edge of a convex polygon, the vertex farthest from the line through it.
//!
//! # Statement
//! Input: a convex hull, strictly convex. Output: for each edge t, from vertex t to vertex t + 1, the vertex s of the
//! largest distance from its line, and whether vertex s + 1 has the same distance, as it does where the opposite edge
//! is parallel; of two such vertices the first in counter-clockwise order. A point and a segment have no edges in this
//! sense: for them the answer is empty.
//!
//! # Shapes
//! One answer an edge, in the order of the edges.
//!
//! # Methods
//! | method | time | notes |
//! |---|---|---|
//! | [`brute_force`] | O(h²) | compares all vertices; the truth |
//! | [`by_rotating_calipers`] | O(h) | half a turn of two parallel supporting lines (Shamos) |
//!
//! h edges. [`farthest_vertices`] is the default method. Every decision is exact, so the answer does not depend on the
//! method.

pub mod brute_force;
pub mod by_rotating_calipers;

pub use by_rotating_calipers::farthest_vertices;

use super::polygon::VertexIndex;

/// The vertex farthest from an edge, and whether the next vertex is as far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FarthestVertex(u32);

impl FarthestVertex {
    /// Packs both into 32 bits; a vertex index has at most 31.
    #[inline]
    fn new(vertex: usize, is_tied: bool) -> Self {
        FarthestVertex((vertex as u32) << 1 | u32::from(is_tied))
    }

    /// The farthest vertex; of two that are equally far, the first in counter-clockwise order.
    #[inline]
    pub fn vertex(self) -> VertexIndex {
        VertexIndex::new((self.0 >> 1) as usize)
    }

    /// Whether the vertex after [`vertex`](Self::vertex) is as far: the edge between them is parallel to the edge in
    /// question.
    #[inline]
    pub fn is_tied(self) -> bool {
        self.0 & 1 == 1
    }
}

#[cfg(test)]
mod tests;
