//! For each column a span of ordinates that is certainly inside a convex polygon, and the points outside of these
//! spans.

use super::bounds::Bounds;
use super::columns::Columns;
use crate::hull::polygon::ConvexHull;
use crate::numeric::tolerance::UNIT;

/// Spans of ordinates inside a convex polygon whose vertices are in the box.
pub(super) struct Interior<const COLUMNS: usize> {
    columns: Columns,
    /// For each column `[low, high]`: a point (x, y) with x in the column and low < y < high is strictly inside the
    /// polygon.
    spans: Box<[[f64; 2]; COLUMNS]>,
}

/// No ordinate is within it.
const NO_SPAN: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

impl<const COLUMNS: usize> Interior<COLUMNS> {
    /// `None` if the polygon has no area or the box is so narrow that rounding mixes up the columns.
    ///
    /// Abscissas of column j lie strictly between the middles of columns j − 1 and j + 1: those belong to other
    /// columns, which is checked, and look-up is monotone. Between the two, the lower chain of the polygon is not above
    /// its value at one of them, since it is convex, and the upper chain not below.
    ///
    /// A chain's height over a middle is computed with relative error at most 2u for each of x − x_1 and x_2 − x_1, and
    /// with the division, y_2 − y_1 and the product at most 5.1u of |y_2 − y_1| ≤ 2Y, where Y is the largest |y|; the
    /// last sum and that with the margin add at most 1.1u·Y each: together less than 16u·Y, and less than 2^-1022 for
    /// underflow. The margin is twice that.
    pub(super) fn new(polygon: &ConvexHull, columns: Columns, bounds: &Bounds) -> Option<Self> {
        if !polygon.has_area() || (0..COLUMNS).any(|column| columns.of(columns.middle(column)) != column) {
            return None;
        }
        let vertices = polygon.vertices();
        let last = (1..vertices.len()).take_while(|&at| vertices[at - 1] < vertices[at]).count();
        let mut lower = Chain::new(vertices[..=last].iter());
        let mut upper = Chain::new(vertices[..1].iter().chain(vertices[last..].iter().rev()));
        let margin = 2.0 * (16.0 * UNIT * f64::max(bounds.low[1].abs(), bounds.high[1].abs()) + f64::MIN_POSITIVE);

        let mut spans = Box::new([NO_SPAN; COLUMNS]);
        let mut at_middle = [NO_SPAN; 2];
        for column in 0..COLUMNS {
            let x = columns.middle(column);
            let here = match (lower.height(x), upper.height(x)) {
                (Some(low), Some(high)) => [low + margin, high - margin],
                _ => NO_SPAN,
            };
            let [two_before, before] = at_middle;
            if column > 0 {
                spans[column - 1] = [two_before[0].max(here[0]), two_before[1].min(here[1])];
            }
            at_middle = [before, here];
        }
        Some(Interior { columns, spans })
    }

    /// The positions of the points outside of the spans, increasing.
    pub(super) fn points_outside(&self, points: &[[f64; 2]]) -> Vec<u32> {
        const BLOCK: usize = 512;
        let mut outside = Vec::new();
        let mut buffer = [0_u32; BLOCK];
        for (block, first) in points.chunks(BLOCK).zip((0..).step_by(BLOCK)) {
            let mut count = 0;
            for (&[x, y], position) in block.iter().zip(first..) {
                let [low, high] = self.spans[self.columns.of(x) % COLUMNS];
                // written always and kept or overwritten, without a branch; the remainder spares a check, as count <
                // BLOCK
                buffer[count % BLOCK] = position;
                count += usize::from(!((low < y) & (y < high)));
            }
            outside.extend_from_slice(&buffer[..count]);
        }
        outside
    }
}

/// The lower or the upper chain of a polygon, walked from left to right.
struct Chain<'a, I> {
    ahead: I,
    edge: [&'a [f64; 2]; 2],
}

impl<'a, I: Iterator<Item = &'a [f64; 2]>> Chain<'a, I> {
    fn new(mut vertices: I) -> Self {
        let from = vertices.next().unwrap_or(&[0.0; 2]);
        let to = vertices.next().unwrap_or(from);
        Chain { ahead: vertices, edge: [from, to] }
    }

    /// The height over an abscissa not less than those of earlier calls; `None` beyond the ends and on overflow.
    fn height(&mut self, x: f64) -> Option<f64> {
        while self.edge[1][0] < x {
            self.edge = [self.edge[1], self.ahead.next()?];
        }
        let [from, to] = self.edge;
        let height = from[1] + (x - from[0]) / (to[0] - from[0]) * (to[1] - from[1]);
        (from[0] <= x && height.is_finite()).then_some(height)
    }
}
