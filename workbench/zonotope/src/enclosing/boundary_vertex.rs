//! A vertex of the boundary of Z(O): a vertex of the hull, or the reflection of one in the centre O.

use crate::hull::VertexIndex;

/// A vertex of the hull, or its reflection in the centre.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct BoundaryVertex {
    /// The vertex of the hull.
    pub vertex: VertexIndex,
    /// Whether the vertex of the boundary is the reflection of the hull's vertex.
    pub reflected: bool,
}

impl BoundaryVertex {
    pub(crate) fn new(vertex: usize, reflected: bool) -> Self {
        Self { vertex: VertexIndex::new(vertex), reflected }
    }

    /// The reflection of this vertex in the centre.
    pub(super) fn opposite(self) -> Self {
        Self { reflected: !self.reflected, ..self }
    }
}
