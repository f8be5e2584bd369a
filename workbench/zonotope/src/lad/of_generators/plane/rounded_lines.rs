//! Lines in the plane { u : u · p = 1 } in doubles, two side by side: the input of every guess.

use wide::f64x2;

/// Two lines a x + b y + c side by side, with the inverse lengths of their generators.
pub(crate) type Pair = [f64x2; 4];

/// The partner of the last line where the number of lines is odd: a line without normal that is far from every point.
const NO_LINE: [f64; 4] = [0.0, 0.0, 1.0, f64::MAX];

/// The lines of generators.
#[derive(Debug, Default)]
pub(crate) struct RoundedLines {
    pairs: Vec<Pair>,
    len: usize,
    /// Σ of the generators' lengths.
    pub(crate) length: f64,
}

impl RoundedLines {
    /// Room for some lines.
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        Self { pairs: Vec::with_capacity(capacity.div_ceil(2)), len: 0, length: 0.0 }
    }

    /// Adds two lines, given the sum of their generators' lengths; the number of lines before is even.
    #[inline(always)]
    pub(crate) fn push_pair(&mut self, pair: Pair, lengths: f64x2) {
        self.pairs.push(pair);
        self.len += 2;
        self.length += lengths.reduce_add();
    }

    /// Adds the last line; the number of lines before is even.
    pub(crate) fn push_last(&mut self, [a, b, c, weight]: [f64; 4], length: f64) {
        let [first, second, third, fourth] = NO_LINE;
        self.pairs.push([[a, first], [b, second], [c, third], [weight, fourth]].map(f64x2::new));
        self.len += 1;
        self.length += length;
    }

    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// The lines two by two; beside the last one of an odd number there is one that has no normal.
    pub(crate) fn pairs(&self) -> &[Pair] {
        &self.pairs
    }

    /// A line: a, b, c and the inverse length of its generator.
    #[inline(always)]
    pub(crate) fn line(&self, i: usize) -> [f64; 4] {
        self.pairs[i / 2].map(|column| column.to_array()[i % 2])
    }

    /// The lines in their order.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl Iterator<Item = [f64; 4]> {
        let both = self.pairs.iter().flat_map(|pair| [0, 1].map(|lane| pair.map(|column| column.to_array()[lane])));
        both.take(self.len)
    }

    /// The slope of linear · x + Σ |a x + b y + c| at a point along a direction, where each line has the sign of its
    /// value at the point. A line has no slope along itself.
    pub(crate) fn slope(&self, linear: [f64; 2], [x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
        let [wide_x, wide_y, wide_dx, wide_dy] = [x, y, dx, dy].map(f64x2::splat);
        let mut sum = f64x2::default();
        for [a, b, c, _] in &self.pairs {
            let value = *a * wide_x + *b * wide_y + *c;
            sum += (*a * wide_dx + *b * wide_dy) ^ (value & f64x2::splat(-0.0));
        }
        linear[0] * dx + linear[1] * dy + sum.reduce_add()
    }

    /// [`slope`](Self::slope), and the place along the direction at which each line is crossed: negative zero where
    /// the point is on the line and the sign is already that behind it, not finite where the line is never crossed.
    pub(crate) fn slope_and_crossings(
        &self,
        linear: [f64; 2],
        [x, y]: [f64; 2],
        [dx, dy]: [f64; 2],
        places: &mut Vec<f64>,
    ) -> f64 {
        let [wide_x, wide_y, wide_dx, wide_dy] = [x, y, dx, dy].map(f64x2::splat);
        let mut sum = f64x2::default();
        places.resize(2 * self.pairs.len(), 0.0);
        for ([a, b, c, _], place) in self.pairs.iter().zip(places.as_chunks_mut::<2>().0) {
            let value = *a * wide_x + *b * wide_y + *c;
            let rate = *a * wide_dx + *b * wide_dy;
            sum += rate ^ (value & f64x2::splat(-0.0));
            *place = (-value / rate).to_array();
        }
        linear[0] * dx + linear[1] * dy + sum.reduce_add()
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

    /// A part that stands for all lines: two lines in every `2 share`.
    pub(crate) fn part(&self, share: usize) -> Self {
        let pairs: Vec<Pair> = self.pairs[..self.len / 2].iter().step_by(share).copied().collect();
        Self { len: 2 * pairs.len(), pairs, length: self.length / share as f64 }
    }

    /// Where two lines meet.
    pub(crate) fn meet(&self, i: usize, j: usize) -> [f64; 2] {
        let ([a, b, c, _], [d, e, f, _]) = (self.line(i), self.line(j));
        let determinant = a * e - b * d;
        [(b * f - c * e) / determinant, (c * d - a * f) / determinant]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_odd_number_of_lines_is_padded_by_one_that_counts_for_nothing() {
        let columns = [[1.0, 0.0, -1.0, 1.0], [0.0, 1.0, -2.0, 1.0], [1.0, 1.0, 0.0, 0.5]];
        let mut lines = RoundedLines::with_capacity(3);
        lines.push_pair([0, 1, 2, 3].map(|k| f64x2::new([columns[0][k], columns[1][k]])), f64x2::new([1.0, 1.0]));
        lines.push_last(columns[2], 2.0);
        assert_eq!((lines.len(), lines.pairs().len(), lines.length), (3, 2, 4.0));
        assert_eq!(lines.iter().collect::<Vec<_>>(), columns);
        assert_eq!([0, 1, 2].map(|i| lines.line(i)), columns);
        // x = 1 and y = 2; y = 2 and x + y = 0
        assert_eq!(lines.meet(0, 1), [1.0, 2.0]);
        assert_eq!(lines.meet(1, 2), [-2.0, 2.0]);
    }
}
