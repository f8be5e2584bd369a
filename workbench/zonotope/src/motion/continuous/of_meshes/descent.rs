//! The descent: pairs of parts with stretches of time, the earliest of each pair first.

use std::rc::Rc;

use super::answer::{FreePair, MeshContact, Part};
use super::placed::Parts;
use super::sizes::MeshScene;
use super::slice::Slice;
use crate::bvh::BoundingVolume;
use crate::motion::continuous::by_control_points::{SHORT_STRETCH, directions};
use crate::motion::continuous::moving::{Moving, spans};
use crate::motion::continuous::parts::body::Body;
use crate::motion::continuous::scene::Hint;
use crate::motion::continuous::{FreeStretch, SeparatingDirection};
use crate::tally::{Operation, Tally};

/// The number of pairs with stretches that are looked at.
const PAIR_LIMIT: usize = 1 << 24;

/// A stretch of two nodes is halved where one of them goes farther than so many times the larger one's size, and a node
/// is opened where they go less far. The first number is of nodes whose volumes overlap at the middle, the second of
/// those that are apart there. Both were found by trial.
const LONGEST_WAYS: [f64; 2] = [4.0, 2.0];

/// Stretches of nodes are halved at most so many times without a proof of any pair of nodes; until there is one, nodes
/// are opened instead. Without this limit nodes that are points, or whose volumes rounding makes larger than a scene,
/// would be halved to the shortest stretches, as no way is short beside their sizes.
const VAIN_HALVINGS: u32 = 64;

/// A pair of parts and a stretch of time that is not decided yet.
pub(super) struct Open<'a, V: BoundingVolume> {
    pub(super) parts: [Part; 2],
    pub(super) slice: Rc<Slice<'a, V>>,
    /// Directions that separate the parts at the ends or near them, if they are known.
    pub(super) hints: [Hint; 2],
    /// Whether the parts are triangles that meet at the end.
    pub(super) meets: bool,
    /// The number of times that the stretch was cut off where the gap was expected to vanish.
    pub(super) cuts: u8,
}

/// Two times between which two triangles meet first, or between which neither was proved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Event {
    pub(super) time: [f64; 2],
    pub(super) triangles: [usize; 2],
    pub(super) is_contact: bool,
}

pub(super) struct Descent<'a, V: BoundingVolume> {
    pub(super) parts: [Parts<'a, V>; 2],
    pub(super) scene: &'a MeshScene<'a, V>,
    pub(super) resolution: f64,
    /// A pair met at this time, or is in doubt until then: later times do not matter.
    pub(super) limit: f64,
    events: Vec<Event>,
    pub(super) free: Vec<FreePair>,
    pub(super) open: Vec<Open<'a, V>>,
    /// The direction along which nodes were proved apart last: the next pair is near them.
    last: [f64; 3],
    /// The number of times that a stretch of nodes was halved since nodes were proved apart last.
    vain: u32,
}

impl<'a, V: BoundingVolume> Descent<'a, V> {
    pub(super) fn new(scene: &'a MeshScene<'a, V>, resolution: f64) -> Self {
        Self {
            parts: scene.hierarchies.map(|hierarchy| Parts::new(hierarchy, scene.exponent)),
            scene,
            resolution,
            limit: 1.0,
            events: Vec::new(),
            free: Vec::new(),
            open: Vec::new(),
            last: [1.0, 0.0, 0.0],
            vain: 0,
        }
    }

