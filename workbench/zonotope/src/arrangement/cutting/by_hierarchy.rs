//! A (1/r)-cutting of lines in the plane, by cutting the plane in two again and again until few lines cross a part.
//!
//! # Statement
//! Input: n lines ([`LineArrangement`]), r from 1, a seed. Output: trapezoids that cover the plane without overlap,
//! each crossed in its interior by at most n / r lines, with these lines and with a search structure ([`Cutting`]).
//! Sides lie along lines of the input, walls go through vertices of the arrangement or along vertical lines. Parallel,
//! equal, concurrent and vertical lines are ordinary input; lines along the sides do not cross, and neither do equal
//! ones. With r = 1 there is one trapezoid, the plane; with r > n no line crosses any. The seed decides which cutting
//! is found; every one that it finds is right.
//!
//! # Source
//! Section 5.2, proof of Lemma 5.3, which takes a cutting from the literature. That the lines crossing a part are cut
//! again among themselves, and that the parts make the search structure, is Chazelle's hierarchy (Discrete Comput.
//! Geom. 9 (1993) 145). Departures: a part is cut in two by one wall or one line, chosen greedily by what a sample of
//! its lines tells, not by a sample's whole vertical decomposition; so the parts have equally many lines, where a
//! random decomposition has many light parts besides heavy ones, and there are about a third as many. Matoušek's
//! construction with 8 r² + 6 r + 4 trapezoids has chords of levels for sides, which have no counterpart among the
//! pseudo-lines of the tiling.
//!
//! # Method
//! 1. The first cell is the plane with all lines.
//! 2. Draw a sample of the lines of a cell that more than n / r lines cross. List walls near the medians of their
//!    crossings within the cell, of their exits by the bottom and the top, and of the vertical lines; and the sampled
//!    lines that lead through the cell from its left to its right end (`split_choice.rs`).
//! 3. Cut along the candidate with the least Σ (k / (n / r))² over both parts, k the number of lines that cross a part.
//! 4. Hand the lines down to the parts that they cross (`cell.rs`). A part that at most n / r lines cross is a
//!    trapezoid; the others go on with step 2.
//! 5. If r is below 16, do so up to 16 times and keep the cutting with the fewest trapezoids: there are few cuts then,
//!    and an unlucky first one counts.
//! 6. Make the search structure of the tree of cuts (`search.rs`).
//!
//! # Complexity
//! n lines, r; measured on the line families of the crate `experiments` for r = 4 to 256 and n = 4 r to 64 r: at most
//! 6 r² trapezoids, lists of at most 5 n r lines together, and for r ≥ 16 at most 13 n r lines handed down from cell to
//! cell, which is the cost of all but O(r²) choices of constant cost. Space O(n r). These are the paper's O(r²) and
//! O(n r), measured and not proved: the greedy choice has no proof. The reason to expect them is that a wall halves the
//! crossings within a cell and a line that few others cross halves the lines, so that Σ k² over the cells of a level
//! hardly grows from level to level, while k shrinks geometrically. The method ends on any input and for any seed, as a
//! line that cuts is gone from both parts and a wall leaves both parts fewer abscissas of vertices. A query takes at
//! most 4 log N comparisons to the base 3/2 among N trapezoids, in the worst case.
//!
//! # Shapes
//! `lines`: n lines in any order, duplicates allowed; rows with a zero normal are no lines and do not count. `r`: from
//! 1, above n too.
//!
//! # Numerics
//! Which lines cross a trapezoid and in which one a point lies is exact over the whole range of doubles
//! (`plane.rs`). The choice of cuts is made in doubles with bounds, the same on every machine.
//!
//! # Checked by
//! [`brute_force`](super::brute_force): lists of lines, cover without overlap, location; the bounds on the families.
//!
//! # Example
//! ```
//! use std::num::NonZeroU32;
//! use zonotope::arrangement::{LineArrangement, LineIndex, cutting::by_hierarchy};
//! // The x-axis and the y-axis, not to be crossed: four quadrants. The wall along the y-axis is found first.
//! let lines = LineArrangement::from_rows(&[[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]).unwrap();
//! let cutting = by_hierarchy::cutting(&lines, NonZeroU32::new(3).unwrap(), 0, &mut ());
//! assert_eq!((cutting.trapezoids().len(), cutting.total_crossings()), (4, 0));
//! let found = cutting.locate([-5.0, 2.0]).unwrap();
//! let quadrant = cutting.trapezoids()[found.0 as usize];
//! assert_eq!((quadrant.bottom, quadrant.top, quadrant.left), (Some(LineIndex(0)), None, None));
//! ```

