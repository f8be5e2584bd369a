//! Points with their positions in the input, their lexicographic order, and the hull of a sorted sequence of them.

use std::cmp::Ordering;

use super::polygon::{ConvexHull, PointIndex};
use crate::numeric::orientation::{Turn, orientation_counted};
use crate::tally::Tally;

/// A point and where it stands in the input.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site {
    pub(super) point: [f64; 2],
    pub(super) index: PointIndex,
}

impl Site {
    /// Order by x, then y, then position; the two zeros are equal. Coordinates are finite.
    #[inline]
    pub(super) fn precedes(&self, other: &Self) -> bool {
        let ([x, y], [other_x, other_y]) = (self.point, other.point);
        // points seldom share an abscissa, so this branch is predictable and the comparison below costs no branch
        if x != other_x {
            x < other_x
        } else if y != other_y {
            y < other_y
        } else {
            self.index < other.index
        }
    }

    /// Order by x and y backwards; equal points still by position.
    #[inline]
    pub(super) fn precedes_backwards(&self, other: &Self) -> bool {
        if self.point == other.point { self.index < other.index } else { other.precedes(self) }
    }
}

/// Sorts sites lexicographically. No two of them have the same position in the input.
pub(super) fn sort(sites: &mut [Site]) {
    sites.sort_unstable_by(|a, b| if a.precedes(b) { Ordering::Less } else { Ordering::Greater });
}

/// The points at some positions, sorted lexicographically.
pub(super) fn sorted(points: &[[f64; 2]], positions: impl Iterator<Item = u32>) -> Vec<Site> {
    let mut sites: Vec<Site> =
        positions.map(|at| Site { point: points[at as usize], index: PointIndex::new(at as usize) }).collect();
    sort(&mut sites);
    sites
}

/// The hull of sites sorted lexicographically, at least one: Andrew's monotone chains.
///
/// Sites on one side of the line from the first to the last site can only be vertices of the chain on that side, and
/// sites on that line of neither. Of equal sites only the first takes part.
pub(super) fn hull_of_sorted(sites: &[Site], tally: &mut impl Tally) -> ConvexHull {
    let (first, end) = (&sites[0], sites[sites.len() - 1].point);
    // the first of the sites that equal the last one
    let last = sites.len() - sites.iter().rev().take_while(|site| site.point == end).count();
    if last == 0 {
        return ConvexHull::from_parts(vec![first.point], vec![first.index]);
    }
    let mut lower = Chain::new(Turn::Left, first.point);
    let mut upper = Chain::new(Turn::Right, first.point);
    let mut previous = first.point;
    for (position, site) in sites[..last].iter().enumerate().skip(1) {
        if site.point == previous {
            continue;
        }
        previous = site.point;
        match orientation_counted(first.point, end, site.point, tally) {
            Turn::Left => upper.push(sites, position, tally),
            Turn::Right => lower.push(sites, position, tally),
            Turn::Straight => {}
        }
    }
    lower.push(sites, last, tally);
    upper.push(sites, last, tally);
    upper.positions.pop();

    let count = lower.positions.len() + upper.positions.len() - 1;
    let mut vertices = Vec::with_capacity(count);
    let mut indices = Vec::with_capacity(count);
    for &position in lower.positions.iter().chain(upper.positions[1..].iter().rev()) {
        let site = &sites[position as usize];
        vertices.push(site.point);
        indices.push(site.index);
    }
    ConvexHull::from_parts(vertices, indices)
}

/// The hull below (left turns) or above (right turns) of the sites pushed so far.
struct Chain {
    /// The turn at each inner vertex.
    turn: Turn,
    /// Positions among the sites, increasing; the first is 0.
    positions: Vec<u32>,
    /// The last two vertices, equal while there is only one.
    end: [[f64; 2]; 2],
}

impl Chain {
    fn new(turn: Turn, first: [f64; 2]) -> Self {
        Chain { turn, positions: vec![0], end: [first; 2] }
    }

    #[inline]
    fn push(&mut self, sites: &[Site], position: usize, tally: &mut impl Tally) {
        let point = sites[position].point;
        while self.positions.len() > 1 && orientation_counted(self.end[0], self.end[1], point, tally) != self.turn {
            self.positions.pop();
            let before = self.positions[self.positions.len().saturating_sub(2)];
            self.end = [sites[before as usize].point, self.end[0]];
        }
        self.positions.push(position as u32);
        self.end = [self.end[1], point];
    }
}
