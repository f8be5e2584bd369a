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
}
