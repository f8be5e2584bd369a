//! Counts of faces and the volume of a zonotope, exactly, without listing the faces of space.

use std::collections::BTreeMap;

use super::Zonotope;
use super::directions::Directions;
use super::faces::by_recursion::{total_volume, vertices_and_facets};
use super::faces::space_counts;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::Span;

/// How many faces a zonotope has, counted within its affine hull.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Combinatorics {
    /// The dimension of the affine hull: the rank of the generators.
    pub affine_dimension: usize,
    /// How many vertices.
    pub vertices: u64,
    /// How many edges.
    pub edges: u64,
    /// How many facets: faces of one dimension less than the body. A segment's are its ends, a zonogon's its edges; a
    /// point has none.
    pub facets: u64,
    /// How many facets have so many vertices.
    pub facet_sizes: BTreeMap<usize, u64>,
    /// The length, area or volume in R^D, exactly; 0 if the body is flat.
    pub measure: Rational,
}

/// Counts the faces of a zonotope and measures it.
///
/// With n directions of rank r: O(n log n) for r ≤ 2; O(n² log n) time and O(n) space for r = 3; as
/// [`vertices_and_facets`] and n^r determinants for r ≥ 4.
#[inline(never)]
pub fn combinatorics<const D: usize>(body: &Zonotope<D>) -> Combinatorics {
    let directions = Directions::of_finite(body.generators());
    let coordinates = Span::of_doubles(directions.representatives()).independent_coordinates();
    let count = directions.len() as u64;
    let full = coordinates.len() == D;
    let answer = |vertices, edges, facets, facet_sizes: &[(usize, u64)], measure: Dyadic| Combinatorics {
        affine_dimension: coordinates.len(),
        vertices,
        edges,
        facets,
        facet_sizes: facet_sizes.iter().copied().collect(),
        measure: measure.to_rational(),
    };
    match coordinates[..] {
        [] => answer(1, 0, 0, &[], if D == 0 { Dyadic::from_f64(1.0) } else { Dyadic::zero() }),
        [axis] => {
            let length = directions.exact_sum(0, body.generators())[axis].clone().scaled(1);
            answer(2, 1, 2, &[(1, 2)], if full { length } else { Dyadic::zero() })
        }
        [x, y] => {
            let area = if full { selected(body, [x, y]).exact_area() } else { Dyadic::zero() };
            answer(2 * count, 2 * count, 2 * count, &[(2, 2 * count)], area)
        }
        [x, y, z] => {
            let counts = space_counts(&selected(body, [x, y, z]), full);
            let facets = counts.facet_sizes.values().sum();
            let sizes: Vec<(usize, u64)> = counts.facet_sizes.into_iter().collect();
            answer(counts.edges + 2 - facets, counts.edges, facets, &sizes, counts.volume)
        }
        _ => {
            let faces = vertices_and_facets(body);
            let mut sizes = BTreeMap::new();
            faces.facet_sizes.iter().for_each(|&size| *sizes.entry(size).or_insert(0) += 1);
            let sizes: Vec<(usize, u64)> = sizes.into_iter().collect();
            let [vertices, edges, facets] =
                [faces.vertices.len(), faces.edge_count(), faces.facets.len()].map(|count| count as u64);
            let volume = if full { total_volume(body) } else { Dyadic::zero() };
            answer(vertices, edges, facets, &sizes, volume)
        }
    }
}

/// The generators in some coordinates.
fn selected<const D: usize, const R: usize>(body: &Zonotope<D>, coordinates: [usize; R]) -> Zonotope<R> {
    let generators = body.generators().iter().map(|g| coordinates.map(|c| g[c])).collect();
    Zonotope::new([0.0; R], generators).expect("coordinates of a zonotope are finite")
}
