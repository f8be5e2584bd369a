//! The smallest zonogon with a given centre around points of the plane: Z(O), as a sequence of hull vertices and their reflections.
//!
//! # Statement
//! Input: the convex hull of the points, the farthest vertex of each edge, a centre O. Output: the boundary of
//! Z(O) = conv(P ∪ P'), P' = 2O − P, as a circular sequence of vertices P_i and P'_i; its runs are the paper's combinatorial description.
//! Collinear neighbours may occur where an edge and a reflected vertex lie on one line. The hull of one point or two points gives
//! the parallelogram (possibly flat) of the points and their reflections.
//!
//! # Source
//! Section 4.1, Z(O) and 𝒮. Departure: built in O(n) from the farthest vertices, without a second convex hull.
//!
//! # Method
//! 1. The edges of the hull and of its reflection in the order of their directions: after edge t come the reflected edges from
//!    the farthest vertex of t up to that of t + 1.
//! 2. In the direction normal to edge t the zonogon's boundary is that edge if O is not to the right of ℓ_t, else the reflection of the
//!    farthest vertex; the same holds with the roles exchanged for reflected edges.
//! 3. Where a centre on ℓ_t puts two parallel edges on one line, the face is spanned by the outermost of their four ends.
//! 4. Between two directions nothing but a bridge from a hull vertex to a reflected one can happen: the sequence of what is visited,
//!    without repetitions, is the boundary. By symmetry half a turn suffices.
//!
//! # Complexity
//! h hull vertices: O(h) time and space. The paper: O(n).
//!
//! # Shapes
//! The sequence has at most 2h vertices, counter-clockwise; the second half repeats the first with P and P' exchanged.
//!
//! # Numerics
//! On which side of ℓ_t the centre lies is decided exactly.
//!
//! # Errors
//! None: a hull is valid; the centre's coordinates must be finite.
//!
//! # Panics
//! If a coordinate of the centre is not finite.
//!
//! # Checked by
//! [`min_area_zonogon::brute_force`](super::min_area_zonogon::brute_force), whose area of Z(O) is that of an exact hull of all 2n points.
//!
//! # Example
//! ```
//! use zonotope::enclosing::centered_zonogon::CenteredZonogon;
//! use zonotope::hull::{antipodal::farthest_vertices, convex_hull};
//!
//! let triangle = convex_hull(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
//! let farthest = farthest_vertices(&triangle);
//! let zonogon = CenteredZonogon::new(&triangle, &farthest, [1.0, 1.0]);
//! // the square of the triangle and its reflection in the midpoint of its long side
//! assert_eq!(zonogon.exact_area().to_f64(), 4.0);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use std::cmp::Ordering;

use crate::hull::antipodal::FarthestVertex;
use crate::hull::{ConvexHull, VertexIndex};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::exact_sum;
use crate::numeric::orientation::{Turn, orientation};

use super::bisectors::Bisectors;

/// A vertex of the hull, or its reflection in the centre.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct BoundaryVertex {
    /// The vertex of the hull.
    pub vertex: VertexIndex,
    /// Whether its reflection is meant.
    pub reflected: bool,
}

impl BoundaryVertex {
    fn opposite(self) -> Self {
        Self { reflected: !self.reflected, ..self }
    }
}

/// A maximal run of the combinatorial description: P_first … P_last, or P'_first … P'_last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// The first vertex.
    pub first: VertexIndex,
    /// The last vertex, counter-clockwise from the first.
    pub last: VertexIndex,
    /// Whether the reflections are meant.
    pub reflected: bool,
}

/// The boundary of Z(O).
#[derive(Debug, Clone)]
pub struct CenteredZonogon<'h> {
    hull: &'h ConvexHull,
    center: [f64; 2],
    half: Vec<BoundaryVertex>,
}

