//! Walks the isomorphism between a tiling and the dual arrangement of its generators.
//!
//! The arrangement is built here, from its definition and in rationals: the crossings along each line in their order, and for each
//! piece of a line between two of them a point inside it, whose signs with respect to all other lines name the two faces on its sides.
//!
//! # What is checked
//! - **tile ↔ vertex**: each crossing of two lines has one tile, with those generators and that dual vertex; there are no others; tiles
//!   are numbered by x, then y.
//! - **edge ↔ edge**: along each line, the pieces from left to right are the edges of that generator, with the tile of
//!   the crossing at each end.
//! - **vertex ↔ face**: the two faces along a piece are the two ends of its edge: the vertex of a face with signs σ is Σ σ v, in space, so it is
//!   the extreme point of Z in the directions (x, y, 1) of the face. All faces have different vertices, and there are no others.
//! - **a tiling**: opposite sides of a tile are its generators' steps, and the areas of the tiles add up to the area of Q.

use std::collections::{BTreeMap, BTreeSet};

use thiserror::Error;

use super::{CornerIndex, Edge, Tile, TileIndex, Tiling};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

type Plane = [Rational; 2];
type Space = [Rational; 3];

/// Where the isomorphism fails.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum IsomorphismError {
    /// Two lines cross where no tile, or a wrong one, is dual to it.
    #[error("the crossing of the lines of {generators:?} has no tile of its own")]
    Tile {
        /// The generators of the lines.
        generators: [usize; 2],
    },
    /// The tiles are not numbered from left to right, or there are more than crossings.
    #[error("the tiles are not the crossings from left to right")]
    TileOrder,
    /// A piece of a line has no edge with the tiles of its ends.
    #[error("piece {piece} of the line of generator {generator} has no edge of its own")]
    Edge {
        /// The generator of the line.
        generator: usize,
        /// The piece from the left, from 0.
        piece: usize,
    },
    /// The faces beside a piece of a line are not the ends of its edge.
    #[error("the faces beside piece {piece} of the line of generator {generator} are not the ends of its edge")]
    Vertex {
        /// The generator of the line.
        generator: usize,
        /// The piece from the left, from 0.
        piece: usize,
    },
    /// The vertices are not the faces one to one.
    #[error("{vertices} vertices for {faces} faces")]
    VertexCount {
        /// Different vertices met.
        vertices: usize,
        /// Different faces met.
        faces: usize,
    },
    /// A tile is not the parallelogram of its generators.
    #[error("tile {tile} is not the parallelogram of its generators")]
    Shape {
        /// Its position.
        tile: usize,
    },
    /// The areas of the tiles do not add up to that of Q.
    #[error("the tiles do not cover Q")]
    Area,
}

/// The line of a generator, with its generator turned up.
struct Line {
    generator: usize,
    vector: Space,
}

/// Checks that a tiling is that of the generators, isomorphic to their dual arrangement. O(n³) exact operations.
///
/// # Errors
/// [`IsomorphismError`] says where the isomorphism fails.
pub fn verify(tiling: &Tiling, generators: &[[f64; 3]]) -> Result<(), IsomorphismError> {
    let vectors: Vec<Space> = generators.iter().map(|v| v.map(|c| Dyadic::from_f64(c).to_rational())).collect();
    let lines: Vec<Line> = vectors
        .iter()
        .enumerate()
        .filter(|(_, [x, y, _])| *x != Rational::ZERO || *y != Rational::ZERO)
        .map(|(generator, vector)| Line { generator, vector: upward(vector) })
        .collect();
    let tiles = check_tiles(tiling, &lines)?;
    let mut faces: BTreeMap<Vec<bool>, CornerIndex> = BTreeMap::new();
    for line in &lines {
        check_line(tiling, line, &lines, &vectors, &tiles, &mut faces)?;
    }
    if lines.is_empty() {
        faces.insert(Vec::new(), CornerIndex(0));
    }
    let met: BTreeSet<&CornerIndex> = faces.values().collect();
    if met.len() != faces.len() || met.len() != tiling.vertices.len() {
        return Err(IsomorphismError::VertexCount { vertices: tiling.vertices.len(), faces: faces.len() });
    }
    check_shapes(tiling, &vectors)
}

