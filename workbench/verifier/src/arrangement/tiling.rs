//! Answers to "the tiling of Q by the facets of the upper hull", as the dual arrangement of the generators.
//!
//! Q is the zonogon of the projections (a, b) of generators (a, b, c), turned to point up (level ones to the left). The
//! arrangement of the lines a x + b y + c = 0 is built here from its definition: the crossings along each line in their
//! order, and for each piece of a line a point inside it, whose signs with respect to all other lines name the two
//! faces on its sides. Then
//!
//! - each crossing of two lines has one tile, with those generators and that dual vertex, and there are no other tiles;
//!   they are numbered by x, then y;
//! - along each line the pieces from left to right are the edges of its generator, with the tile of the crossing at
//!   each end;
//! - the two faces along a piece are the two ends of its edge: the vertex of a face is Σ ± generators with the signs of
//!   the face, in space; different faces have different vertices, and there are no others;
//! - each tile is the parallelogram of its generators, between its four edges, and the areas of the tiles add up to Q.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fmt::{self, Display};

use dashu_int::IBig;

use super::separator::{Crossing, on_grid, upward};
use crate::exact::fraction::Fraction;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::linear::{Vector, dot};
use crate::exact::polygon::{ConvexPolygon, Point, cross};
use crate::verdict::{Stop, Verdict};

/// Up to this many signs of points with respect to lines are worked out.
const MOST_SIGNS: usize = 200_000_000;

/// A tiling as it was written; all indices count from 0.
#[derive(Debug, Clone, PartialEq)]
pub struct TilingAnswer {
    /// The vertices, where they are in space.
    pub vertices: Vec<[Fraction; 3]>,
    /// The edges.
    pub edges: Vec<TilingEdge>,
    /// The tiles, from left to right.
    pub tiles: Vec<Tile>,
    /// The vertices of the left side of Q, from its top to its bottom.
    pub left_side: Vec<usize>,
}

/// An edge of a tiling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TilingEdge {
    /// The generator along it.
    pub generator: usize,
    /// Its upper end; of two ends of one height the left one.
    pub upper: usize,
    /// Its lower end.
    pub lower: usize,
    /// The tile on its left, unless that is outside of Q.
    pub left: Option<usize>,
    /// The tile on its right, unless that is outside of Q.
    pub right: Option<usize>,
}

/// A tile of a tiling.
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    /// Its generators, the lower number first.
    pub generators: [usize; 2],
    /// Its corners: top, left, bottom, right.
    pub corners: [usize; 4],
    /// Its edges: upper left, lower left, lower right, upper right.
    pub edges: [usize; 4],
    /// The point where the lines of its generators cross.
    pub dual: [Fraction; 2],
}

/// The size of a proved tiling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TilingProof {
    /// The number of tiles.
    pub tiles: usize,
}

impl Display for TilingProof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} tiles, isomorphic to the dual arrangement", self.tiles)
    }
}

/// Proves that a tiling is that of the generators, of which no three are coplanar, or says what fails. O(n³) exact
/// operations for n generators; of too many the tiling is left unchecked.
pub fn check_tiling(generators: &[Vec<f64>], answer: &TilingAnswer) -> Verdict<TilingProof> {
    isomorphic(generators, answer).map(|()| TilingProof { tiles: answer.tiles.len() }).into()
}

/// The line of a generator, with its generator turned up.
struct Line {
    generator: usize,
    vector: Vector,
}

/// The question and the answer on one grid, every index of the answer within its list.
struct Walk<'a> {
    answer: &'a TilingAnswer,
    vertices: Vec<Vector>,
    lines: Vec<Line>,
    /// The sum of the generators that stand upright, turned up: all vertices of the upper hull share it.
    upright: IBig,
    /// The tiles by their generators.
    tiles: BTreeMap<[usize; 2], usize>,
}

fn isomorphic(generators: &[Vec<f64>], answer: &TilingAnswer) -> Result<(), Stop> {
    if generators.iter().any(|generator| generator.len() != 3) {
        return Err("answered a question whose generators are not in space".into());
    }
    check_finite("the question", generators.iter().flatten())?;
    check_indices(generators.len(), answer)?;
    let grid = Grid::of(generators.iter().flatten().copied());
    let on_grid = |vertex: &[Fraction; 3]| vertex.iter().map(|x| on_grid(x, grid)).collect::<Option<Vector>>();
    let vertices: Option<Vec<Vector>> = answer.vertices.iter().map(on_grid).collect();
    let mut walk = Walk {
        answer,
        vertices: vertices.ok_or("a vertex is no sum of generators")?,
        lines: Vec::new(),
        upright: IBig::ZERO,
        tiles: (0..).zip(&answer.tiles).map(|(index, tile)| (tile.generators, index)).collect(),
    };
    for (generator, vector) in generators.iter().enumerate() {
        let vector: Vector = vector.iter().map(|&x| grid.units(x)).collect();
        let height = vector[2].clone();
        match upward(vector) {
            Some(vector) => walk.lines.push(Line { generator, vector }),
            None if height < IBig::ZERO => walk.upright -= height,
            None => walk.upright += height,
        }
    }
    let count = walk.lines.len();
    if count.saturating_mul(count).saturating_mul(count) > MOST_SIGNS {
        return Err(Stop::Unchecked("too many generators to go along every line of the arrangement".to_owned()));
    }
    Ok(walk.check()?)
}

