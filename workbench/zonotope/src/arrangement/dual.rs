//! The dual arrangement of generators in space (Section 3): the generator (a, b, c) becomes the line a x + b y + c = 0
//! of the plane z = 1.
//!
//! The line is where the plane through the origin perpendicular to the generator meets z = 1: the directions (x, y, 1)
//! in which the generator changes sides. A vertex of the arrangement is the normal of an upward facet, and slope
//! selection on it is slope selection on the facets of the upper hull.
//!
//! What general position leaves out:
//! - a vertical generator, a = b = 0, changes sides in no direction (x, y, 1): it has no line, and neither has a zero
//!   one;
//! - a generator with b = 0 has a vertical line. It crosses every line that is not vertical;
//! - generators with parallel projections have parallel lines, without a vertex, whether or not they coincide: parallel
//!   generators have one line, counted as often as there are generators;
//! - coplanar generators have concurrent lines: each pair is a vertex of its own at the common point.

use thiserror::Error;

use super::line::{ExactLine, LineIndex};
use super::lines::{LineArrangement, LineSource};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::non_finite::NonFinite;
use crate::tally::Tally;

/// Why generators are refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum GeneratorError {
    /// A coordinate is NaN or infinite.
    #[error(transparent)]
    NonFinite(#[from] NonFinite),
    /// There are more generators than a 32-bit index can name.
    #[error("{count} generators are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// How many generators there are.
        count: usize,
    },
}

impl GeneratorError {
    /// Refuses generators that are not finite or too many.
    pub(crate) fn check(generators: &[[f64; 3]]) -> Result<(), Self> {
        NonFinite::check_list("generator", generators)?;
        u32::try_from(generators.len()).map(|_| ()).map_err(|_| Self::TooMany { count: generators.len() })
    }
}

/// The lines of generators of R^3; a line has the index of its generator.
#[derive(Debug)]
pub struct DualArrangement<'a> {
    lines: LineArrangement<'a>,
    count: usize,
    /// The generators of the lines at all places, upward: y > 0.
    pub(crate) slanted: Vec<Upward>,
    /// The generators of the vertical lines from left to right, upward: y = 0 and x < 0.
    pub(crate) level: Vec<Upward>,
    /// The vertical generators, upward: z > 0.
    pub(crate) poles: Vec<Upward>,
}

/// Generators in two runs, with their coordinates in a chosen order.
#[derive(Debug, Clone, Copy)]
struct Generators<'a> {
    runs: [&'a [[f64; 3]]; 2],
    axes: [usize; 3],
}

/// A generator turned to point up, as if the plane z = 1 were turned a little counter-clockwise: y > 0, else x < 0,
/// else z > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Upward {
    pub(crate) generator: u32,
    /// Whether `vector` is the generator's negative.
    pub(crate) reversed: bool,
    pub(crate) vector: [f64; 3],
}

impl<'a> DualArrangement<'a> {
    /// The lines of generators, sorted by slope. O(n log n).
    ///
    /// # Errors
    /// [`GeneratorError`] on the first coordinate that is not finite, or too many generators.
    pub fn new(generators: &'a [[f64; 3]]) -> Result<Self, GeneratorError> {
        GeneratorError::check(generators)?;
        Ok(Self::of_runs([generators, &[]], [0, 1, 2], &mut ()))
    }

    /// The lines of finite generators in two runs, whose coordinates x, y, z are those with the numbers `axes`.
    pub(crate) fn of_runs(runs: [&'a [[f64; 3]]; 2], axes: [usize; 3], tally: &mut impl Tally) -> Self {
        let generators = Generators { runs, axes };
        let lines = LineArrangement::new(Box::new(generators), tally);
        let upward = |line: LineIndex| generators.upward(line.0);
        let slanted = (0..lines.place_count() as u32).map(|place| upward(lines.line_at(place))).collect();
        let level = lines.vertical_lines().map(upward).collect();
        let is_pole = |vector: &[f64; 3]| vector[0] == 0.0 && vector[1] == 0.0 && vector[2] != 0.0;
        let count = generators.len();
        let poles = (0..count as u32).map(|i| generators.upward(i)).filter(|pole| is_pole(&pole.vector)).collect();
        Self { lines, count, slanted, level, poles }
    }

    /// The lines.
    pub fn lines(&self) -> &LineArrangement<'a> {
        &self.lines
    }

    /// How many generators there are, with those that have no line.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are no generators.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Generators<'_> {
    fn row(&self, index: u32) -> [f64; 3] {
        let (index, [first, second]) = (index as usize, self.runs);
        let row = if index < first.len() { first[index] } else { second[index - first.len()] };
        self.axes.map(|axis| row[axis])
    }

    fn upward(&self, generator: u32) -> Upward {
        let vector = self.row(generator);
        let [x, y, z] = vector;
        let reversed = y < 0.0 || (y == 0.0 && (x > 0.0 || (x == 0.0 && z < 0.0)));
        Upward { generator, reversed, vector: if reversed { vector.map(|c| -c) } else { vector } }
    }
}

impl LineSource for Generators<'_> {
    fn len(&self) -> usize {
        self.runs[0].len() + self.runs[1].len()
    }

    fn line(&self, index: u32) -> ExactLine {
        let [x, y, offset] = self.row(index).map(Dyadic::from_f64);
        ExactLine { normal: [x, y], offset }
    }
}
