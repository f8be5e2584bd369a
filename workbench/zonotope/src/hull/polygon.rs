//! The answer: a strictly convex polygon, possibly a segment or a point.

/// Position of a point in the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PointIndex(u32);

impl PointIndex {
    /// The index of the point at `position`, which is at most [`MAX_POINTS`](super::MAX_POINTS).
    #[inline]
    pub(super) fn new(position: usize) -> Self {
        PointIndex(position as u32)
    }

    /// The position as a number to index a slice with.
    #[inline]
    pub fn get(self) -> usize {
        self.0 as usize
    }
}

/// Position of a vertex on a hull, counter-clockwise from the lexicographically smallest, and of the edge that starts
/// there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexIndex(u32);

impl VertexIndex {
    /// The index of the vertex at `position`, which is at most [`MAX_POINTS`](super::MAX_POINTS).
    #[inline]
    pub fn new(position: usize) -> Self {
        assert!(position <= super::MAX_POINTS, "vertex {position} cannot be indexed");
        VertexIndex(position as u32)
    }

    /// The position as a number to index a slice with.
    #[inline]
    pub fn get(self) -> usize {
        self.0 as usize
    }
}

/// The convex hull of a finite nonempty set of points.
///
/// Strictly convex, counter-clockwise, from the lexicographically smallest vertex. All methods give the same value.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexHull {
    /// At least one vertex; no two equal, no three collinear.
    vertices: Vec<[f64; 2]>,
    /// As long as `vertices`: where each occurs first in the input.
    indices: Vec<PointIndex>,
}

impl ConvexHull {
    /// Callers have established the invariants of the fields.
    pub(super) fn from_parts(vertices: Vec<[f64; 2]>, indices: Vec<PointIndex>) -> Self {
        assert!(!vertices.is_empty() && vertices.len() == indices.len());
        ConvexHull { vertices, indices }
    }

    /// The vertices, counter-clockwise from the lexicographically smallest; one for a point, two for a segment.
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// For each vertex its first occurrence in the input.
    pub fn indices(&self) -> &[PointIndex] {
        &self.indices
    }

    /// The number of vertices, at least 1.
    pub fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// The number of edges: that of the vertices, but none for a point or a segment.
    pub fn edge_count(&self) -> usize {
        if self.has_area() { self.vertices.len() } else { 0 }
    }

    /// Whether the hull has at least three vertices.
    pub fn has_area(&self) -> bool {
        self.vertices.len() >= 3
    }

    /// The vertex at an index.
    ///
    /// # Panics
    /// If the index is not below [`vertex_count`](Self::vertex_count).
    pub fn vertex(&self, index: VertexIndex) -> [f64; 2] {
        self.vertices[index.get()]
    }

    /// The index of the vertex that follows counter-clockwise.
    pub fn next(&self, index: VertexIndex) -> VertexIndex {
        VertexIndex::new(if index.get() + 1 < self.vertices.len() { index.get() + 1 } else { 0 })
    }

    /// The two ends of the edge that starts at a vertex, in counter-clockwise order.
    ///
    /// # Panics
    /// If the index is not below [`vertex_count`](Self::vertex_count).
    pub fn edge(&self, index: VertexIndex) -> [[f64; 2]; 2] {
        [self.vertex(index), self.vertex(self.next(index))]
    }
}
