//! Bodies around a body: the generators of each cell of directions, written in terms of the cell's corners.
//!
//! A vector v in a triangle of corners a, b, c is α a + β b + γ c with coefficients that are not negative, so |v · u| ≤
//! α |a · u| + β |b · u| + γ |c · u| for every direction u: the body with the generators A a, B b, …, where A adds up
//! the coefficients of the corner a, contains the body of the v. The two sides are equal unless u is orthogonal to a
//! direction in the triangle, and then they differ by a part of the order of the triangle's width. A direction is
//! orthogonal to few of many triangles, so the error falls with the square of the width, as one over the number of
//! corners.
//!
//! A corner of one depth is the middle of an edge of the depth above, so halves of its coefficient are those of the
//! ends: each body contains the one of the next depth, and no generator is read again.

use super::grid::{Cell, Corner, width};
use crate::numeric::linear::euclidean_norm;
use crate::numeric::outward::{above, with_leading_bits_at_least};
use crate::numeric::tolerance::{CORNER_COEFFICIENTS, LONG_SUM, NEGLIGIBLE_LENGTH, PRODUCT_UNDERFLOW};

/// The bits of a corner's sum; its coordinates have at most 21, so that the products of both are doubles.
const SUM_BITS: u32 = 32;

/// The corners of one depth with the sums of their coefficients, never too small, for generators that were scaled to
/// magnitude about 1.
#[derive(Debug, Clone)]
pub(super) struct CornerSums {
    depth: u32,
    sums: Vec<(Corner, f64)>,
}

impl CornerSums {
    /// The sums of vectors in the order of their cells, of a depth from 1 on; each is turned to the face of its cell
    /// and scaled. O(n) and the sorting of corners.
    pub(super) fn new(vectors: impl Iterator<Item = (Cell, [f64; 3])>, depth: u32) -> Self {
        let mut sums: Vec<(Corner, f64)> = Vec::new();
        let (mut open, mut of_open): (Option<Cell>, [f64; 4]) = (None, [0.0; 4]);
        let (mut lengths, mut count) = (0.0, 0u64);
        let mut close = |cell: Option<Cell>, coefficients: [f64; 4]| {
            let corners = cell.into_iter().flat_map(|cell| cell.corners(depth)).zip(coefficients);
            sums.extend(corners.filter(|(_, sum)| *sum != 0.0));
        };
        for (cell, v) in vectors {
            if open != Some(cell) {
                close(open, of_open);
                (open, of_open) = (Some(cell), [0.0; 4]);
            }
            let coefficients = coefficients(&v, cell, depth);
            of_open = [0, 1, 2, 3].map(|k| above(of_open[k] + coefficients[k]));
            lengths += v[cell.face(depth)];
            count += 1;
        }
        close(open, of_open);
        // what the coefficients leave of the vectors is in a box, whose sides are corners, too
        let left = (lengths * CORNER_COEFFICIENTS + count as f64 * PRODUCT_UNDERFLOW) * LONG_SUM;
        sums.extend([0, 1, 2].map(|face| (Corner::on_axis(face, depth), left)));
        Self { depth, sums: added_up(sums) }
    }

    /// The sums of the depth above. O(k log k).
    pub(super) fn coarser(&self) -> Self {
        let halves = self.sums.iter().flat_map(|&(corner, sum)| corner.ends(self.depth).map(|end| (end, sum / 2.0)));
        Self { depth: self.depth - 1, sums: added_up(halves.collect()) }
    }

    /// The depth of the corners.
    pub(super) fn depth(&self) -> u32 {
        self.depth
    }

    /// How many corners there are.
    pub(super) fn len(&self) -> usize {
        self.sums.len()
    }

    /// The generators along the corners, times a power of two, exactly.
    pub(super) fn generators(&self, size: f64) -> Vec<[f64; 3]> {
        let generator = |&(corner, sum): &(Corner, f64)| corner.direction(self.depth).map(|c| sum * c * size);
        self.sums.iter().map(generator).collect()
    }

