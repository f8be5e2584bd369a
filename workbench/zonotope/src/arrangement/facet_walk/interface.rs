//! What a walk does, by whatever method.

use super::error::WalkError;
use super::facet::{FacetEdge, FacetName};

/// A walk from facet to facet over the boundary of a zonotope with interior; it is always at one facet.
///
/// The edges of a facet are numbered counter-clockwise seen from outside, from the one along the first generator of the
/// facet's name in its direction; edges half of their number apart are parallel.
pub trait FacetWalk {
    /// The facet at which the walk is.
    fn facet(&self) -> FacetName;

    /// The edges of this facet, in the order of their numbers: two for each direction of generators along it, four in
    /// general position.
    fn edges(&self) -> Vec<FacetEdge>;

    /// Goes to the facet on the other side of an edge.
    ///
    /// # Errors
    /// [`WalkError::UnknownEdge`] if the facet has no edge of this number; the walk stays where it is.
    fn step(&mut self, edge: usize) -> Result<(), WalkError>;

    /// The facet on the other side of an edge; the walk stays where it is.
    ///
    /// # Errors
    /// [`WalkError::UnknownEdge`] if the facet has no edge of this number.
    fn neighbour(&mut self, edge: usize) -> Result<FacetName, WalkError>;

    /// The facets on the other sides of all edges, in the order of the edges; the walk stays where it is.
    fn neighbours(&mut self) -> Vec<FacetName> {
        let count = self.edges().len();
        (0..count).map(|edge| self.neighbour(edge).expect("the edge is one of the facet's")).collect()
    }

    /// Goes to a facet that may be far away, without a step. Any two generators that are not parallel name a facet by
    /// which it is found, whether or not they are the least ones.
    ///
    /// # Errors
    /// [`WalkError`] if the name is that of no facet; the walk stays where it is.
    fn place_at(&mut self, facet: FacetName) -> Result<(), WalkError>;

    /// Walks to a facet through which the ray from the centre in a direction leaves the body, and counts the steps.
    /// Where the ray leaves through an edge or a vertex, the walk ends at one of the facets there.
    ///
    /// # Errors
    /// [`WalkError::NonFinite`] and [`WalkError::NoDirection`] if the direction is none; the walk stays where it is.
    fn walk_to(&mut self, direction: [f64; 3]) -> Result<u64, WalkError>;
}
