//! Lines prepared for sweeping: sorted by slope, with heights that can be compared exactly along any vertical line.

use std::fmt::Debug;
use std::ops::Range;

use super::exact_sort::{Keyed, sort_exactly};
use super::fraction::Fraction;
use super::line::{ExactLine, LineIndex};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::tally::{Operation, Tally};

/// More than the exponent of any abscissa is below zero.
const EXPONENTS: i64 = 1 << 20;

/// Exact lines, made when a decision needs them.
pub(crate) trait LineSource: Debug {
    /// How many lines there are.
    fn len(&self) -> usize;

    /// The exact line with an index.
    ///
    /// # Panics
    /// If there is no such line: the index is not below [`len`](Self::len).
    fn line(&self, index: u32) -> ExactLine;
}

/// A set of lines of the plane, each pair of which has a vertex unless it is parallel.
///
/// Lines whose normal is zero are no lines and have no vertex. Lines that are not vertical are known by their place in
/// the order of slopes, then heights, then indices. Approximations live in a frame scaled by powers of two such that
/// typical slopes and intercepts are about 1.
#[derive(Debug)]
pub struct LineArrangement<'a> {
    source: Box<dyn LineSource + 'a>,
    /// The line at each place.
    places: Vec<Graph>,
    /// The class of parallel lines at each place; classes are numbered by ascending slope.
    classes: Vec<u32>,
    /// The vertical lines with their abscissas, ascending.
    verticals: Vec<(Fraction, u32)>,
    shift: Shift,
}

/// The line y = slope · x + intercept.
#[derive(Debug, Clone, Copy)]
struct Graph {
    line: u32,
    slope: BoundedDoubleDouble,
    intercept: BoundedDoubleDouble,
}

/// The powers of two by which slopes and intercepts are scaled.
#[derive(Debug, Clone, Copy)]
struct Shift {
    slope: i64,
    intercept: i64,
}

/// Where lines meet.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Event {
    /// The lines at two places cross.
    Crossing([u32; 2]),
    /// A vertical line, given by its position among them, crosses the lines at all places.
    Vertical(u32),
}

/// The places from bottom to top along a vertical line.
pub(crate) struct VerticalOrder {
    /// The order just right of the line.
    right: Vec<u32>,
    /// The ranges, longer than one, of lines that meet on the vertical line.
    ties: Vec<Range<usize>>,
}

impl<'a> LineArrangement<'a> {
    /// Sorts the lines by slope. O(n log n).
    pub(crate) fn new(source: Box<dyn LineSource + 'a>, tally: &mut impl Tally) -> Self {
        let count = source.len() as u32;
        tally.add(Operation::LineEvaluation, u64::from(count));
        let shift = Shift::typical(&*source);
        let (mut graphs, mut verticals) = (Vec::with_capacity(source.len()), Vec::new());
        for index in 0..count {
            let line = source.line(index);
            if !line.normal[1].is_zero() {
                graphs.push(Graph {
                    line: index,
                    slope: slope(&line).approximate(shift.slope),
                    intercept: intercept(&line).approximate(shift.intercept),
                });
            } else if !line.normal[0].is_zero() {
                let [x, _] = line.normal;
                verticals.push((Fraction::new(-line.offset, x), index));
            }
        }
        let exact = |item: u32| source.line(graphs[item as usize].line);
        let keyed =
            |key: fn(&Graph) -> BoundedDoubleDouble, item: u32| Keyed { key: key(&graphs[item as usize]), item };
        let mut order: Vec<Keyed> = (0..graphs.len() as u32).map(|item| keyed(|g| g.slope, item)).collect();
        let parallel = sort_exactly(&mut order, |item| slope(&exact(item)), tally);
        let mut classes: Vec<u32> = (0..graphs.len() as u32).collect();
        for range in parallel {
            classes[range.clone()].fill(range.start as u32);
            let class = &mut order[range];
            for place in class.iter_mut() {
                *place = keyed(|g| g.intercept, place.item);
            }
            sort_exactly(class, |item| intercept(&exact(item)), tally);
        }
        let places = order.iter().map(|place| graphs[place.item as usize]).collect();
        verticals.sort();
        Self { source, places, classes, verticals, shift }
    }

    /// How many lines are neither vertical nor without normal.
    pub(crate) fn place_count(&self) -> usize {
        self.places.len()
    }

    /// How many lines are vertical.
    pub(crate) fn vertical_count(&self) -> usize {
        self.verticals.len()
    }

    /// The line at a place.
    pub(crate) fn line_at(&self, place: u32) -> LineIndex {
        LineIndex(self.places[place as usize].line)
    }

    /// The vertical line with a position among them, from the left.
    pub(crate) fn vertical_line_at(&self, position: u32) -> LineIndex {
        LineIndex(self.verticals[position as usize].1)
    }

