//! Problem: for each edge of a convex polygon, the vertex farthest from the line through it.
//!
//! The polygon is strictly convex, so at most two vertices are farthest from an edge; there are two exactly if the
//! opposite edge is parallel. Then the first of them in counter-clockwise order is reported, with a flag. A point and a
//! segment have no edges in this sense, and the answer is empty.
//!
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
