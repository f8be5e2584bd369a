//! The tiling of Q, by the facets of the upper hull in the face lattice: for generators in any position.
//!
//! # Statement
//! Input: a zonotope in space. Output: the projections of the facets of its upper hull, from left to right, with the
//! lines and the vertices of the dual arrangement that belong to them. Zero, vertical, level, parallel and coplanar
//! generators are ordinary input. There are no tiles where Q has no area.
//!
//! # Source
//! Section 3, Figure 1, stated there for general position. Departures, by the kind of degenerate generators:
//! - parallel generators are one class with one line;
//! - the lines of coplanar generators meet in one vertex, and their facet is one tile with an edge and its opposite for
//!   each class;
//! - zero generators are in no class, vertical ones in a class without a line, which only lifts the hull;
//! - facets that are vertical project to edges and have no vertex: generators with parallel projections have parallel
//!   lines.
//!
//! # Method
//! 1. List the faces ([`by_sweep`](crate::zonotope::faces::by_sweep)).
//! 2. The normal of a facet is the cross product of two edges. The facet is of the upper hull if z > 0, and its dual
//!    vertex is (x / z, y / z).
//! 3. Sort the facets by the abscissas of their vertices, then from bottom to top.
//! 4. The top of a tile is where its boundary turns from upward to downward edges, a level edge to the left counting as
//!    upward.
//!
//! # Complexity
//! n generators: O(n² log n), and the size of the face lattice.
//!
//! # Shapes
//! `body`: n × 3, any order, duplicates allowed. The vertices are those of the body where it stands.
//!
//! # Numerics
//! The facets of the upper hull, the order of tiles and the direction of edges are exact; vertices and dual
//! vertices are rounded, the latter within a relative 2^-50.
//!
//! # Errors
//! [`FacesError`] if the directions are too many for the face lattice.
//!
//! # Checked by
//! A sweep of the arrangement in general position; areas of tiles, chains and incidences in any.
//!
//! # Example
//! ```
//! use zonotope::arrangement::tiling::by_face_lattice::facet_tiling;
//! // Three coplanar generators: their hexagon is one tile, and two more tiles have the fourth one ...
//! let generators = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1.0]];
//! let tiling = facet_tiling(&zonotope::Zonotope::new([0.0; 3], generators.to_vec())?)?;
//! let sides: Vec<usize> = tiling.tiles.iter().map(|tile| 2 * tile.classes.len()).collect();
//! assert_eq!(sides, [4, 4, 6, 4]); // ... or one of the three
//! assert_eq!(tiling.tiles[2].dual, [0.0, 0.0]); // the normal of the hexagon points up
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross};
use crate::zonotope::Zonotope;
use crate::zonotope::directions::Directions;
use crate::zonotope::faces::{self, Edge, FaceLattice, Faces, FacesError, Facet, Zone};

/// The tiling of Q by the facets of the upper hull. An index in one of its parts is a position in one of its lists.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FacetTiling {
    /// The classes of parallel generators.
    pub classes: Vec<Class>,
    /// The vertices of the upper hull that tiles have, rounded; x and y are those of the tiling's vertices.
    pub vertices: Vec<[f64; 3]>,
    /// The edges of tiles.
    pub edges: Vec<TileEdge>,
    /// The tiles from left to right, by their dual vertices; of those with one abscissa the lowest first.
    pub tiles: Vec<FacetTile>,
    /// The vertices on the left side of Q, from top to bottom.
    pub left_side: Vec<usize>,
    /// The number of facets whose projection is an edge.
    pub vertical_facets: usize,
}

/// Parallel generators.
#[derive(Debug, Clone, PartialEq)]
pub struct Class {
    /// The generators.
    pub generators: Vec<usize>,
    /// Their sum, all turned to one side, rounded: the coefficients (a, b, c) of their line a x + b y + c = 0.
    pub line: [f64; 3],
    /// Whether they are vertical, and have no line.
    pub is_vertical: bool,
}

/// An edge of the tiling, dual to a piece of the line of its class.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TileEdge {
    /// The class of the generators along it.
    pub class: usize,
    /// Its upper end; of two ends of one height the left one.
    pub upper: usize,
    /// Its lower end.
    pub lower: usize,
    /// The tile on its left; none on the left side of Q.
    pub left: Option<usize>,
    /// The tile on its right; none on the right side of Q.
    pub right: Option<usize>,
}