    /// The vertical lines from left to right.
    pub(crate) fn vertical_lines(&self) -> impl Iterator<Item = LineIndex> {
        self.verticals.iter().map(|(_, line)| LineIndex(*line))
    }

    /// How many lines there are, with those whose normal is zero.
    pub fn len(&self) -> usize {
        self.source.len()
    }

    /// Whether there are no lines.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The exact line with an index.
    ///
    /// # Panics
    /// If there is no such line: the index is not below [`len`](Self::len).
    pub fn exact_line(&self, line: LineIndex) -> ExactLine {
        self.source.line(line.0)
    }

    /// How many pairs of lines cross, whether or not at the same point. O(n).
    pub fn vertex_count(&self) -> u64 {
        self.crossings_among(0..self.place_count() as u32) + self.verticals.len() as u64 * self.places.len() as u64
    }

    /// How many pairs among lines that are not vertical, given by ascending places, cross.
    pub(crate) fn crossings_among(&self, places: impl ExactSizeIterator<Item = u32>) -> u64 {
        let pairs = |n: u64| n * n.saturating_sub(1) / 2;
        let all = pairs(places.len() as u64);
        let (mut parallel, mut class, mut size) = (0, u32::MAX, 0);
        for place in places {
            let own = self.classes[place as usize];
            if own != class {
                parallel += pairs(size);
                (class, size) = (own, 0);
            }
            size += 1;
        }
        all - parallel - pairs(size)
    }

    /// The places from bottom to top left of every vertex.
    pub(crate) fn order_before_all(&self) -> Vec<u32> {
        let mut order: Vec<u32> = (0..self.place_count() as u32).collect();
        self.turn(&mut order);
        order
    }

    /// The places from bottom to top right of every vertex.
    pub(crate) fn order_after_all(&self) -> Vec<u32> {
        (0..self.place_count() as u32).collect()
    }

    /// Turns lines that meet in one point from their order right of it to their order left of it; equal lines stay.
    pub(crate) fn turn(&self, places: &mut [u32]) {
        places.reverse();
        for parallel in places.chunk_by_mut(|&a, &b| self.classes[a as usize] == self.classes[b as usize]) {
            parallel.reverse();
        }
    }

    /// Sorts the lines along the vertical line at an abscissa. O(n log n).
    pub(crate) fn order_at(&self, x: &Fraction, tally: &mut impl Tally) -> VerticalOrder {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::LineEvaluation, self.places.len() as u64);
        let rounded = x.approximate(self.shift.abscissa());
        let height =
            |(item, graph): (usize, &Graph)| Keyed { key: graph.slope * rounded + graph.intercept, item: item as u32 };
        let mut keyed: Vec<Keyed> = self.places.iter().enumerate().map(height).collect();
        let ties = sort_exactly(&mut keyed, |place| self.scaled_height(place, x), tally);
        VerticalOrder { right: keyed.iter().map(|keyed| keyed.item).collect(), ties }
    }

    /// The height of the line at a place along the vertical line at an abscissa, times the abscissa's denominator.
    pub(crate) fn scaled_height(&self, place: u32, x: &Fraction) -> Fraction {
        let ExactLine { normal: [a, b], offset } = self.source.line(self.places[place as usize].line);
        Fraction::new(-(a * x.numerator.clone() + offset * x.denominator.clone()), b)
    }

    /// The slope and the intercept of the line at a place in the scaled frame.
    pub(crate) fn approximate_line(&self, place: u32) -> [BoundedDoubleDouble; 2] {
        let graph = &self.places[place as usize];
        [graph.slope, graph.intercept]
    }

    /// The coordinates in the scaled frame of a point given by homogeneous coordinates, the last of them positive.
    pub(crate) fn approximate_point(&self, [x, y, w]: &[Dyadic; 3]) -> [BoundedDoubleDouble; 2] {
        let scaled = |v: &Dyadic, shift: i64| BoundedDoubleDouble::of_ratio(&v.clone().scaled(shift), w);
        [scaled(x, self.shift.abscissa()), scaled(y, self.shift.intercept)]
    }

    /// Whether the lines at two places are parallel.
    pub(crate) fn are_parallel(&self, [a, b]: [u32; 2]) -> bool {
        self.classes[a as usize] == self.classes[b as usize]
    }

    /// Whether the lines at two places are one line.
    pub(crate) fn coincide(&self, places: [u32; 2]) -> bool {
        let [a, b] = places.map(|place| &self.places[place as usize]);
        self.are_parallel(places)
            && a.intercept.certain_order(&b.intercept).is_none()
            && intercept(&self.source.line(a.line)) == intercept(&self.source.line(b.line))
    }

    /// The abscissa of an event, exactly.
    pub(crate) fn abscissa(&self, event: Event) -> Fraction {
        match event {
            Event::Crossing(places) => {
                let [first, second] = places.map(|place| self.source.line(self.places[place as usize].line));
                let [x, _, w] = first.meet(&second);
                Fraction::new(x, w)
            }
            Event::Vertical(position) => self.verticals[position as usize].0.clone(),
        }
    }

    /// The abscissa of an event in the scaled frame.
    pub(crate) fn approximate_abscissa(&self, event: Event) -> BoundedDoubleDouble {
        match event {
            Event::Crossing(places) => {
                let [first, second] = places.map(|place| &self.places[place as usize]);
                (second.intercept - first.intercept) / (first.slope - second.slope)
            }
            Event::Vertical(position) => self.verticals[position as usize].0.approximate(self.shift.abscissa()),
        }
    }

    /// Ascends with the abscissa of an event but for rounding, however far out of the range of doubles: the size of its
    /// exponent with its sign, then the rest.
    pub(crate) fn rough_abscissa(&self, event: Event) -> (i64, f64) {
        let high = self.approximate_abscissa(event).high;
        let leading = match binary_exponent(high) {
            Some(exponent) if high.is_normal() => {
                let exponent = i64::from(exponent);
                Some((exponent, scale_by_power_of_two(high, -exponent)))
            }
            _ => self.abscissa(event).leading().map(|(exponent, rest)| (exponent + self.shift.abscissa(), rest)),
        };
        let order = |(exponent, rest): (i64, f64)| (rest.signum() as i64 * (exponent + EXPONENTS), rest);
        leading.map_or((0, 0.0), order)
    }

    /// Two lines that meet at an event, the lower index first.
    pub(crate) fn lines_of(&self, event: Event) -> [LineIndex; 2] {
        let line = |place: u32| self.places[place as usize].line;
        let mut lines = match event {
            Event::Crossing(places) => places.map(line),
            Event::Vertical(position) => [self.verticals[position as usize].1, line(0)],
        };
        lines.sort_unstable();
        lines.map(LineIndex)
    }

    /// How many vertical lines lie left of an abscissa, and how many left of it or on it. O(log n).
    pub(crate) fn verticals_up_to(&self, x: &Fraction) -> [usize; 2] {
        [self.verticals.partition_point(|(own, _)| own < x), self.verticals.partition_point(|(own, _)| own <= x)]
    }
}

