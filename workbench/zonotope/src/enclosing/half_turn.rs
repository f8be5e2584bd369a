//! Half of the boundary of Z(O), edge by edge: the edges of the hull and of its reflection in the order of their directions, for half a
//! turn from edge 0.
//!
//! The edges of the lower chain, those that turn by less than π from edge 0, are met as they are, those of the upper chain
//! reflected. In the direction normal to edge t the boundary of Z(O) is that edge if O is not to the right of ℓ_t, else the reflection of its
//! farthest vertex, which is on the other chain. So at each edge the boundary is on one of the two chains, which the side of one line tells;
//! where that changes from an edge to the next, a bridge leads from the vertex that has been reached on one chain to the one reached on the
//! other.
//!
//! Where a centre on ℓ_t puts two parallel edges on one line, the face is spanned by the outermost of their four ends.

use std::cmp::Ordering;

use super::boundary_vertex::BoundaryVertex;
use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;

/// What is done with the edges of half of the boundary, in counter-clockwise order.
pub(crate) trait EdgeVisitor {
    /// An edge along one of the hull, or of its reflection, from a vertex to another one of that kind.
    fn hull_edge(&mut self, from: BoundaryVertex, to: usize);

    /// An edge from a vertex of the hull to a reflected one, or the other way round.
    fn bridge(&mut self, from: BoundaryVertex, to: usize);
}

/// A hull with area, a centre, and the side of each ℓ_t on which the centre lies.
#[derive(Debug)]
pub(crate) struct HalfTurn<'h, 'a> {
    hull: &'h ConvexHull,
    farthest: &'a [FarthestVertex],
    center: [f64; 2],
    exact_center: &'a [Dyadic; 3],
    /// Whether the centre's coordinates are doubles.
    center_is_double: bool,
    sides: &'a [i8],
}

/// How far a walk has come.
struct Reached {
    /// The vertex of the lower chain.
    lower: usize,
    /// The vertex of the upper chain.
    upper: usize,
    /// Whether the boundary is at that of the upper chain, reflected.
    is_upper: bool,
}

impl Reached {
    /// Crosses the bridge to the other chain, if that is the one wanted.
    #[inline(always)]
    fn switch(&mut self, to_upper: bool, visitor: &mut impl EdgeVisitor) {
        if self.is_upper != to_upper {
            let (from, to) = if to_upper { (self.lower, self.upper) } else { (self.upper, self.lower) };
            visitor.bridge(BoundaryVertex::new(from, !to_upper), to);
            self.is_upper = to_upper;
        }
    }
}

impl<'h, 'a> HalfTurn<'h, 'a> {
    /// `center` is the exact centre, given in homogeneous coordinates, rounded; `sides` is 1 or 0 where edge t belongs to the boundary.
    pub(crate) fn new(
        hull: &'h ConvexHull,
        farthest: &'a [FarthestVertex],
        center: [f64; 2],
        exact_center: &'a [Dyadic; 3],
        sides: &'a [i8],
    ) -> Self {
        let center_is_double = (0..2).all(|i| exact_center[i] == &exact_center[2] * &Dyadic::from_f64(center[i]));
        Self { hull, farthest, center, exact_center, center_is_double, sides }
    }

    pub(crate) fn hull(&self) -> &'h ConvexHull {
        self.hull
    }

    /// The centre, rounded.
    pub(crate) fn center(&self) -> [f64; 2] {
        self.center
    }

    /// Whether the centre is a double.
    pub(crate) fn center_is_double(&self) -> bool {
        self.center_is_double
    }

    /// Visits half of the boundary, from a vertex to its reflection. O(h).
    #[inline(always)]
    pub(crate) fn walk(&self, visitor: &mut impl EdgeVisitor) {
        let first_upper = self.farthest[0].vertex().get();
        let is_pair = self.is_collinear_pair(0);
        let starts_upper = if is_pair { self.outermost_ends(0, first_upper)[0] } else { self.sides[0] < 0 };
        let mut at = Reached { lower: 0, upper: first_upper, is_upper: starts_upper };
        let mut left = self.hull.edge_count();
        while left > 0 {
            left -= 1;
            let is_lower = self.farthest[at.lower].vertex().get() == at.upper;
            let edge = if is_lower { at.lower } else { at.upper };
            let end = self.following(edge);
            if self.is_collinear_pair(edge) {
                let opposite_end = self.following(at.upper);
                let [starts_upper, ends_upper] = self.outermost_ends(edge, at.upper);
                at.switch(starts_upper, visitor);
                let from = BoundaryVertex::new(if starts_upper { at.upper } else { edge }, starts_upper);
                let to = if ends_upper { opposite_end } else { end };
                if starts_upper == ends_upper {
                    visitor.hull_edge(from, to);
                } else {
                    visitor.bridge(from, to);
                }
                at = Reached { lower: end, upper: opposite_end, is_upper: ends_upper };
                left -= 1;
                continue;
            }
            let is_edge = self.sides[edge] >= 0;
            at.switch(is_lower != is_edge, visitor);
            if is_edge {
                visitor.hull_edge(BoundaryVertex::new(edge, !is_lower), end);
            }
            *(if is_lower { &mut at.lower } else { &mut at.upper }) = end;
        }
        at.switch(!starts_upper, visitor);
    }

    fn following(&self, vertex: usize) -> usize {
        if vertex + 1 < self.hull.edge_count() { vertex + 1 } else { 0 }
    }

    /// Whether the opposite of an edge is parallel to it and the centre is midway between them.
    #[inline(always)]
    fn is_collinear_pair(&self, edge: usize) -> bool {
        self.sides[edge] == 0 && self.farthest[edge].is_tied()
    }

    /// Of an edge and the reflection of the opposite one on the same line: whether the reflected one starts first, and whether it ends last.
    #[inline(never)]
    fn outermost_ends(&self, edge: usize, opposite: usize) -> [bool; 2] {
        let (end, opposite_end) = (self.following(edge), self.following(opposite));
        [
            self.reflection_is_ahead(edge, opposite, edge) == Ordering::Less,
            self.reflection_is_ahead(edge, opposite_end, end) == Ordering::Greater,
        ]
    }

    /// Whether P'_a = P_b, where that is seen at a glance; `false` decides nothing.
    fn meet_in_center(&self, a: usize, b: usize) -> bool {
        let (a, b) = (self.hull.vertices()[a], self.hull.vertices()[b]);
        self.center_is_double && (0..2).all(|i| exact_sum(a[i], b[i]) == (2.0 * self.center[i], 0.0))
    }

    /// The sign of the scalar product of an edge with P'_a − P_b.
    fn reflection_is_ahead(&self, edge: usize, a: usize, b: usize) -> Ordering {
        if self.meet_in_center(a, b) {
            return Ordering::Equal;
        }
        let exact = |vertex: usize| self.hull.vertices()[vertex].map(Dyadic::from_f64);
        let [x, y, w] = self.exact_center;
        let (from, to, a, b) = (exact(edge), exact(self.following(edge)), exact(a), exact(b));
        let along = |axis: usize, center: &Dyadic| {
            (&to[axis] - &from[axis]) * (center.clone().scaled(1) - w * &(&a[axis] + &b[axis]))
        };
        (along(0, x) + along(1, y)).sign()
    }
}
