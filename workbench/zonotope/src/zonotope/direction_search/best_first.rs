//! Branch and bound over cells of directions, the cell of the least bound first.
//!
//! The function's values are told from above at directions that it proposes, and from below on cells. The cell of the
//! least lower bound is divided into quarters, until no cell can hold a value that is much less than the best one
//! known. A cell may be settled: its own bound is all that there is to know about it.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use super::cell::Cell;

/// A function of directions that does not change when a direction is multiplied by a positive number.
pub(crate) trait DirectionFunction {
    /// What is known of a cell and handed down to its quarters.
    type Known;

    /// What is known before any cell is looked at.
    fn everywhere(&self) -> Self::Known;

    /// Looks at a cell, of which `known` holds; `upper` is the least value found so far.
    fn look_at(&self, cell: &Cell, known: &Self::Known, upper: f64) -> Look<Self::Known>;
}

/// What a look at a cell finds.
#[derive(Debug)]
pub(crate) struct Look<Known> {
    /// If the least value of the function is taken in the cell, it is not below this, which is not NaN.
    pub(crate) lower: f64,
    /// A direction, of the cell or not, with a value that it certainly does not exceed.
    pub(crate) found: Option<([f64; 3], f64)>,
    /// What the quarters inherit; `None` if they are not worth a look.
    pub(crate) known: Option<Known>,
}

/// The least value of a function, from both sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bracket {
    /// No direction has a value below this.
    pub(crate) lower: f64,
    /// The value at `direction` is at most this.
    pub(crate) upper: f64,
    /// The direction of the least value that was found.
    pub(crate) direction: [f64; 3],
}

impl Bracket {
    /// Whether the bounds differ by at most so much of the upper one.
    pub(crate) fn is_within(&self, relative: f64) -> bool {
        self.upper - self.lower <= relative * self.upper
    }
}

/// An open cell.
struct Open<Known> {
    lower: f64,
    /// Which look found it, so that the order does not depend on the heap.
    number: u32,
    cell: Cell,
    known: Known,
}

impl<Known> Open<Known> {
    fn compare(&self, other: &Self) -> Ordering {
        self.lower.total_cmp(&other.lower).then(self.number.cmp(&other.number))
    }
}

impl<Known> PartialEq for Open<Known> {
    fn eq(&self, other: &Self) -> bool {
        self.compare(other).is_eq()
    }
}

impl<Known> Eq for Open<Known> {}

impl<Known> PartialOrd for Open<Known> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<Known> Ord for Open<Known> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.compare(other)
    }
}

/// Brackets the least value of a function that is not negative, until the bounds differ by at most `relative` of the
/// upper one, no cell can be divided or `most_cells` were looked at. Also returns how many were.
pub(crate) fn least_value<F: DirectionFunction>(function: &F, relative: f64, most_cells: u32) -> (Bracket, u32) {
    let everywhere = function.everywhere();
    let mut search = Search {
        open: BinaryHeap::new(),
        settled: f64::INFINITY,
        upper: f64::INFINITY,
        direction: [1.0, 0.0, 0.0],
        looks: 0,
    };
    for side in Cell::sides() {
        search.look_at(function, &side, &everywhere);
    }
    loop {
        let bracket = search.bracket();
        if bracket.is_within(relative) || search.looks >= most_cells {
            return (bracket, search.looks);
        }
        let Some(Reverse(next)) = search.open.pop() else { return (bracket, search.looks) };
        match next.cell.quarters() {
            Some(quarters) => {
                quarters.iter().for_each(|quarter| search.look_at(function, quarter, &next.known));
            }
            None => search.settled = search.settled.min(next.lower),
        }
    }
}

struct Search<Known> {
    open: BinaryHeap<Reverse<Open<Known>>>,
    /// The least bound of a cell that is not divided.
    settled: f64,
    upper: f64,
    direction: [f64; 3],
    looks: u32,
}

impl<Known> Search<Known> {
    fn look_at<F: DirectionFunction<Known = Known>>(&mut self, function: &F, cell: &Cell, known: &Known) {
        let look = function.look_at(cell, known, self.upper);
        if let Some((direction, value)) = look.found.filter(|(_, value)| *value < self.upper) {
            (self.upper, self.direction) = (value, direction);
        }
        match look.known {
            Some(known) if look.lower < self.upper => {
                let open = Open { lower: look.lower, number: self.looks, cell: *cell, known };
                self.open.push(Reverse(open));
            }
            _ => self.settled = self.settled.min(look.lower),
        }
        self.looks += 1;
    }

    fn bracket(&self) -> Bracket {
        let open = self.open.peek().map_or(f64::INFINITY, |Reverse(open)| open.lower);
        let lower = open.min(self.settled).min(self.upper);
        Bracket { lower, upper: self.upper, direction: self.direction }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::linear::{dot, euclidean_norm};

    /// The support function of the box with half-lengths 3, 2, 1 around the origin, minus that of a point.
    struct BoxDepth([f64; 3]);

    impl BoxDepth {
        fn at(&self, u: [f64; 3]) -> f64 {
            (3.0 * u[0].abs() + 2.0 * u[1].abs() + u[2].abs() - dot(&u, &self.0)) / euclidean_norm(&u)
        }
    }

    impl DirectionFunction for BoxDepth {
        type Known = ();

        fn everywhere(&self) {}

        fn look_at(&self, cell: &Cell, (): &(), _: f64) -> Look<()> {
            let center = cell.center();
            // the corner of the box that is extreme in the middle
            let corner = [3.0, 2.0, 1.0].into_iter().zip(center).map(|(half, c)| f64::copysign(half, c));
            let off: Vec<f64> = corner.zip(self.0).map(|(c, p)| c - p).collect();
            let bound = |u: &[f64; 3]| dot(u, &[off[0], off[1], off[2]]) / euclidean_norm(u);
            let lower = cell.corners().iter().map(bound).fold(f64::INFINITY, f64::min).max(0.0);
            Look { lower, found: Some((center, self.at(center))), known: Some(()) }
        }
    }

    #[test]
    fn the_depth_of_a_point_in_a_box() {
        // nearest to the side z = 1
        let (bracket, looks) = least_value(&BoxDepth([1.0, 0.5, 0.25]), 1e-3, 10_000);
        assert!(bracket.lower <= 0.75 && 0.75 <= bracket.upper && bracket.is_within(1e-3), "{bracket:?}");
        assert!(bracket.direction[2] == 1.0 && looks < 10_000, "{bracket:?} after {looks}");
        // 2.5 from the sides y = −2 and y = 2 - nearest to x = 3
        let (bracket, _) = least_value(&BoxDepth([2.9375, 0.0, 0.0]), 1e-2, 10_000);
        assert!(bracket.lower <= 0.0625 && 0.0625 <= bracket.upper && bracket.is_within(1e-2), "{bracket:?}");
    }
}