fn upward(v: &Space) -> Space {
    let is_up = v[1] > Rational::ZERO || (v[1] == Rational::ZERO && v[0] < Rational::ZERO);
    if is_up { v.clone() } else { v.clone().map(|c| -c) }
}

fn crossing(a: &Space, b: &Space) -> Option<Plane> {
    let w = &a[0] * &b[1] - &a[1] * &b[0];
    let [x, y] = [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2]];
    (w != Rational::ZERO).then(|| [x / &w, y / w])
}

/// The tiles by their generators; each is dual to its crossing, in order.
fn check_tiles(tiling: &Tiling, lines: &[Line]) -> Result<BTreeMap<[usize; 2], TileIndex>, IsomorphismError> {
    let tiles: BTreeMap<[usize; 2], TileIndex> =
        (0..).map(TileIndex).zip(&tiling.tiles).map(|(index, tile)| (tile.generators, index)).collect();
    let mut crossings = 0;
    for (j, second) in lines.iter().enumerate() {
        for first in &lines[..j] {
            let Some(point) = crossing(&first.vector, &second.vector) else { continue };
            crossings += 1;
            let generators = [first.generator, second.generator];
            let dual = tiles.get(&generators).map(|&tile| &tiling.tiles[tile.0 as usize].exact_dual);
            if dual != Some(&point) {
                return Err(IsomorphismError::Tile { generators });
            }
        }
    }
    let is_ascending = tiling.tiles.windows(2).all(|pair| pair[0].exact_dual < pair[1].exact_dual);
    let is_complete = tiling.tiles.len() == crossings && tiles.len() == crossings;
    if is_ascending && is_complete { Ok(tiles) } else { Err(IsomorphismError::TileOrder) }
}

fn check_line(
    tiling: &Tiling,
    line: &Line,
    lines: &[Line],
    vectors: &[Space],
    tiles: &BTreeMap<[usize; 2], TileIndex>,
    faces: &mut BTreeMap<Vec<bool>, CornerIndex>,
) -> Result<(), IsomorphismError> {
    let generator = line.generator;
    let mut crossings: Vec<(Plane, TileIndex)> = lines
        .iter()
        .filter_map(|other| {
            let pair = [generator.min(other.generator), generator.max(other.generator)];
            Some((crossing(&line.vector, &other.vector)?, tiles[&pair]))
        })
        .collect();
    crossings.sort();
    let edges: Vec<&Edge> = tiling.edges.iter().filter(|edge| edge.generator == generator).collect();
    if edges.len() != crossings.len() + 1 {
        return Err(IsomorphismError::Edge { generator, piece: edges.len() });
    }
    for piece in 0..=crossings.len() {
        let left = piece.checked_sub(1).map(|before| &crossings[before]);
        let right = crossings.get(piece);
        let ends = [left, right].map(|end| end.map(|(_, tile)| *tile));
        let edge = edges.iter().find(|edge| [edge.left, edge.right] == ends);
        let edge = edge.ok_or(IsomorphismError::Edge { generator, piece })?;
        let middle = middle(&line.vector, left.map(|(point, _)| point), right.map(|(point, _)| point));
        for (corner, own) in [(edge.upper, true), (edge.lower, false)] {
            let signs: Vec<bool> = lines
                .iter()
                .map(|other| if other.generator == generator { own } else { is_positive(&other.vector, &middle) })
                .collect();
            let known = *faces.entry(signs.clone()).or_insert(corner);
            if known != corner || !is_at(tiling, corner, lines, vectors, &signs) {
                return Err(IsomorphismError::Vertex { generator, piece });
            }
        }
    }
    Ok(())
}

