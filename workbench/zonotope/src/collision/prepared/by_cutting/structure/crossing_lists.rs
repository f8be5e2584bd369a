//! The lines that cross each part of a cutting, from those that cross its trapezoids.
//!
//! A line that crosses a part crosses one of the two parts that it was cut into, unless it runs along the cut. So the
//! lists are made from the trapezoids upward.

use crate::arrangement::LineArrangement;
use crate::arrangement::LineIndex;
use crate::arrangement::cutting::{Boundary, Cutting, Part, Wall};
use crate::arrangement::fraction::Fraction;

/// The lines that are one with each line, itself included.
struct EqualLines {
    /// The class of each line.
    classes: Vec<u32>,
    members: Vec<Vec<u32>>,
}

/// The lines that cross each part, in increasing order. O(n log n + the length of the lists).
pub(crate) fn crossing_lists(lines: &LineArrangement, cutting: &Cutting) -> Vec<Vec<u32>> {
    let equal = EqualLines::of(lines);
    let mut lists: Vec<Vec<u32>> = vec![Vec::new(); cutting.part_count() as usize];
    for number in (0..cutting.part_count()).rev() {
        let list = match cutting.part(number) {
            Part::Trapezoid(trapezoid) => {
                let mut list: Vec<u32> = cutting.crossing_lines(trapezoid).iter().map(|line| line.0).collect();
                list.sort_unstable();
                list
            }
            Part::Cut(boundary, [before, beyond]) => {
                let sides = union(&lists[before as usize], &lists[beyond as usize]);
                union(&sides, &equal.along(boundary, lines))
            }
        };
        lists[number as usize] = list;
    }
    lists
}

impl EqualLines {
    fn of(lines: &LineArrangement) -> Self {
        let mut equal = Self { classes: vec![u32::MAX; lines.len()], members: Vec::new() };
        for place in 0..lines.place_count() as u32 {
            let is_new = place == 0 || !lines.coincide([place - 1, place]);
            equal.add(lines.line_at(place), is_new);
        }
        let verticals: Vec<LineIndex> = lines.vertical_lines().collect();
        for (position, &line) in verticals.iter().enumerate() {
            let is_new = position == 0 || abscissa(lines, verticals[position - 1]) != abscissa(lines, line);
            equal.add(line, is_new);
        }
        equal
    }

    /// Adds a line to a new class, or to that of the line before.
    fn add(&mut self, line: LineIndex, is_new: bool) {
        if is_new {
            self.members.push(Vec::new());
        }
        let class = self.members.len() - 1;
        self.members[class].push(line.0);
        self.classes[line.position()] = class as u32;
    }

    fn of_line(&self, line: LineIndex) -> Vec<u32> {
        let mut members = self.members[self.classes[line.position()] as usize].clone();
        members.sort_unstable();
        members
    }

    /// The lines along a boundary, in increasing order.
    fn along(&self, boundary: Boundary, lines: &LineArrangement) -> Vec<u32> {
        match boundary {
            Boundary::Line(line) | Boundary::Wall(Wall::Along(line)) => self.of_line(line),
            Boundary::Wall(Wall::Through(_)) if lines.vertical_count() == 0 => Vec::new(),
            Boundary::Wall(Wall::Through(pair)) => {
                let [first, second] = pair.map(|line| lines.exact_line(line));
                let [x, _, w] = first.meet(&second);
                let [before, up_to] = lines.verticals_up_to(&Fraction::new(x, w));
                let mut along: Vec<u32> =
                    (before..up_to).map(|position| lines.vertical_line_at(position as u32).0).collect();
                along.sort_unstable();
                along
            }
        }
    }
}

/// The abscissa of a vertical line.
fn abscissa(lines: &LineArrangement, line: LineIndex) -> Fraction {
    let line = lines.exact_line(line);
    let [x, _] = line.normal;
    Fraction::new(-line.offset, x)
}

/// The members of two increasing lists, each once.
fn union(a: &[u32], b: &[u32]) -> Vec<u32> {
    let mut all = Vec::with_capacity(a.len() + b.len());
    let (mut a, mut b) = (a.iter().peekable(), b.iter().peekable());
    loop {
        let next = match (a.peek(), b.peek()) {
            (Some(&&first), Some(&&second)) => first.min(second),
            (Some(&&only), None) | (None, Some(&&only)) => only,
            (None, None) => return all,
        };
        a.next_if_eq(&&next);
        b.next_if_eq(&&next);
        all.push(next);
    }
}

#[cfg(test)]
mod tests {
    use super::union;

    #[test]
    fn unions_are_increasing() {
        assert_eq!(union(&[1, 3, 5], &[0, 3, 4, 9]), [0, 1, 3, 4, 5, 9]);
        assert_eq!(union(&[], &[2]), [2]);
        assert_eq!(union(&[2], &[]), [2]);
    }
}
