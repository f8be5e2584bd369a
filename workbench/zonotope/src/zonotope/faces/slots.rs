//! The moving meridian of the sweep: circles in slots from north to south, cells between them.

use super::circles::{Crossings, NEW_PLACE};
use super::lattice::FaceLattice;
use super::position::{Position, Step};

/// The next crossing of a circle.
#[derive(Clone, Copy)]
struct Next {
    /// The two northernmost circles through it: no other crossing of the half turn has both.
    name: (u32, u32),
    /// How many circles go through it.
    size: u32,
    /// Where the crossing after it begins in the circle's sequence.
    end: u32,
}

/// A crossing that the meridian can pass: the first of its slots, and how many there are.
#[derive(Clone, Copy)]
pub(super) struct Ready {
    slot: usize,
    size: usize,
}

pub(super) struct Slots<'a> {
    sequences: &'a [u32],
    zone_starts: &'a [u32],
    /// The rank of the circle in each slot.
    circles: Vec<u32>,
    /// The cell north of each slot, and the one south of the last.
    cells: Vec<u32>,
    /// Where the vertices of these cells are, relative to the body's centre.
    positions: Vec<Position>,
    /// By rank: the next crossing; the number of crossings passed; twice the generator.
    next: Vec<Next>,
    passed: Vec<u32>,
    steps: Vec<Step>,
    ready: Vec<Ready>,
    new_cell: u32,
}

impl<'a> Slots<'a> {
    /// The slots on the first meridian.
    pub(super) fn new(crossings: &'a Crossings, lattice: &FaceLattice) -> Self {
        let count = crossings.zone_starts.len() - 1;
        let steps = lattice.steps();
        let mut positions = vec![Position::north(&steps)];
        for step in &steps {
            positions.push(positions[positions.len() - 1].across(step));
        }
        let mut slots = Self {
            sequences: &crossings.sequences,
            zone_starts: &crossings.zone_starts,
            circles: (0..count as u32).collect(),
            cells: (0..=count as u32).map(|slot| lattice.unnumbered_cell(slot)).collect(),
            positions,
            next: Vec::with_capacity(count),
            passed: vec![0; count],
            steps,
            ready: Vec::new(),
            new_cell: 0,
        };
        slots.next = (0..count).map(|rank| slots.crossing_at(rank, 0)).collect();
        let mut slot = 0;
        while slot + 1 < count {
            let run = slots.run_around(slot);
            slot = run.slot + run.size;
            slots.ready.extend(slots.complete(run));
        }
        slots
    }

    pub(super) fn next_crossing(&mut self) -> Option<Ready> {
        self.ready.pop()
    }

    /// The cells along the meridian from the north pole to the south pole, and where the vertex of the first one is.
    pub(super) fn finish(self) -> (Vec<u32>, Position) {
        (self.cells, self.positions[0])
    }

    /// Moves the meridian past a crossing and writes down its facet.
    pub(super) fn pass(&mut self, Ready { slot, size }: Ready, lattice: &mut FaceLattice) {
        let facet = lattice.begin_facet(2 * size);
        let first_new = self.new_cell;
        self.new_cell += size as u32 - 1;
        for &cell in &self.cells[slot..=slot + size] {
            lattice.push_vertex(cell);
        }
        for cell in (first_new..self.new_cell).rev() {
            lattice.push_vertex(cell);
        }
        for (side, &rank) in self.circles[slot..slot + size].iter().enumerate() {
            let [before, after] = self.arcs_at_next(rank);
            lattice.set_edge(facet, side, before);
            lattice.set_edge(facet, size + side, after);
        }
        self.circles[slot..slot + size].reverse();
        for inner in 1..size {
            let cell = first_new + inner as u32 - 1;
            let position =
                self.positions[slot + inner - 1].across(&self.steps[self.circles[slot + inner - 1] as usize]);
            self.positions[slot + inner] = position;
            self.cells[slot + inner] = cell;
            lattice.set_vertex(cell, &position);
        }
        for place in slot..slot + size {
            let rank = self.circles[place] as usize;
            let arc = self.zone_starts[rank] + self.passed[rank];
            lattice.set_arc(arc, [self.cells[place + 1], self.cells[place]], facet);
            self.passed[rank] += 1;
            self.next[rank] = self.crossing_at(rank, self.next[rank].end);
        }
        if slot > 0 && self.agree(slot - 1) {
            let run = self.run_around(slot);
            self.ready.extend(self.complete(run));
        }
        if slot + size < self.circles.len() && self.agree(slot + size - 1) {
            let run = self.run_around(slot + size);
            self.ready.extend(self.complete(run));
        }
    }

    /// The arcs of a circle that its next crossing ends and begins, each with its opposite.
    #[inline]
    fn arcs_at_next(&self, rank: u32) -> [[u32; 2]; 2] {
        let [start, end] = [0, 1].map(|i| self.zone_starts[rank as usize + i]);
        let (passed, half) = (self.passed[rank as usize], (end - start) / 2);
        let after = start + passed;
        let before = if passed > 0 { [after - 1, after - 1 + half] } else { [end - 1, start + half - 1] };
        [before, [after, after + half]]
    }

    /// The crossing of a circle that begins at a place of its sequence.
    fn crossing_at(&self, rank: usize, begin: u32) -> Next {
        let count = self.zone_starts.len() - 2;
        let rest = &self.sequences[rank * count + begin as usize..(rank + 1) * count];
        let circle = rank as u32;
        let Some((&first, others)) = rest.split_first() else {
            return Next { name: (circle, circle), size: 1, end: begin };
        };
        let first = first & !NEW_PLACE;
        let more = others.iter().take_while(|&&other| other & NEW_PLACE == 0).count() as u32;
        let second = if more > 0 { others[0] } else { u32::MAX };
        let name = if circle < first { (circle, first) } else { (first, circle.min(second)) };
        Next { name, size: more + 2, end: begin + more + 1 }
    }

    /// Whether the circles in a slot and the one after it have their next crossing in common.
    fn agree(&self, slot: usize) -> bool {
        let [a, b] = [slot, slot + 1].map(|slot| self.next[self.circles[slot] as usize].name);
        a == b
    }

    /// The slots around one that agree with it.
    fn run_around(&self, slot: usize) -> Ready {
        let mut first = slot;
        while first > 0 && self.agree(first - 1) {
            first -= 1;
        }
        let mut last = slot;
        while last + 1 < self.circles.len() && self.agree(last) {
            last += 1;
        }
        Ready { slot: first, size: last - first + 1 }
    }

    /// The run, if all circles through its crossing are in it.
    fn complete(&self, run: Ready) -> Option<Ready> {
        let next = self.next[self.circles[run.slot] as usize];
        (run.size > 1 && next.size as usize == run.size).then_some(run)
    }
}
