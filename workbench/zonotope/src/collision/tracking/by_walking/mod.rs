//! Tracking two bodies that translate, by walking over the facets of their sum: the closest feature of a frame is near
//! that of the frame before.
//!
//! # Statement
//! Input: two bodies of space whose generators span space, and frame by frame the places of their centres. Output: for
//! each frame how the bodies meet and, if they are disjoint, the closest face of their sum with the distance
//! ([`Walked`]). Zero, parallel and coplanar generators and one body without any are ordinary input; bodies of a flat
//! sum are refused.
//!
//! # Source
//! Lemma 5.6 and the methods of Lin and Canny and of Mirtich that Section 5.2 carries over to implicit zonotopes.
//! Departure: the paper walks on both bodies at once; here the walk is on A ⊕ (−B), where the closest features are the
//! face nearest to the displacement p of the centres. A translation moves p and nothing else, so the walk stays. A
//! rotation changes the sum, and the images of generators under it are no doubles: it takes another tracker.
//!
//! # Method
//! 1. The walk is at a facet F. If p is not beyond the plane of F, the walk follows the ray to p
//!    ([`facet_walk`](crate::arrangement::facet_walk)); if p is not beyond the plane of the last facet either, it is in
//!    the body, on its boundary if it is in that plane.
//! 2. Otherwise let x be the point of F nearest to p. Inside F it is the nearest one of the body, as p is beyond the
//!    plane.
//! 3. If x is inside an edge, the walk crosses it if p is beyond the plane of the facet there, and that facet comes
//!    nearer to p.
//! 4. If x is a corner, the walk goes around the corner, from facet to facet, and stays at the first one with p beyond
//!    its plane that comes nearer.
//! 5. Where no facet comes nearer, x is the nearest point of the body.
//!
//! Each move of 3 and 4 lowers the distance from p to the facet, strictly and exactly, so no facet comes twice and the
//! walk ends. It ends at the nearest point: if p − x were not in the normal cone of the body at x, the projection of p
//! on the tangent cone at x would be another point than x. It lies on a facet of that cone with p beyond its plane, and
//! moving from x towards it comes nearer to p: that facet has x on it, and the walk would have moved there. Facets
//! whose plane hides p are left out since one that is nearest to p with its inside may still be on the far side.
//!
//! # Complexity
//! n generators: O(log² n) for each edge crossed and O(k) exact operations for a facet of k classes of generators; a
//! corner of m facets costs m crossings. A motion by a body's size crosses O(n) edges. Built in O(n log n), space O(n).
//!
//! # Shapes
//! `bodies`: generators in any order, those of the first before those of the second.
//!
//! # Numerics
//! All decisions are exact: doubles with a bound of their error, then exact numbers. The square of the distance is
//! exact.
//!
//! # Errors
//! [`WalkError`] if the generators of both bodies do not span space; [`NonFinite`] if a place is not finite.
//!
//! # Checked by
//! The twins of location and distance, on small bodies of whole numbers;
//! [`by_support_simplex`](crate::collision::distance::by_support_simplex), on frames of all families of bodies that
//! pass, slide, touch and jump; the verifier, on their proofs.
//!
//! # Example
//! ```
//! use zonotope::collision::Status;
//! use zonotope::collision::distance::FeatureKind;
//! use zonotope::collision::tracking::WalkingTracker;
//! use zonotope::zonotope::Zonotope;
//! // two cubes [−1, 1]³, the second one 3 to the right and 4 above a place beside the first
//! let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let cube = Zonotope::new([0.0; 3], axes).unwrap();
//! let mut tracker = WalkingTracker::new(&cube, &cube).unwrap();
//! let frame = tracker.frame([0.0; 3], [5.0, 6.0, 0.5]).unwrap();
//! assert_eq!((frame.squared_distance(), frame.closest()), (25.0, Some(FeatureKind::Edge)));
//! assert_eq!(tracker.frame([0.0; 3], [2.0, 1.0, 0.5]).unwrap().status(), Status::Boundary);
//! ```

mod answer;
mod facet_polygon;

#[cfg(test)]
mod tests;

pub use answer::Walked;

use std::cmp::Ordering;

use self::facet_polygon::{FacetPolygon, NearestFace, Place, Reach};
use crate::arrangement::facet_walk::{FacetWalk, HullWalk, WalkError};
use crate::collision::{Query, Status};
use crate::numeric::exact_linear::{difference, exact};
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::Zonotope;

/// Two bodies that translate, and a walk over the facets of their sum.
#[derive(Debug, Clone)]
pub struct WalkingTracker {
    generators: Vec<[f64; 3]>,
    walk: HullWalk,
    /// The facet at which the walk is.
    polygon: FacetPolygon,
}

