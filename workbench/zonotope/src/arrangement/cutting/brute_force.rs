//! Which lines cross a trapezoid, in which trapezoids a point lies, and whether trapezoids make a cutting, from the
//! definitions in rationals: the truth the methods are held to.
//!
//! # Statement
//! Input: lines ([`LineArrangement`]) with trapezoids between them, or a point. Output of [`crossing_lines`]: the lines
//! that meet the interior of a trapezoid, by index. Of [`locate`]: all trapezoids that a point belongs to. Of
//! [`check`]: the first [`Flaw`] of what is claimed to be a cutting, if there is one. Unbounded trapezoids, triangles,
//! vertical, equal and concurrent lines are ordinary input.
//!
//! # Source
//! The definitions.
//!
//! # Method
//! 1. On a line that is not vertical, the points right of the left wall, left of the right wall, above the bottom and
//!    below the top are four sets of abscissas, each bounded by one number, or empty or everything. The line crosses if
//!    all of them have an abscissa in common. A vertical line crosses if it lies strictly between the walls.
//! 2. A point is compared with all sides of all trapezoids.
//! 3. The abscissas of all walls divide the plane into slabs. In the middle of each, the trapezoids that reach over it
//!    must lie on each other without a gap: nothing below the first, the top of each the bottom of the next, nothing
//!    above the last. That bottom and top of a trapezoid do not cross between its walls is checked at the walls.
//!
//! # Complexity
//! n lines, N trapezoids: O(n) rational operations for the lines of a trapezoid; O(N) for a point; O(N² log N) for the
//! check of a cover, besides O(n N) for the lists.
//!
//! # Shapes
//! `lines`: n up to about 100; `trapezoids`: N up to about 1000.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Errors
//! [`Flaw`] ⇔ what was checked is no (1/r)-cutting with the right lists.
//!
//! # Panics
//! If a trapezoid names a line that is not there, a vertical line as a side, or a wall through parallel lines.
//!
//! # Checked by
//! Hand-worked examples; its simplicity.
//!
//! # Example
//! ```
//! use zonotope::arrangement::{LineArrangement, LineIndex, cutting::{Trapezoid, Wall, brute_force}};
//! // Between y = x and y = −x, right of their crossing: y = 1 crosses, the lines along the sides do not.
//! let rows = [[1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, -1.0]];
//! let lines = LineArrangement::from_rows(&rows).unwrap();
//! let left = Some(Wall::Through([LineIndex(0), LineIndex(1)]));
//! let triangle = Trapezoid { left, right: None, bottom: Some(LineIndex(1)), top: Some(LineIndex(0)) };
//! assert_eq!(brute_force::crossing_lines(&lines, &triangle), [LineIndex(2)]);
//! ```

use std::cmp::Ordering;

use thiserror::Error;

use super::trapezoid::{Trapezoid, TrapezoidIndex, Wall};
use crate::arrangement::line::LineIndex;
use crate::arrangement::lines::LineArrangement;
use crate::numeric::Rational;

/// What is wrong with something that is claimed to be a cutting.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Flaw {
    /// The list of a trapezoid does not hold exactly the lines that cross it.
    #[error("the list of trapezoid {} does not hold the lines that cross it", .0.0)]
    List(TrapezoidIndex),
    /// More lines cross a trapezoid than may.
    #[error("trapezoid {} is crossed by {count} lines, of at most {limit}", trapezoid.0)]
    Weight {
        /// The trapezoid.
        trapezoid: TrapezoidIndex,
        /// How many lines cross it.
        count: usize,
        /// How many may.
        limit: usize,
    },
    /// The bottom and the top of a trapezoid, or its walls, have no points between them or cross.
    #[error("trapezoid {} has sides that cross or meet", .0.0)]
    Shape(TrapezoidIndex),
    /// Trapezoids overlap or leave a gap.
    #[error("the trapezoids do not cover every vertical line once")]
    Cover,
}

/// A line y = slope x + intercept.
#[derive(Clone, PartialEq)]
struct Graph {
    slope: Rational,
    intercept: Rational,
}

impl Graph {
    fn height(&self, x: &Rational) -> Rational {
        &self.slope * x + &self.intercept
    }

