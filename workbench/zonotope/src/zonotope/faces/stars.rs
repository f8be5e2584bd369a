//! What meets in a vertex: its edges and facets, counter-clockwise.

use super::lattice::{Edge, FaceLattice, Facet, Vertex};

/// A lattice with one edge of each vertex looked up, from which the others are found by going around.
#[derive(Debug, Clone)]
pub struct Stars<'a> {
    lattice: &'a FaceLattice,
    first_edges: Vec<u32>,
}

impl FaceLattice {
    /// Prepares for questions about what meets in vertices: O(number of edges), 4 bytes a vertex.
    pub fn stars(&self) -> Stars<'_> {
        let mut first_edges = vec![0; self.vertex_count()];
        for edge in (0..self.edge_count() as u32).map(Edge) {
            for vertex in self.edge_ends(edge) {
                first_edges[vertex.0 as usize] = edge.0;
            }
        }
        Stars { lattice: self, first_edges }
    }
}

impl Stars<'_> {
    /// The edges at a vertex, counter-clockwise seen from outside. O(sides of the facets at the vertex).
    pub fn edges(&self, vertex: Vertex) -> impl Iterator<Item = Edge> {
        let first = Edge(self.first_edges[vertex.0 as usize]);
        let next = move |&edge: &Edge| Some(self.edge_after(vertex, edge)).filter(|&next| next != first);
        std::iter::successors(Some(first), next)
    }

    /// The facets at a vertex, each counter-clockwise next to the [edge](Self::edges) of the same place.
    pub fn facets(&self, vertex: Vertex) -> impl Iterator<Item = Facet> {
        self.edges(vertex).map(move |edge| self.facet_beside(vertex, edge))
    }

    /// The facet to the left of an edge that leaves a vertex.
    fn facet_beside(&self, vertex: Vertex, edge: Edge) -> Facet {
        let [left, right] = self.lattice.edge_facets(edge);
        if self.lattice.edge_ends(edge)[0] == vertex { left } else { right }
    }

    /// The edge that arrives at the vertex where the facet to the left of `edge` goes on with `edge`.
    fn edge_after(&self, vertex: Vertex, edge: Edge) -> Edge {
        let sides = self.lattice.facet_edges(self.facet_beside(vertex, edge));
        let before = sides.clone().cycle().skip(sides.len() - 1);
        let found = before.zip(sides).find(|&(_, side)| side == edge);
        found.map_or(edge, |(before, _)| before)
    }
}