    pub(super) fn first_contact(mut self, tally: &mut dyn Tally) -> MeshContact {
        let whole = |times| Open {
            parts: [Part::Node(0); 2],
            slice: Slice::new(self.scene, times),
            hints: [None; 2],
            meets: false,
            cuts: 0,
        };
        self.open = spans(self.scene.motions()).into_iter().rev().map(whole).collect();
        for _ in 0..PAIR_LIMIT {
            let Some(pair) = self.open.pop() else { break };
            self.decide(pair, tally);
        }
        // what is left over is in doubt from its begin on
        let left = self.open.iter().filter(|pair| pair.slice.times[0] < self.limit);
        let doubt = |pair: &Open<'_, V>| {
            let triangles = self.first_triangles(pair.parts);
            Event { time: pair.slice.times, triangles, is_contact: false }
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

    /// Proves a pair free, opens it, or cuts its stretch.
    fn decide(&mut self, mut pair: Open<'a, V>, tally: &mut dyn Tally) {
        let [from, until] = pair.slice.times;
        if from >= self.limit {
            return;
        }
        if until > self.limit {
            let slice = pair.slice.until(self.limit);
            pair = Open { slice, hints: [pair.hints[0], None], meets: false, ..pair };
        }
        match pair.parts {
            [Part::Node(i), Part::Node(j)] => self.decide_nodes(pair, [i, j], tally),
            [Part::Triangle(i), Part::Triangle(j)] => self.decide_triangles(pair, [i, j], tally),
            _ => unreachable!("leaves are opened together"),
        }
    }

    /// Decides about two nodes. The test of their volumes where they stand at the middle comes first: it costs much
    /// less than a search for a direction, which is in vain where they overlap.
    fn decide_nodes(&mut self, pair: Open<'a, V>, nodes: [usize; 2], tally: &mut dyn Tally) {
        tally.add(Operation::NodeTest, 1);
        let slice = &pair.slice;
        if slice.are_apart(nodes) == Some(false) {
            return self.refine(pair, nodes, LONGEST_WAYS[0]);
        }
        let [Some(a), Some(b)] = [0, 1].map(|i| self.parts[i].body(nodes[i])) else {
            return self.open_nodes(&pair, nodes);
        };
        let moving = Moving::new([Body::of(&a), Body::of(&b)], self.scene.motions(), [0.0; 2]);
        let stretch = moving.stretch_of(slice.arcs.clone());
        let Some(u) = directions::in_space(&moving, &stretch, slice.times, self.last, tally) else {
            return self.refine(pair, nodes, LONGEST_WAYS[1]);
        };
        (self.last, self.vain) = (u, 0);
        let [from, until] = slice.times;
        let direction = SeparatingDirection::Space(u);
        self.free.push(FreePair { parts: pair.parts, stretch: FreeStretch { from, until, direction } });
    }

    /// Halves a stretch on which the nodes go far, or else opens a node. Where it is not known how far they go, shorter
    /// stretches would not tell it either.
    fn refine(&mut self, pair: Open<'a, V>, nodes: [usize; 2], far: f64) {
        let sizes = [0, 1].map(|i| self.parts[i].size(nodes[i]));
        let way = self.parts[1].body(nodes[1]).and_then(|body| pair.slice.way_of(&body.center(), sizes[1]));
        let may_be_halved = self.vain < VAIN_HALVINGS && pair.slice.width() > SHORT_STRETCH;
        if may_be_halved && way.is_some_and(|way| way > far * sizes[0].max(sizes[1])) {
            self.vain += 1;
            self.cut(&pair, pair.slice.middle(), [None; 2]);
        } else {
            self.open_nodes(&pair, nodes);
        }
    }

    /// Takes both parts of a stretch, the first one next, with the directions that separate the pair at the cut or
    /// prove what is before it, if they are known.
    pub(super) fn cut(&mut self, pair: &Open<'a, V>, time: f64, [before, at]: [Hint; 2]) {
        let Open { parts, ref slice, hints: [first, last], meets, cuts } = *pair;
        let [earlier, later] = slice.cut_at(time);
        self.open.push(Open { parts, slice: later, hints: [at.or(first), last], meets, cuts });
        self.open.push(Open { parts, slice: earlier, hints: [before.or(first), at.or(last)], meets: false, cuts: 0 });
    }

    /// Opens the larger one of two nodes, and two leaves together.
    fn open_nodes(&mut self, pair: &Open<'a, V>, nodes: [usize; 2]) {
        let mut open = |parts: [Part; 2]| {
            let Open { ref slice, hints, .. } = *pair;
            self.open.push(Open { parts, slice: slice.clone(), hints, meets: false, cuts: 0 });
        };
        let sizes = [0, 1].map(|i| self.parts[i].size(nodes[i]));
        let children = [0, 1].map(|i| self.parts[i].children(nodes[i]));
        let opened = match children {
            [None, None] => {
                let [rows, columns] = [0, 1].map(|i| self.parts[i].triangles(nodes[i]));
                for &row in rows.iter().rev() {
                    columns.iter().rev().for_each(|&column| open([row, column].map(|t| Part::Triangle(t as usize))));
                }
                return;
            }
            [Some(_), None] => 0,
            [None, Some(_)] => 1,
            [Some(_), Some(_)] => usize::from(sizes[1] > sizes[0]),
        };
        for child in children[opened].into_iter().flatten().rev() {
            let mut parts = pair.parts;
            parts[opened] = Part::Node(child);
            open(parts);
        }
    }

    /// Keeps an event. After a contact nothing matters, and after a doubt what is farther off than the resolution.
    pub(super) fn note(&mut self, event: Event) {
        let [from, until] = event.time;
        let limit = if event.is_contact { until } else { until.max(from + self.resolution) };
        self.limit = self.limit.min(limit);
        self.events.push(event);
    }

    /// A pair of triangles of two parts.
    fn first_triangles(&self, parts: [Part; 2]) -> [usize; 2] {
        [0, 1].map(|i| match parts[i] {
            Part::Triangle(triangle) => triangle,
            Part::Node(node) => self.parts[i].triangles(node)[0] as usize,
        })
    }
}