    /// Narrows a range of abscissas to those at which this line is above another one.
    fn narrow_to_above(&self, other: &Self, range: &mut Abscissas) {
        let (slope, rest) = (&self.slope - &other.slope, &other.intercept - &self.intercept);
        match slope.cmp(&Rational::ZERO) {
            Ordering::Greater => range.narrow_to_right_of(rest / slope),
            Ordering::Less => range.narrow_to_left_of(rest / slope),
            Ordering::Equal => range.is_empty |= rest >= Rational::ZERO,
        }
    }
}

/// An open range of abscissas, without end where there is none.
#[derive(Clone)]
struct Abscissas {
    after: Option<Rational>,
    before: Option<Rational>,
    is_empty: bool,
}

impl Abscissas {
    fn narrow_to_right_of(&mut self, x: Rational) {
        if self.after.as_ref().is_none_or(|after| *after < x) {
            self.after = Some(x);
        }
    }

    fn narrow_to_left_of(&mut self, x: Rational) {
        if self.before.as_ref().is_none_or(|before| *before > x) {
            self.before = Some(x);
        }
    }

    fn contains(&self, x: &Rational) -> bool {
        !self.is_empty
            && self.after.as_ref().is_none_or(|after| after < x)
            && self.before.as_ref().is_none_or(|before| before > x)
    }

    fn has_points(&self) -> bool {
        !self.is_empty && !matches!((&self.after, &self.before), (Some(after), Some(before)) if after >= before)
    }
}

/// A line by its coefficients, as a graph, or as an abscissa if it is vertical; nothing if its normal is zero.
fn read(lines: &LineArrangement, line: LineIndex) -> Option<Result<Graph, Rational>> {
    let exact = lines.exact_line(line);
    let ([a, b], c) = (exact.normal.map(|v| v.to_rational()), exact.offset.to_rational());
    match (a == Rational::ZERO, b == Rational::ZERO) {
        (true, true) => None,
        (false, true) => Some(Err(-c / a)),
        (_, false) => Some(Ok(Graph { slope: -a / &b, intercept: -c / b })),
    }
}

fn graph(lines: &LineArrangement, line: LineIndex) -> Graph {
    read(lines, line).and_then(Result::ok).expect("the lines along the bottom and the top have a slope")
}

fn abscissa(lines: &LineArrangement, wall: Wall) -> Rational {
    match wall {
        Wall::Through(pair) => {
            let [first, second] = pair.map(|line| graph(lines, line));
            (second.intercept - first.intercept) / (first.slope - second.slope)
        }
        Wall::Along(line) => {
            read(lines, line).and_then(Result::err).expect("a wall along a line is along a vertical one")
        }
    }
}

/// A trapezoid by its walls' abscissas and the lines along its sides.
struct Sides {
    between_walls: Abscissas,
    bottom: Option<Graph>,
    top: Option<Graph>,
}

impl Sides {
    fn of(lines: &LineArrangement, trapezoid: &Trapezoid) -> Self {
        let [after, before] = [trapezoid.left, trapezoid.right].map(|wall| wall.map(|wall| abscissa(lines, wall)));
        let [bottom, top] = [trapezoid.bottom, trapezoid.top].map(|side| side.map(|line| graph(lines, line)));
        Self { between_walls: Abscissas { after, before, is_empty: false }, bottom, top }
    }

    /// Whether a line, as [`read`] has it, meets the interior.
    fn are_crossed_by(&self, line: &Result<Graph, Rational>) -> bool {
        match line {
            Err(x) => self.between_walls.contains(x),
            Ok(graph) => {
                let mut range = self.between_walls.clone();
                if let Some(bottom) = &self.bottom {
                    graph.narrow_to_above(bottom, &mut range);
                }
                if let Some(top) = &self.top {
                    top.narrow_to_above(graph, &mut range);
                }
                range.has_points()
            }
        }
    }

    /// Whether there is an interior and the bottom lies below the top all over it.
    fn have_a_shape(&self) -> bool {
        let (whole, mut proper) = (&self.between_walls, self.between_walls.clone());
        if let (Some(bottom), Some(top)) = (&self.bottom, &self.top) {
            top.narrow_to_above(bottom, &mut proper);
        }
        whole.has_points() && proper.has_points() && (&whole.after, &whole.before) == (&proper.after, &proper.before)
    }
}

