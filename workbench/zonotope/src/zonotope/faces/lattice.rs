//! The face lattice of a zonotope of R^3: vertices, edges, facets and zones as indices in flat arrays.

use std::ops::Range;

use super::circles::{Circles, Crossings};
use super::position::{Position, Step};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::Extents;
use crate::numeric::scaling::power_of_two;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::Zonotope;
use crate::zonotope::directions::{Directions, Member};

/// A vertex of a [`FaceLattice`], by its index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Vertex(pub u32);

/// An edge of a [`FaceLattice`], by its index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge(pub u32);

/// A facet of a [`FaceLattice`], by its index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Facet(pub u32);

/// A zone of a [`FaceLattice`], by its index: the edges of one direction, and the facets around the body that have two
/// of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Zone(pub u32);

/// The vertices, edges and facets of a zonotope with at least two directions, and how they meet. A flat body has two
/// facets, one a side.
///
/// Opposite faces have indices half of their number apart; the edges of a zone follow one another around the body.
///
/// # Panics
/// The methods that take a [`Vertex`], [`Edge`], [`Facet`] or [`Zone`] panic if this lattice has none of that index: it
/// is of another lattice. An index below the count of its kind is always one of this lattice.
#[derive(Debug, Clone)]
pub struct FaceLattice {
    pub(super) body: Zonotope<3>,
    pub(super) directions: Directions<3>,
    pub(super) circles: Circles,
    scale: f64,
    center: Position,
    vertices: Vec<[f64; 3]>,
    /// By edge: the vertices at its tail and head, and the facet that it has on its left.
    edge_ends: Vec<[u32; 2]>,
    edge_left: Vec<u32>,
    edge_zones: Vec<u32>,
    zone_starts: Vec<u32>,
    /// By facet: where its vertices and edges begin; edge k joins vertices k and k + 1.
    facet_starts: Vec<u32>,
    facet_vertices: Vec<u32>,
    facet_edges: Vec<u32>,
    facets: usize,
}

/// The index of the opposite of a face with `index` among `count` that are numbered in opposite halves.
fn opposite(index: u32, count: usize) -> u32 {
    let half = count as u32 / 2;
    if index < half { index + half } else { index - half }
}

impl FaceLattice {
    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// How many edges there are.
    pub fn edge_count(&self) -> usize {
        self.edge_ends.len()
    }

    /// How many facets there are.
    pub fn facet_count(&self) -> usize {
        self.facets
    }

    /// How many zones there are: one a direction of generators.
    pub fn zone_count(&self) -> usize {
        self.directions.len()
    }

    /// Whether the body lies in a plane: its two facets are the sides of one zonogon.
    pub fn is_flat(&self) -> bool {
        self.facets == 2
    }

