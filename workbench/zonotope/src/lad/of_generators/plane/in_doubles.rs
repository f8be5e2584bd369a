//! The plane { u : u · p = 1 } in doubles, for guesses: its coordinates, the lines of generators in them, eight side by
//! side, and what a guess in it is.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::octet::{LANES, Octet, slot, total, turned};
use crate::numeric::lanes::octets::Octets;
use crate::numeric::linear::{dot, sum_norm};
use crate::numeric::reused::{Reused, keep_lists_of};

/// The least size of a cell, in terms of its centre.
const LEAST_CELL_SIZE: f64 = 1e-11;

/// An ellipse is taken for a ball where the square of its shorter axis is at least this part of the square of its
/// longer one.
const ROUND_ELLIPSE: f64 = 0.1;

/// The filling of the last block: a line without normal that is far from every point.
const NO_LINE: [f64; 4] = [0.0, 0.0, 1.0, f64::MAX];

/// A point near the optimum, the band of lines whose kinks were rounded off, and the sides of a parallelogram around
/// the point in which the optimum is likely to be.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Guess {
    pub(crate) point: [f64; 2],
    pub(crate) band: f64,
    pub(crate) sides: [[f64; 2]; 2],
}

impl Guess {
    /// Whether the distance of a point is at most `times` that of the corner between the sides.
    pub(crate) fn is_near(&self, point: [f64; 2], times: f64) -> bool {
        let square = |[x, y]: [f64; 2]| x * x + y * y;
        let off = [point[0] - self.point[0], point[1] - self.point[1]];
        square(off) <= times * times * (square(self.sides[0]) + square(self.sides[1]))
    }
}

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

/// Eight lines a x + b y + c side by side, with the inverse lengths of their generators.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(crate) struct LineBlock(pub(crate) [[f64; LANES]; 4]);

keep_lists_of!(LineBlock);

/// A plane over the plane of the lines: slope · x + height at the point x.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Plane {
    pub(crate) slope: [f64; 2],
    pub(crate) height: f64,
}

impl Plane {
    /// The plane a x + b y + c.
    pub(crate) fn of([a, b, c]: [f64; 3]) -> Self {
        Self { slope: [a, b], height: c }
    }

    pub(crate) fn value(&self, [x, y]: [f64; 2]) -> f64 {
        self.slope[0] * x + self.slope[1] * y + self.height
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self { slope: [0, 1].map(|k| self.slope[k] + other.slope[k]), height: self.height + other.height }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self { slope: [0, 1].map(|k| self.slope[k] - other.slope[k]), height: self.height - other.height }
    }
}

/// The lines of generators. A line has the number of its generator's row; its [`slot`] says where in the blocks it is.
#[derive(Debug)]
pub(crate) struct RoundedLines {
    blocks: Reused<LineBlock>,
    len: usize,
    /// Σ of the generators' lengths.
    pub(crate) length: f64,
}

impl RoundedLines {
    /// No lines, with room for so many.
    fn with_capacity(len: usize) -> Self {
        Self { blocks: Reused::with_capacity(len.div_ceil(LANES)), len: 0, length: 0.0 }
    }

