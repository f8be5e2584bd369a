//! The registry of the methods, for callers that choose one by name.

use super::answer::{MinLengthError, MinLengthZonotope};
use super::by_direction_net::min_length_by_net;
use super::by_vertex_sets::min_length_by_vertex_sets;
use crate::enclosing::min_total_length::direction_net::Net;
use crate::tables::methods;
use crate::tally::Tally;

methods! {
    /// A method whose answers contain the points exactly and prove their lower bounds.
    pub enum Method;
    /// The cost for m points that have a multiplier, or for a precision ε, in d dimensions.
    fn cost;

    /// [`by_vertex_sets`](super::by_vertex_sets), the default.
    VertexSets => "by_column_generation", "Directions as they are needed",
        "some ten to hundred steps of O((d m)³); in a plane some fifty convex hulls";
    /// [`by_direction_net`](super::by_direction_net) with [`Net::Cells`].
    DirectionNet => "by_direction_net", "A net of cells", "O(ε^(−(d−1)/2)) directions";
    /// [`by_direction_net`](super::by_direction_net) with [`Net::Paper`].
    PapersNet => "by_papers_net", "The paper's net", "d (d/ε)^(d−1) directions";
}

impl Method {
    /// A zonotope around the points whose total length is within 1 + ε of the least; `tally` counts the operations of
    /// the methods that count any.
    ///
    /// # Errors
    /// When the points or ε are refused, or the net is too large.
    #[inline(never)]
    pub fn solve<const D: usize>(
        self,
        points: &[[f64; D]],
        epsilon: f64,
        tally: &mut dyn Tally,
    ) -> Result<MinLengthZonotope<D>, MinLengthError> {
        match self {
            Self::VertexSets => min_length_by_vertex_sets(points, epsilon, tally),
            Self::DirectionNet => min_length_by_net(points, epsilon, Net::Cells, tally),
            Self::PapersNet => min_length_by_net(points, epsilon, Net::Paper, tally),
        }
    }
}
