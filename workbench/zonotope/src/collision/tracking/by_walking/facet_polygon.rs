//! A facet as a polygon: where a point lies relative to its plane and its edges, decided exactly.
//!
//! Corners are sums of generators, seldom vectors of doubles; they are kept exactly, and rounded for filters. The edges
//! and the normal have the directions of generators and of their cross products, which are exact in doubles or products
//! of these.

use std::cmp::Ordering;

use crate::arrangement::facet_walk::{FacetName, FacetWalk, HullWalk, NormalSense};
use crate::collision::distance::FeatureKind;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, exact, multiple};

/// An exact vector with its coordinates in doubles.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) exact: ExactVector,
    rounded: BoundedVector,
}

/// A facet with its corners, counter-clockwise seen from outside.
#[derive(Debug, Clone)]
pub(super) struct FacetPolygon {
    /// Two vectors along the facet, the cross product of which is the outward normal.
    spanning: [[f64; 3]; 2],
    corners: Vec<Place>,
    /// The direction of the edge that begins at each corner.
    along: Vec<[f64; 3]>,
}

/// The face of a polygon, of the least dimension, that holds its point nearest to some point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NearestFace {
    Whole,
    /// The inside of an edge.
    Edge(usize),
    Corner(usize),
}

impl Place {
    pub(super) fn new(exact: ExactVector) -> Self {
        Self { rounded: bounded::leading(&exact), exact }
    }

    /// The vector from another place to this one, in doubles.
    fn rounded_from(&self, other: &Self) -> BoundedVector {
        [0, 1, 2].map(|k| self.rounded[k] - other.rounded[k])
    }

    /// The vector from another place to this one.
    fn exact_from(&self, other: &Self) -> ExactVector {
        difference(&self.exact, &other.exact)
    }
}

/// The sign of a number that is known in doubles and, where these leave it open, exactly.
fn sign(rounded: Bounded, exact: impl FnOnce() -> Dyadic) -> Ordering {
    rounded.sign().map_or_else(|| exact().sign(), |sign| sign.cmp(&0))
}

impl FacetPolygon {
    /// The facet at which a walk is, of generators in the order of the walk.
    pub(super) fn of(walk: &mut HullWalk, generators: &[[f64; 3]]) -> Self {
        let FacetName { first, second, normal } = walk.facet();
        let [first, second] = [first, second].map(|index| generators[index]);
        let spanning = if normal == NormalSense::Along { [first, second] } else { [second, first] };
        let edges = walk.edges();
        let corner = |edge: usize| walk.vertex(edge).expect("every edge of a facet begins at a corner");
        let corners = (0..edges.len()).map(corner).map(Place::new).collect();
        let along = edges.into_iter().map(|edge| {
            let v = generators[edge.generator];
            if edge.is_reversed { v.map(|c| -c) } else { v }
        });
        Self { spanning, corners, along: along.collect() }
    }

    /// How many corners there are.
    pub(super) fn len(&self) -> usize {
        self.corners.len()
    }

    pub(super) fn corner(&self, corner: usize) -> &Place {
        &self.corners[corner]
    }

    /// The corner at a place.
    pub(super) fn corner_at(&self, place: &ExactVector) -> Option<usize> {
        self.corners.iter().position(|corner| corner.exact == *place)
    }

    fn rounded_normal(&self) -> BoundedVector {
        let [a, b] = self.spanning.map(bounded::exact);
        cross(&a, &b)
    }

    /// The outward normal.
    pub(super) fn normal(&self) -> ExactVector {
        let [a, b] = self.spanning.map(exact);
        cross(&a, &b)
    }

    /// On which side of the plane of the facet a point lies: greater if beyond it, seen from the body.
    pub(super) fn side(&self, point: &Place) -> Ordering {
        let corner = &self.corners[0];
        let rounded = dot(&self.rounded_normal(), &point.rounded_from(corner));
        sign(rounded, || dot(&self.normal(), &point.exact_from(corner)))
    }

    /// The face of the polygon that holds the point nearest to a point of space.
    ///
    /// The plane around a convex polygon is divided into the strips beyond its edges and the cones beyond its corners,
    /// and the plane's point below the given one is in one of these or in the polygon.
    pub(super) fn nearest_face(&self, point: &Place) -> NearestFace {
        let normal = self.rounded_normal();
        let count = self.len();
        let inward = |edge: usize| {
            let (corner, along) = (&self.corners[edge], self.along[edge]);
            let rounded = dot(&normal, &cross(&bounded::exact(along), &point.rounded_from(corner)));
            sign(rounded, || dot(&self.normal(), &cross(&exact(along), &point.exact_from(corner))))
        };
        // for each corner whether the point is ahead of it along the edge that begins there, and along the one before
        let ahead = |corner: usize, edge: usize| {
            let (corner, along) = (&self.corners[corner], self.along[edge]);
            let rounded = dot(&bounded::exact(along), &point.rounded_from(corner));
            sign(rounded, || dot(&exact(along), &point.exact_from(corner)))
        };
        let is_beyond: Vec<bool> = (0..count).map(|edge| inward(edge).is_le()).collect();
        if !is_beyond.contains(&true) {
            return NearestFace::Whole;
        }
        let is_beside = |edge: usize| ahead(edge, edge).is_gt() && ahead((edge + 1) % count, edge).is_lt();
        if let Some(edge) = (0..count).find(|&edge| is_beyond[edge] && is_beside(edge)) {
            return NearestFace::Edge(edge);
        }
        let before = |corner: usize| (corner + count - 1) % count;
        let is_in_cone = |corner: usize| ahead(corner, corner).is_le() && ahead(corner, before(corner)).is_ge();
        let corner = (0..count).find(|&corner| is_in_cone(corner));
        NearestFace::Corner(corner.expect("the strips and cones around a polygon cover what is outside of it"))
    }

    /// How near a face of the polygon comes to the point to which it is nearest.
    pub(super) fn reach(&self, face: NearestFace, point: &Place) -> Reach {
        match face {
            NearestFace::Whole => {
                let normal = self.normal();
                let along = dot(&normal, &point.exact_from(&self.corners[0]));
                let square = dot(&normal, &normal);
                Reach { kind: FeatureKind::Facet, direction: normal, numerator: &along * &along, denominator: square }
            }
            NearestFace::Edge(edge) => {
                let (along, off) = (exact(self.along[edge]), point.exact_from(&self.corners[edge]));
                let (square, part) = (dot(&along, &along), dot(&along, &off));
                let direction = difference(&multiple(&square, &off), &multiple(&part, &along));
                let area = cross(&along, &off);
                let numerator = dot(&area, &area);
                Reach { kind: FeatureKind::Edge, direction, numerator, denominator: square }
            }
            NearestFace::Corner(corner) => {
                let off = point.exact_from(&self.corners[corner]);
                let numerator = dot(&off, &off);
                Reach { kind: FeatureKind::Vertex, direction: off, numerator, denominator: Dyadic::one() }
            }
        }
    }
}

/// How near a face comes to a point.
#[derive(Debug, Clone)]
pub(super) struct Reach {
    pub(super) kind: FeatureKind,
    /// From the nearest point of the face to the point, times a positive number.
    pub(super) direction: ExactVector,
    /// The square of the distance, over a positive number.
    pub(super) numerator: Dyadic,
    pub(super) denominator: Dyadic,
}

impl Reach {
    /// Whether this distance is less than another one.
    pub(super) fn is_nearer_than(&self, other: &Self) -> bool {
        &self.numerator * &other.denominator < &other.numerator * &self.denominator
    }
}