impl<'h> CenteredZonogon<'h> {
    /// The smallest zonogon with a centre of finite coordinates around a hull.
    ///
    /// # Panics
    /// When `farthest` does not have one vertex for each edge of the hull, or the centre is not finite.
    pub fn new(hull: &'h ConvexHull, farthest: &'h [FarthestVertex], center: [f64; 2]) -> Self {
        assert!(center.iter().all(|v| v.is_finite()), "the centre has finite coordinates");
        let bisectors = Bisectors::new(hull, farthest);
        let exact_center = homogeneous(center);
        let sides = bisectors.kernel_problem().signs_at(&bisectors.kernel_point(&exact_center));
        Self::from_sides(hull, farthest, center, &exact_center, &sides)
    }

    /// The zonogon whose exact centre, in homogeneous coordinates, lies on the given side of each ℓ_t: 1 or 0 where edge t belongs
    /// to the boundary. `center` is the same centre, rounded.
    pub(crate) fn from_sides(
        hull: &'h ConvexHull,
        farthest: &[FarthestVertex],
        center: [f64; 2],
        exact_center: &[Dyadic; 3],
        sides: &[i8],
    ) -> Self {
        if !hull.has_area() {
            return Self { hull, center, half: half_of_segment(hull, center) };
        }
        let is_exact = (0..2).all(|i| exact_center[i] == &exact_center[2] * &Dyadic::from_f64(center[i]));
        let center_in_doubles = is_exact.then_some(center);
        let visited = Vec::with_capacity(hull.edge_count() + 2);
        let half = HalfTurn { hull, farthest, exact_center, center_in_doubles, sides, visited };
        Self { hull, center, half: half.walk() }
    }

    /// The hull.
    pub fn hull(&self) -> &'h ConvexHull {
        self.hull
    }

    /// The centre.
    pub fn center(&self) -> [f64; 2] {
        self.center
    }

    /// Half of the boundary, counter-clockwise, from a vertex to its reflection inclusive.
    pub fn half_boundary(&self) -> &[BoundaryVertex] {
        &self.half
    }

    /// The whole boundary, counter-clockwise.
    pub fn boundary(&self) -> impl Iterator<Item = BoundaryVertex> + '_ {
        let half = &self.half[..self.half.len() - 1];
        half.iter().copied().chain(half.iter().map(|v| v.opposite()))
    }

    /// The combinatorial description: maximal runs of hull vertices and of reflected ones, counter-clockwise.
    pub fn description(&self) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for BoundaryVertex { vertex, reflected } in self.boundary() {
            match runs.last_mut() {
                Some(run) if run.reflected == reflected => run.last = vertex,
                _ => runs.push(Run { first: vertex, last: vertex, reflected }),
            }
        }
        if runs.len() > 2 && runs[0].reflected == runs[runs.len() - 1].reflected {
            let tail = runs.pop().expect("there are at least three runs");
            runs[0].first = tail.first;
        }
        runs
    }

    /// A vertex of the boundary, exactly.
    pub fn exact_vertex(&self, BoundaryVertex { vertex, reflected }: BoundaryVertex) -> [Dyadic; 2] {
        let point = self.hull.vertex(vertex);
        std::array::from_fn(|i| {
            let p = Dyadic::from_f64(point[i]);
            if reflected { Dyadic::from_f64(self.center[i]).scaled(1) - p } else { p }
        })
    }

    /// The vertices of the boundary, counter-clockwise, rounded.
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        self.boundary().map(|v| self.exact_vertex(v).map(|c| c.to_f64())).collect()
    }

    /// The area, exactly. O(h) exact operations.
    pub fn exact_area(&self) -> Dyadic {
        let center = self.center.map(Dyadic::from_f64);
        let arms = self.half.iter().map(|&v| {
            let [x, y] = self.exact_vertex(v);
            [&x - &center[0], &y - &center[1]]
        });
        let arms: Vec<[Dyadic; 2]> = arms.collect();
        arms.windows(2).fold(Dyadic::zero(), |sum, w| sum + (&w[0][0] * &w[1][1] - &w[0][1] * &w[1][0]))
    }
}

