//! The parts of a mesh in the coordinates of its motion, and triangles where exact motions put them.

use std::cell::OnceCell;

use super::answer::Part;
use crate::bvh::triangles::meet_exactly;
use crate::bvh::{BoundingVolume, Bvh};
use crate::motion::arc::Arc;
use crate::motion::continuous::parts::body::Body;
use crate::motion::quaternion::{image, polar_rotation};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::dot;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::numeric::tolerance::UNDERFLOW;
use crate::zonotope::Zonotope;

/// A hierarchy with what the descent needs of its nodes.
pub(super) struct Parts<'a, V> {
    hierarchy: &'a Bvh<V>,
    /// A zonotope around each node in the mesh's own coordinates, made when it is asked for; none where the range of
    /// doubles is too narrow for it.
    nodes: Vec<OnceCell<Option<Zonotope<3>>>>,
    corners: Vec<[[f64; 3]; 3]>,
}

impl<'a, V: BoundingVolume> Parts<'a, V> {
    pub(super) fn new(hierarchy: &'a Bvh<V>) -> Self {
        let nodes = hierarchy.volumes().iter().map(|_| OnceCell::new()).collect();
        let corners = (0..hierarchy.mesh().triangles().len()).map(|t| hierarchy.mesh().corners(t)).collect();
        Self { hierarchy, nodes, corners }
    }

    /// A body around a part; none of a node for which the range of doubles is too narrow.
    pub(super) fn body(&self, part: Part) -> Option<Body<'_>> {
        match part {
            Part::Node(node) => self.nodes[node].get_or_init(|| self.around(node)).as_ref().map(Body::of),
            Part::Triangle(triangle) => Some(Body::hull_of(&self.corners[triangle])),
        }
    }

    fn around(&self, node: usize) -> Option<Zonotope<3>> {
        let unit = self.hierarchy.unit();
        let own = self.hierarchy.volumes()[node].as_zonotope();
        let exactly = |c: f64| {
            let scaled = scale_by_power_of_two(c, unit);
            (scale_by_power_of_two(scaled, -unit) == c).then_some(scaled)
        };
        let vector = |v: &[f64; 3]| Some([exactly(v[0])?, exactly(v[1])?, exactly(v[2])?]);
        // a vertex may have lost digits on its way into the units
        let lost = if self.hierarchy.is_rounded() { UNDERFLOW } else { 0.0 };
        let margins = [[lost, 0.0, 0.0], [0.0, lost, 0.0], [0.0, 0.0, lost]].into_iter().filter(|_| lost > 0.0);
        let generators = own.generators().iter().copied().chain(margins);
        let generators = generators.map(|g| vector(&g)).collect::<Option<Vec<_>>>()?;
        Zonotope::new(vector(&own.center())?, generators).ok()
    }

    /// The parts of a part: children of a node, or the triangles of a leaf; none of a triangle.
    pub(super) fn opened(&self, part: Part) -> Vec<Part> {
        let Part::Node(node) = part else { return Vec::new() };
        let topology = self.hierarchy.topology();
        match topology.nodes()[node].children(node) {
            Some(children) => children.map(Part::Node).into(),
            None => {
                let below = &topology.order()[topology.nodes()[node].range()];
                below.iter().map(|&triangle| Part::Triangle(triangle as usize)).collect()
            }
        }
    }

    /// About half the diagonal of a part, by which the larger one of two is opened; that of a triangle counts as none.
    pub(super) fn size(&self, part: Part) -> f64 {
        match part {
            Part::Node(node) => scale_by_power_of_two(self.hierarchy.size(node), self.hierarchy.unit()),
            Part::Triangle(_) => -1.0,
        }
    }

    /// The corners of a triangle where the end of an exact stretch puts it, times the weight and the square of the
    /// quaternion there.
    fn image(&self, triangle: usize, arc: &Arc<Dyadic>, end: usize) -> [ExactVector; 3] {
        let turn = &arc.turns[end];
        let (rotation, square) = (polar_rotation(turn, turn), dot(turn, turn));
        self.corners[triangle].map(|corner| {
            let turned = image(&rotation, &arc.arm_of(&corner));
            [0, 1, 2].map(|k| &turned[k] + &(&square * &arc.base[end][k]))
        })
    }

    /// The positive number by which an image is too large.
    fn factor(arc: &Arc<Dyadic>, end: usize) -> Dyadic {
        &dot(&arc.turns[end], &arc.turns[end]) * &arc.weight
    }
}

/// Whether two triangles meet at an end of exact stretches of their motions.
pub(super) fn meet<V: BoundingVolume>(
    parts: [&Parts<'_, V>; 2],
    triangles: [usize; 2],
    arcs: &[Arc<Dyadic>; 2],
    end: usize,
) -> bool {
    let [a, b] = [0, 1].map(|i| {
        let other = Parts::<V>::factor(&arcs[1 - i], end);
        parts[i].image(triangles[i], &arcs[i], end).map(|corner| corner.map(|c| &c * &other))
    });
    meet_exactly(&a, &b)
}