/// The walk of one frame.
struct FrameWalk<'t> {
    tracker: &'t mut WalkingTracker,
    point: Place,
    steps: u64,
}

impl WalkingTracker {
    /// A tracker of two bodies, whose generators are copied. O(n log n).
    ///
    /// # Errors
    /// [`WalkError`] if the generators of both do not span space.
    pub fn new(first: &Zonotope<3>, second: &Zonotope<3>) -> Result<Self, WalkError> {
        let generators = [first.generators(), second.generators()].concat();
        let mut walk = HullWalk::new(&generators)?;
        Ok(Self { polygon: FacetPolygon::of(&mut walk, &generators), walk, generators })
    }

    /// How the bodies meet when their centres are at two places.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate is NaN or infinite; the walk stays where it is.
    pub fn frame(&mut self, first: [f64; 3], second: [f64; 3]) -> Result<Walked<'_>, NonFinite> {
        NonFinite::check_vector("the start", &first)?;
        NonFinite::check_vector("the end", &second)?;
        let point = Place::new(difference(&exact(second), &exact(first)));
        let mut frame = FrameWalk { tracker: self, point, steps: 0 };
        let (status, closest) = match frame.side_at_ray() {
            Ordering::Greater => (Status::Outside, Some(frame.nearest())),
            Ordering::Equal => (Status::Boundary, None),
            Ordering::Less => (Status::Inside, None),
        };
        let steps = frame.steps;
        let query = Query::of_finite(first, second, &self.generators);
        Ok(Walked { query, status, facet: self.walk.facet(), steps, closest })
    }
}

impl FrameWalk<'_> {
    /// Crosses an edge.
    fn step(&mut self, edge: usize) {
        let WalkingTracker { generators, walk, polygon } = self.tracker;
        walk.step(edge).expect("the edge is one of the facet's");
        *polygon = FacetPolygon::of(walk, generators);
        self.steps += 1;
    }

    /// On which side of the plane of the walk's facet the point is: beyond it, or after a walk to the ray through the
    /// point.
    fn side_at_ray(&mut self) -> Ordering {
        if self.tracker.polygon.side(&self.point).is_gt() {
            return Ordering::Greater;
        }
        let WalkingTracker { generators, walk, polygon } = self.tracker;
        self.steps += walk.walk_along(&self.point.exact);
        *polygon = FacetPolygon::of(walk, generators);
        polygon.side(&self.point)
    }

    /// Walks to a facet with the point of the body that is nearest to a point beyond the plane of this one.
    fn nearest(&mut self) -> Reach {
        let mut face = self.tracker.polygon.nearest_face(&self.point);
        let mut reach = self.tracker.polygon.reach(face, &self.point);
        while let Some((nearer_face, nearer)) = match face {
            NearestFace::Whole => None,
            NearestFace::Edge(edge) => self.nearer_across(edge, &reach),
            NearestFace::Corner(corner) => self.nearer_around(corner, &reach),
        } {
            (face, reach) = (nearer_face, nearer);
        }
        reach
    }

    /// Crosses an edge if the facet beyond comes nearer.
    fn nearer_across(&mut self, edge: usize, reach: &Reach) -> Option<(NearestFace, Reach)> {
        let start = self.tracker.polygon.corner(edge).exact.clone();
        self.step(edge);
        let nearer = self.nearer_here(reach);
        if nearer.is_none() {
            // the edge runs the other way here: it ends where it began
            let count = self.tracker.polygon.len();
            let end = self.tracker.polygon.corner_at(&start).expect("both facets have the edge");
            self.step((end + count - 1) % count);
        }
        nearer
    }

    /// Goes around a corner to the first facet that comes nearer, or once around.
    fn nearer_around(&mut self, corner: usize, reach: &Reach) -> Option<(NearestFace, Reach)> {
        let (home, place) = (self.tracker.walk.facet(), self.tracker.polygon.corner(corner).exact.clone());
        let mut edge = corner;
        loop {
            self.step(edge);
            if self.tracker.walk.facet() == home {
                return None;
            }
            let nearer = self.nearer_here(reach);
            if nearer.is_some() {
                return nearer;
            }
            edge = self.tracker.polygon.corner_at(&place).expect("the facets around a corner have it");
        }
    }

    /// The nearest face of this facet, if the point is beyond the facet's plane and the face comes nearer.
    fn nearer_here(&self, reach: &Reach) -> Option<(NearestFace, Reach)> {
        if !self.tracker.polygon.side(&self.point).is_gt() {
            return None;
        }
        let face = self.tracker.polygon.nearest_face(&self.point);
        let own = self.tracker.polygon.reach(face, &self.point);
        own.is_nearer_than(reach).then_some((face, own))
    }
}
