//! The point of a simplex nearest to the origin, exactly.
//!
//! The simplex is kept as small as possible: its nearest point is in its interior, a combination of all its vertices
//! with positive weights. That point is known by a positive multiple of it, in whose coordinates there are no
//! quotients.

use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, multiple, negated, sum};

/// A simplex of at most three vertices whose hull does not hold the origin.
#[derive(Debug)]
pub(super) struct ExactSimplex {
    vertices: Vec<ExactVector>,
    /// A positive multiple of the nearest point.
    nearest: ExactVector,
}

impl ExactSimplex {
    /// A single point, not the origin.
    pub(super) fn of(vertex: ExactVector) -> Self {
        Self { nearest: vertex.clone(), vertices: vec![vertex] }
    }

    /// A positive multiple of the nearest point.
    pub(super) fn nearest(&self) -> &ExactVector {
        &self.nearest
    }

    /// One of the vertices: all have the same product with the nearest point.
    pub(super) fn vertex(&self) -> &ExactVector {
        &self.vertices[0]
    }

    /// Adds a vertex whose product with the nearest point is smaller than that of the others, and keeps those that the
    /// new nearest point needs: the new vertex, and some of the old ones.
    ///
    /// By the theorem of Carathéodory the nearest point of the hull of all has positive weights at independent
    /// vertices, among them the new one, without which the hull holds no nearer point than the old one. It is told by
    /// its products with the others, which are not smaller.
    pub(super) fn add(&mut self, vertex: ExactVector) {
        let count = self.vertices.len();
        // the old vertices that are kept, as bits: few first; of three, two at most
        let mut subsets: Vec<usize> = (0..1 << count).filter(|subset: &usize| subset.count_ones() < 3).collect();
        subsets.sort_by_key(|subset| subset.count_ones());
        for subset in subsets {
            let is_kept = |place: &usize| subset & (1 << place) != 0;
            let kept: Vec<&ExactVector> = (0..count).filter(is_kept).map(|place| &self.vertices[place]).collect();
            let Some(nearest) = inner_foot(&vertex, &kept) else { continue };
            let level = dot(&nearest, &vertex);
            let others = (0..count).filter(|place| !is_kept(place));
            if others.into_iter().all(|place| dot(&nearest, &self.vertices[place]) >= level) {
                let kept = kept.into_iter().cloned().collect::<Vec<_>>();
                *self = Self { vertices: [vec![vertex], kept].concat(), nearest };
                return;
            }
        }
        unreachable!("the hull of points of a body without the origin does not hold the origin");
    }
}

/// A positive multiple of the point of the affine hull of one to three points that is nearest to the origin, if that
/// point is a combination of them with positive weights and is not the origin.
fn inner_foot(first: &ExactVector, others: &[&ExactVector]) -> Option<ExactVector> {
    let is_positive = |number: &Dyadic| number.sign().is_gt();
    match others {
        [] => Some(first.clone()),
        [second] => {
            let edge = difference(second, first);
            let (own, other) = (dot(second, &edge), -dot(first, &edge));
            let is_inside = is_positive(&own) && is_positive(&other);
            is_inside.then(|| sum(&multiple(&own, first), &multiple(&other, second)))
        }
        [second, third] => {
            let normal = cross(&difference(second, first), &difference(third, first));
            let weights = [cross(second, third), cross(third, first), cross(first, second)].map(|v| dot(&v, &normal));
            let is_inside = weights.iter().all(is_positive);
            let level = dot(first, &normal).sign();
            (is_inside && level.is_ne()).then(|| if level.is_gt() { normal } else { negated(normal) })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::exact;
    use crate::numeric::linear;

    /// Whether two vectors are positive multiples of each other.
    fn is_multiple(a: &ExactVector, b: [f64; 3]) -> bool {
        let b = exact(b);
        cross(a, &b).iter().all(Dyadic::is_zero) && linear::dot(a, &b).sign().is_gt()
    }

    #[test]
    fn nearest_points_worked_out_by_hand() {
        let mut simplex = ExactSimplex::of(exact([2.0, 4.0, 0.0]));
        simplex.add(exact([2.0, -1.0, 0.0]));
        assert!(is_multiple(simplex.nearest(), [2.0, 0.0, 0.0]));
        // the triangle in the plane x + z = 2, with (1, 0, 1) inside
        simplex.add(exact([0.0, -1.0, 2.0]));
        assert!(is_multiple(simplex.nearest(), [1.0, 0.0, 1.0]), "{simplex:?}");
        // nearer than all of the triangle, and alone so
        simplex.add(exact([0.25, 0.0, 0.25]));
        assert!(is_multiple(simplex.nearest(), [1.0, 0.0, 1.0]));
        assert_eq!(simplex.vertices.len(), 1);
    }
}
