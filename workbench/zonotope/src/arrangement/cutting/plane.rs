//! The order of lines along walls and the order of walls, exactly: by doubles with bounds, by pairs of doubles where
//! those leave a doubt, by exact numbers where pairs do.

use std::cell::{Cell, OnceCell};
use std::cmp::Ordering;
use std::ops::Range;

use super::trapezoid::Wall;
use crate::arrangement::fraction::Fraction;
use crate::arrangement::lines::{Event, LineArrangement};
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;

/// The lines, by their places in the order of slopes, and the walls that were made.
#[derive(Debug)]
pub(super) struct Plane<'a> {
    pub(super) lines: &'a LineArrangement<'a>,
    graphs: Vec<Graph>,
    /// The first place of all that have the same line.
    first_equal: Vec<u32>,
    walls: Vec<Abscissa>,
    exact_decisions: Cell<u64>,
}

/// The line y = slope · x + intercept, in the scaled frame of the arrangement.
#[derive(Debug, Clone, Copy)]
struct Graph {
    slope: Bounded,
    intercept: Bounded,
}

/// The abscissa of a wall, in the scaled frame of the arrangement and exactly.
#[derive(Debug)]
pub(super) struct Abscissa {
    event: Event,
    rounded: Bounded,
    approximate: BoundedDoubleDouble,
    exact: OnceCell<Fraction>,
}

/// A point given by homogeneous coordinates, the last of them positive.
#[derive(Debug)]
pub(super) struct Point {
    exact: [Dyadic; 3],
    approximate: [BoundedDoubleDouble; 2],
    rounded: [Bounded; 2],
}

/// Where a range of abscissas ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// Left of every vertex.
    BeforeAll,
    /// Right of every vertex.
    AfterAll,
    /// At the wall with this number.
    At(u32),
}

impl<'a> Plane<'a> {
    /// The lines without walls. O(n).
    pub(super) fn new(lines: &'a LineArrangement<'a>) -> Self {
        let places = 0..lines.place_count() as u32;
        let graph = |place| {
            let [slope, intercept] = lines.approximate_line(place).map(|v| v.rounded());
            Graph { slope, intercept }
        };
        let mut first_equal: Vec<u32> = places.clone().collect();
        for place in places.clone().skip(1) {
            if lines.coincide([place - 1, place]) {
                first_equal[place as usize] = first_equal[place as usize - 1];
            }
        }
        let graphs = places.map(graph).collect();
        Self { lines, graphs, first_equal, walls: Vec::new(), exact_decisions: Cell::new(0) }
    }

    /// How many decisions took exact numbers.
    pub(super) fn exact_decisions(&self) -> u64 {
        self.exact_decisions.get()
    }

    /// The abscissa of an event.
    pub(super) fn abscissa(&self, event: Event) -> Abscissa {
        let approximate = self.lines.approximate_abscissa(event);
        Abscissa { event, rounded: approximate.rounded(), approximate, exact: OnceCell::new() }
    }

    /// Keeps a wall; returns its number.
    pub(super) fn add_wall(&mut self, abscissa: Abscissa) -> u32 {
        self.walls.push(abscissa);
        u32::try_from(self.walls.len() - 1).expect("memory ends long before the numbers of walls")
    }

    /// The abscissa of the wall with a number.
    pub(super) fn wall_abscissa(&self, wall: u32) -> &Abscissa {
        &self.walls[wall as usize]
    }

    /// The wall with a number, by lines of the input.
    pub(super) fn wall(&self, wall: u32) -> Wall {
        match self.walls[wall as usize].event {
            Event::Crossing(places) => {
                let mut lines = places.map(|place| self.lines.line_at(place));
                lines.sort_unstable();
                Wall::Through(lines)
            }
            Event::Vertical(position) => Wall::Along(self.lines.vertical_line_at(position)),
        }
    }

    /// Whether an abscissa lies strictly between two ends.
    pub(super) fn is_strictly_between(&self, x: &Abscissa, [left, right]: [End; 2]) -> bool {
        let compare = |end| match end {
            End::BeforeAll => Ordering::Greater,
            End::AfterAll => Ordering::Less,
            End::At(wall) => self.order_of_abscissas(x, &self.walls[wall as usize]),
        };
        compare(left).is_gt() && compare(right).is_lt()
    }

    /// The positions of those in a range of vertical lines that lie left of a wall, and of those right of it.
    pub(super) fn verticals_beside(&self, range: &Range<u32>, x: &Abscissa) -> [Range<u32>; 2] {
        if range.is_empty() {
            return [range.clone(), range.clone()];
        }
        let [before, up_to] = self.lines.verticals_up_to(self.exact(x)).map(|count| count as u32);
        [range.start..before.clamp(range.start, range.end), up_to.clamp(range.start, range.end)..range.end]
    }

    /// The order in height of the lines at two places along a wall, or towards the left or right end of the plane.
    #[inline]
    pub(super) fn order(&self, pair: [u32; 2], end: End) -> Ordering {
        let [a, b] = pair;
        if self.first_equal[a as usize] == self.first_equal[b as usize] {
            return Ordering::Equal;
        }
        match end {
            End::At(wall) => self.order_along(pair, &self.walls[wall as usize]),
            End::BeforeAll if !self.lines.are_parallel(pair) => b.cmp(&a),
            End::BeforeAll | End::AfterAll => a.cmp(&b),
        }
    }

