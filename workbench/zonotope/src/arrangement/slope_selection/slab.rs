//! The open strip between two vertical lines: how many vertices it holds, and where it can be cut.
//!
//! Two lines cross strictly within the strip iff their order just right of its left end differs from their order just
//! left of its right end, so the crossings are the inversions between the two orders. A vertical line within the strip
//! adds one vertex for each line that is not vertical.

use std::ops::Range;
use std::rc::Rc;

use super::inversions;
use crate::arrangement::exact_sort::Keyed;
use crate::arrangement::fraction::Fraction;
use crate::arrangement::lines::{Event, LineArrangement, VerticalOrder};
use crate::tally::Tally;

/// The vertices strictly between two vertical lines.
#[derive(Debug, Clone)]
pub(crate) struct Slab {
    /// The places from bottom to top just right of the left end.
    start: Rc<[u32]>,
    /// The places from bottom to top just left of the right end.
    end: Rc<[u32]>,
    /// How many pairs of lines that are not vertical cross within.
    crossings: u64,
    /// The vertical lines within.
    verticals: Range<usize>,
}

/// A vertical line through a slab.
pub(crate) struct Cut {
    pub(crate) order: VerticalOrder,
    /// How many pairs cross left of it and on it.
    crossings: [u64; 2],
    /// How many vertical lines of the arrangement lie left of it, and left of it or on it.
    pub(crate) verticals: [usize; 2],
    /// How many vertices of the slab lie left of it.
    pub(crate) left: u64,
    /// How many vertices of the slab lie on it.
    pub(crate) at: u64,
}

impl Slab {
    /// The whole plane.
    pub(crate) fn whole(arrangement: &LineArrangement) -> Self {
        let (places, verticals) = (arrangement.place_count() as u64, arrangement.vertical_count());
        Self {
            start: arrangement.order_before_all().into(),
            end: arrangement.order_after_all().into(),
            crossings: arrangement.vertex_count() - places * verticals as u64,
            verticals: 0..verticals,
        }
    }

    /// A slab without vertices.
    pub(crate) fn empty() -> Self {
        Self { start: Rc::new([]), end: Rc::new([]), crossings: 0, verticals: 0..0 }
    }

    fn place_count(&self) -> u64 {
        self.start.len() as u64
    }

    /// How many vertices lie within.
    pub(crate) fn vertex_count(&self) -> u64 {
        self.crossings + self.verticals.len() as u64 * self.place_count()
    }

    /// How many events lie within: a vertical line counts once.
    pub(super) fn event_count(&self) -> u64 {
        self.crossings + self.verticals.len() as u64
    }

    /// How many vertices an event stands for.
    pub(super) fn multiplicity(&self, event: Event) -> u64 {
        match event {
            Event::Crossing(_) => 1,
            Event::Vertical(_) => self.place_count(),
        }
    }

    /// The places of the end in terms of the start: its inversions are the crossings within.
    fn sequence(&self) -> Vec<u32> {
        let mut rank = vec![0; self.start.len()];
        for (position, &place) in (0..).zip(&*self.start) {
            rank[place as usize] = position;
        }
        self.end.iter().map(|&place| rank[place as usize]).collect()
    }

    fn crossing(&self, inversion: [u32; 2]) -> Event {
        Event::Crossing(inversion.map(|position| self.start[position as usize]))
    }

    /// The events of the vertices with the given ranks, which ascend, in an order without meaning. O(n log n) for n
    /// ranks.
    pub(super) fn pick(&self, ranks: &[u64], tally: &mut impl Tally) -> Vec<Event> {
        let (crossings, verticals) = ranks.split_at(ranks.partition_point(|&rank| rank < self.crossings));
        let inversions = inversions::pick(&mut self.sequence(), crossings.iter().copied(), tally);
        let position = |rank: u64| self.verticals.start as u64 + (rank - self.crossings) / self.place_count();
        let verticals = verticals.iter().map(|&rank| Event::Vertical(position(rank) as u32));
        inversions.into_iter().map(|inversion| self.crossing(inversion)).chain(verticals).collect()
    }

    /// All events within. O(n log n + k) for k of them.
    pub(super) fn events(&self, tally: &mut impl Tally) -> Vec<Event> {
        let inversions = inversions::list(&mut self.sequence(), tally);
        let verticals = self.verticals.clone().map(|position| Event::Vertical(position as u32));
        inversions.into_iter().map(|inversion| self.crossing(inversion)).chain(verticals).collect()
    }

    /// Cuts the slab at an abscissa within. O(n log n).
    pub(crate) fn cut(&self, arrangement: &LineArrangement, x: &Fraction, tally: &mut impl Tally) -> Cut {
        let order = arrangement.order_at(x, tally);
        let verticals = arrangement.verticals_up_to(x);
        let mut cut = Cut { crossings: [0, order.crossings(arrangement)], order, verticals, left: 0, at: 0 };
        let mut left = self.left_of(arrangement, &cut);
        left.crossings = inversions::count(&mut left.sequence(), tally);
        cut.crossings[0] = left.crossings;
        cut.left = left.vertex_count();
        cut.at = cut.crossings[1] + (verticals[1] - verticals[0]) as u64 * self.place_count();
        cut
    }

    /// The part left of a cut.
    pub(crate) fn left_of(&self, arrangement: &LineArrangement, cut: &Cut) -> Self {
        Self {
            start: Rc::clone(&self.start),
            end: cut.order.just_left(arrangement).into(),
            crossings: cut.crossings[0],
            verticals: self.verticals.start..cut.verticals[0],
        }
    }

    /// The part right of a cut.
    pub(crate) fn right_of(&self, cut: &Cut) -> Self {
        Self {
            start: cut.order.just_right().into(),
            end: Rc::clone(&self.end),
            crossings: self.crossings - cut.crossings[0] - cut.crossings[1],
            verticals: cut.verticals[1]..self.verticals.end,
        }
    }
}

/// Events with their approximate abscissas, for sorting.
pub(super) fn keyed(arrangement: &LineArrangement, events: &[Event]) -> Vec<Keyed> {
    (0..).zip(events).map(|(item, &event)| Keyed { key: arrangement.approximate_abscissa(event), item }).collect()
}