    /// Where the vertices are, rounded within [`coordinate_error`](Self::coordinate_error), by index.
    pub fn points(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    /// Where a vertex is, rounded within [`coordinate_error`](Self::coordinate_error).
    pub fn point(&self, vertex: Vertex) -> [f64; 3] {
        self.vertices[vertex.0 as usize]
    }

    /// A bound for the distance of each coordinate of a [`point`](Self::point) from that of the vertex; infinite where
    /// a vertex may leave the range of doubles.
    ///
    /// Positions are sums of two doubles, good to 2^-98 of the extent after the longest way; two roundings of the
    /// result follow.
    pub fn coordinate_error(&self) -> [f64; 3] {
        let extents = Extents::new(self.body.generators()).sums();
        std::array::from_fn(|axis| (2.0 * UNIT * (extents[axis] + self.body.center()[axis].abs())).next_up())
    }

    /// The vertices of a facet, counter-clockwise seen from outside.
    pub fn facet_vertices(&self, facet: Facet) -> impl ExactSizeIterator<Item = Vertex> + Clone {
        self.facet_vertices[self.facet_range(facet)].iter().copied().map(Vertex)
    }

    /// The edges of a facet, counter-clockwise seen from outside: edge k joins vertices k and k + 1, edges half a turn
    /// apart are parallel.
    pub fn facet_edges(&self, facet: Facet) -> impl ExactSizeIterator<Item = Edge> + Clone {
        self.facet_edges[self.facet_range(facet)].iter().copied().map(Edge)
    }

    /// The zones that meet in a facet: half as many as it has edges.
    pub fn facet_zones(&self, facet: Facet) -> impl ExactSizeIterator<Item = Zone> + Clone {
        let range = self.facet_range(facet);
        let half = range.start..range.start + range.len() / 2;
        self.facet_edges[half].iter().map(|&edge| self.edge_zone(Edge(edge)))
    }

    /// The tail and the head of an edge: all edges of a zone point the same way.
    pub fn edge_ends(&self, edge: Edge) -> [Vertex; 2] {
        self.edge_ends[edge.0 as usize].map(Vertex)
    }

    /// The facets to the left and to the right of an edge, going from tail to head outside the body.
    pub fn edge_facets(&self, edge: Edge) -> [Facet; 2] {
        let edges = self.zone_edges(self.edge_zone(edge));
        let next = if edge.0 + 1 < edges.end { edge.0 + 1 } else { edges.start };
        [edge.0, next].map(|edge| Facet(self.edge_left[edge as usize]))
    }

    /// The zone that an edge belongs to.
    pub fn edge_zone(&self, edge: Edge) -> Zone {
        Zone(self.edge_zones[edge.0 as usize])
    }

    /// The indices of the edges of a zone, in the order around the body: counter-clockwise seen from where they point.
    pub fn zone_edges(&self, zone: Zone) -> Range<u32> {
        self.zone_starts[zone.0 as usize]..self.zone_starts[zone.0 as usize + 1]
    }

    /// The generators of a zone, all parallel, and whether each points against the zone's edges.
    pub fn zone_generators(&self, zone: Zone) -> impl ExactSizeIterator<Item = Member> {
        let (class, turned) = self.circles.classes[zone.0 as usize];
        let members = self.directions.members(class as usize).iter();
        members.map(move |&member| Member { reversed: member.reversed ^ turned, ..member })
    }

    /// The vertex on the other side of the centre.
    pub fn opposite_vertex(&self, vertex: Vertex) -> Vertex {
        Vertex(opposite(vertex.0, self.vertex_count()))
    }

    /// The facet on the other side of the centre.
    pub fn opposite_facet(&self, facet: Facet) -> Facet {
        Facet(opposite(facet.0, self.facet_count()))
    }

    /// The zonotope.
    pub fn body(&self) -> &Zonotope<3> {
        &self.body
    }

    /// How much memory its arrays of faces take.
    #[cfg(test)]
    pub(super) fn size_in_bytes(&self) -> usize {
        let indices = 2 * self.edge_ends.len()
            + self.edge_left.len()
            + self.edge_zones.len()
            + self.facet_starts.len()
            + self.facet_vertices.len()
            + self.facet_edges.len();
        indices * size_of::<u32>() + size_of_val(&self.vertices[..])
    }

    /// How many facets come before this one, less than half of all, counted with half their sides less one: the first
    /// vertex that is numbered by the facet.
    pub(super) fn first_vertex_of(&self, facet: u32) -> u32 {
        self.facet_starts[facet as usize] / 2 - facet
    }

    /// Half the sum of the edges of a zone, exactly, pointing as they do.
    pub(crate) fn exact_half_edge(&self, zone: Zone) -> [Dyadic; 3] {
        let (class, turned) = self.circles.classes[zone.0 as usize];
        let sum = self.directions.exact_sum(class as usize, self.body.generators());
        if turned { sum.map(|c| -c) } else { sum }
    }

    fn facet_range(&self, facet: Facet) -> Range<usize> {
        let [start, end] = [0, 1].map(|next| self.facet_starts[facet.0 as usize + next] as usize);
        start..end
    }
}

/// What the sweep writes.
impl FaceLattice {
    /// A lattice without faces, with room for those of the crossings.
    pub(super) fn with_room(
        body: &Zonotope<3>,
        directions: Directions<3>,
        circles: Circles,
        crossings: &Crossings,
    ) -> Self {
        let Crossings { zone_starts, facets, incidences, .. } = crossings;
        let vertices = 2 * (incidences - facets) + 2;
        let large = Extents::new(body.generators()).sums().iter().zip(body.center()).any(|(e, c)| e + c.abs() > 1e300);
        let shift = if large { 64 } else { 0 };
        let mut edge_zones = Vec::with_capacity(2 * incidences);
        for (zone, range) in zone_starts.windows(2).enumerate() {
            edge_zones.resize(range[1] as usize, zone as u32);
        }
        let mut facet_starts = Vec::with_capacity(2 * facets + 1);
        facet_starts.push(0);
        Self {
            body: body.clone(),
            directions,
            circles,
            scale: if large { power_of_two(64) } else { 1.0 },
            center: Position::of_exact(&body.center().map(|c| Dyadic::from_f64(c).scaled(-shift))),
            vertices: vec![[0.0; 3]; vertices],
            edge_ends: vec![[0; 2]; 2 * incidences],
            edge_left: vec![0; 2 * incidences],
            edge_zones,
            zone_starts: zone_starts.clone(),
            facet_starts,
            facet_vertices: Vec::with_capacity(4 * incidences),
            facet_edges: vec![0; 4 * incidences],
            facets: 2 * facets,
        }
    }

