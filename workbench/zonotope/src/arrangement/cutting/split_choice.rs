//! Where to cut a cell: the best of a few walls and of the lines that lead through, as a sample of its lines tells.
//!
//! The cost of a choice is the number of trapezoids that the two parts will probably come to. A cell with k lines, of
//! which most pairs cross within it, takes about (k / limit)² trapezoids, whatever its shape, so the costs of both
//! parts are added up. A wall is good for a wide cell, a line for a high one, and the cells that come out are as wide
//! as they are high, measured in lines: those have the most area for the lines that cross their boundary.
//!
//! The choice decides how many trapezoids there are, never whether the cutting is right, so that all is done in doubles
//! here but for two conditions: a wall lies strictly within the cell, a line leads through. There is always a choice,
//! since a line that crosses the cell and does not lead through leaves by the bottom or the top between the ends.

use std::cmp::Ordering;

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use super::cell::{Cell, CrossingLine};
use super::plane::{Abscissa, Plane};
use crate::arrangement::lines::Event;

/// At most this many lines of a cell are looked at: as many as an integer has bits.
const SAMPLE_SIZE: usize = u32::BITS as usize;

/// At most this many pairs of them are tried for a crossing within the cell.
const SAMPLED_PAIRS: usize = 2 * SAMPLE_SIZE;

/// The cost of a part that needs no further cut.
const COST_OF_LIGHT_CELL: f64 = 0.5;

/// What a cell is cut along.
pub(super) enum Split {
    /// A wall, strictly between the ends of the cell.
    Wall(Abscissa),
    /// The line at a place, which leads through the cell.
    Line(u32),
}

/// A choice that was assessed.
struct Candidate {
    cost: f64,
    split: Split,
}

/// Some of the lines of a cell, one bit for each in the sets below.
struct Sample<'a> {
    plane: &'a Plane<'a>,
    cell: &'a Cell,
    lines: Vec<CrossingLine>,
    /// How many lines of the cell stand behind one of the sample.
    share: f64,
    /// The lines at or below the bottom, at the left and at the right end.
    below_bottom: [u32; 2],
    /// The lines at or above the top, at the left and at the right end.
    above_top: [u32; 2],
    /// The rank in height of each line at the left and at the right end; lines that meet there have equal ranks.
    ranks: [[u32; SAMPLE_SIZE]; 2],
    limit: usize,
}

/// The best cut of a cell that more than `limit` lines cross.
pub(super) fn choose(plane: &Plane, cell: &Cell, limit: usize, random: &mut Pcg64Mcg) -> Split {
    let sample = Sample::draw(plane, cell, limit, random);
    let mut best: Option<Candidate> = None;
    let walls = sample.walls(random).into_iter().filter_map(|event| sample.assess_wall(event));
    let lines = (0..sample.lines.len()).filter_map(|line| sample.assess_line(line));
    for candidate in walls.chain(lines) {
        if best.as_ref().is_none_or(|best| candidate.cost < best.cost) {
            best = Some(candidate);
        }
    }
    best.expect("a line leads through the cell or leaves it between the ends, and vertical lines are walls").split
}

/// The set of the positions for which a predicate holds.
fn set_of(count: usize, mut holds: impl FnMut(usize) -> bool) -> u32 {
    (0..count).fold(0, |set, i| set | u32::from(holds(i)) << i)
}

/// The median of a list and what stands an eighth of it before and behind; all of a short one.
///
/// Candidates farther out make worse cuttings: one part becomes light, and the other stays what it was.
fn central_items<T: Copy>(sorted: &[T]) -> Vec<T> {
    if sorted.len() <= 3 {
        return sorted.to_vec();
    }
    [4, 3, 5].map(|eighths| sorted[(sorted.len() as u64 * eighths / 8) as usize]).to_vec()
}

