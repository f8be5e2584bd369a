//! A question about two placed hierarchies: the frame in which it is asked, and the tests of nodes and of triangles.

use std::borrow::Cow;

use super::frame::Frame;
use super::hierarchy::{Bvh, PlacedBvh};
use super::mesh::PlacedMesh;
use super::triangles::plane::{Corners, Planar};
use super::triangles::{by_planes, distance as of_triangles, meet_exactly};
use super::volume::BoundingVolume;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::root::Root;
use crate::numeric::exact_linear::{ExactVector, exact};
use crate::numeric::linear::max_norm;
use crate::numeric::outward::at_least;
use crate::numeric::tolerance::{DISTANCE_OF_A_FRAME, PRODUCT_UNDERFLOW, ROUNDED_IMAGE};

/// One of both meshes.
struct Side<'a, V: Clone> {
    hierarchy: Cow<'a, Bvh<V>>,
    mesh: PlacedMesh<'a>,
}

/// Two hierarchies in a common frame, that of the one with the larger unit.
pub(crate) struct Question<'a, V: BoundingVolume> {
    sides: [Side<'a, V>; 2],
    /// Whether the second mesh of the caller comes first.
    is_swapped: bool,
    pub(super) frame: Frame,
    prepared: V::Prepared,
    /// Largest magnitude of a coordinate of a corner in the frame.
    largest_coordinate: f64,
}

impl<'a, V: BoundingVolume> Question<'a, V> {
    /// The question about two hierarchies under poses. O(1) for rotations; of poses that shear, scale or flatten, both
    /// are fitted anew where they stand.
    pub(crate) fn new(first: PlacedBvh<'a, V>, second: PlacedBvh<'a, V>) -> Self {
        let is_swapped = first.hierarchy().exponent < second.hierarchy().exponent;
        let placed = if is_swapped { [second, first] } else { [first, second] };
        let meshes = placed.map(|placed| placed.mesh());
        let exponents = placed.map(|placed| placed.hierarchy().exponent);
        let (hierarchies, frame) = match Frame::of_poses([meshes[0].pose(), meshes[1].pose()], exponents) {
            Some(frame) => (placed.map(|placed| Cow::Borrowed(placed.hierarchy())), frame),
            None => (images(&placed), Frame::of_rounded_points(ROUNDED_IMAGE)),
        };
        let [a, b] = hierarchies;
        let sides = [Side { hierarchy: a, mesh: meshes[0] }, Side { hierarchy: b, mesh: meshes[1] }];
        let largest_coordinate = 4.0 + max_norm(&frame.shift);
        Self { sides, is_swapped, frame, prepared: V::prepared(&frame), largest_coordinate }
    }

    /// The hierarchies, in the order of the frame.
    pub(super) fn hierarchies(&self) -> [&Bvh<V>; 2] {
        [&self.sides[0].hierarchy, &self.sides[1].hierarchy]
    }

    /// A proven lower bound of the distance of two nodes in the frame, negative where none is proved.
    #[inline]
    pub(super) fn proven_gap(&self, [a, b]: [usize; 2]) -> f64 {
        let [first, second] = self.hierarchies();
        first.volumes[a].gap(&second.volumes[b], &self.prepared) - self.frame.slack
    }

    /// Whether two nodes are proved disjoint, in the order of the frame.
    #[inline]
    pub(crate) fn are_apart(&self, [a, b]: [usize; 2]) -> bool {
        let [first, second] = self.hierarchies();
        first.volumes[a].is_apart(&second.volumes[b], &self.prepared, self.frame.slack)
    }

    /// The pairs of a node with the children of the other one: of the larger of both, or of the one that is no leaf;
    /// none of two leaves.
    #[inline]
    pub(super) fn opened(&self, [i, j]: [usize; 2]) -> Option<[[usize; 2]; 2]> {
        let [a, b] = self.hierarchies();
        match (a.topology.nodes[i].children(i), b.topology.nodes[j].children(j)) {
            (None, None) => None,
            (Some(children), of_b)
                if of_b.is_none() || a.half_diagonals[i] >= self.frame.ratio * b.half_diagonals[j] =>
            {
                Some(children.map(|child| [child, j]))
            }
            (_, Some(children)) => Some(children.map(|child| [i, child])),
            (Some(_), None) => unreachable!("the arm before takes a node beside a leaf"),
        }
    }