    /// The edges of the zones as vectors, scaled like [`center`](Self::center).
    pub(super) fn steps(&self) -> Vec<Step> {
        let shift = if self.scale == 1.0 { 0 } else { 64 };
        let zones = (0..self.zone_count() as u32).map(Zone);
        zones.map(|zone| Position::of_exact(&self.exact_half_edge(zone).map(|c| c.scaled(1 - shift)))).collect()
    }

    /// A name for the cell in a slot of the first meridian: the poles have their numbers, the others get them at the
    /// end.
    pub(super) fn unnumbered_cell(&self, slot: u32) -> u32 {
        let count = self.vertex_count() as u32;
        match slot {
            0 => count / 2 - 1,
            _ if slot as usize == self.zone_count() => count - 1,
            _ => count + slot,
        }
    }

    /// Begins a facet with so many sides; its vertices and edges follow.
    #[inline]
    pub(super) fn begin_facet(&mut self, sides: usize) -> u32 {
        let facet = self.facet_starts.len() as u32 - 1;
        let start = self.facet_starts[facet as usize];
        self.facet_starts.push(start + sides as u32);
        facet
    }

    #[inline]
    pub(super) fn push_vertex(&mut self, vertex: u32) {
        self.facet_vertices.push(vertex);
    }

    /// Writes edge `side` of the facet begun last, and its opposite into the opposite facet: seen from outside, a
    /// reflection in the centre turns the order around.
    #[inline]
    pub(super) fn set_edge(&mut self, facet: u32, side: usize, [edge, opposite]: [u32; 2]) {
        let [start, end] = [0, 1].map(|next| self.facet_starts[facet as usize + next] as usize);
        self.facet_edges[start + side] = edge;
        let half = self.facet_edges.len() / 2;
        self.facet_edges[half + end - 1 - side] = opposite;
    }

    #[inline]
    pub(super) fn set_arc(&mut self, arc: u32, ends: [u32; 2], facet: u32) {
        self.edge_ends[arc as usize] = ends;
        self.edge_left[arc as usize] = facet;
    }

    /// Writes a vertex and its opposite.
    #[inline]
    pub(super) fn set_vertex(&mut self, vertex: u32, position: &Position) {
        let half = self.vertices.len() / 2;
        self.vertices[vertex as usize] = self.center.plus(position).rounded(self.scale);
        self.vertices[vertex as usize + half] = self.center.plus(&position.reflected()).rounded(self.scale);
    }

    /// Adds the opposites of all faces, given the cells along the last meridian from north to south.
    pub(super) fn complete_by_reflection(&mut self, last_cells: &[u32], north: &Position) {
        let count = self.vertex_count() as u32;
        let north_pole = self.unnumbered_cell(0);
        self.set_vertex(north_pole, north);
        let reflect = |vertex: u32| opposite(vertex, count as usize);
        // the first meridian cuts the opposites of the cells that the last one cuts, in the opposite order
        let number = |cell: u32| match cell.checked_sub(count) {
            None => cell,
            Some(slot) => reflect(last_cells[last_cells.len() - 1 - slot as usize]),
        };
        let facets = self.facets as u32 / 2;
        let half = self.facet_starts[facets as usize];
        for facet in 0..facets as usize {
            let (start, end) = (self.facet_starts[facet] as usize, self.facet_starts[facet + 1] as usize);
            for vertex in &mut self.facet_vertices[start..end] {
                *vertex = number(*vertex);
            }
            // seen from outside, a reflection in the centre turns the order around
            self.facet_vertices.push(reflect(self.facet_vertices[start]));
            for at in (start + 1..end).rev() {
                self.facet_vertices.push(reflect(self.facet_vertices[at]));
            }
            self.facet_starts.push(half + end as u32);
        }
        for zone in 0..self.zone_count() {
            let (start, end) = (self.zone_starts[zone] as usize, self.zone_starts[zone + 1] as usize);
            let arcs = (end - start) / 2;
            for arc in start..start + arcs {
                let ends = self.edge_ends[arc].map(number);
                self.edge_ends[arc] = ends;
                self.edge_ends[arc + arcs] = [reflect(ends[1]), reflect(ends[0])];
                self.edge_left[arc + arcs] = self.edge_left[arc] + facets;
            }
        }
    }
}
