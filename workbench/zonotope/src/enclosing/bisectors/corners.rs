//! A signed sum of edges of a polygon as a sum of few vertices.
//!
//! Where edges of one sign follow each other, their sum is the difference of the last end and the first one. So the sum
//! of all edges is empty, and that of nearly all of them, with the same sign, has as few terms as edges are missing.

use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::ExactSum;

/// The vertices between edges of different signs, each with its factor in the sum: the sign of the edge that ends there
/// less that of the edge that starts there.
#[derive(Debug)]
pub(super) struct Corners(Vec<(u32, f64)>);

/// At most this many coordinates are added up one by one: an accumulator for all exponents costs more to set up.
const ONE_BY_ONE_LIMIT: usize = 24;

/// The number of signs that are compared at once.
const BLOCK: usize = 64;

impl Corners {
    /// The corners of the sum of all edges of a polygon, each with its sign; edge t starts at vertex t.
    pub(super) fn of(signs: &[i8]) -> Self {
        let mut corners = Vec::new();
        let mut before = signs.last().copied().unwrap_or(0);
        for (block, signs) in signs.chunks(BLOCK).enumerate() {
            if signs.iter().all(|sign| *sign == before) {
                continue;
            }
            for (vertex, &sign) in (block * BLOCK..).zip(signs) {
                if sign != before {
                    corners.push((vertex as u32, f64::from(before) - f64::from(sign)));
                    before = sign;
                }
            }
        }
        Self(corners)
    }

    /// Whether the sum is a multiple of one edge of a polygon with so many edges: it has the direction of that edge, or
    /// it is zero.
    pub(super) fn are_ends_of(&self, edge: usize, count: usize) -> bool {
        let next = if edge + 1 < count { edge + 1 } else { 0 };
        let is_end = |vertex: u32| [edge, next].contains(&(vertex as usize));
        self.0.iter().all(|&(vertex, _)| is_end(vertex))
    }

    /// The sum by pairs of doubles; `None` where `vertex`, the position of a vertex, is so.
    pub(super) fn sum(&self, vertex: impl Fn(usize) -> Option<[f64; 2]>) -> Option<[BoundedDoubleDouble; 2]> {
        self.0.iter().try_fold([BoundedDoubleDouble::exact(0.0); 2], |sum, &(at, factor)| {
            let point = vertex(at as usize)?;
            Some([0, 1].map(|axis| sum[axis] + BoundedDoubleDouble::exact(factor * point[axis])))
        })
    }

    /// The sum, exactly, for the vertices of the polygon.
    pub(super) fn exact_sum(&self, vertices: &[[f64; 2]]) -> [Dyadic; 2] {
        [0, 1].map(|axis| {
            let exact =
                |&(at, factor): &(u32, f64)| Dyadic::from_f64(factor) * Dyadic::from_f64(vertices[at as usize][axis]);
            if self.0.len() <= ONE_BY_ONE_LIMIT {
                return self.0.iter().map(exact).fold(Dyadic::zero(), |sum, c| sum + c);
            }
            let mut sum = ExactSum::default();
            for &(at, factor) in &self.0 {
                // twice the largest double is none, so a factor of 2 is two terms
                let half = vertices[at as usize][axis] * factor.signum();
                (0..factor.abs() as u32).for_each(|_| sum.add(half));
            }
            sum.value()
        })
    }
}
