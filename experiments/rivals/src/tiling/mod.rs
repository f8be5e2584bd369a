//! Problem: the tiling of Q, which the facets of the upper hull project to, and its isomorphism with the dual
//! arrangement (Section 3, Figure 1).
//!
//! Q is the projection of a zonotope in space, a zonogon. Each facet of the upper hull projects to a parallelogram
//! T_ij = { c + s v'_i + t v'_j : |s|, |t| ≤ 1 }, and these tile Q. In the dual arrangement the tile is the vertex
//! where the lines of i and j cross, an edge of the tiling is a piece of its generator's line, and a vertex of the
//! tiling is a face.
//!
//! The generators must be in general position as far as the isomorphism needs it: no two are parallel, no three of
//! those with a line are coplanar; anything else is refused with their numbers. Zero and vertical generators have no
//! line: the former take no part, the latter raise the hull. Generators with parallel projections have no tile in
//! common. A level generator (y = 0) has a vertical line. Tiles are numbered by the x of their vertices, then by y.
//!
//! | method | cost for n generators | what it is |
//! |---|---|---|
//! | [`by_sweep`] | O(n² log n) exact operations | the tiling from left to right, tile by tile |
//!
//! The library has the facets of the upper hull, for generators in any position
//! ([`by_face_lattice`](zonotope::arrangement::tiling::by_face_lattice)). The crate `verifier` builds the arrangement
//! on its own and walks the isomorphism ([`check_tiling`]).

pub mod by_sweep;
mod verified;

use thiserror::Error;

pub use by_sweep::tiling;
pub use verified::{check_tiling, tiling_answer};

use zonotope::arrangement::GeneratorError;
use zonotope::numeric::Rational;
use zonotope::numeric::dyadic::Dyadic;

/// A vertex of a tiling, as a position in [`Tiling::vertices`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CornerIndex(pub u32);

/// An edge of a tiling, as a position in [`Tiling::edges`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EdgeIndex(pub u32);

/// A tile of a tiling, as a position in [`Tiling::tiles`]; the tile with the number k of the paper has position k − 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TileIndex(pub u32);

/// The tiling of Q by the facets of the upper hull; the zonotope has its centre in the origin. An index in one of its
/// parts is a position in one of its lists.
#[derive(Debug, Clone, PartialEq)]
pub struct Tiling {
    vertices: Vec<Corner>,
    edges: Vec<Edge>,
    tiles: Vec<Tile>,
    left_side: Vec<CornerIndex>,
    left_generators: Vec<usize>,
}

/// A vertex of the upper hull.
#[derive(Debug, Clone, PartialEq)]
pub struct Corner {
    /// Its place in space, exactly; x and y are those of the tiling's vertex.
    pub exact_point: [Dyadic; 3],
}

/// An edge of the upper hull, dual to a piece of its generator's line.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// The generator along it.
    pub generator: usize,
    /// Its upper end in the plane; of two ends of one height the left one.
    pub upper: CornerIndex,
    /// Its lower end.
    pub lower: CornerIndex,
    /// The tile on its left, where the dual piece begins; none on the left side of Q, where it is unbounded.
    pub left: Option<TileIndex>,
    /// The tile on its right, where the dual piece ends.
    pub right: Option<TileIndex>,
}

/// A facet of the upper hull, dual to the vertex of two lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    /// Its generators, the lower number first.
    pub generators: [usize; 2],
    /// Its corners counter-clockwise from the top: top, left, bottom, right.
    pub corners: [CornerIndex; 4],
    /// Its edges counter-clockwise from the top: upper left, lower left, lower right, upper right.
    pub edges: [EdgeIndex; 4],
    /// The dual vertex, exactly: (x, y, 1) is a normal of the facet.
    pub exact_dual: [Rational; 2],
    /// The number of edges that a separator has above the tile.
    pub above: usize,
}

/// Why generators have no tiling that is isomorphic to their dual arrangement.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TilingError {
    /// A coordinate is not finite, or there are too many generators.
    #[error(transparent)]
    Generators(#[from] GeneratorError),
    /// Two generators are parallel: their lines are one.
    #[error("the generators {first} and {second} are parallel, not in general position")]
    Parallel {
        /// The one with the lower number.
        first: usize,
        /// The other one.
        second: usize,
    },
    /// Three generators are coplanar: their lines meet in one point.
    #[error("the generators {generators:?} are coplanar, not in general position")]
    Coplanar {
        /// Their numbers, ascending.
        generators: [usize; 3],
    },
}

impl Tiling {
    /// The vertices; that of a face of the dual arrangement each.
    pub fn vertices(&self) -> &[Corner] {
        &self.vertices
    }

    /// The edges; that of a piece of a line each.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The tiles in their order from left to right; that of a vertex of the dual arrangement each.
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// The left side of Q, from its top to its bottom vertex.
    pub fn left_side(&self) -> &[CornerIndex] {
        &self.left_side
    }

    /// The generators along the left side of Q, from the top.
    pub fn left_generators(&self) -> &[usize] {
        &self.left_generators
    }

    /// The separator L'_k, from the top to the bottom vertex of Q; `None` if there are fewer than k tiles. O(n + k).
    pub fn separator(&self, k: usize) -> Option<Vec<CornerIndex>> {
        let mut chain = self.left_side.clone();
        for tile in self.tiles.get(..k)? {
            chain[tile.above + 1] = tile.corners[3];
        }
        Some(chain)
    }

    /// The generators along L'_k from the top, whose lines L_k meets from top to bottom. O(n + k).
    pub fn separator_generators(&self, k: usize) -> Option<Vec<usize>> {
        let mut generators = self.left_generators.clone();
        for tile in self.tiles.get(..k)? {
            generators.swap(tile.above, tile.above + 1);
        }
        Some(generators)
    }

    /// The boundary of Q counter-clockwise from its top vertex. O(n²).
    pub fn outline(&self) -> Vec<CornerIndex> {
        let right = self.separator(self.tiles.len()).expect("all tiles are left of the right side");
        let back = right.iter().rev().skip(1).take(right.len().saturating_sub(2));
        let mut outline: Vec<CornerIndex> = self.left_side.iter().chain(back).copied().collect();
        outline.dedup();
        outline
    }

    /// The middle of a tile, each coordinate within a relative 2^-50; `None` if there is no such tile.
    pub fn center(&self, tile: TileIndex) -> Option<[f64; 2]> {
        let [top, _, bottom, _] = self.tiles.get(tile.0 as usize)?.corners;
        let [top, bottom] = [top, bottom].map(|corner| &self.vertices[corner.0 as usize].exact_point);
        Some([0, 1].map(|axis| (&top[axis] + &bottom[axis]).scaled(-1).to_f64()))
    }
}

impl Corner {
    /// The place of the vertex in the plane, each coordinate within a relative 2^-50.
    pub fn point(&self) -> [f64; 2] {
        [self.exact_point[0].to_f64(), self.exact_point[1].to_f64()]
    }

    /// The height of the upper hull there, within a relative 2^-50.
    pub fn height(&self) -> f64 {
        self.exact_point[2].to_f64()
    }
}

impl Tile {
    /// The dual vertex, each coordinate rounded.
    pub fn dual(&self) -> [f64; 2] {
        self.exact_dual.each_ref().map(|coordinate| coordinate.to_f64().value())
    }
}