/// A facet of the upper hull, dual to a vertex where lines meet.
#[derive(Debug, Clone, PartialEq)]
pub struct FacetTile {
    /// The classes of generators along its edges.
    pub classes: Vec<usize>,
    /// The vertices of its left side, from top to bottom.
    pub left: Vec<usize>,
    /// The vertices of its right side, from top to bottom.
    pub right: Vec<usize>,
    /// The dual vertex: (x, y, 1) is a normal of the facet.
    pub dual: [f64; 2],
    /// The facet in the lattice.
    pub facet: Facet,
}

/// The tiling by the facets of the upper hull of a body.
///
/// # Errors
/// [`FacesError`] if the directions of the generators are too many.
pub fn facet_tiling(body: &Zonotope<3>) -> Result<FacetTiling, FacesError> {
    Ok(match faces::faces(body, &mut ())? {
        Faces::Solid(lattice) | Faces::Flat(lattice) => of_lattice(&lattice),
        Faces::Point(_) | Faces::Segment(_) => {
            let directions = Directions::of_finite(body.generators());
            let class = |class: usize| {
                let generators = directions.members(class).iter().map(|member| member.generator).collect();
                Class::new(generators, &directions.exact_sum(class, body.generators()))
            };
            FacetTiling { classes: (0..directions.len()).map(class).collect(), ..FacetTiling::default() }
        }
    })
}

/// The tiling by the facets of the upper hull, given all faces.
pub fn of_lattice(lattice: &FaceLattice) -> FacetTiling {
    let steps: Vec<ExactVector> =
        (0..lattice.zone_count() as u32).map(|zone| lattice.exact_half_edge(Zone(zone))).collect();
    let facets = (0..lattice.facet_count() as u32).map(Facet);
    let normals: Vec<(Facet, ExactVector)> = facets.map(|facet| (facet, normal(lattice, &steps, facet))).collect();
    let vertical_facets = normals.iter().filter(|(_, normal)| normal[2].is_zero()).count();
    let mut upper: Vec<(Facet, ExactVector)> =
        normals.into_iter().filter(|(_, normal)| normal[2].sign().is_gt()).collect();
    upper.sort_by(|(_, a), (_, b)| compare_ratio(a, b, 0).then_with(|| compare_ratio(a, b, 1)));

    let down: Vec<bool> = steps.iter().map(points_down).collect();
    let mut renumbered = Renumbered { numbers: vec![None; lattice.vertex_count()], points: Vec::new() };
    let mut tile_of = vec![None; lattice.facet_count()];
    let mut tiles = Vec::with_capacity(upper.len());
    for (number, (facet, normal)) in upper.into_iter().enumerate() {
        tile_of[facet.0 as usize] = Some(number);
        let [left, right] = sides(lattice, &down, facet).map(|side| renumbered.all(lattice, side));
        let dual = [0, 1].map(|axis| normal[axis].ratio(&normal[2]));
        let classes = lattice.facet_zones(facet).map(|zone| zone.0 as usize).collect();
        tiles.push(FacetTile { classes, left, right, dual, facet });
    }
    let mut edges = Vec::new();
    for edge in (0..lattice.edge_count() as u32).map(Edge) {
        let class = lattice.edge_zone(edge).0 as usize;
        let ([tail, head], beside) = (lattice.edge_ends(edge), lattice.edge_facets(edge));
        let [left, right] = beside.map(|facet| tile_of[facet.0 as usize]);
        if left.is_none() && right.is_none() {
            continue;
        }
        let [tail, head] = [tail, head].map(|vertex| renumbered.one(lattice, vertex.0));
        // Seen from above, east is on the left of an edge that points down.
        edges.push(if down[class] {
            TileEdge { class, upper: tail, lower: head, left: right, right: left }
        } else {
            TileEdge { class, upper: head, lower: tail, left, right }
        });
    }
    let classes = (0..lattice.zone_count() as u32).map(|zone| {
        let generators = lattice.zone_generators(Zone(zone)).map(|member| member.generator).collect();
        Class::new(generators, &steps[zone as usize])
    });
    let left_side = left_side(&edges, renumbered.points.len());
    FacetTiling { classes: classes.collect(), vertices: renumbered.points, edges, tiles, left_side, vertical_facets }
}