    /// Lets someone write as many blocks as so many lines take, and return the sum of their lengths; the lines that
    /// fill up the last block are overwritten.
    fn rewrite(&mut self, len: usize, write: impl FnOnce(&mut [LineBlock]) -> f64) {
        self.blocks.resize(len.div_ceil(LANES), LineBlock([[0.0; LANES]; 4]));
        self.length = write(&mut self.blocks);
        self.len = len;
        for row in len..LANES * self.blocks.len() {
            let LineBlock(columns) = &mut self.blocks[row / LANES];
            for (column, c) in columns.iter_mut().zip(NO_LINE) {
                column[slot(row) % LANES] = c;
            }
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// The lines eight by eight; those that fill up the last block have no normal.
    pub(crate) fn blocks(&self) -> &[LineBlock] {
        &self.blocks
    }

    /// A line: a, b, c and the inverse length of its generator.
    #[inline(always)]
    pub(crate) fn line(&self, row: usize) -> [f64; 4] {
        self.blocks[row / LANES].0.map(|column| column[slot(row) % LANES])
    }

    /// The lines in their order.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl Iterator<Item = [f64; 4]> {
        (0..self.len).map(|row| self.line(row))
    }

    /// The slope of linear · x + Σ |a x + b y + c| at a point along a direction, where each line has the sign of its
    /// value at the point. A line has no slope along itself.
    pub(crate) fn slope(&self, linear: [f64; 2], point: [f64; 2], direction: [f64; 2]) -> f64 {
        let sum = dispatch!(level(), simd => slope(simd, &self.blocks, point, direction));
        linear[0] * direction[0] + linear[1] * direction[1] + sum
    }

    /// [`slope`](Self::slope), and the place along the direction at which the line of each slot is crossed: negative
    /// zero where the point is on the line and the sign is already that behind it, not finite where the line is never
    /// crossed.
    #[inline(always)]
    pub(crate) fn slope_and_crossings<S: Simd>(
        &self,
        simd: S,
        linear: [f64; 2],
        [x, y]: [f64; 2],
        [dx, dy]: [f64; 2],
        places: &mut [f64],
    ) -> f64 {
        let mut sum = f64x8::splat(simd, 0.0);
        for (block, place) in self.blocks.iter().zip(places.as_chunks_mut::<LANES>().0) {
            let [a, b, c, _] = load(simd, block);
            let value = a * x + b * y + c;
            let rate = a * dx + b * dy;
            sum += turned(simd, rate, value);
            (-value / rate).store_slice(place);
        }
        linear[0] * dx + linear[1] * dy + total(sum)
    }

    /// linear · x + Σ |a x + b y + c|.
    pub(crate) fn value(&self, linear: [f64; 2], [x, y]: [f64; 2]) -> f64 {
        let own: f64 = self.iter().map(|[a, b, c, _]| (a * x + b * y + c).abs()).sum();
        linear[0] * x + linear[1] * y + own
    }

    /// The gradient of Σ |a x + b y + c| at a point.
    pub(crate) fn gradient(&self, point: [f64; 2]) -> [f64; 2] {
        [[1.0, 0.0], [0.0, 1.0]].map(|direction| self.slope([0.0; 2], point, direction))
    }

    /// The piece of Σ |a x + b y + c| at a point (x, y, 1), or far out in a direction (x, y, 0).
    pub(crate) fn piece(&self, place: [f64; 3]) -> Plane {
        let whole = self.len / LANES;
        let [mut a, mut b, mut c] = dispatch!(level(), simd => piece(simd, &self.blocks[..whole], place));
        for row in LANES * whole..self.len {
            let [p, q, r, _] = self.line(row);
            let sign = f64::copysign(1.0, p * place[0] + q * place[1] + r * place[2]);
            (a, b, c) = (a + sign * p, b + sign * q, c + sign * r);
        }
        Plane::of([a, b, c])
    }

    /// A part that stands for all lines: eight lines in every `8 share`.
    pub(crate) fn part(&self, share: usize) -> Self {
        let blocks: Reused<LineBlock> = self.blocks[..self.len / LANES].iter().step_by(share).copied().collect();
        Self { len: LANES * blocks.len(), blocks, length: self.length / share as f64 }
    }

    /// Some of the lines, by their rows.
    pub(crate) fn picked(&self, rows: &[usize]) -> Self {
        let mut lines = Self::with_capacity(rows.len());
        lines.rewrite(rows.len(), |blocks| {
            let mut length = 0.0;
            for (place, &row) in rows.iter().enumerate() {
                let line = self.line(row);
                for (column, c) in blocks[place / LANES].0.iter_mut().zip(line) {
                    column[slot(place) % LANES] = c;
                }
                length += 1.0 / line[3];
            }
            length
        });
        lines
    }

    /// The lines with a width for each in the place of its generator's length: a line is in a band of 1 where its
    /// product with a point is below its width.
    pub(crate) fn with_widths(mut self, widths: &[f64]) -> Self {
        for (row, width) in widths.iter().enumerate().take(self.len) {
            self.blocks[row / LANES].0[3][slot(row) % LANES] = 1.0 / width;
        }
        self
    }

    /// The meeting point of two lines.
    pub(crate) fn meet(&self, i: usize, j: usize) -> [f64; 2] {
        let ([a, b, c, _], [d, e, f, _]) = (self.line(i), self.line(j));
        let determinant = a * e - b * d;
        [(b * f - c * e) / determinant, (c * d - a * f) / determinant]
    }
}

/// Eight lines in vectors of lanes.
#[inline(always)]
pub(crate) fn load<S: Simd>(simd: S, LineBlock([a, b, c, w]): &LineBlock) -> [f64x8<S>; 4] {
    [f64x8::from_slice(simd, a), f64x8::from_slice(simd, b), f64x8::from_slice(simd, c), f64x8::from_slice(simd, w)]
}

#[inline(always)]
fn slope<S: Simd>(simd: S, blocks: &[LineBlock], [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    let mut sum = f64x8::splat(simd, 0.0);
    for block in blocks {
        let [a, b, c, _] = load(simd, block);
        let value = a * x + b * y + c;
        sum += turned(simd, a * dx + b * dy, value);
    }
    total(sum)
}

#[inline(always)]
fn piece<S: Simd>(simd: S, blocks: &[LineBlock], [x, y, w]: [f64; 3]) -> [f64; 3] {
    let mut sums = [f64x8::splat(simd, 0.0); 3];
    for block in blocks {
        let [a, b, c, _] = load(simd, block);
        let value = a * x + b * y + c * w;
        for (sum, part) in sums.iter_mut().zip([a, b, c]) {
            *sum += turned(simd, part, value);
        }
    }
    sums.map(total)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_block_is_filled_up_with_lines_that_count_for_nothing() {
        let columns = [[1.0, 0.0, -1.0, 1.0], [0.0, 1.0, -2.0, 1.0], [1.0, 1.0, 0.0, 0.5]];
        let mut block = LineBlock([[7.0; LANES]; 4]);
        for (row, line) in columns.iter().enumerate() {
            for (column, c) in block.0.iter_mut().zip(line) {
                column[slot(row)] = *c;
            }
        }
        let mut lines = RoundedLines::with_capacity(3);
        lines.rewrite(3, |blocks| {
            blocks[0] = block;
            4.0
        });
        assert_eq!((lines.len(), lines.blocks().len(), lines.length), (3, 1, 4.0));
        assert_eq!(lines.iter().collect::<Vec<_>>(), columns);
        assert_eq!([0, 1, 2].map(|i| lines.line(i)), columns);
        // x = 1 and y = 2; y = 2 and x + y = 0
        assert_eq!(lines.meet(0, 1), [1.0, 2.0]);
        assert_eq!(lines.meet(1, 2), [-2.0, 2.0]);
        // |x − 1| + |y − 2| + |x + y| at (0, 1): the slopes are −1 and 1, and −1 and 1
        assert_eq!(lines.gradient([0.0, 1.0]), [0.0, 0.0]);
        assert_eq!(lines.value([0.0; 2], [0.0, 1.0]), 3.0);
    }
}