    /// A pair of triangles in the order of the caller, or of nodes in that of the frame.
    #[inline]
    pub(crate) fn ordered(&self, [i, j]: [usize; 2]) -> [usize; 2] {
        if self.is_swapped { [j, i] } else { [i, j] }
    }

    /// The corners of a triangle of one side in the frame.
    #[inline]
    pub(super) fn corners(&self, side: usize, triangle: usize) -> Corners {
        let hierarchy = &*self.sides[side].hierarchy;
        let values = hierarchy.mesh.triangles()[triangle].map(|vertex| hierarchy.points[vertex as usize]);
        if side == 0 {
            return Corners { values, error: hierarchy.rounding };
        }
        let error = self.frame.point_error + hierarchy.rounding;
        let error = if self.frame.ratio == 1.0 { error } else { error + PRODUCT_UNDERFLOW };
        Corners { values: values.map(|corner| self.frame.image(&corner)), error }
    }

    /// Whether two triangles meet.
    #[inline]
    pub(super) fn meet(&self, pair: [usize; 2], [a, b]: [&Planar; 2], exact_tests: &mut u64) -> bool {
        if a.has_beside(&b.corners) || b.has_beside(&a.corners) {
            return false;
        }
        by_planes::meet(&a.corners.bounded(), &b.corners.bounded()).unwrap_or_else(|| {
            *exact_tests += 1;
            let [a, b] = self.exact_corners(pair);
            meet_exactly(&a, &b)
        })
    }

    #[cold]
    fn exact_corners(&self, [i, j]: [usize; 2]) -> [[ExactVector; 3]; 2] {
        [self.sides[0].mesh.exact_corners(i), self.sides[1].mesh.exact_corners(j)]
    }

    /// Bounds of the distance of two triangles in the frame.
    pub(super) fn bounds(&self, [a, b]: [&Corners; 2]) -> [f64; 2] {
        of_triangles::bounds(&a.values, &b.values, self.largest_coordinate, a.error.max(b.error))
    }

    /// The neighbouring doubles of the distance of two triangles, in the coordinates in which the meshes were placed.
    pub(super) fn exact_bounds(&self, pair: [usize; 2]) -> [f64; 2] {
        let [a, b] = self.exact_corners(pair);
        if meet_exactly(&a, &b) {
            return [0.0; 2];
        }
        let square = of_triangles::exact_square(&a, &b);
        let ratio = square.numerator.to_rational() / square.denominator.to_rational();
        let root = Root::of(&ratio, 0);
        [root.below, root.above]
    }

    /// An upper bound of a length in the frame.
    pub(super) fn in_frame(&self, length: f64) -> f64 {
        if !length.is_finite() {
            return length;
        }
        let in_units = Dyadic::from_f64(length).scaled(-self.unit());
        at_least(&in_units) * (1.0 + 2.0 * DISTANCE_OF_A_FRAME)
    }

    /// The exponent of the frame's unit.
    pub(super) fn unit(&self) -> i64 {
        self.sides[0].hierarchy.exponent
    }
}

/// Both hierarchies fitted anew around the rounded places of their vertices, in a common unit.
fn images<'a, V: BoundingVolume>(placed: &[PlacedBvh<'a, V>; 2]) -> [Cow<'a, Bvh<V>>; 2] {
    let places = placed.map(|placed| {
        let pose = *placed.mesh().pose();
        let vertices = placed.hierarchy().mesh.vertices().iter();
        vertices
            .map(|v| if pose == crate::Pose::IDENTITY { exact(*v) } else { pose.exact_point(*v) })
            .collect::<Vec<_>>()
    });
    let exponents = places.iter().flatten().flatten().filter_map(Dyadic::binary_exponent);
    let exponent = exponents.max().unwrap_or(0) + 1;
    let [a, b] = [0, 1].map(|side| {
        let rounded = |place: &ExactVector| place.clone().map(|c| c.scaled(-exponent).to_f64());
        let points: Vec<[f64; 3]> = places[side].iter().map(rounded).collect();
        let hierarchy = placed[side].hierarchy();
        hierarchy.with_points(hierarchy.mesh.clone(), points, exponent, ROUNDED_IMAGE)
    });
    [Cow::Owned(a), Cow::Owned(b)]
}
