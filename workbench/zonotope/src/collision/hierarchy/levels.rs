//! Bodies around and within a body, from coarse to fine, by sums over cells of directions.
//!
//! # Statement
//! Input: a zonotope Z of space with n generators. Output: levels from coarse to fine, the last of which is Z. Each of
//! the others has an outer body, which contains that of the next level exactly, and an inner one, which is exactly
//! within Z, where there is one; all have the centre of Z. A level has at most a third of the generators of the next
//! one, and the coarsest a handful. Zero, parallel and coplanar generators and none at all are ordinary input. Where
//! the largest coordinate is below 2^-800 or above 2^900, or n is small (below 48 for generators of even directions),
//! there is no level but Z itself.
//!
//! # Source
//! Section 5.2, hierarchical method. The paper's outer bodies are those of Lemma 5.5: the generators of a patch of
//! directions are projected on one direction of the patch, and a box takes the rest; k patches leave an error of O(1 /
//! √k). Here the generators of a patch are written in terms of its corners instead (`corner_sums`), which leaves O(1 /
//! k), and corners are shared. The inner bodies (`cell_sums`) are not in the paper: they tell overlaps early.
//!
//! Of 10^5 random generators, levels of 13, 49, 193, 769, 3,073 and 12,289 generators reach farther than the body by
//! 14 %, 4.1 %, 1.1 %, 0.24 %, 0.061 % and 0.016 %, the most among 200 directions; bodies of as many generators by the
//! lemma by 74 %, 31 %, 14 %, 6.7 %, 3.4 % and 1.8 %. The inner bodies reach less far by 7 % to 0.007 %.
//!
//! # Method
//! 1. Sort the generators by the cells of a grid of directions through which they leave a cube (`grid`). Take the
//!    finest grid of which at most n / 4 cells have generators.
//! 2. Add up the generators of each cell, and the coefficients with which the cell's corners make them up. That is the
//!    only reading of all generators after the sorting.
//! 3. From the sums of one grid follow those of the next coarser one, with half as many cells along a side: so each
//!    reduced body is reduced again, and contains what it was made of.
//! 4. Keep a level wherever the outer body has at most a third of the generators of the finer level that was kept last.
//!
//! # Complexity
//! n generators: O(n log n) time for the sorting, O(n) else. Space O(n): a level of k generators takes 48 bytes for
//! each of its outer body and as many of its inner one, and the levels together have at most half as many outer
//! generators as Z. Measured on random generators, n = 10^4 and 10^5: the time of 500 to 1,000 passes of a prepared
//! body, and 58 to 64 bytes a generator, 48 of them for the prepared body itself.
//!
//! # Shapes
//! `body`: any order, duplicates allowed.
//!
//! # Numerics
//! Coefficients of corners are rounded, what they leave of a generator is bounded and goes into a box, and sums are
//! rounded up, so that outer bodies contain what they were made of exactly. Sums of cells are exact, or shortened by
//! more than rounding took away; where the body is too thin for that, a level has no inner body.
//!
//! # Checked by
//! [`reduction::contains`](crate::reduction::contains()), exactly, on bodies that it finishes; the answers that rest on
//! the levels, by the kernel without them and the verifier.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, collision::hierarchy::Hierarchy, reduction::contains};
//! let generators = (1..200u32).map(|i| [1.0, f64::from(i * i % 83) / 41.0 - 1.0, f64::from(i % 13) / 6.0 - 1.0]);
//! let hierarchy = Hierarchy::new(Zonotope::new([0.0; 3], generators.collect()).unwrap());
//! let coarsest = hierarchy.outer(0).body();
//! assert!(hierarchy.level_count() > 1 && coarsest.generators().len() <= 12);
//! assert_eq!(contains(coarsest, hierarchy.body()), Some(true));
//! ```

use super::cell_sums::CellSums;
use super::corner_sums::CornerSums;
use super::grid::{Cell, FINEST_DEPTH, finest_cell};
use crate::lad::of_generators::certify::unit_gauge_bound::unit_gauge_bound;
use crate::numeric::linear::euclidean_norm;
use crate::numeric::scaling::{binary_exponent, largest_magnitude, power_of_two};
use crate::zonotope::query::Query;
use crate::zonotope::{PreparedBody, Zonotope};

/// The finest grid has so many generators for each cell, or more.
const GENERATORS_OF_CELL: usize = 4;

/// A level has so many times as many generators as the next coarser one, or more.
const LEVEL_RATIO: usize = 3;

/// Exponents of the longest generator for which generators of sums neither overflow nor lose digits to underflow.
const EXPONENTS: std::ops::RangeInclusive<i32> = -800..=900;

/// A body with its levels, for many questions of whether it meets others.
#[derive(Debug, Clone)]
pub struct Hierarchy {
    body: PreparedBody,
    /// From coarse to fine, without the body itself.
    levels: Vec<Level>,
}

/// A body around the body, and one within it.
#[derive(Debug, Clone)]
struct Level {
    outer: PreparedBody,
    inner: Option<PreparedBody>,
    /// By how much the lengths of the outer generators together exceed those of the body's.
    excess: f64,
}

