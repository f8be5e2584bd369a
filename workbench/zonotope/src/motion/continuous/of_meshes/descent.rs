//! The descent: pairs of parts with stretches of time, the earliest of each pair first.

use super::answer::{FreePair, MeshContact, Part};
use super::placed::{Parts, meet};
use crate::bvh::{BoundingVolume, Bvh};
use crate::motion::Motion;
use crate::motion::constant_rate::Clock;
use crate::motion::continuous::by_control_points::{SHORT_STRETCH, SHORTEST_STRETCH, directions};
use crate::motion::continuous::moving::Moving;
use crate::motion::continuous::scene::Apart;
use crate::motion::continuous::simplex_search::Search;
use crate::motion::continuous::{FreeStretch, SeparatingDirection};
use crate::tally::{Operation, Tally};

/// The number of pairs with stretches that are looked at.
const PAIR_LIMIT: usize = 1 << 24;

/// A pair of parts and a stretch of time that is not decided yet.
struct Open {
    parts: [Part; 2],
    times: [f64; 2],
    /// Directions that separate the parts at the ends or near them, if they are known.
    hints: [Apart; 2],
    /// Whether the parts are triangles that meet at the end.
    meets: bool,
}

/// Two times between which two triangles meet first, or between which neither was proved.
#[derive(Debug, Clone, Copy)]
struct Event {
    time: [f64; 2],
    triangles: [usize; 2],
    is_contact: bool,
}