/// The lines that cross the interior of a trapezoid, by ascending indices.
pub fn crossing_lines(lines: &LineArrangement, trapezoid: &Trapezoid) -> Vec<LineIndex> {
    crossing_among(&read_all(lines), &Sides::of(lines, trapezoid))
}

fn read_all(lines: &LineArrangement) -> Vec<Option<Result<Graph, Rational>>> {
    (0..lines.len() as u32).map(|line| read(lines, LineIndex(line))).collect()
}

fn crossing_among(all: &[Option<Result<Graph, Rational>>], sides: &Sides) -> Vec<LineIndex> {
    let crosses = |line: &Option<Result<Graph, Rational>>| line.as_ref().is_some_and(|line| sides.are_crossed_by(line));
    (0..).map(LineIndex).zip(all).filter(|(_, line)| crosses(line)).map(|(index, _)| index).collect()
}

/// The trapezoids that a point belongs to: the left wall and the bottom are part of a trapezoid, the right wall and the
/// top are not.
pub fn locate(lines: &LineArrangement, trapezoids: &[Trapezoid], [x, y]: &[Rational; 2]) -> Vec<TrapezoidIndex> {
    let holds = |trapezoid: &Trapezoid| {
        let height = |line| graph(lines, line).height(x);
        trapezoid.left.is_none_or(|wall| abscissa(lines, wall) <= *x)
            && trapezoid.right.is_none_or(|wall| abscissa(lines, wall) > *x)
            && trapezoid.bottom.is_none_or(|line| height(line) <= *y)
            && trapezoid.top.is_none_or(|line| height(line) > *y)
    };
    (0..)
        .map(TrapezoidIndex)
        .zip(trapezoids)
        .filter(|(_, trapezoid)| holds(trapezoid))
        .map(|(index, _)| index)
        .collect()
}

/// Checks that trapezoids cover the plane without overlap, that the list of each holds the lines that cross it, and
/// that these are at most `limit`.
///
/// # Errors
/// The first [`Flaw`] that is found.
pub fn check<'l>(
    lines: &LineArrangement,
    limit: usize,
    trapezoids: &[Trapezoid],
    list: impl Fn(TrapezoidIndex) -> &'l [LineIndex],
) -> Result<(), Flaw> {
    let all = read_all(lines);
    let sides: Vec<Sides> = trapezoids.iter().map(|trapezoid| Sides::of(lines, trapezoid)).collect();
    for (index, sides) in (0..).map(TrapezoidIndex).zip(&sides) {
        let mut listed = list(index).to_vec();
        listed.sort_unstable();
        if listed != crossing_among(&all, sides) {
            return Err(Flaw::List(index));
        }
        if listed.len() > limit {
            return Err(Flaw::Weight { trapezoid: index, count: listed.len(), limit });
        }
        if !sides.have_a_shape() {
            return Err(Flaw::Shape(index));
        }
    }
    slab_middles(&sides).iter().try_for_each(|x| is_covered_once(&sides, x))
}

/// An abscissa between any two neighbouring walls, one left and one right of all walls.
fn slab_middles(sides: &[Sides]) -> Vec<Rational> {
    let walls = sides.iter().flat_map(|sides| [&sides.between_walls.after, &sides.between_walls.before]).flatten();
    let mut walls: Vec<Rational> = walls.cloned().collect();
    walls.sort();
    walls.dedup();
    let (Some(first), Some(last)) = (walls.first(), walls.last()) else { return vec![Rational::ZERO] };
    let middles = walls.windows(2).map(|pair| (&pair[0] + &pair[1]) / Rational::from(2));
    middles.chain([first - Rational::ONE, last + Rational::ONE]).collect()
}

fn is_covered_once(sides: &[Sides], x: &Rational) -> Result<(), Flaw> {
    let mut column: Vec<&Sides> = sides.iter().filter(|sides| sides.between_walls.contains(x)).collect();
    // `None` is the least, so that a trapezoid without bottom comes first
    column.sort_by_cached_key(|sides| sides.bottom.as_ref().map(|bottom| bottom.height(x)));
    let ends = column.first().is_some_and(|sides| sides.bottom.is_none())
        && column.last().is_some_and(|sides| sides.top.is_none());
    let joins = column.windows(2).all(|pair| pair[0].top.is_some() && pair[0].top == pair[1].bottom);
    if ends && joins { Ok(()) } else { Err(Flaw::Cover) }
}
