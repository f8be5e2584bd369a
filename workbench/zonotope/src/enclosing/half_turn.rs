//! A walk along half of the boundary of Z(O), edge by edge: over the edges of the hull and of its reflection in the
//! order of their directions, for half a turn from edge 0.
//!
//! The lower chain is the edges of the hull that turn by less than π from edge 0; the upper chain is the other edges,
//! and the walk meets their reflections. In the outward normal direction of an edge t of the hull, the boundary of Z(O)
//! is that edge if O is not to the right of ℓ_t. Else it is the reflection of the edge's farthest vertex, which is on
//! the other chain. So at each edge the side of one line decides which of the two chains the boundary follows. Where
//! the chain changes from an edge to the next, a bridge leads from the vertex reached on one chain to the vertex
//! reached on the other. That is why no second convex hull is computed.
//!
//! A centre on ℓ_t may put an edge and the reflection of a parallel one on one line. Then the two outermost of their
//! four ends span the edge of Z(O).

use std::cmp::Ordering;

use super::boundary_vertex::BoundaryVertex;
use crate::hull::ConvexHull;
use crate::hull::antipodal::FarthestVertex;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;

/// A visitor of the edges of half of the boundary, in counter-clockwise order.
pub(crate) trait EdgeVisitor {
    /// Visits an edge between two vertices of the hull, or between the reflections of two.
    fn hull_edge(&mut self, from: BoundaryVertex, to: usize);

    /// Visits an edge from a vertex of the hull to a reflected one, or from a reflected one to a vertex of the hull.
    fn bridge(&mut self, from: BoundaryVertex, to: usize);
}

/// A hull with area, a centre, and the side of each ℓ_t on which the centre lies.
#[derive(Debug)]
pub(crate) struct HalfTurn<'h, 'a> {
    hull: &'h ConvexHull,
    farthest: &'a [FarthestVertex],
    center: [f64; 2],
    exact_center: &'a [Dyadic; 3],
    /// Whether the rounded centre is the exact one.
    center_is_double: bool,
    sides: &'a [i8],
}

/// The vertices that a walk has reached.
struct Reached {
    /// The vertex reached on the lower chain.
    lower: usize,
    /// The vertex reached on the upper chain.
    upper: usize,
    /// Whether the boundary is at the reflection of the upper chain's vertex, else at the lower chain's vertex.
    is_upper: bool,
}

impl Reached {
    /// Visits the bridge to a chain unless the boundary is on it.
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
    /// The walk around a hull for a centre, given exactly in homogeneous coordinates and rounded. `sides[t]` is 1 or 0
    /// if edge t of the hull is on the boundary, else −1.
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

    /// The hull.
    pub(crate) fn hull(&self) -> &'h ConvexHull {
        self.hull
    }

    /// The centre, rounded.
    pub(crate) fn center(&self) -> [f64; 2] {
        self.center
    }

    /// Whether the rounded centre is the exact one.
    pub(crate) fn center_is_double(&self) -> bool {
        self.center_is_double
    }

    /// Visits the edges of half of the boundary, from a vertex to its reflection. O(h).
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

    /// The next vertex of the hull, counter-clockwise.
    fn following(&self, vertex: usize) -> usize {
        if vertex + 1 < self.hull.edge_count() { vertex + 1 } else { 0 }
    }

    /// Whether an edge is on one line with the reflection of the opposite edge: both are parallel, and the centre is
    /// midway between them.
    #[inline(always)]
    fn is_collinear_pair(&self, edge: usize) -> bool {
        self.sides[edge] == 0 && self.farthest[edge].is_tied()
    }

    /// For an edge on one line with the reflection of the opposite one: whether the reflected edge starts first, and
    /// whether it ends last.
    #[inline(never)]
    fn outermost_ends(&self, edge: usize, opposite: usize) -> [bool; 2] {
        let (end, opposite_end) = (self.following(edge), self.following(opposite));
        [
            self.order_along(edge, opposite, edge) == Ordering::Less,
            self.order_along(edge, opposite_end, end) == Ordering::Greater,
        ]
    }

    /// A filter in floating point: true only if P'_a = P_b.
    fn certainly_coincide(&self, a: usize, b: usize) -> bool {
        let (a, b) = (self.hull.vertices()[a], self.hull.vertices()[b]);
        self.center_is_double && (0..2).all(|i| exact_sum(a[i], b[i]) == (2.0 * self.center[i], 0.0))
    }

    /// The order along an edge of P'_a and P_b: the sign of the scalar product of the edge with P'_a − P_b.
    fn order_along(&self, edge: usize, a: usize, b: usize) -> Ordering {
        if self.certainly_coincide(a, b) {
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
