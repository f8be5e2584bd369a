//! Two triangles on a stretch of time: proved free by a direction, cut, or proved to meet.

use super::answer::FreePair;
use super::descent::{Descent, Event, Open};
use super::placed::meet;
use crate::bvh::BoundingVolume;
use crate::motion::constant_rate::Timing;
use crate::motion::continuous::by_control_points::{SHORTEST_STRETCH, approach, directions};
use crate::motion::continuous::moving::Moving;
use crate::motion::continuous::parts::body::Body;
use crate::motion::continuous::simplex_search::Outcome;
use crate::motion::continuous::{FreeStretch, SeparatingDirection};
use crate::tally::{Operation, Tally};

impl<'a, V: BoundingVolume> Descent<'a, V> {
    /// Decides about two triangles.
    pub(super) fn decide_triangles(&mut self, pair: Open<'a, V>, triangles: [usize; 2], tally: &mut dyn Tally) {
        tally.add(Operation::TriangleTest, 1);
        let times @ [from, until] = pair.slice.times;
        let corners = [0, 1].map(|i| self.parts[i].corners(triangles[i]));
        let moving = Moving::new(corners.each_ref().map(|c| Body::hull_of(c)), self.scene.motions(), [0.0; 2]);
        let hint = pair.hints.iter().flatten().find_map(SeparatingDirection::fixed_in_space);
        let search = |time: f64, tally: &mut dyn Tally| moving.search_at(time, hint, tally);
        let middle = pair.slice.middle();
        let at_middle = match pair.slice.poses() {
            Some(poses) => moving.search_placed(poses, hint, tally),
            None => Outcome::Undecided,
        };
        // parts that overlap at the middle have no direction
        if at_middle != Outcome::Inside && !pair.meets {
            let before = self.free.last().filter(|free| free.parts == pair.parts).map(|free| free.stretch.direction);
            let known = [at_middle.found().or(pair.hints[1]), pair.hints[0], before];
            let stretch = moving.stretch_of(pair.slice.arcs.clone());
            let direction = directions::separating(&moving, &stretch, times, &known, tally)
                .or_else(|| directions::of_edges(&moving, &stretch, times, &known, tally));
            if let Some(direction) = direction {
                return self.free.push(FreePair { parts: pair.parts, stretch: FreeStretch { from, until, direction } });
            }
        }
        let width = pair.slice.width();
        let is_begin = from == 0.0 || self.scene.motions().iter().any(|motion| motion.breaks().any(|t| t == from));
        if is_begin && self.meet(triangles, times, 0, tally) {
            return self.note(Event { time: [from; 2], triangles, is_contact: true });
        }
        if pair.meets && width <= self.resolution {
            return self.note(Event { time: times, triangles, is_contact: true });
        }
        if width <= SHORTEST_STRETCH && !pair.meets {
            let is_contact = width <= self.resolution && self.meet(triangles, times, 1, tally);
            return self.note(Event { time: times, triangles, is_contact });
        }
        // the time before which a direction that separates the triangles at the begin keeps a gap, now and then
        let latest = (pair.cuts % 3 < 2)
            .then(|| pair.hints[0].or_else(|| search(from, tally).found()))
            .flatten()
            .and_then(|hint| approach::latest_gap(&moving, times, &hint, self.resolution, tally));
        let (time, found) = match latest {
            Some((time, _)) => (time, search(time, tally).found()),
            None => (middle, at_middle.found()),
        };
        let pair = Open { cuts: pair.cuts.wrapping_add(1), ..pair };
        if found.is_none() && self.meet(triangles, [from, time], 1, tally) {
            self.limit = self.limit.min(time);
            let [slice, _] = pair.slice.cut_at(time);
            return self.open.push(Open { slice, hints: [pair.hints[0], None], meets: true, ..pair });
        }
        self.cut(&pair, time, [latest.map(|(_, direction)| direction), found]);
    }

    /// Whether two triangles meet at an end of a stretch, exactly.
    fn meet(&self, triangles: [usize; 2], times: [f64; 2], end: usize, tally: &mut dyn Tally) -> bool {
        tally.add(Operation::ExactFallback, 1);
        let arcs = self.scene.motions().map(|motion| motion.exact_arc(times, Timing::Timed));
        meet(self.parts.each_ref(), triangles, &arcs, end)
    }
}
