//! The smallest zonogon Z(O) with a given centre O around points of the plane, as a sequence of hull vertices and their
//! reflections.
//!
//! # Statement
//! Input: the convex hull of the points, the farthest vertex of each edge, a centre O. Output: the boundary of Z(O) =
//! conv(P ∪ P'), P' = 2O − P, as a circular sequence of vertices P_i and P'_i; its runs are the paper's combinatorial
//! description. Neighbours in the sequence may be collinear where an edge and a reflected vertex lie on one line. For
//! the hull of one or two points Z(O) is the parallelogram, possibly flat, of the points and their reflections.
//!
//! # Source
//! Section 4.1, Z(O) and 𝒮. Departure: Z(O) is built in O(n) from the farthest vertices, without a second convex hull.
//!
//! # Method
//! 1. Walk over the edges of the hull and of its reflection in the order of their directions, for half a turn
//!    (`half_turn.rs`).
//! 2. Collect the edges of the boundary as the walk meets them; the other half follows by symmetry.
//!
//! # Complexity
//! h hull vertices: O(h) time and space. The paper: O(n).
//!
//! # Shapes
//! The sequence has at most 2h vertices, counter-clockwise; the second half repeats the first with P and P' exchanged.
//!
//! # Numerics
//! The side of ℓ_t on which the centre lies is decided exactly.
//!
//! # Panics
//! If a coordinate of the centre is not finite, or there is not one farthest vertex for each edge of the hull.
//!
//! # Checked by
//! [`min_area_zonogon::brute_force`](super::min_area_zonogon::brute_force), whose area of Z(O) is that of an exact hull
//! of all 2n points.
//!
//! # Example
//! ```
//! use zonotope::enclosing::centered_zonogon::CenteredZonogon;
//! use zonotope::hull::{antipodal::farthest_vertices, convex_hull};
//!
//! let triangle = convex_hull(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]], &mut ())?;
//! let farthest = farthest_vertices(&triangle, &mut ());
//! let zonogon = CenteredZonogon::new(&triangle, &farthest, [1.0, 1.0], &mut ());
//! // the square of the triangle and its reflection in the midpoint of its long side
//! assert_eq!(zonogon.exact_area().to_f64(), 4.0);
//! # Ok::<(), zonotope::hull::HullError>(())
//! ```

use crate::hull::antipodal::FarthestVertex;
use crate::hull::{ConvexHull, VertexIndex};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::orientation::{Turn, orientation};
use crate::tally::{Operation, Tally};

use super::bisectors::Bisectors;
pub use super::boundary_vertex::BoundaryVertex;
use super::half_turn::{EdgeVisitor, HalfTurn};

/// A maximal run of the combinatorial description: P_first … P_last, or P'_first … P'_last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// The first vertex.
    pub first: VertexIndex,
    /// The last vertex, counter-clockwise from the first.
    pub last: VertexIndex,
    /// Whether the run is of the reflections P'_i.
    pub reflected: bool,
}

/// The smallest zonogon Z(O) with a given centre around a hull, by its boundary.
#[derive(Debug, Clone)]
pub struct CenteredZonogon<'h> {
    hull: &'h ConvexHull,
    center: [f64; 2],
    half: Vec<BoundaryVertex>,
}

impl<'h> CenteredZonogon<'h> {
    /// The smallest zonogon with a centre of finite coordinates around a hull.
    ///
    /// The sides of lines and the edges of the boundary are counted.
    ///
    /// # Panics
    /// When `farthest` does not have one vertex for each edge of the hull, or the centre is not finite.
    pub fn new(hull: &'h ConvexHull, farthest: &'h [FarthestVertex], center: [f64; 2], tally: &mut impl Tally) -> Self {
        assert!(center.iter().all(|v| v.is_finite()), "the centre has finite coordinates");
        let bisectors = Bisectors::new(hull, farthest);
        let exact_center = homogeneous(center);
        let sides = bisectors.kernel_problem().signs_at(&bisectors.kernel_point(&exact_center), tally);
        let zonogon = Self::from_sides(hull, farthest, center, &exact_center, &sides);
        tally.add(Operation::Comparison, zonogon.half.len() as u64);
        zonogon
    }

    /// The zonogon with a centre, given exactly in homogeneous coordinates and rounded. `sides[t]` is the side of ℓ_t
    /// on which the centre lies: 1 or 0 if edge t is on the boundary, else −1.
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
        Self::of(&HalfTurn::new(hull, farthest, center, exact_center, sides))
    }

    /// The zonogon whose boundary a walk visits.
    pub(crate) fn of(half_turn: &HalfTurn<'h, '_>) -> Self {
        let mut starts = Starts(Vec::with_capacity(half_turn.hull().edge_count() + 2));
        half_turn.walk(&mut starts);
        let Starts(mut half) = starts;
        half.push(half[0].opposite());
        Self { hull: half_turn.hull(), center: half_turn.center(), half }
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
    ///
    /// # Panics
    /// When the hull does not have the vertex: it is of another boundary.
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

/// The visitor that collects the start of every edge of the boundary.
struct Starts(Vec<BoundaryVertex>);

impl EdgeVisitor for Starts {
    fn hull_edge(&mut self, from: BoundaryVertex, _: usize) {
        self.0.push(from);
    }

    fn bridge(&mut self, from: BoundaryVertex, _: usize) {
        self.0.push(from);
    }
}

/// A point of finite coordinates in homogeneous coordinates.
pub(crate) fn homogeneous([x, y]: [f64; 2]) -> [Dyadic; 3] {
    [x, y, 1.0].map(Dyadic::from_f64)
}

/// Half of the boundary around a point or a segment.
fn half_of_segment(hull: &ConvexHull, center: [f64; 2]) -> Vec<BoundaryVertex> {
    let at = BoundaryVertex::new;
    match *hull.vertices() {
        [first, last] => {
            let clockwise = orientation(first, last, center) == Turn::Right;
            vec![at(0, false), at(1, clockwise), at(0, true)]
        }
        _ => vec![at(0, false), at(0, true)],
    }
}
