//! Trapezoids while they are cut: the lines that cross one, with their order at its four corners, and what a wall or a
//! line makes of it.
//!
//! The difference in height between two lines is a linear function of the abscissa, so the order of a line and a side
//! at both ends tells whether the line gets to the inner side of it anywhere between. A line that gets above the bottom
//! somewhere and below the top somewhere crosses the interior: were the two places apart, the bottom would be above the
//! top between them.

use std::cmp::Ordering;
use std::ops::Range;

use super::plane::{End, Plane};

/// A trapezoid with the lines that cross its interior.
#[derive(Debug)]
pub(super) struct Cell {
    /// Where it ends on the left and on the right.
    pub(super) ends: [End; 2],
    /// The place of the line along the bottom.
    pub(super) bottom: Option<u32>,
    /// The place of the line along the top.
    pub(super) top: Option<u32>,
    /// The lines that cross it and are not vertical, by ascending places.
    pub(super) crossing: Vec<CrossingLine>,
    /// The positions of the vertical lines that cross it.
    pub(super) verticals: Range<u32>,
}

/// A line that crosses a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct CrossingLine {
    pub(super) place: u32,
    /// Its order in height against the bottom, at the left and at the right end; above it if there is none.
    pub(super) to_bottom: [Ordering; 2],
    /// Its order in height against the top, at the left and at the right end; below it if there is none.
    pub(super) to_top: [Ordering; 2],
}

impl CrossingLine {
    /// Whether the line crosses the interior of a cell with these orders.
    fn crosses(&self) -> bool {
        !self.to_bottom.iter().all(|order| order.is_le()) && !self.to_top.iter().all(|order| order.is_ge())
    }

    /// Whether the line leads from the left end to the right end without crossing the bottom or the top.
    pub(super) fn leads_through(&self) -> bool {
        self.to_bottom.iter().all(|order| order.is_ge()) && self.to_top.iter().all(|order| order.is_le())
    }
}

impl Cell {
    /// The whole plane with all lines.
    pub(super) fn whole(plane: &Plane) -> Self {
        let line = |place| CrossingLine { place, to_bottom: [Ordering::Greater; 2], to_top: [Ordering::Less; 2] };
        Self {
            ends: [End::BeforeAll, End::AfterAll],
            bottom: None,
            top: None,
            crossing: (0..plane.lines.place_count() as u32).map(line).collect(),
            verticals: 0..plane.lines.vertical_count() as u32,
        }
    }

    /// How many lines cross the cell.
    pub(super) fn weight(&self) -> usize {
        self.crossing.len() + self.verticals.len()
    }

    /// The parts left and right of a wall with a number, which lies strictly between the ends. O(k) for k lines.
    pub(super) fn split_at_wall(&self, plane: &Plane, wall: u32) -> [Self; 2] {
        let end = End::At(wall);
        let [left, right] = self.ends;
        let part = |ends, verticals| Self { ends, crossing: Vec::new(), verticals, ..*self };
        let [before, after] = plane.verticals_beside(&self.verticals, plane.wall_abscissa(wall));
        let mut parts = [part([left, end], before), part([end, right], after)];
        for line in &self.crossing {
            let to_bottom = self.bottom.map_or(Ordering::Greater, |side| plane.order([line.place, side], end));
            let to_top = self.top.map_or(Ordering::Less, |side| plane.order([line.place, side], end));
            let halves = [
                CrossingLine { to_bottom: [line.to_bottom[0], to_bottom], to_top: [line.to_top[0], to_top], ..*line },
                CrossingLine { to_bottom: [to_bottom, line.to_bottom[1]], to_top: [to_top, line.to_top[1]], ..*line },
            ];
            for (part, half) in parts.iter_mut().zip(halves) {
                part.crossing.extend(half.crosses().then_some(half));
            }
        }
        parts
    }

    /// The parts below and above the line at a place, which leads through the cell. O(k) for k lines.
    pub(super) fn split_at_line(&self, plane: &Plane, place: u32) -> [Self; 2] {
        let part = |bottom, top| Self { bottom, top, crossing: Vec::new(), verticals: self.verticals.clone(), ..*self };
        let mut parts = [part(self.bottom, Some(place)), part(Some(place), self.top)];
        for line in &self.crossing {
            let order = self.ends.map(|end| plane.order([line.place, place], end));
            let halves = [CrossingLine { to_top: order, ..*line }, CrossingLine { to_bottom: order, ..*line }];
            for (part, half) in parts.iter_mut().zip(halves) {
                part.crossing.extend(half.crosses().then_some(half));
            }
        }
        parts
    }
}