pub(super) struct Descent<'a, V> {
    parts: [Parts<'a, V>; 2],
    motions: [&'a Motion; 2],
    resolution: f64,
    /// A pair met at this time, or is in doubt until then: later times do not matter.
    limit: f64,
    events: Vec<Event>,
    free: Vec<FreePair>,
    open: Vec<Open>,
}

impl<'a, V: BoundingVolume> Descent<'a, V> {
    pub(super) fn new(hierarchies: [&'a Bvh<V>; 2], motions: [&'a Motion; 2], resolution: f64) -> Self {
        Self {
            parts: hierarchies.map(Parts::new),
            motions,
            resolution,
            limit: 1.0,
            events: Vec::new(),
            free: Vec::new(),
            open: Vec::new(),
        }
    }

    pub(super) fn first_contact(mut self, tally: &mut dyn Tally) -> MeshContact {
        let mut times: Vec<f64> = self.motions.iter().flat_map(|motion| motion.breaks()).chain([0.0, 1.0]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let root = [Part::Node(0); 2];
        let stretches = times.windows(2).rev().map(|pair| [pair[0], pair[1]]);
        self.open = stretches.map(|times| Open { parts: root, times, hints: [None; 2], meets: false }).collect();
        for _ in 0..PAIR_LIMIT {
            let Some(pair) = self.open.pop() else { break };
            self.decide(pair, tally);
        }
        // what is left over is in doubt from its begin on
        let left = self.open.iter().filter(|pair| pair.times[0] < self.limit);
        let doubt = |pair: &Open| {
            let triangles = self.first_triangles(pair.parts);
            Event { time: pair.times, triangles, is_contact: false }
        };
        let doubts: Vec<Event> = left.map(doubt).collect();
        self.events.extend(doubts);
        self.answer()
    }

    fn answer(mut self) -> MeshContact {
        let in_order = |a: &Event, b: &Event| a.time[0].total_cmp(&b.time[0]).then(b.is_contact.cmp(&a.is_contact));
        let Some(earliest) = self.events.iter().copied().min_by(in_order) else {
            return MeshContact::Separate { free: self.free };
        };
        // neighbouring triangles share the edge that meets first: one pair may prove what another leaves in doubt
        let begin = earliest.time[0];
        let is_near = |event: &&Event| event.is_contact && event.time[1] - begin <= self.resolution;
        let proved = self.events.iter().filter(is_near).min_by(|a, b| in_order(a, b));
        let decided = proved.map(|event| Event { time: [begin, event.time[1]], ..*event });
        let Event { time, triangles, is_contact } = decided.unwrap_or(earliest);
        self.free.retain(|pair| pair.stretch.from < begin);
        match is_contact {
            true => MeshContact::Contact { free: self.free, time, triangles },
            false => MeshContact::Grazing { free: self.free, time, triangles },
        }
    }

    /// Proves a pair free, opens it, or cuts its stretch in halves.
    fn decide(&mut self, mut pair: Open, tally: &mut dyn Tally) {
        let [from, until] = pair.times;
        if from >= self.limit {
            return;
        }
        if until > self.limit {
            pair = Open { times: [from, self.limit], hints: [pair.hints[0], None], meets: false, ..pair };
        }
        let triangles = match pair.parts {
            [Part::Triangle(i), Part::Triangle(j)] => Some([i, j]),
            _ => None,
        };
        tally.add(if triangles.is_some() { Operation::TriangleTest } else { Operation::NodeTest }, 1);
        let bodies = [0, 1].map(|i| self.parts[i].body(pair.parts[i]));
        let [Some(a), Some(b)] = bodies else { return self.open_larger(&pair) };
        let moving = Moving::new([a, b], self.motions, [0.0; 2]);
        let [from, until] = pair.times;
        let middle = from + (until - from) / 2.0;
        let hint = pair.hints.iter().flatten().find_map(SeparatingDirection::fixed_in_space);
        let look = moving.looked_at(middle, hint, tally);
        let found = match look {
            Search::Found(u) => Some(SeparatingDirection::Space(u)),
            Search::Inside | Search::Undecided => None,
        };
        // parts that overlap at the middle have no direction
        if look != Search::Inside && !pair.meets {
            let before = self.free.last().filter(|free| free.parts == pair.parts).map(|free| free.stretch.direction);
            let known = [found.or(pair.hints[1]), pair.hints[0], before];
            let stretch = moving.rounded_stretch(pair.times);
            let direction = directions::separating(&moving, &stretch, pair.times, &known, tally)
                .or_else(|| directions::of_edges(&moving, &stretch, pair.times, &known, tally));
            if let Some(direction) = direction {
                return self.free.push(FreePair { parts: pair.parts, stretch: FreeStretch { from, until, direction } });
            }
        }
        match triangles {
            Some(triangles) => self.halve_triangles(&pair, triangles, found, tally),
            None if found.is_some() && until - from > SHORT_STRETCH => self.halve(&pair, middle, found),
            None => self.open_larger(&pair),
        }
    }

    /// Takes both halves of a stretch, the first one next.
    fn halve(&mut self, pair: &Open, middle: f64, found: Apart) {
        let Open { parts, times: [from, until], hints: [first, last], meets } = *pair;
        self.open.push(Open { parts, times: [middle, until], hints: [found.or(first), last], meets });
        self.open.push(Open { parts, times: [from, middle], hints: [first, found.or(last)], meets: false });
    }

    /// Opens the larger one of two nodes.
    fn open_larger(&mut self, pair: &Open) {
        let [a, b] = [0, 1].map(|i| self.parts[i].size(pair.parts[i]));
        let opened = usize::from(b > a);
        for part in self.parts[opened].opened(pair.parts[opened]).into_iter().rev() {
            let mut parts = pair.parts;
            parts[opened] = part;
            self.open.push(Open { parts, meets: false, ..*pair });
        }
    }

    /// Decides about two triangles that no direction was found for.
    fn halve_triangles(&mut self, pair: &Open, triangles: [usize; 2], found: Apart, tally: &mut dyn Tally) {
        let [from, until] = pair.times;
        let (width, middle) = (until - from, from + (until - from) / 2.0);
        let is_begin = from == 0.0 || self.motions.iter().any(|motion| motion.breaks().any(|time| time == from));
        if is_begin && self.meet(triangles, pair.times, 0, tally) {
            return self.note(Event { time: [from; 2], triangles, is_contact: true });
        }
        if pair.meets && width <= self.resolution {
            return self.note(Event { time: pair.times, triangles, is_contact: true });
        }
        if width <= SHORTEST_STRETCH && !pair.meets {
            let is_contact = width <= self.resolution && self.meet(triangles, pair.times, 1, tally);
            return self.note(Event { time: pair.times, triangles, is_contact });
        }
        if found.is_none() && self.meet(triangles, [from, middle], 1, tally) {
            self.limit = self.limit.min(middle);
            let Open { parts, hints, .. } = *pair;
            return self.open.push(Open { parts, times: [from, middle], hints: [hints[0], None], meets: true });
        }
        self.halve(pair, middle, found);
    }

    /// Whether two triangles meet at an end of a stretch, exactly.
    fn meet(&self, triangles: [usize; 2], times: [f64; 2], end: usize, tally: &mut dyn Tally) -> bool {
        tally.add(Operation::ExactFallback, 1);
        let arcs = self.motions.map(|motion| motion.exact_arc(times, Clock::Kept));
        meet(self.parts.each_ref(), triangles, &arcs, end)
    }

    /// Keeps an event. After a contact nothing matters, and after a doubt what is farther off than the resolution.
    fn note(&mut self, event: Event) {
        let [from, until] = event.time;
        let limit = if event.is_contact { until } else { until.max(from + self.resolution) };
        self.limit = self.limit.min(limit);
        self.events.push(event);
    }

    /// A pair of triangles of two parts.
    fn first_triangles(&self, parts: [Part; 2]) -> [usize; 2] {
        [0, 1].map(|i| {
            let mut part = parts[i];
            loop {
                match part {
                    Part::Triangle(triangle) => return triangle,
                    Part::Node(_) => part = self.parts[i].opened(part)[0],
                }
            }
        })
    }
}