    /// The order in height along a wall, of two different lines.
    #[inline]
    fn order_along(&self, pair: [u32; 2], x: &Abscissa) -> Ordering {
        match self.height_difference(pair, x).sign() {
            Some(sign) => sign.cmp(&0),
            None => self.precise_order(pair, x),
        }
    }

    /// How much higher the first of two lines is along a wall.
    #[inline]
    fn height_difference(&self, pair: [u32; 2], x: &Abscissa) -> Bounded {
        let [a, b] = pair.map(|place| self.graphs[place as usize]);
        (a.slope - b.slope) * x.rounded + (a.intercept - b.intercept)
    }

    /// The order in height along a wall, without the exact decision: equal where doubles leave a doubt, which is
    /// nearly always because lines meet there.
    #[inline]
    pub(super) fn probable_order(&self, [a, b]: [u32; 2], x: &Abscissa) -> Ordering {
        self.height_difference([a, b], x).sign().map_or(Ordering::Equal, |sign| sign.cmp(&0))
    }

    /// The same at an end.
    pub(super) fn probable_order_at(&self, pair: [u32; 2], end: End) -> Ordering {
        match end {
            End::At(wall) => self.probable_order(pair, &self.walls[wall as usize]),
            _ => self.order(pair, end),
        }
    }

    /// The abscissa, in one double, at which the lines at two places that are not parallel probably cross.
    pub(super) fn probable_crossing(&self, pair: [u32; 2]) -> f64 {
        let [a, b] = pair.map(|place| self.graphs[place as usize]);
        (b.intercept.value - a.intercept.value) / (a.slope.value - b.slope.value)
    }

    /// The height, in one double, of the line at a place at an abscissa that is one double.
    pub(super) fn probable_height(&self, place: u32, x: f64) -> f64 {
        let graph = self.graphs[place as usize];
        graph.slope.value * x + graph.intercept.value
    }

    fn precise_order(&self, pair: [u32; 2], x: &Abscissa) -> Ordering {
        let first_equal = |place: u32| self.first_equal[place as usize];
        if self.lines.are_parallel(pair) {
            return pair[0].cmp(&pair[1]);
        }
        if let Event::Crossing(through) = x.event {
            let (pair, through) = (pair.map(first_equal), through.map(first_equal));
            if pair == through || [pair[1], pair[0]] == through {
                return Ordering::Equal;
            }
        }
        let [[slope, intercept], [other_slope, other_intercept]] = pair.map(|place| self.lines.approximate_line(place));
        let difference = (slope - other_slope) * x.approximate + (intercept - other_intercept);
        if let Some(sign) = difference.sign() {
            return sign.cmp(&0);
        }
        self.count_exact_decision();
        let [first, second] = pair.map(|place| self.lines.scaled_height(place, self.exact(x)));
        first.cmp(&second)
    }

    fn order_of_abscissas(&self, a: &Abscissa, b: &Abscissa) -> Ordering {
        let rounded = (a.rounded - b.rounded).sign().map(|sign| sign.cmp(&0));
        rounded.or_else(|| a.approximate.certain_order(&b.approximate)).unwrap_or_else(|| {
            self.count_exact_decision();
            self.exact(a).cmp(self.exact(b))
        })
    }

    fn exact<'b>(&self, x: &'b Abscissa) -> &'b Fraction {
        x.exact.get_or_init(|| self.lines.abscissa(x.event))
    }

    fn count_exact_decision(&self) {
        self.exact_decisions.set(self.exact_decisions.get() + 1);
    }

    /// The point with homogeneous coordinates, the last of them positive.
    pub(super) fn point(&self, exact: [Dyadic; 3]) -> Point {
        let approximate = self.lines.approximate_point(&exact);
        Point { rounded: approximate.map(|v| v.rounded()), approximate, exact }
    }

    /// Whether a point lies right of a wall or on it.
    pub(super) fn is_right_of(&self, point: &Point, wall: u32) -> bool {
        let wall = &self.walls[wall as usize];
        if let Some(sign) = (point.rounded[0] - wall.rounded).sign() {
            return sign > 0;
        }
        let order = point.approximate[0].certain_order(&wall.approximate).unwrap_or_else(|| {
            let [x, _, w] = point.exact.clone();
            Fraction::new(x, w).cmp(self.exact(wall))
        });
        order.is_ge()
    }

    /// Whether a point lies above the line at a place or on it.
    pub(super) fn is_above(&self, point: &Point, place: u32) -> bool {
        let Graph { slope, intercept } = self.graphs[place as usize];
        let [x, y] = point.rounded;
        if let Some(sign) = (y - (slope * x + intercept)).sign() {
            return sign > 0;
        }
        let [slope, intercept] = self.lines.approximate_line(place);
        let [x, y] = point.approximate;
        let order = y.certain_order(&(slope * x + intercept)).unwrap_or_else(|| {
            let [x, y, w] = point.exact.clone();
            Fraction::new(y, Dyadic::one()).cmp(&self.lines.scaled_height(place, &Fraction::new(x, w)))
        });
        order.is_ge()
    }
}
