//! The parts of a mesh in the coordinates of its motion, and triangles where exact motions put them.

use std::cell::RefCell;
use std::rc::Rc;

use crate::bvh::triangles::meet_exactly;
use crate::bvh::{BoundingVolume, Bvh};
use crate::motion::arc::Arc;
use crate::motion::quaternion::{image, polar_rotation};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::ExactVector;
use crate::numeric::linear::dot;
use crate::numeric::scaling::{scale_by_power_of_two, scaled_exactly};
use crate::numeric::tolerance::UNDERFLOW;
use crate::zonotope::Zonotope;

/// A hierarchy with what the descent needs of its nodes.
pub(super) struct Parts<'a, V> {
    hierarchy: &'a Bvh<V>,
    /// The exponent of the power of two by which all lengths are multiplied.
    exponent: i64,
    /// For each node the place of its zonotope in the list, counted from 1; 0 where none is made.
    places: RefCell<Vec<u32>>,
    /// Zonotopes around nodes in the mesh's own coordinates, made when they are asked for; none where the range of
    /// doubles is too narrow for one.
    zonotopes: RefCell<Vec<Option<Rc<Zonotope<3>>>>>,
}

impl<'a, V: BoundingVolume> Parts<'a, V> {
    /// The parts of a mesh times 2^`exponent`, by which all vertices are scaled exactly.
    pub(super) fn new(hierarchy: &'a Bvh<V>, exponent: i64) -> Self {
        let places = RefCell::new(vec![0; hierarchy.volumes().len()]);
        Self { hierarchy, exponent, places, zonotopes: RefCell::new(Vec::new()) }
    }

    /// A zonotope around a node; none of one for which the range of doubles is too narrow.
    pub(super) fn body(&self, node: usize) -> Option<Rc<Zonotope<3>>> {
        let (mut places, mut zonotopes) = (self.places.borrow_mut(), self.zonotopes.borrow_mut());
        if places[node] == 0 {
            zonotopes.push(self.around(node).map(Rc::new));
            places[node] = zonotopes.len() as u32;
        }
        zonotopes[places[node] as usize - 1].clone()
    }

    /// The corners of a triangle.
    pub(super) fn corners(&self, triangle: usize) -> [[f64; 3]; 3] {
        self.hierarchy.mesh().corners(triangle).map(|corner| corner.map(|c| scale_by_power_of_two(c, self.exponent)))
    }

    fn around(&self, node: usize) -> Option<Zonotope<3>> {
        let unit = self.hierarchy.unit() + self.exponent;
        let own = self.hierarchy.volumes()[node].as_zonotope();
        // a vertex may have lost digits on its way into the units
        let lost = if self.hierarchy.is_rounded() { UNDERFLOW } else { 0.0 };
        let margins = [[lost, 0.0, 0.0], [0.0, lost, 0.0], [0.0, 0.0, lost]].into_iter().filter(|_| lost > 0.0);
        let generators = own.generators().iter().copied().chain(margins);
        let generators = generators.map(|g| scaled_exactly(&g, unit)).collect::<Option<Vec<_>>>()?;
        Zonotope::new(scaled_exactly(&own.center(), unit)?, generators).ok()
    }

    /// The children of a node, none of a leaf.
    pub(super) fn children(&self, node: usize) -> Option<[usize; 2]> {
        self.hierarchy.topology().nodes()[node].children(node)
    }

    /// The triangles below a node.
    pub(super) fn triangles(&self, node: usize) -> &'a [u32] {
        let topology = self.hierarchy.topology();
        &topology.order()[topology.nodes()[node].range()]
    }

    /// About half the diagonal of a node, by which the larger one of two is opened.
    pub(super) fn size(&self, node: usize) -> f64 {
        scale_by_power_of_two(self.hierarchy.size(node), self.hierarchy.unit() + self.exponent)
    }

    /// The corners of a triangle where the end of an exact stretch puts it, times the weight and the square of the
    /// quaternion there.
    fn image(&self, triangle: usize, arc: &Arc<Dyadic>, end: usize) -> [ExactVector; 3] {
        let turn = &arc.turns[end];
        let (rotation, square) = (polar_rotation(turn, turn), dot(turn, turn));
        self.corners(triangle).map(|corner| {
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
