//! A grid of directions: the faces x = 1, y = 1 and z = 1 of the cube [−1, 1]³ in squares, which are halved along both
//! sides again and again.
//!
//! A generator v ≠ 0, turned such that its largest coordinate is positive, leaves the cube through a cell of such a
//! face. The cells of one depth are the unions of four cells of the next one, and the corners of one depth are corners
//! of the next one as well. A corner stands for a line through the origin, so that corners on the edges and vertices of
//! the cube belong to several faces; each has one name.

use crate::zonotope::directions::cube_faces::{cell_at, face_of, place_on};

/// The finest depth: a corner's coordinates have at most so many bits and one more.
pub(super) const FINEST_DEPTH: u32 = 20;

/// A cell: its face, and its column and row bit by bit in turns, so that the cell of the depth above is what is left
/// without the last two bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Cell(u64);

/// A corner of cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Corner {
    face: usize,
    place: [u32; 2],
}

/// The cell of the finest depth that a vector, turned to the side of the face, leaves the cube through; none for the
/// zero vector.
pub(super) fn finest_cell(v: &[f64; 3]) -> Option<Cell> {
    let face = face_of(v)?;
    let cells = 1u32 << FINEST_DEPTH;
    let [column, row] = place_on(face, v).map(|c| cell_at(c, cells));
    let key = (face as u64) << (2 * FINEST_DEPTH) | spread(column) << 1 | spread(row);
    Some(Cell(key))
}

impl Cell {
    /// The cell of a lesser depth that holds this one of the finest.
    pub(super) fn at_depth(self, depth: u32) -> Self {
        Self(self.0 >> (2 * (FINEST_DEPTH - depth)))
    }

    /// The cell of the depth above.
    pub(super) fn parent(self) -> Self {
        Self(self.0 >> 2)
    }

    /// The least depth at which two different cells of the finest depth are in different ones.
    pub(super) fn parting_depth(self, other: Self) -> u32 {
        let bits = u64::BITS - (self.0 ^ other.0).leading_zeros();
        (FINEST_DEPTH + 1).saturating_sub(bits.div_ceil(2))
    }

    /// The axis of the face.
    pub(super) fn face(self, depth: u32) -> usize {
        (self.0 >> (2 * depth)) as usize
    }

    /// Column and row.
    pub(super) fn place(self, depth: u32) -> [u32; 2] {
        let within = self.0 & ((1 << (2 * depth)) - 1);
        [gathered(within >> 1), gathered(within)]
    }

    /// The corners at (0, 0), (1, 0), (0, 1) and (1, 1) of the cell.
    pub(super) fn corners(self, depth: u32) -> [Corner; 4] {
        let (face, [column, row]) = (self.face(depth), self.place(depth));
        [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| Corner::named(face, [column + i, row + j], depth))
    }
}

impl Corner {
    /// The corner on the axis of a face, of which there is one from depth 1 on.
    pub(super) fn on_axis(face: usize, depth: u32) -> Self {
        Self { face, place: [1 << (depth - 1); 2] }
    }

    /// The name of a corner: by the first of its faces, on the side where that coordinate is positive.
    fn named(face: usize, place: [u32; 2], depth: u32) -> Self {
        let size = 1i64 << depth;
        let mut vector = [size; 3];
        for k in 0..2 {
            vector[(face + 1 + k) % 3] = 2 * i64::from(place[k]) - size;
        }
        let first = vector.iter().position(|c| c.abs() == size).unwrap_or(face);
        let turn = vector[first].signum();
        let place = [1, 2].map(|k| ((turn * vector[(first + k) % 3] + size) / 2) as u32);
        Self { face: first, place }
    }

    /// The direction of the corner, its largest coordinate 1; exact, every coordinate a multiple of 2^(1 − depth).
    pub(super) fn direction(self, depth: u32) -> [f64; 3] {
        let mut direction = [1.0; 3];
        for k in 0..2 {
            direction[(self.face + 1 + k) % 3] = f64::from(self.place[k]) * width(depth) - 1.0;
        }
        direction
    }

    /// The corners of the depth above of which this one is the middle; the same twice where it is one of that depth.
    ///
    /// The cells' diagonals from (0, 0) to (1, 1) divide them into triangles, and those of one depth are unions of
    /// those of the next: so a corner is the middle of an edge of triangles.
    pub(super) fn ends(self, depth: u32) -> [Self; 2] {
        let [low, high] = [0, 1].map(|up| self.place.map(|c| (c + up) / 2));
        [low, high].map(|place| Self::named(self.face, place, depth - 1))
    }
}

