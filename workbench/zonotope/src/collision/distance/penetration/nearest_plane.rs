//! The nearest of the planes of the facets around a point, exactly.

use super::Penetration;
use crate::collision::distance::answer::rounded_length;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::sum_of_products;

/// The nearest plane to a point p of those that were compared.
pub(super) struct NearestPlane<const D: usize> {
    p: [Dyadic; D],
    nearest: Option<Plane>,
    is_inside: bool,
}

struct Plane {
    normal: Vec<Dyadic>,
    /// The distance of the plane times the length of the normal.
    along: Dyadic,
    /// The square of the length of the normal.
    square: Dyadic,
}

impl<const D: usize> NearestPlane<D> {
    /// No plane around a point yet.
    pub(super) fn of(p: [Dyadic; D]) -> Self {
        Self { p, nearest: None, is_inside: true }
    }

    /// Whether the point lies strictly between the planes of every pair so far.
    pub(super) fn is_inside(&self) -> bool {
        self.is_inside
    }

    /// Takes note of the planes with a normal u and its opposite at which the body ends, of which `reach` is h(u).
    pub(super) fn compare(&mut self, normal: Vec<Dyadic>, reach: Dyadic) {
        let level = sum_of_products(&normal, &self.p);
        let is_opposite = level.sign().is_lt();
        let along = reach - level.abs();
        self.is_inside &= along.sign().is_gt();
        let square = sum_of_products(&normal, &normal);
        let is_nearer = |best: &Plane| &(&along * &along) * &best.square < &(&best.along * &best.along) * &square;
        if self.nearest.as_ref().is_none_or(is_nearer) {
            let normal = if is_opposite { normal.into_iter().map(|c| -c).collect() } else { normal };
            self.nearest = Some(Plane { normal, along, square });
        }
    }

    /// The distance of the nearest plane; none where a point is not inside.
    pub(super) fn depth(self) -> Penetration<D> {
        let Some(Plane { normal, along, square }) = self.nearest.filter(|_| self.is_inside) else {
            return Penetration::NONE;
        };
        let depth = rounded_length(&along, &square);
        let exponent = normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        Penetration {
            lower: depth.next_down().next_down().max(0.0),
            upper: depth.next_up().next_up(),
            direction: std::array::from_fn(|k| normal[k].clone().scaled(-exponent).to_f64()),
        }
    }
}
