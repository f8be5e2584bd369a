//! Counts of faces in space from the crossings of one great circle after the other, without the lattice.

use std::collections::BTreeMap;

use super::circles::{Circles, NEW_PLACE};
use super::determinants::HalfEdges;
use crate::numeric::dyadic::Dyadic;
use crate::zonotope::Zonotope;
use crate::zonotope::directions::Directions;

/// What the crossings of all circles tell.
pub(in crate::zonotope) struct SpaceCounts {
    pub(in crate::zonotope) edges: u64,
    /// How many facets have so many vertices.
    pub(in crate::zonotope) facet_sizes: BTreeMap<usize, u64>,
    /// The volume, if it was asked for; else 0.
    pub(in crate::zonotope) volume: Dyadic,
}

/// The counts of a zonotope of rank 3: every place of a circle begins one edge, and a facet belongs to the northernmost
/// of its circles. O(n² log n) time, O(n) space, and O(n²) exact operations for the volume.
pub(in crate::zonotope) fn space_counts(body: &Zonotope<3>, with_volume: bool) -> SpaceCounts {
    let directions = Directions::of_finite(body.generators());
    let circles = Circles::new(directions.representatives());
    let mut half_edges = with_volume.then(|| HalfEdges::new(&circles, &directions, body.generators()));
    let mut counts = SpaceCounts { edges: 0, facet_sizes: BTreeMap::new(), volume: Dyadic::zero() };
    let (mut keys, mut crossings) = (Vec::new(), Vec::new());
    for rank in 0..circles.len() {
        circles.crossings(rank, &mut keys, &mut crossings, &mut ());
        for place in crossings.chunk_by(|_, next| next & NEW_PLACE == 0) {
            counts.edges += 2;
            if (place[0] & !NEW_PLACE) as usize > rank {
                *counts.facet_sizes.entry(2 * (place.len() + 1)).or_insert(0) += 2;
            }
        }
        if let Some(half_edges) = &mut half_edges {
            counts.volume = counts.volume + half_edges.determinants_south_of(rank, &crossings);
        }
    }
    counts.volume = counts.volume.scaled(3);
    counts
}