/// The side of a cell on a face.
pub(super) fn width(depth: u32) -> f64 {
    2.0 / f64::from(1u32 << depth)
}

/// The bits of a number at every other place: halves move apart, then their halves, and so on.
fn spread(number: u32) -> u64 {
    const MASKS: [(u32, u64); 5] = [
        (16, 0x0000_ffff_0000_ffff),
        (8, 0x00ff_00ff_00ff_00ff),
        (4, 0x0f0f_0f0f_0f0f_0f0f),
        (2, 0x3333_3333_3333_3333),
        (1, 0x5555_5555_5555_5555),
    ];
    MASKS.iter().fold(u64::from(number), |bits, (shift, mask)| (bits | bits << shift) & mask)
}

/// The number of the bits at every other place, by the same steps backwards.
fn gathered(bits: u64) -> u32 {
    const MASKS: [(u32, u64); 5] = [
        (1, 0x3333_3333_3333_3333),
        (2, 0x0f0f_0f0f_0f0f_0f0f),
        (4, 0x00ff_00ff_00ff_00ff),
        (8, 0x0000_ffff_0000_ffff),
        (16, 0x0000_0000_ffff_ffff),
    ];
    let bits = bits & 0x5555_5555_5555_5555;
    MASKS.iter().fold(bits, |bits, (shift, mask)| (bits | bits >> shift) & mask) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn all_corners(depth: u32) -> BTreeSet<Corner> {
        let cells = (0..3u64 << (2 * depth)).map(Cell);
        cells.flat_map(|cell| cell.corners(depth)).collect()
    }

    #[test]
    fn a_corner_has_one_name() {
        // 6 m² + 2 corners of the cube's squares are half as many lines
        for depth in 0..4 {
            let corners = all_corners(depth);
            assert_eq!(corners.len(), 3 * (1 << (2 * depth)) + 1);
            let lines: BTreeSet<[u64; 3]> = corners.iter().map(|c| c.direction(depth).map(f64::to_bits)).collect();
            assert_eq!(lines.len(), corners.len());
        }
        assert_eq!(Corner::on_axis(1, 2).direction(2), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn a_corner_is_the_middle_of_its_ends_but_for_a_sign() {
        for depth in 1..4 {
            let above = all_corners(depth - 1);
            for corner in all_corners(depth) {
                let ends = corner.ends(depth);
                assert!(ends.iter().all(|end| above.contains(end)), "{corner:?}");
                let [a, b] = ends.map(|end| end.direction(depth - 1));
                let own = corner.direction(depth);
                let is_middle = [1.0, -1.0].iter().any(|first| {
                    [1.0, -1.0].iter().any(|second| (0..3).all(|k| first * a[k] + second * b[k] == 2.0 * own[k]))
                });
                assert!(is_middle, "{own:?} of {a:?} and {b:?}");
            }
        }
    }

    #[test]
    fn cells_hold_the_vectors_that_leave_through_them() {
        let vectors = [[1.0, 0.25, -0.5], [-3.0, 2.0, 2.9], [1.0, 1.0, 1.0], [0.1, -0.9, 0.9], [0.0, 0.0, -5e-324]];
        for v in vectors {
            let finest = finest_cell(&v).expect("not zero");
            for depth in 0..=FINEST_DEPTH {
                let cell = finest.at_depth(depth);
                let face = cell.face(depth);
                assert!(v.iter().all(|c| c.abs() <= v[face].abs()));
                let [s, t] = [1, 2].map(|k| v[(face + k) % 3] / v[face]);
                let low = cell.place(depth).map(|c| f64::from(c) * width(depth) - 1.0);
                assert!((low[0]..=low[0] + width(depth)).contains(&s) && (low[1]..=low[1] + width(depth)).contains(&t));
            }
        }
        assert!(finest_cell(&[0.0; 3]).is_none());
        let [a, b] = [[1.0, 0.25, -0.5], [1.0, 0.25, 0.5]].map(|v| finest_cell(&v).expect("not zero"));
        assert!(a.parting_depth(b) == 1 && a.at_depth(1) != b.at_depth(1) && a.at_depth(1).parent() == b.at_depth(0));
        let other = finest_cell(&[0.25, 1.0, 0.5]).expect("not zero");
        assert_eq!(a.parting_depth(other), 0);
        let next = finest_cell(&[1.0, 0.25, -0.5 + 2f64.powi(-19)]).expect("not zero");
        assert_eq!(a.parting_depth(next), FINEST_DEPTH);
    }
}
