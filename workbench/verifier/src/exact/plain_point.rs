//! Points of the plane as doubles, and the side of a line on which one lies: in floating point where its error leaves
//! no doubt, else on the grid.

use std::cmp::Ordering;

use super::grid::Grid;
use super::polygon::Corner;

/// The error of a cross product of two differences of doubles, relative to the sum of the magnitudes of its two
/// products: each difference, each product and the last difference are rounded once, and so is that sum.
const CROSS_ERROR: f64 = 2.0 * f64::EPSILON;

/// More than two products lose that are rounded below the normal doubles.
const CROSS_UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// A finite point, its zeros without a sign.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlainPoint([f64; 2]);

impl PlainPoint {
    /// The point, whose coordinates are finite.
    pub(crate) fn new(point: [f64; 2]) -> Self {
        Self(point.map(|coordinate| coordinate + 0.0))
    }
}

impl Ord for PlainPoint {
    fn cmp(&self, other: &Self) -> Ordering {
        let [first, second] = [0, 1].map(|axis: usize| self.0[axis].total_cmp(&other.0[axis]));
        first.then(second)
    }
}

impl PartialOrd for PlainPoint {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for PlainPoint {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for PlainPoint {}

impl Corner for PlainPoint {
    fn side(a: &Self, b: &Self, p: &Self) -> Ordering {
        let ([ax, ay], [bx, by], [px, py]) = (a.0, b.0, p.0);
        let (left, right) = ((ax - px) * (by - py), (ay - py) * (bx - px));
        let doubt = (left.abs() + right.abs()) * CROSS_ERROR + CROSS_UNDERFLOW;
        let turn = left - right;
        // The doubt leaves the range of doubles where a product does, or nothing compares.
        if turn > doubt && doubt.is_finite() {
            return Ordering::Greater;
        }
        if turn < -doubt && doubt.is_finite() {
            return Ordering::Less;
        }
        let grid = Grid::of([ax, ay, bx, by, px, py]);
        Corner::side(&grid.point(a.0), &grid.point(b.0), &grid.point(p.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_are_exact() {
        let side = |a, b, p| PlainPoint::side(&PlainPoint::new(a), &PlainPoint::new(b), &PlainPoint::new(p));
        assert_eq!(side([0.0, 0.0], [1.0, 0.0], [0.5, 0.25]), Ordering::Greater);
        assert_eq!(side([0.0, 0.0], [1.0, 0.0], [0.5, -0.25]), Ordering::Less);
        assert_eq!(side([0.1, 0.1], [0.3, 0.3], [0.7, 0.7]), Ordering::Equal);
        assert_eq!(side([0.1, 0.1], [0.3, 0.3], [0.7, 0.7_f64.next_up()]), Ordering::Greater);
        let tiny = f64::from_bits(1);
        assert_eq!(side([0.0, 0.0], [tiny, 0.0], [0.0, tiny]), Ordering::Greater);
        assert_eq!(side([-f64::MAX, 0.0], [f64::MAX, 0.0], [0.0, -f64::MAX]), Ordering::Less);
    }

    /// Points around the diagonal, a few units in the last place beside it: most turns are rounded to a wrong sign.
    #[test]
    fn sides_of_points_beside_a_line_are_those_of_whole_numbers() {
        let line = [[12.0, 12.0], [24.0, 24.0]];
        let mut wrong = 0;
        for (i, j) in (0..64_u64).flat_map(|i| (0..64_u64).map(move |j| (i, j))) {
            let p = [i, j].map(|steps| f64::from_bits(0.5_f64.to_bits() + steps));
            let grid = Grid::of([line[0], line[1], p].concat());
            let exact = Corner::side(&grid.point(line[0]), &grid.point(line[1]), &grid.point(p));
            let [a, b, p] = [line[0], line[1], p].map(PlainPoint::new);
            assert_eq!(PlainPoint::side(&a, &b, &p), exact, "{i} {j}");
            let turn = (line[0][0] - p.0[0]) * (line[1][1] - p.0[1]) - (line[0][1] - p.0[1]) * (line[1][0] - p.0[0]);
            wrong += usize::from(turn.partial_cmp(&0.0) != Some(exact));
        }
        assert!(wrong > 100, "{wrong}");
    }

    #[test]
    fn points_are_equal_where_their_coordinates_are() {
        let p = PlainPoint::new([1.0, -0.0]);
        assert_eq!(p, PlainPoint::new([1.0, 0.0]));
        assert_ne!(p, PlainPoint::new([1.0, f64::from_bits(1)]));
        assert_ne!(p, PlainPoint::new([1.0_f64.next_up(), 0.0]));
    }

    /// The line from (12, 12) to (24, 24) and points a few units in the last place beside the diagonal, at 2^-40 and
    /// 2^40 times this size: products of small numbers are smaller than their sum.
    #[test]
    fn sides_do_not_depend_on_the_size_of_the_picture() {
        for size in [2.0_f64.powi(-40), 1.0, 2.0_f64.powi(40)] {
            for (i, j) in (0..64_u64).flat_map(|i| (0..64_u64).map(move |j| (i, j))) {
                let p = [i, j].map(|steps| f64::from_bits(0.5_f64.to_bits() + steps) * size);
                let [a, b, p] = [[12.0 * size; 2], [24.0 * size; 2], p].map(PlainPoint::new);
                // the point lies on the left of the diagonal where its ordinate is the larger coordinate
                assert_eq!(PlainPoint::side(&a, &b, &p), j.cmp(&i), "{size} {i} {j}");
            }
        }
    }
}
