//! A cutting as it is handed out: its trapezoids, the lines that cross each, and the search among them.

use super::plane::{Plane, Point};
use super::search::{Cut, Node, Search};
use super::trapezoid::{Boundary, Trapezoid, TrapezoidIndex};
use crate::arrangement::LineIndex;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::non_finite::NonFinite;

/// A (1/r)-cutting: trapezoids that cover the plane without overlap, each with the lines that cross its interior.
#[derive(Debug)]
pub struct Cutting<'a> {
    pub(super) plane: Plane<'a>,
    pub(super) limit: usize,
    pub(super) trapezoids: Vec<Trapezoid>,
    /// The lines that cross the trapezoids, one trapezoid after the other.
    pub(super) crossing: Vec<LineIndex>,
    /// Where the lines of each trapezoid begin in that list; one more than there are trapezoids.
    pub(super) starts: Vec<usize>,
    pub(super) search: Search,
    /// The tree of cuts: the whole plane first, parts behind what they are parts of.
    pub(super) tree: Vec<Node>,
}

impl Cutting<'_> {
    /// At most how many lines may cross a trapezoid: n / r, rounded down.
    pub fn limit(&self) -> usize {
        self.limit
    }

    /// The trapezoids.
    pub fn trapezoids(&self) -> &[Trapezoid] {
        &self.trapezoids
    }

    /// The lines that cross the interior of a trapezoid: those that are not vertical by ascending slope, then the
    /// vertical ones from left to right. The lines along its sides are not among them.
    ///
    /// # Panics
    /// If there is no such trapezoid: the index is that of another cutting.
    pub fn crossing_lines(&self, trapezoid: TrapezoidIndex) -> &[LineIndex] {
        let position = trapezoid.0 as usize;
        &self.crossing[self.starts[position]..self.starts[position + 1]]
    }

    /// How many lines cross trapezoids, each counted once for every trapezoid that it crosses.
    pub fn total_crossings(&self) -> u64 {
        self.crossing.len() as u64
    }

    /// The trapezoid in which a point lies. O(log r).
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate is NaN or infinite.
    pub fn locate(&self, point: [f64; 2]) -> Result<TrapezoidIndex, NonFinite> {
        NonFinite::check_vector("the point", &point)?;
        let [x, y] = point.map(Dyadic::from_f64);
        Ok(self.locate_point(&self.plane.point([x, y, Dyadic::one()])))
    }

    /// The trapezoid in which the point (X / W, Y / W) lies, given as [X, Y, W] like the
    /// [meeting point](crate::arrangement::ExactLine::meet) of two lines; `None` if W = 0, at infinity. O(log r).
    pub fn locate_homogeneous(&self, point: [Dyadic; 3]) -> Option<TrapezoidIndex> {
        let sign = point[2].sign();
        let point = if sign.is_lt() { point.map(|v| -v) } else { point };
        sign.is_ne().then(|| self.locate_point(&self.plane.point(point)))
    }

    fn locate_point(&self, point: &Point) -> TrapezoidIndex {
        TrapezoidIndex(self.search.find(|cut| match cut {
            Cut::Wall(wall) => self.plane.is_right_of(point, wall),
            Cut::Line(place) => self.plane.is_above(point, place),
        }))
    }

    /// The trapezoid that is on the right side of all [boundaries](Boundary), for what is no point of the plane but
    /// lies on one side of each: of a wall and of a line, beyond it or not. O(log r) questions.
    ///
    /// So a point of the tiling that is dual to the arrangement is located among the images of the trapezoids.
    pub fn locate_by(&self, mut is_beyond: impl FnMut(Boundary) -> bool) -> TrapezoidIndex {
        TrapezoidIndex(self.search.find(|cut| is_beyond(self.boundary(cut))))
    }

    /// The boundary along which a cut was made.
    pub(super) fn boundary(&self, cut: Cut) -> Boundary {
        match cut {
            Cut::Wall(wall) => Boundary::Wall(self.plane.wall(wall)),
            Cut::Line(place) => Boundary::Line(self.plane.lines.line_at(place)),
        }
    }
}