impl FacetTiling {
    /// The separator with the first k tiles on its left, as vertices from top to bottom; `None` if there are fewer.
    pub fn separator(&self, k: usize) -> Option<Vec<usize>> {
        let mut chain = self.left_side.clone();
        for tile in self.tiles.get(..k)? {
            let start = chain.iter().position(|vertex| vertex == &tile.left[0])?;
            chain.splice(start..start + tile.left.len(), tile.right.iter().copied());
        }
        Some(chain)
    }
}

impl Class {
    fn new(generators: Vec<usize>, sum: &ExactVector) -> Self {
        let is_vertical = sum[0].is_zero() && sum[1].is_zero();
        Self { generators, line: sum.each_ref().map(Dyadic::to_f64), is_vertical }
    }
}

/// The vertices of a lattice that are in use, with new numbers.
struct Renumbered {
    numbers: Vec<Option<usize>>,
    points: Vec<[f64; 3]>,
}

impl Renumbered {
    fn one(&mut self, lattice: &FaceLattice, vertex: u32) -> usize {
        *self.numbers[vertex as usize].get_or_insert_with(|| {
            self.points.push(lattice.points()[vertex as usize]);
            self.points.len() - 1
        })
    }

    fn all(&mut self, lattice: &FaceLattice, vertices: Vec<u32>) -> Vec<usize> {
        vertices.into_iter().map(|vertex| self.one(lattice, vertex)).collect()
    }
}

/// An outward normal of a facet: the cross product of two edges that follow each other around it.
fn normal(lattice: &FaceLattice, steps: &[ExactVector], facet: Facet) -> ExactVector {
    let mut edges = lattice.facet_edges(facet).zip(lattice.facet_vertices(facet)).map(|(edge, from)| {
        let step = &steps[lattice.edge_zone(edge).0 as usize];
        let against = lattice.edge_ends(edge)[0] != from;
        step.clone().map(|c| if against { -c } else { c })
    });
    let [first, second] = [edges.next(), edges.next()].map(|edge| edge.expect("a facet has four edges at least"));
    cross(&first, &second)
}

/// The order of the quotients of a coordinate by z, for two vectors with z > 0.
fn compare_ratio(a: &ExactVector, b: &ExactVector, axis: usize) -> Ordering {
    (&a[axis] * &b[2]).cmp(&(&b[axis] * &a[2]))
}

/// Whether a step goes down in the plane; a level one does so if it goes to the right.
fn points_down(step: &ExactVector) -> bool {
    step[1].sign().reverse().then(step[0].sign()).is_gt()
}

/// The left and the right side of a facet of the upper hull, from its top to its bottom.
fn sides(lattice: &FaceLattice, down: &[bool], facet: Facet) -> [Vec<u32>; 2] {
    let around: Vec<u32> = lattice.facet_vertices(facet).map(|vertex| vertex.0).collect();
    let goes_down: Vec<bool> = lattice
        .facet_edges(facet)
        .zip(&around)
        .map(|(edge, &from)| down[lattice.edge_zone(edge).0 as usize] == (lattice.edge_ends(edge)[0].0 == from))
        .collect();
    let count = around.len();
    let is_top = |&side: &usize| goes_down[side] && !goes_down[(side + count - 1) % count];
    let top = (0..count).find(is_top).expect("the boundary of a polygon goes up and down");
    let side = |step: usize| (0..=count / 2).map(|k| around[(top + k * step) % count]).collect();
    [side(1), side(count - 1)]
}