impl Hierarchy {
    /// The levels of a body. O(n log n).
    pub fn new(body: Zonotope<3>) -> Self {
        let levels = levels(&body);
        Self { body: PreparedBody::new(body), levels }
    }

    /// The body.
    pub fn body(&self) -> &Zonotope<3> {
        self.body.body()
    }

    /// How many levels there are, the body itself included.
    pub fn level_count(&self) -> usize {
        self.levels.len() + 1
    }

    /// The outer body of a level, which contains those of all finer ones: 0 is the coarsest, and the last is the body.
    pub fn outer(&self, level: usize) -> &PreparedBody {
        self.levels.get(level).map_or(&self.body, |level| &level.outer)
    }

    /// The inner body of a level, if there is one; that of the last is the body.
    pub fn inner(&self, level: usize) -> Option<&PreparedBody> {
        self.levels.get(level).map_or(Some(&self.body), |level| level.inner.as_ref())
    }

    /// The bytes that are held, the generators included.
    pub fn bytes(&self) -> usize {
        let of_level = |level: &Level| level.outer.bytes() + level.inner.as_ref().map_or(0, PreparedBody::bytes);
        self.body.bytes() + self.levels.iter().map(of_level).sum::<usize>()
    }

    /// Twice the mean, over all directions, of what the outer body of a level reaches beyond the body: Σ |g| of a
    /// zonotope of space is twice the mean of Σ |g · u|. Rounded, and 0 for the last level.
    pub(super) fn excess(&self, level: usize) -> f64 {
        self.levels.get(level).map_or(0.0, |level| level.excess)
    }
}

/// A generator by the finest cell through which it leaves the cube.
type Placed = (Cell, usize);

/// The levels of a body from coarse to fine.
fn levels(body: &Zonotope<3>) -> Vec<Level> {
    let generators = body.generators();
    let exponent = binary_exponent(largest_magnitude(generators.as_flattened())).unwrap_or(i32::MIN);
    let placed = placed(generators);
    let cells = cells_by_depth(&placed);
    if !EXPONENTS.contains(&exponent) || cells[1] * GENERATORS_OF_CELL > generators.len() {
        return Vec::new();
    }
    let is_coarse = |depth: &u32| cells[*depth as usize] * GENERATORS_OF_CELL <= generators.len();
    let depth = (1..=FINEST_DEPTH).rev().find(is_coarse).unwrap_or(1);
    let [size, inverse] = [exponent, -exponent].map(power_of_two);
    let turned = |&(finest, index): &Placed| {
        let (cell, v) = (finest.at_depth(depth), generators[index]);
        (cell, if v[cell.face(depth)] < 0.0 { v.map(|c| -c) } else { v })
    };
    let turned: Vec<(Cell, [f64; 3])> = placed.iter().map(turned).collect();
    let scaled = |(cell, v): &(Cell, [f64; 3])| (*cell, v.map(|c| c * inverse));
    let length: f64 = turned.iter().map(|place| euclidean_norm(&scaled(place).1)).sum();
    let gauge_bound = unit_gauge_bound(&Query::of_finite([0.0; 3], [0.0; 3], generators), 1);
    let mut corners = CornerSums::new(turned.iter().map(scaled), depth);
    let mut sums = CellSums::new(turned.iter().copied());
    let mut levels = Vec::new();
    let mut finer = generators.len();
    loop {
        if corners.len() * LEVEL_RATIO <= finer {
            finer = corners.len();
            let prepared = |generators| Zonotope::new(body.center(), generators).ok().map(PreparedBody::new);
            let inner = sums.generators(gauge_bound).and_then(prepared);
            let excess = (corners.length() - length).max(0.0) * size;
            levels.extend(prepared(corners.generators(size)).map(|outer| Level { outer, inner, excess }));
        }
        if corners.depth() == 0 {
            break;
        }
        (corners, sums) = (corners.coarser(), sums.coarser());
    }
    levels.reverse();
    levels
}

/// The generators that are not zero in the order of their cells.
fn placed(generators: &[[f64; 3]]) -> Vec<Placed> {
    let place = |(index, v)| finest_cell(v).map(|cell| (cell, index));
    let mut placed: Vec<Placed> = generators.iter().enumerate().filter_map(place).collect();
    placed.sort_unstable();
    placed
}

/// How many cells of each depth have generators.
fn cells_by_depth(placed: &[Placed]) -> [usize; FINEST_DEPTH as usize + 1] {
    let mut counts = [0; FINEST_DEPTH as usize + 1];
    counts[0] = usize::from(!placed.is_empty());
    for pair in placed.windows(2).filter(|pair| pair[0].0 != pair[1].0) {
        counts[pair[0].0.parting_depth(pair[1].0) as usize] += 1;
    }
    for depth in 1..counts.len() {
        counts[depth] += counts[depth - 1];
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_counted() {
        let list = [[1.0, 0.5, 0.5], [2.0, 1.0, 1.0], [1.0, 0.5, -0.5], [0.0, 1.0, 0.0], [0.0; 3]];
        let placed = placed(&list);
        let counts = cells_by_depth(&placed);
        assert_eq!((placed.len(), counts[0], counts[1], counts[20]), (4, 2, 3, 3));
        assert_eq!(cells_by_depth(&[])[20], 0);
    }
}