impl<'a> Sample<'a> {
    fn draw(plane: &'a Plane<'a>, cell: &'a Cell, limit: usize, random: &mut Pcg64Mcg) -> Self {
        let all = &cell.crossing;
        let count = all.len().min(SAMPLE_SIZE);
        let bound = |i: usize| (i as u64 * all.len() as u64 / count as u64) as usize;
        let lines: Vec<CrossingLine> = (0..count)
            .map(|i| {
                let stratum = bound(i)..bound(i + 1);
                if stratum.len() == 1 { all[stratum.start] } else { all[random.random_range(stratum)] }
            })
            .collect();
        let set = |holds: &dyn Fn(&CrossingLine) -> bool| set_of(count, |i| holds(&lines[i]));
        let below_bottom = [0, 1].map(|side| set(&|line| line.to_bottom[side].is_le()));
        let above_top = [0, 1].map(|side| set(&|line| line.to_top[side].is_ge()));
        let ranks = cell.ends.map(|end| {
            let order = |&a: &usize, &b: &usize| plane.probable_order_at([lines[a].place, lines[b].place], end);
            let mut sorted: Vec<usize> = (0..count).collect();
            // rounding may leave the order without a meaning where lines meet, so the sort must not rely on one
            insertion_sort(&mut sorted, order);
            let mut ranks = [0; SAMPLE_SIZE];
            for pair in sorted.windows(2) {
                ranks[pair[1]] = ranks[pair[0]] + u32::from(order(&pair[0], &pair[1]).is_ne());
            }
            ranks
        });
        let share = if count == 0 { 0.0 } else { all.len() as f64 / count as f64 };
        Self { plane, cell, lines, share, below_bottom, above_top, ranks, limit }
    }

    /// Walls that may be good: near the medians of the crossings within the cell, of the places where lines leave it by
    /// the bottom or the top, and of the vertical lines.
    fn walls(&self, random: &mut Pcg64Mcg) -> Vec<Event> {
        let mut crossings: Vec<(f64, Event)> =
            self.pairs(random).filter_map(|pair| self.crossing_within(pair)).collect();
        let mut exits: Vec<(f64, Event)> = self.lines.iter().flat_map(|line| self.exits(line)).collect();
        let verticals: Vec<Event> = self.cell.verticals.clone().map(Event::Vertical).collect();
        for events in [&mut crossings, &mut exits] {
            events.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        }
        let central_events =
            |sorted: &[(f64, Event)]| central_items(sorted).into_iter().map(|(_, event)| event).collect();
        let groups: [Vec<Event>; 3] = [central_events(&crossings), central_events(&exits), central_items(&verticals)];
        groups.concat()
    }

    /// All pairs of the sample, or so many at random.
    fn pairs(&self, random: &mut Pcg64Mcg) -> impl Iterator<Item = [usize; 2]> + use<> {
        let count = self.lines.len();
        let pairs: Vec<[usize; 2]> = if count * count.saturating_sub(1) / 2 <= SAMPLED_PAIRS {
            (0..count).flat_map(|j| (0..j).map(move |i| [i, j])).collect()
        } else {
            (0..SAMPLED_PAIRS).map(|_| [0; 2].map(|_| random.random_range(0..count))).collect()
        };
        pairs.into_iter()
    }

    /// Where two lines of the sample cross, if that is probably within the cell.
    fn crossing_within(&self, pair: [usize; 2]) -> Option<(f64, Event)> {
        let [first, second] = pair;
        let at = |side: usize| self.ranks[side][first].cmp(&self.ranks[side][second]);
        let places = pair.map(|i| self.lines[i].place);
        if at(0) == at(1) || at(0).is_eq() || at(1).is_eq() || self.plane.lines.are_parallel(places) {
            return None;
        }
        let x = self.plane.probable_crossing(places);
        let height = |place| self.plane.probable_height(place, x);
        let is_outside = self.cell.bottom.is_some_and(|bottom| height(places[0]) < height(bottom))
            || self.cell.top.is_some_and(|top| height(places[0]) > height(top));
        (!is_outside).then_some((x, Event::Crossing(places)))
    }