fn check_indices(generators: usize, answer: &TilingAnswer) -> Result<(), String> {
    let TilingAnswer { vertices, edges, tiles, left_side } = answer;
    let is_tile = |tile: Option<usize>| tile.is_none_or(|tile| tile < tiles.len());
    let is_edge = |edge: &TilingEdge| {
        edge.generator < generators
            && edge.upper.max(edge.lower) < vertices.len()
            && is_tile(edge.left)
            && is_tile(edge.right)
    };
    if let Some(wrong) = edges.iter().position(|edge| !is_edge(edge)) {
        return Err(format!("edge {wrong} names what does not exist"));
    }
    let exists = |tile: &Tile| {
        tile.generators.iter().all(|&generator| generator < generators)
            && tile.corners.iter().all(|&corner| corner < vertices.len())
            && tile.edges.iter().all(|&edge| edge < edges.len())
    };
    if let Some(wrong) = tiles.iter().position(|tile| !exists(tile)) {
        return Err(format!("tile {wrong} names what does not exist"));
    }
    match left_side.iter().find(|&&vertex| vertex >= vertices.len()) {
        Some(wrong) => Err(format!("the left side names vertex {wrong}, which does not exist")),
        None => Ok(()),
    }
}

impl Walk<'_> {
    fn check(&self) -> Result<(), String> {
        self.check_tiles()?;
        let mut faces: BTreeMap<Vec<bool>, usize> = BTreeMap::new();
        for line in &self.lines {
            self.check_line(line, &mut faces)?;
        }
        if self.lines.is_empty() {
            let place = vec![IBig::ZERO, IBig::ZERO, self.upright.clone()];
            if self.vertices.first() != Some(&place) {
                return Err("the only vertex is not where the generators that stand upright add up".to_owned());
            }
            faces.insert(Vec::new(), 0);
        }
        let mut met: Vec<usize> = faces.values().copied().collect();
        met.sort_unstable();
        met.dedup();
        if met.len() != faces.len() || met.len() != self.vertices.len() || self.answer.edges.len() != self.pieces() {
            return Err(format!("{} vertices for {} faces", self.vertices.len(), faces.len()));
        }
        self.check_shapes()?;
        self.check_left_side()
    }

    /// Every line has a piece more than crossings.
    fn pieces(&self) -> usize {
        self.lines.len() + 2 * self.answer.tiles.len()
    }

    /// Each tile is dual to the crossing of its lines, from left to right.
    fn check_tiles(&self) -> Result<(), String> {
        let mut crossings = 0;
        for (j, second) in self.lines.iter().enumerate() {
            for first in &self.lines[..j] {
                let Some(crossing) = Crossing::of(&first.vector, &second.vector) else { continue };
                crossings += 1;
                let generators = [first.generator, second.generator];
                let tile = self.tiles.get(&generators).map(|&tile| &self.answer.tiles[tile]);
                if !tile.is_some_and(|tile| crossing.is_at(&tile.dual)) {
                    return Err(format!("the crossing of the lines of {generators:?} has no tile of its own"));
                }
            }
        }
        let duals: Vec<Crossing> = self.answer.tiles.iter().map(|tile| Crossing::at(&tile.dual)).collect();
        let is_complete = self.answer.tiles.len() == crossings && self.tiles.len() == crossings;
        if is_complete && duals.is_sorted_by(|a, b| a < b) {
            Ok(())
        } else {
            Err("the tiles are not the crossings from left to right".to_owned())
        }
    }

    fn check_line(&self, line: &Line, faces: &mut BTreeMap<Vec<bool>, usize>) -> Result<(), String> {
        let generator = line.generator;
        let mut crossings: Vec<(Crossing, usize)> = self
            .lines
            .iter()
            .filter_map(|other| {
                let pair = [generator.min(other.generator), generator.max(other.generator)];
                Some((Crossing::of(&line.vector, &other.vector)?, *self.tiles.get(&pair)?))
            })
            .collect();
        crossings.sort();
        let edges: Vec<&TilingEdge> = self.answer.edges.iter().filter(|edge| edge.generator == generator).collect();
        for piece in 0..=crossings.len() {
            let named = || format!("piece {piece} of the line of generator {generator}");
            let left = piece.checked_sub(1).map(|before| &crossings[before]);
            let right = crossings.get(piece);
            let ends = [left, right].map(|end| end.map(|(_, tile)| *tile));
            let edge = edges.iter().find(|edge| [edge.left, edge.right] == ends);
            let edge = edge.ok_or_else(|| format!("{} has no edge of its own", named()))?;
            let inside = middle(&line.vector, left.map(|(point, _)| point), right.map(|(point, _)| point));
            for (vertex, own) in [(edge.upper, true), (edge.lower, false)] {
                let sign = |other: &Line| {
                    if other.generator == generator { own } else { dot(&other.vector, &inside) > IBig::ZERO }
                };
                let signs: Vec<bool> = self.lines.iter().map(sign).collect();
                let known = faces.get(&signs).copied().unwrap_or(vertex);
                if known != vertex || self.place(&signs) != self.vertices[vertex] {
                    return Err(format!("the faces beside {} are not the ends of its edge", named()));
                }
                faces.insert(signs, vertex);
            }
        }
        Ok(())
    }

    /// Σ ± generators with the signs of a face.
    fn place(&self, signs: &[bool]) -> Vector {
        let start = vec![IBig::ZERO, IBig::ZERO, self.upright.clone()];
        self.lines.iter().zip(signs).fold(start, |mut sum, (line, &is_added)| {
            for (sum, x) in sum.iter_mut().zip(&line.vector) {
                if is_added { *sum += x } else { *sum -= x }
            }
            sum
        })
    }

    fn check_shapes(&self) -> Result<(), String> {
        let mut covered = IBig::ZERO;
        for (index, tile) in self.answer.tiles.iter().enumerate() {
            let Tile { generators, corners: [top, left, bottom, right], .. } = *tile;
            let edges = tile.edges.map(|edge| self.answer.edges[edge]);
            let ends = [[top, left], [left, bottom], [right, bottom], [top, right]];
            let is_between = edges.iter().zip(ends).all(|(edge, ends)| [edge.upper, edge.lower] == ends)
                && edges[..2].iter().all(|edge| edge.right == Some(index))
                && edges[2..].iter().all(|edge| edge.left == Some(index));
            let along = edges.map(|edge| edge.generator);
            let is_parallelogram = along[0] == along[2]
                && along[1] == along[3]
                && generators == [along[0].min(along[1]), along[0].max(along[1])];
            if !is_between || !is_parallelogram {
                return Err(format!("tile {index} is not the parallelogram of its generators"));
            }
            let [first, second] = [self.step(left, top), self.step(bottom, left)];
            covered += cross(&first, &second);
        }
        let projections: Vec<Point> =
            self.lines.iter().map(|line| [line.vector[0].clone(), line.vector[1].clone()]).collect();
        let whole = ConvexPolygon::zonogon(&[IBig::ZERO, IBig::ZERO], &projections).doubled_area();
        if covered * 2 == whole { Ok(()) } else { Err("the tiles do not cover Q".to_owned()) }
    }

    /// From one vertex to another, in the plane.
    fn step(&self, from: usize, to: usize) -> Point {
        [0, 1].map(|axis: usize| &self.vertices[to][axis] - &self.vertices[from][axis])
    }

    /// The left side of Q goes down along every edge without a tile on its left, and along no other.
    fn check_left_side(&self) -> Result<(), String> {
        let is_first = |pair: &[usize]| {
            let along = |edge: &&TilingEdge| edge.left.is_none() && [edge.upper, edge.lower] == *pair;
            self.answer.edges.iter().any(|edge| along(&edge))
        };
        let left_side = &self.answer.left_side;
        if left_side.len() == self.lines.len() + 1 && left_side.windows(2).all(is_first) {
            Ok(())
        } else {
            Err("the left side is not that of Q".to_owned())
        }
    }
}

/// A point inside the piece of a line between two of its points, either of which may be missing: (x, y, w) with w > 0.
fn middle(line: &Vector, left: Option<&Crossing>, right: Option<&Crossing>) -> Vector {
    // To the right along the line of a generator that points up, or up a vertical line.
    let ahead = [line[1].clone(), -&line[0]];
    let beside = |from: &Crossing, forward: bool| {
        let [x, y, w] = from.homogeneous();
        let moved = |at: &IBig, step: &IBig| if forward { at + step * w } else { at - step * w };
        vec![moved(x, &ahead[0]), moved(y, &ahead[1]), w.clone()]
    };
    match (left, right) {
        (Some(left), Some(right)) => {
            let ([x, y, w], [u, v, z]) = (left.homogeneous(), right.homogeneous());
            vec![x * z + u * w, y * z + v * w, w * z * 2]
        }
        (Some(left), None) => beside(left, true),
        (None, Some(right)) => beside(right, false),
        (None, None) => {
            let square = &line[0] * &line[0] + &line[1] * &line[1];
            vec![-(&line[0] * &line[2]), -(&line[1] * &line[2]), square]
        }
    }
}