impl VerticalOrder {
    /// The places just right of the vertical line.
    pub(crate) fn just_right(&self) -> Vec<u32> {
        self.right.clone()
    }

    /// The places just left of the vertical line.
    pub(crate) fn just_left(&self, arrangement: &LineArrangement) -> Vec<u32> {
        let mut order = self.right.clone();
        for tie in &self.ties {
            arrangement.turn(&mut order[tie.clone()]);
        }
        order
    }

    /// The lines from bottom to top, those that meet on the vertical line together, in their order right of it.
    pub(crate) fn groups(&self) -> impl DoubleEndedIterator<Item = &[u32]> {
        let mut groups = Vec::new();
        let mut next = 0;
        for tie in &self.ties {
            groups.extend((next..tie.start).map(|single| single..single + 1));
            groups.push(tie.clone());
            next = tie.end;
        }
        groups.extend((next..self.right.len()).map(|single| single..single + 1));
        groups.into_iter().map(|group| &self.right[group])
    }

    /// How many pairs of lines that are not vertical cross on the vertical line.
    pub(crate) fn crossings(&self, arrangement: &LineArrangement) -> u64 {
        self.ties.iter().map(|tie| arrangement.crossings_among(self.right[tie.clone()].iter().copied())).sum()
    }
}

impl Shift {
    /// The shifts that make the median slope and intercept of an even sample about 1.
    fn typical(source: &dyn LineSource) -> Self {
        const SAMPLE: usize = 1000;
        let step = source.len().div_ceil(SAMPLE).max(1);
        let lines = (0..source.len() as u32).step_by(step).map(|index| source.line(index));
        let (mut slopes, mut intercepts) = (Vec::new(), Vec::new());
        for line in lines.filter(|line| !line.normal[1].is_zero()) {
            slopes.extend(slope(&line).binary_exponent());
            intercepts.extend(intercept(&line).binary_exponent());
        }
        let [slope, intercept] = [slopes, intercepts].map(|mut exponents| {
            let middle = exponents.len() / 2;
            if exponents.is_empty() { 0 } else { -*exponents.select_nth_unstable(middle).1 }
        });
        Self { slope, intercept }
    }

    /// The power of two by which abscissas are scaled.
    fn abscissa(&self) -> i64 {
        self.intercept - self.slope
    }
}

fn slope(line: &ExactLine) -> Fraction {
    let [a, b] = &line.normal;
    Fraction::new(-a.clone(), b.clone())
}

fn intercept(line: &ExactLine) -> Fraction {
    Fraction::new(-line.offset.clone(), line.normal[1].clone())
}