    /// Where a line leaves the cell by the bottom or the top, strictly between the ends.
    fn exits(&self, line: &CrossingLine) -> impl Iterator<Item = (f64, Event)> {
        let bottom = self.cell.bottom.filter(|_| changes_sides(line.to_bottom));
        let top = self.cell.top.filter(|_| changes_sides(line.to_top));
        let place = line.place;
        let exit = move |side| (self.plane.probable_crossing([place, side]), Event::Crossing([place, side]));
        bottom.into_iter().chain(top).map(exit)
    }

    /// The cost of the two parts beside a wall; none if it is not strictly within the cell.
    fn assess_wall(&self, event: Event) -> Option<Candidate> {
        let x = self.plane.abscissa(event);
        if !self.plane.is_strictly_between(&x, self.cell.ends) {
            return None;
        }
        let meets = |pair: [u32; 2]| match event {
            Event::Crossing(through) => through == pair,
            Event::Vertical(_) => false,
        };
        let order = |line: usize, side: u32| {
            let pair = [self.lines[line].place, side];
            if meets(pair) { Ordering::Equal } else { self.plane.probable_order(pair, &x) }
        };
        let side = |side: Option<u32>, holds: fn(Ordering) -> bool| {
            side.map_or(0, |side| set_of(self.lines.len(), |line| holds(order(line, side))))
        };
        let below = side(self.cell.bottom, Ordering::is_le);
        let above = side(self.cell.top, Ordering::is_ge);
        let beside = self.plane.verticals_beside(&self.cell.verticals, &x);
        let cost = |end: usize| {
            let outside = (self.below_bottom[end] & below) | (self.above_top[end] & above);
            self.cost(outside, beside[end].len())
        };
        Some(Candidate { cost: cost(0) + cost(1), split: Split::Wall(x) })
    }

    /// The cost of the two parts beside a line of the sample; none if it does not lead through the cell.
    fn assess_line(&self, line: usize) -> Option<Candidate> {
        if !self.lines[line].leads_through() {
            return None;
        }
        let set = |holds: fn(&u32, &u32) -> bool| {
            let at = |side: usize| {
                let ranks = &self.ranks[side];
                set_of(self.lines.len(), |other| holds(&ranks[other], &ranks[line]))
            };
            at(0) & at(1)
        };
        let (above, below) = (set(u32::ge), set(u32::le));
        let verticals = self.cell.verticals.len();
        let [below_bottom, above_top] = [self.below_bottom, self.above_top].map(|[left, right]| left & right);
        let cost = self.cost(below_bottom | above, verticals) + self.cost(above_top | below, verticals);
        Some(Candidate { cost, split: Split::Line(self.lines[line].place) })
    }

    /// The number of trapezoids that a part will probably come to, given the lines of the sample that do not cross it
    /// and the number of vertical lines that do.
    fn cost(&self, outside: u32, verticals: usize) -> f64 {
        let crossing = self.lines.len() as u32 - outside.count_ones();
        let weight = self.share * f64::from(crossing) + verticals as f64;
        let limit = self.limit as f64;
        if weight <= limit {
            return COST_OF_LIGHT_CELL;
        }
        let parts = weight / limit.max(1.0);
        parts * parts
    }
}

/// Whether a line crosses a side of the cell strictly between the ends.
fn changes_sides([left, right]: [Ordering; 2]) -> bool {
    left.is_ne() && right.is_ne() && left != right
}

/// Sorts a few items by an order that need not be transitive; where it is, the result is sorted.
fn insertion_sort<T>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering) {
    for end in 1..items.len() {
        for i in (1..=end).rev() {
            if order(&items[i - 1], &items[i]).is_le() {
                break;
            }
            items.swap(i - 1, i);
        }
    }
}