/// The vertices on the left side of Q from top to bottom: those of the edges without a tile on their left.
fn left_side(edges: &[TileEdge], vertices: usize) -> Vec<usize> {
    let mut below = vec![None; vertices];
    let mut is_lower_end = vec![false; vertices];
    for edge in edges.iter().filter(|edge| edge.left.is_none()) {
        below[edge.upper] = Some(edge.lower);
        is_lower_end[edge.lower] = true;
    }
    let top = (0..vertices).find(|&vertex| below[vertex].is_some() && !is_lower_end[vertex]);
    std::iter::successors(top, |&vertex| below[vertex]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(generators: &[[f64; 3]]) -> FacetTiling {
        let body = Zonotope::new([0.0; 3], generators.to_vec()).expect("the generators are finite");
        facet_tiling(&body).expect("there are few generators")
    }

    fn cross_of(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    /// Chains from side to side, tiles that fill Q, and edges that belong to their tiles and lines.
    fn assert_sound(generators: &[[f64; 3]]) {
        let tiling = of(generators);
        let at = |vertex: usize| tiling.vertices[vertex];
        let doubled = |outline: &[usize]| -> f64 {
            outline.windows(2).map(|pair| cross_of(at(outline[0]), at(pair[0]), at(pair[1]))).sum()
        };
        let total: f64 = (0..generators.len())
            .flat_map(|j| (0..j).map(move |i| (i, j)))
            .map(|(i, j)| (generators[i][0] * generators[j][1] - generators[i][1] * generators[j][0]).abs())
            .sum();
        let mut tiled = 0.0;
        for (number, tile) in tiling.tiles.iter().enumerate() {
            let outline: Vec<usize> = tile.left.iter().chain(tile.right.iter().rev().skip(1)).copied().collect();
            let area = doubled(&outline);
            assert!(area > 0.0, "a tile is counter-clockwise: {generators:?}");
            tiled += area / 2.0;
            assert_eq!((tile.left.len(), tile.right.len()), (tile.classes.len() + 1, tile.classes.len() + 1));
            for &class in &tile.classes {
                let [a, b, c] = tiling.classes[class].line;
                let value = a * tile.dual[0] + b * tile.dual[1] + c;
                assert!(value.abs() < 1e-9, "line {class} passes through its vertex: {generators:?}");
            }
            for edge in &tiling.edges {
                let is_on = |side: &[usize]| side.windows(2).any(|pair| pair == [edge.upper, edge.lower]);
                assert_eq!(edge.right == Some(number), is_on(&tile.left), "{generators:?}");
                assert_eq!(edge.left == Some(number), is_on(&tile.right), "{generators:?}");
            }
        }
        assert!((tiled - 4.0 * total).abs() < 1e-9, "the tiles fill Q: {tiled}, {total}, {generators:?}");
        for k in 0..=tiling.tiles.len() {
            let chain = tiling.separator(k).expect("there are so many tiles");
            let is_edge = |pair: &[usize]| tiling.edges.iter().any(|edge| [edge.upper, edge.lower] == *pair);
            assert!(chain.windows(2).all(is_edge), "separator {k} goes down along edges: {generators:?}");
            let ends = [chain.first(), chain.last()];
            assert_eq!(ends, [tiling.left_side.first(), tiling.left_side.last()]);
        }
        assert_eq!(tiling.separator(tiling.tiles.len() + 1), None);
    }

    #[test]
    fn a_flat_body_is_one_tile_unless_it_is_vertical() {
        let flat = of(&[[1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0], [-1.0, 0.0, -1.0]]);
        assert_eq!((flat.tiles.len(), flat.classes.len()), (1, 3));
        assert_eq!(flat.tiles[0].dual, [-1.0, 0.0]);
        let vertical = of(&[[1.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 0.0, 2.0]]);
        assert_eq!((vertical.tiles.len(), vertical.vertical_facets), (0, 2));
        assert!(vertical.left_side.is_empty() && vertical.classes.iter().any(|class| class.is_vertical));
        let segment = of(&[[1.0, 0.0, 1.0], [0.0; 3], [2.0, 0.0, 2.0]]);
        assert_eq!((segment.classes.len(), segment.classes[0].generators.as_slice()), (1, [0, 2].as_slice()));
        assert_eq!(of(&[]), FacetTiling::default());
    }

    #[test]
    fn a_rhombic_dodecahedron_in_two_positions() {
        let diagonals = [[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];
        assert_sound(&diagonals);
        let tiling = of(&diagonals);
        assert_eq!((tiling.tiles.len(), tiling.vertical_facets), (4, 4));
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_sound(&cube);
        assert_eq!((of(&cube).tiles.len(), of(&cube).vertical_facets), (1, 4));
    }

    properties! {
        #[test]
        fn tiles_fill_q_and_separators_sweep_over_it(
            generators in proptest::collection::vec([-2i8..3, -2i8..3, -2i8..3], 0..9),
        ) {
            let generators: Vec<[f64; 3]> = generators.into_iter().map(|g| g.map(f64::from)).collect();
            assert_sound(&generators);
        }
    }
}
