//! What a cutting consists of: trapezoids between two walls and two lines.

use crate::arrangement::LineIndex;

/// A trapezoid of a cutting, as a position in [`Cutting::trapezoids`](super::Cutting::trapezoids).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TrapezoidIndex(pub u32);

/// A vertical line along which trapezoids end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Wall {
    /// The vertical line through the vertex in which two lines cross.
    Through([LineIndex; 2]),
    /// A vertical line of the arrangement.
    Along(LineIndex),
}

/// What a plane is cut along: a wall, or a line that is not vertical.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// A wall; the side beyond it is the right one, with the wall.
    Wall(Wall),
    /// A line; the side beyond it is the upper one, with the line.
    Line(LineIndex),
}

/// The points between two walls and two lines; where there is no wall or no line it is unbounded.
///
/// The points of the left wall and of the bottom line belong to it, those of the right wall and the top line do not, so
/// that every point of the plane lies in one trapezoid. A trapezoid whose lines cross on a wall is a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Trapezoid {
    /// The wall on the left.
    pub left: Option<Wall>,
    /// The wall on the right.
    pub right: Option<Wall>,
    /// The line along the bottom.
    pub bottom: Option<LineIndex>,
    /// The line along the top.
    pub top: Option<LineIndex>,
}
