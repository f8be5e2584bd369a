//! The plane { u : u · p = 1 } in doubles: for guesses.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::guess::Guess;
use crate::lad::of_generators::plane::rounded_lines::{LineBlock, RoundedLines};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{Octet, total};
use crate::numeric::lanes::octets::Octets;
use crate::numeric::linear::{dot, sum_norm};

/// The least size of a cell, in terms of its centre.
const LEAST_CELL_SIZE: f64 = 1e-11;

/// An ellipse is taken for a ball where the square of its shorter axis is at least this part of the square of its
/// longer one.
const ROUND_ELLIPSE: f64 = 0.1;

/// Coordinates (x, y) = (u_i, u_j) of the plane, k the axis along which p is longest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RoundedChart {
    axes: [usize; 3],
    /// p_i / p_k and p_j / p_k.
    slopes: [f64; 2],
    /// 1 / p_k.
    inverse: f64,
}

impl RoundedChart {
    pub(crate) fn new(p: [f64; 3]) -> Self {
        let longest = if p[0].abs() >= p[1].abs() && p[0].abs() >= p[2].abs() {
            0
        } else if p[1].abs() >= p[2].abs() {
            1
        } else {
            2
        };
        let [i, j, k] = [(longest + 1) % 3, (longest + 2) % 3, longest];
        Self { axes: [i, j, k], slopes: [p[i] / p[k], p[j] / p[k]], inverse: 1.0 / p[k] }
    }

    /// The axes i and j of the coordinates, and k.
    pub(crate) fn axes(&self) -> [usize; 3] {
        self.axes
    }

    /// The line a x + b y + c = v · u.
    #[inline(always)]
    pub(crate) fn line(&self, v: &[f64; 3]) -> [f64; 3] {
        let [i, j, k] = self.axes;
        [v[i] - v[k] * self.slopes[0], v[j] - v[k] * self.slopes[1], v[k] * self.inverse]
    }

    /// The lines of some vectors.
    pub(crate) fn lines(&self, vectors: &[[f64; 3]]) -> RoundedLines {
        let mut lines = RoundedLines::with_capacity(vectors.len());
        self.write_lines(vectors, &mut lines);
        lines
    }

    /// The lines of some vectors, in the place of others: a search writes one list after the other where it stands.
    pub(crate) fn write_lines(&self, vectors: &[[f64; 3]], lines: &mut RoundedLines) {
        // the axes are known when the loop is compiled, so that coordinates stay where they are
        lines.rewrite(vectors.len(), |blocks| match self.axes {
            [1, ..] => dispatch!(level(), simd => self.read_lines::<_, 1, 2, 0>(simd, vectors, blocks)),
            [2, ..] => dispatch!(level(), simd => self.read_lines::<_, 2, 0, 1>(simd, vectors, blocks)),
            _ => dispatch!(level(), simd => self.read_lines::<_, 0, 1, 2>(simd, vectors, blocks)),
        });
    }

    /// The lines of vectors, eight by eight; returns the sum of the lengths.
    #[inline(always)]
    fn read_lines<S: Simd, const I: usize, const J: usize, const K: usize>(
        &self,
        simd: S,
        vectors: &[[f64; 3]],
        blocks: &mut [LineBlock],
    ) -> f64 {
        let octets = Octets::new(vectors, &[]);
        let mut lengths = f64x8::splat(simd, 0.0);
        for (k, block) in blocks.iter_mut().enumerate() {
            let v = octets.load(simd, k);
            lengths += self.write_block(simd, [v[I], v[J], v[K]], block);
        }
        total(lengths)
    }

    #[inline(always)]
    fn write_block<S: Simd>(&self, simd: S, [x, y, z]: Octet<S>, block: &mut LineBlock) -> f64x8<S> {
        let sizes = x.abs() + y.abs() + z.abs();
        let least = f64x8::splat(simd, f64::MIN_POSITIVE);
        let lengths = sizes.simd_gt(least).select(sizes, least);
        (x - z * self.slopes[0]).store_slice(&mut block.0[0]);
        (y - z * self.slopes[1]).store_slice(&mut block.0[1]);
        (z * self.inverse).store_slice(&mut block.0[2]);
        (f64x8::splat(simd, 1.0) / lengths).store_slice(&mut block.0[3]);
        lengths
    }

    fn direction(&self, [x, y]: [f64; 2], height: f64) -> [f64; 3] {
        let [i, j, k] = self.axes;
        let mut u = [0.0; 3];
        u[i] = x;
        u[j] = y;
        u[k] = height * self.inverse - x * self.slopes[0] - y * self.slopes[1];
        u
    }

    /// The direction u of a point, u · p = 1.
    pub(crate) fn point(&self, point: [f64; 2]) -> [f64; 3] {
        self.direction(point, 1.0)
    }

    /// The guess whose ellipse is a cell, the centre u of which has u · p = 1.
    pub(crate) fn guess_of(&self, cell: &DirectionCone) -> Guess {
        let place = |u: &[f64; 3]| [u[self.axes[0]], u[self.axes[1]]];
        let sides = cell.axes.map_or([[cell.ball, 0.0], [0.0, cell.ball]], |axes| axes.each_ref().map(place));
        let length = sum_norm(&cell.center);
        let band = sides.as_flattened().iter().fold(0.0f64, |m, c| m.max(c.abs())).min(length);
        Guess { point: place(&cell.center), band, sides }
    }

    /// The ellipse of a guess, stretched; a ball around the ellipse where the ball is hardly larger.
    pub(crate) fn cell(&self, guess: &Guess, stretch: f64) -> DirectionCone {
        let [first, second] = guess.sides.map(|side| self.direction(side, 0.0).map(|c| stretch * c));
        let center = self.point(guess.point);
        // not so small that a vertex in which many lines meet is missed by rounding
        let least = LEAST_CELL_SIZE * center.iter().fold(0.0f64, |m, c| m.max(c.abs()));
        let (xx, xy, yy) = (dot(&first, &first), dot(&first, &second), dot(&second, &second));
        let (middle, half) = ((xx + yy) / 2.0, ((xx - yy) * (xx - yy) / 4.0 + xy * xy).sqrt());
        if middle - half >= ROUND_ELLIPSE * (middle + half) {
            DirectionCone { center, axes: None, ball: least.max((middle + half).sqrt()) }
        } else {
            DirectionCone { center, axes: Some([first, second]), ball: least }
        }
    }
}