/// The walk over the edges of the hull and of its reflection in the order of their directions, for half a turn from edge 0.
struct HalfTurn<'a> {
    hull: &'a ConvexHull,
    farthest: &'a [FarthestVertex],
    exact_center: &'a [Dyadic; 3],
    /// The centre, if its coordinates are doubles.
    center_in_doubles: Option<[f64; 2]>,
    sides: &'a [i8],
    visited: Vec<BoundaryVertex>,
}

impl HalfTurn<'_> {
    fn walk(mut self) -> Vec<BoundaryVertex> {
        let opposite_of_first = self.farthest[0].is_tied().then(|| self.farthest[0].vertex().get());
        let mut reflected_edge = self.farthest[0].vertex().get();
        'half_turn: for edge in 0..self.hull.edge_count() {
            if opposite_of_first == Some(edge) {
                break;
            }
            self.visit_edge(edge, false);
            let stop = self.farthest[self.following(edge)].vertex().get();
            while reflected_edge != stop {
                if reflected_edge == 0 {
                    break 'half_turn;
                }
                self.visit_edge(reflected_edge, true);
                reflected_edge = self.following(reflected_edge);
            }
        }
        let end = self.visited[0].opposite();
        self.visit(end.vertex.get(), end.reflected);
        self.visited
    }

    fn following(&self, vertex: usize) -> usize {
        if vertex + 1 < self.hull.edge_count() { vertex + 1 } else { 0 }
    }

    fn visit(&mut self, vertex: usize, reflected: bool) {
        let vertex = BoundaryVertex { vertex: VertexIndex::new(vertex), reflected };
        if self.visited.last() != Some(&vertex) {
            self.visited.push(vertex);
        }
    }

    /// Visits what the boundary has in the direction of an edge.
    fn visit_edge(&mut self, edge: usize, reflected: bool) {
        let far = self.farthest[edge];
        // Of two parallel edges the one of the hull itself comes first and visits what both have.
        let visited_already = reflected && far.is_tied() && self.sides[edge] <= 0;
        match self.sides[edge] {
            _ if visited_already => {}
            0 if far.is_tied() => self.visit_collinear_edges(edge, far.vertex().get()),
            0.. => {
                self.visit(edge, reflected);
                self.visit(self.following(edge), reflected);
            }
            _ => self.visit(far.vertex().get(), !reflected),
        }
    }

    fn visit_collinear_edges(&mut self, edge: usize, opposite: usize) {
        let starts_later = self.reflection_is_ahead(edge, opposite, edge) == Ordering::Less;
        self.visit(if starts_later { opposite } else { edge }, starts_later);
        let (end, opposite_end) = (self.following(edge), self.following(opposite));
        let ends_earlier = self.reflection_is_ahead(edge, opposite_end, end) == Ordering::Greater;
        self.visit(if ends_earlier { opposite_end } else { end }, ends_earlier);
    }

    /// Whether P'_a = P_b, where that is seen at a glance; `false` decides nothing.
    fn meet_in_center(&self, a: usize, b: usize) -> bool {
        let (a, b) = (self.hull.vertices()[a], self.hull.vertices()[b]);
        self.center_in_doubles.is_some_and(|center| (0..2).all(|i| exact_sum(a[i], b[i]) == (2.0 * center[i], 0.0)))
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

/// A point of finite coordinates in homogeneous coordinates.
pub(crate) fn homogeneous([x, y]: [f64; 2]) -> [Dyadic; 3] {
    [x, y, 1.0].map(Dyadic::from_f64)
}

/// Half of the boundary around a point or a segment.
fn half_of_segment(hull: &ConvexHull, center: [f64; 2]) -> Vec<BoundaryVertex> {
    let at = |vertex: usize, reflected| BoundaryVertex { vertex: VertexIndex::new(vertex), reflected };
    match *hull.vertices() {
        [first, last] => {
            let clockwise = orientation(first, last, center) == Turn::Right;
            vec![at(0, false), at(1, clockwise), at(0, true)]
        }
        _ => vec![at(0, false), at(0, true)],
    }
}