    /// The lengths of the generators together, rounded.
    pub(super) fn length(&self) -> f64 {
        self.sums.iter().map(|(corner, sum)| sum * euclidean_norm(&corner.direction(self.depth))).sum()
    }
}

/// The coefficients, none negative, of the corners (0, 0), (1, 0), (0, 1) and (1, 1) of a vector's cell that make up
/// the vector but for [`CORNER_COEFFICIENTS`].
fn coefficients(v: &[f64; 3], cell: Cell, depth: u32) -> [f64; 4] {
    let (face, [column, row]) = (cell.face(depth), cell.place(depth));
    let length = v[face];
    let along = |k: usize, place: u32| {
        let start = length * (f64::from(place) * width(depth) - 1.0);
        ((v[(face + k) % 3] - start) / width(depth)).clamp(0.0, length)
    };
    let (x, y) = (along(1, column), along(2, row));
    [length - x.max(y), (x - y).max(0.0), (y - x).max(0.0), x.min(y)]
}

/// The sums for each corner, never too small, and of few bits: a coarser level contains a finer one as it was rounded.
fn added_up(mut sums: Vec<(Corner, f64)>) -> Vec<(Corner, f64)> {
    sums.sort_by_key(|(corner, _)| *corner);
    let total = |of_corner: &[(Corner, f64)]| {
        let total = of_corner.iter().fold(0.0, |total, (_, sum)| above(total + sum));
        (of_corner[0].0, with_leading_bits_at_least(total.max(NEGLIGIBLE_LENGTH), SUM_BITS))
    };
    sums.chunk_by(|a, b| a.0 == b.0).map(total).collect()
}

#[cfg(test)]
mod tests {
    use super::super::grid::finest_cell;
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    properties! {
        #![proptest_config(crate::property_cases::config(256))]

        #[test]
        fn coefficients_leave_less_than_their_bound(
            v in proptest::array::uniform3(prop_oneof![-1.0..1.0f64, (-4..=4i32).prop_map(|c| f64::from(c) / 4.0)]),
            depth in 0u32..=20,
        ) {
            let Some(finest) = finest_cell(&v) else { return Ok(()) };
            let cell = finest.at_depth(depth);
            let turn = f64::copysign(1.0, v[cell.face(depth)]);
            let v = v.map(|c| turn * c);
            let (face, [column, row]) = (cell.face(depth), cell.place(depth));
            let coefficients = coefficients(&v, cell, depth);
            prop_assert!(coefficients.iter().all(|c| *c >= 0.0));
            let places = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| [column + i, row + j]);
            for k in 0..3 {
                let along = |place: u32| f64::from(place) * width(depth) - 1.0;
                let coordinate = |[i, j]: [u32; 2]| [1.0, along(i), along(j)][k];
                let made = places.iter().zip(coefficients).fold(Dyadic::zero(), |sum, (&place, c)| {
                    sum + Dyadic::from_f64(c) * Dyadic::from_f64(coordinate(place))
                });
                let left = (Dyadic::from_f64(v[(face + k) % 3]) - made).abs();
                prop_assert!(left <= Dyadic::from_f64(CORNER_COEFFICIENTS) * Dyadic::from_f64(v[face]));
            }
        }
    }

    #[test]
    fn a_diagonal_is_its_own_corner() {
        let finest = finest_cell(&[1.0, 1.0, 1.0]).expect("not zero");
        let sums = CornerSums::new([(finest.at_depth(1), [1.0; 3])].into_iter(), 1);
        // the corner, and the three axes of the box
        assert_eq!((sums.len(), sums.depth()), (4, 1));
        let generators = sums.generators(8.0);
        let longest = generators.iter().find(|g| g[0] > 7.0).expect("the diagonal");
        assert!(longest[0] >= 8.0 && longest[0] < 8.0 * (1.0 + 1e-9) && longest.iter().all(|c| *c == longest[0]));
        assert_eq!(sums.coarser().len(), 4);
    }
}