/// A point inside the piece of a line between two of its points, either of which may be missing.
fn middle(line: &Space, left: Option<&Plane>, right: Option<&Plane>) -> Plane {
    // to the right along an upward generator's line, or up a vertical one
    let ahead = [line[1].clone(), -line[0].clone()];
    let away = |from: &Plane, sign: i32| [0, 1].map(|axis| &from[axis] + Rational::from(sign) * &ahead[axis]);
    match (left, right) {
        (Some(left), Some(right)) => [0, 1].map(|axis| (&left[axis] + &right[axis]) / Rational::from(2)),
        (Some(left), None) => away(left, 1),
        (None, Some(right)) => away(right, -1),
        (None, None) => {
            let square = &line[0] * &line[0] + &line[1] * &line[1];
            [0, 1].map(|axis| -(&line[axis] * &line[2]) / &square)
        }
    }
}

fn is_positive(v: &Space, point: &Plane) -> bool {
    &v[0] * &point[0] + &v[1] * &point[1] + &v[2] > Rational::ZERO
}

/// Whether a vertex is Σ ± v with the signs of a face; vertical generators point up.
fn is_at(tiling: &Tiling, corner: CornerIndex, lines: &[Line], vectors: &[Space], signs: &[bool]) -> bool {
    let poles = vectors.iter().filter(|[x, y, _]| *x == Rational::ZERO && *y == Rational::ZERO);
    let start = poles.fold([Rational::ZERO, Rational::ZERO, Rational::ZERO], |[x, y, z], pole| {
        let height = if pole[2] < Rational::ZERO { -pole[2].clone() } else { pole[2].clone() };
        [x, y, z + height]
    });
    let point = lines.iter().zip(signs).fold(start, |sum, (line, &sign)| {
        [0, 1, 2].map(|axis| if sign { &sum[axis] + &line.vector[axis] } else { &sum[axis] - &line.vector[axis] })
    });
    tiling.vertices[corner.0 as usize].exact_point.each_ref().map(Dyadic::to_rational) == point
}

fn check_shapes(tiling: &Tiling, vectors: &[Space]) -> Result<(), IsomorphismError> {
    let point =
        |corner: CornerIndex| tiling.vertices[corner.0 as usize].exact_point.each_ref().map(Dyadic::to_rational);
    let step = |from: CornerIndex, to: CornerIndex| {
        let (from, to) = (point(from), point(to));
        [0, 1, 2].map(|axis| (&to[axis] - &from[axis]) / Rational::from(2))
    };
    let area = |a: &Space, b: &Space| &a[0] * &b[1] - &a[1] * &b[0];
    let mut covered = Rational::ZERO;
    for (position, tile) in tiling.tiles.iter().enumerate() {
        let Tile { corners: [top, left, bottom, right], edges, .. } = tile;
        let steps = [step(*left, *top), step(*bottom, *left), step(*bottom, *right), step(*right, *top)];
        let mut generators = [0, 1].map(|edge| tiling.edges[edges[edge].0 as usize].generator);
        let is_parallelogram = steps[0] == steps[2] && steps[1] == steps[3];
        let fits = (0..2).all(|edge| steps[edge] == upward(&vectors[generators[edge]]));
        generators.sort_unstable();
        if !is_parallelogram || !fits || generators != tile.generators {
            return Err(IsomorphismError::Shape { tile: position });
        }
        covered += Rational::from(4) * area(&steps[0], &steps[1]);
    }
    let outline: Vec<Space> = tiling.outline().into_iter().map(point).collect();
    let next = outline.iter().skip(1).chain(&outline[..1]);
    let double = outline.iter().zip(next).fold(Rational::ZERO, |sum, (a, b)| sum + area(a, b));
    if double == Rational::from(2) * covered { Ok(()) } else { Err(IsomorphismError::Area) }
}