use std::num::NonZeroU32;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::cell::Cell;
use super::plane::{End, Plane};
use super::search::{Cut, Node, Search};
use super::split_choice::{Split, choose};
use super::subdivision::Cutting;
use super::trapezoid::Trapezoid;
use crate::arrangement::line::LineIndex;
use crate::arrangement::lines::LineArrangement;
use crate::tally::{Operation, Tally};

/// From this r on there is one attempt; the first cuts, which samples tell the least about, are then few among all.
const FULL_ATTEMPT: u32 = 16;

/// At most this many attempts are made.
const ATTEMPT_LIMIT: u32 = 16;

/// A (1/r)-cutting; `seed` decides which one.
///
/// A search step is counted for each cut, a part evaluation for each line handed down.
pub fn cutting<'a>(lines: &'a LineArrangement<'a>, r: NonZeroU32, seed: u64, tally: &mut impl Tally) -> Cutting<'a> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let attempts = (FULL_ATTEMPT / r.get()).pow(2).clamp(1, ATTEMPT_LIMIT);
    let attempts = (0..attempts).map(|_| attempt(lines, r, &mut random, tally));
    attempts.min_by_key(|cutting| cutting.trapezoids.len()).expect("there is one attempt at least")
}

/// The cutting that one sequence of samples leads to.
fn attempt<'a>(
    lines: &'a LineArrangement<'a>,
    r: NonZeroU32,
    random: &mut Pcg64Mcg,
    tally: &mut impl Tally,
) -> Cutting<'a> {
    let mut plane = Plane::new(lines);
    tally.add(Operation::LineEvaluation, lines.len() as u64);
    let whole = Cell::whole(&plane);
    let limit = whole.weight() / r.get() as usize;
    let mut leaves = Leaves { trapezoids: Vec::new(), crossing: Vec::new(), starts: vec![0] };
    let mut nodes = vec![Node::Leaf(0)];
    let mut waiting = vec![(0, whole)];
    while let Some((node, cell)) = waiting.pop() {
        if cell.weight() <= limit {
            nodes[node] = Node::Leaf(leaves.add(&plane, &cell));
            continue;
        }
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::PartEvaluation, cell.weight() as u64);
        let (cut, parts) = match choose(&plane, &cell, limit, random) {
            Split::Wall(abscissa) => {
                let wall = plane.add_wall(abscissa);
                (Cut::Wall(wall), cell.split_at_wall(&plane, wall))
            }
            Split::Line(place) => (Cut::Line(place), cell.split_at_line(&plane, place)),
        };
        let children = [0, 1].map(|next| nodes.len() + next);
        let numbers = children.map(|child| u32::try_from(child).expect("memory ends before the numbers of nodes"));
        nodes[node] = Node::Inner(cut, numbers);
        nodes.extend([Node::Leaf(0), Node::Leaf(0)]);
        waiting.extend(children.into_iter().zip(parts).rev());
    }
    tally.add(Operation::ExactFallback, plane.exact_decisions());
    let search = Search::new(&nodes);
    let Leaves { trapezoids, crossing, starts } = leaves;
    Cutting { plane, limit, trapezoids, crossing, starts, search, tree: nodes }
}

/// The trapezoids that are done.
struct Leaves {
    trapezoids: Vec<Trapezoid>,
    crossing: Vec<LineIndex>,
    starts: Vec<usize>,
}

impl Leaves {
    /// Appends a cell; returns its number.
    fn add(&mut self, plane: &Plane, cell: &Cell) -> u32 {
        let wall = |end| match end {
            End::At(wall) => Some(plane.wall(wall)),
            End::BeforeAll | End::AfterAll => None,
        };
        let [left, right] = cell.ends.map(wall);
        let [bottom, top] = [cell.bottom, cell.top].map(|side| side.map(|place| plane.lines.line_at(place)));
        let number = self.trapezoids.len() as u32;
        self.trapezoids.push(Trapezoid { left, right, bottom, top });
        self.crossing.extend(cell.crossing.iter().map(|line| plane.lines.line_at(line.place)));
        self.crossing.extend(cell.verticals.clone().map(|position| plane.lines.vertical_line_at(position)));
        self.starts.push(self.crossing.len());
        number
    }
}
