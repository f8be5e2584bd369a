//! What the last proof still says after a motion: the status by a few dozen operations, however many generators there
//! are.
//!
//! Let M_i be the matrices of the two bodies where the proof was found and M'_i those of now, L_i = Σ |v| over the
//! generators of body i, and h and h' the support functions of the sum of both bodies then and now. Since
//! |v · (M' − M)ᵀ u| ≤ |v| |(M' − M)ᵀ u|,
//!
//! |h'(u) − h(u)| ≤ T(u) = Σ_i |(M'_i − M_i)ᵀ u| L_i ≤ T |u|, T = Σ_i ‖M'_i − M_i‖ L_i.
//!
//! - Outside: a direction u with u · p' − h(u) > T(u) separates the displacement p' of now. Of bodies that only
//!   translate T is 0, and u is asked about without a pass.
//! - Inside: let the gauge of the displacement p of then be at most γ, and let the ball of radius r > 0 be in the body
//!   of then, so that h(u) ≥ r |u|. Then h'(u) ≥ (1 − T / r) h(u), gauges grow at most by the factor 1 / (1 − T / r),
//!   and the gauge of p' is below 1 if γ + |p' − p| / r + T / r < 1.
//!
//! A rotation takes a body's ball to one as large, so r needs no pass either. The Frobenius norm stands for ‖·‖. Nearer
//! to the boundary, the facet through which the ray left ([`ExitFacet`]) may tell that bodies that only translate still
//! overlap.

use super::exit_facet::ExitFacet;
use super::extent::Extent;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::optimum::Optimum;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, PRODUCT_UNDERFLOW, SQUARABLE_SIZES, THIRTY_ROUNDINGS, UNIT};
use crate::zonotope::pose::Pose;
use crate::zonotope::query::{Placed, Query};

/// A proof of the status of a frame, as far as it may hold after a motion.
#[derive(Debug)]
pub(super) enum Kept {
    /// A direction u and h(u).
    Outside { direction: [f64; 3], support: Bounded, place: Matrices },
    /// A member; in a box, as it is much larger.
    Inside(Box<Inside>),
}

/// A bound of the gauge of a displacement, the radius of a ball in the body, 0 if none is known, and perhaps the facet
/// through which the ray left.
#[derive(Debug)]
pub(super) struct Inside {
    displacement: BoundedVector,
    gauge: f64,
    radius: f64,
    facet: Option<ExitFacet>,
    place: Matrices,
}

/// The matrices of both poses.
pub(super) type Matrices = [[[f64; 3]; 3]; 2];

impl Kept {
    /// What an optimum proves, if doubles prove the optimum. O(1).
    pub(super) fn of_optimum(query: &Query<'_, 3, Pose>, optimum: &Optimum, extents: &[Extent; 2]) -> Option<Self> {
        if optimum.is_member() {
            let (value, error) = optimum.gauge();
            return Self::inside(query, value + error, ExitFacet::of(optimum), extents);
        }
        let Optimum::Rounded(decided) = optimum else { return None };
        let RoundedOptimum { direction, magnitude, .. } = &*decided.optimum;
        // rounding the direction by e takes it off by at most e Σ |v|_1, |v|_1 < 2 |v|
        let off = direction.iter().fold(0.0f64, |largest, c| largest.max(c.error));
        let support = decided.optimum.support();
        let error = (support.error + 4.0 * off * magnitude) * FIVE_ROUNDINGS;
        Some(Self::outside(query, direction.map(|c| c.value), Bounded { error, ..support }))
    }

    /// That a direction separates, with h(u) where the poses are.
    pub(super) fn outside(query: &Query<'_, 3, Pose>, direction: [f64; 3], support: Bounded) -> Self {
        Self::Outside { direction, support, place: matrices(query) }
    }

    /// That the gauge is at most a bound, and where the ray left; none if neither tells of other displacements.
    pub(super) fn inside(
        query: &Query<'_, 3, Pose>,
        gauge: f64,
        facet: Option<ExitFacet>,
        extents: &[Extent; 2],
    ) -> Option<Self> {
        let radius = radius_of_sum(query, extents);
        // false for NaN as well
        let is_useful = gauge < 1.0 && (facet.is_some() || radius > 0.0);
        let displacement = query.displacement_estimate();
        let place = matrices(query);
        is_useful.then(|| Self::Inside(Box::new(Inside { displacement, gauge, radius, facet, place })))
    }

    /// Whether the proof still holds where the poses are now.
    pub(super) fn holds(&self, query: &Query<'_, 3, Pose>, extents: &[Extent; 2]) -> bool {
        let p = query.displacement_estimate();
        match self {
            Self::Outside { direction, support, place } => {
                let turned = turned(place, query, extents, Some(direction));
                let room = dot(&p, &bounded::exact(*direction)) - *support;
                (room - Bounded { value: 0.0, error: turned }).is_positive()
            }
            Self::Inside(inside) => inside.holds(&p, turned(&inside.place, query, extents, None)),
        }
    }
}

impl Inside {
    /// Whether a displacement is inside after a turn by T.
    fn holds(&self, p: &BoundedVector, turned: f64) -> bool {
        let off = [0, 1, 2].map(|k| (p[k] - self.displacement[k]).magnitude());
        let way = (norm_bound(&off) + turned) / self.radius;
        // false without a ball, where the way is infinite or NaN
        let is_near = (self.gauge + way) * THIRTY_ROUNDINGS < 1.0;
        is_near || turned == 0.0 && self.facet.is_some_and(|facet| facet.holds_inside(p))
    }
}

/// The radius of a ball in the sum of both bodies; 0 where doubles do not tell.
fn radius_of_sum(query: &Query<'_, 3, Pose>, extents: &[Extent; 2]) -> f64 {
    let [from, to] = query.parts().each_ref().map(Placed::standing);
    (extents[0].radius_under(from) + extents[1].radius_under(to)) * (1.0 - 4.0 * UNIT)
}

/// s such that the gauge of any x is at most s |x|_1, if the sum of both bodies is known to hold a ball.
pub(super) fn gauge_bound(query: &Query<'_, 3, Pose>, extents: &[Extent; 2]) -> Option<f64> {
    let bound = FIVE_ROUNDINGS / radius_of_sum(query, extents);
    bound.is_finite().then_some(bound)
}

/// At least √(Σ c²), 0 only for zeros, whatever underflows in the squares.
fn norm_bound(coordinates: &[f64]) -> f64 {
    if coordinates.iter().all(|c| *c == 0.0) {
        return 0.0;
    }
    let squares: f64 = coordinates.iter().map(|c| c * c).sum();
    squares.sqrt() * THIRTY_ROUNDINGS + 16.0 * SQUARABLE_SIZES.start
}

/// At least T(u) for a direction u, or T.
fn turned(place: &Matrices, query: &Query<'_, 3, Pose>, extents: &[Extent; 2], direction: Option<&[f64; 3]>) -> f64 {
    let of = |i: usize| {
        let (then, now) = (&place[i], query.parts()[i].standing().rows());
        let off = [0, 1, 2].map(|row| [0, 1, 2].map(|k| now[row][k] - then[row][k]));
        let norm = norm_bound(off.as_flattened());
        let length = extents[i].length;
        // a body whose length overflows may stand still
        if norm == 0.0 || length == 0.0 {
            return 0.0;
        }
        let way = direction.map_or(norm, |u| {
            let along = [0, 1, 2].map(|k| dot(&off.map(|row| row[k]), u));
            norm_bound(&along) + 8.0 * UNIT * norm * norm_bound(u) + PRODUCT_UNDERFLOW
        });
        (way * length).max(f64::MIN_POSITIVE)
    };
    (of(0) + of(1)) * THIRTY_ROUNDINGS
}

fn matrices(query: &Query<'_, 3, Pose>) -> Matrices {
    query.parts().each_ref().map(|body| *body.standing().rows())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::Zonotope;

    /// The proofs of two cubes [−1, 1]³, whose sum is [−2, 2]³, hold at these displacements and turns.
    fn holds(
        kept: impl Fn(&Query<'_, 3, Pose>, &[Extent; 2]) -> Option<Kept>,
        start: [f64; 3],
        to: [f64; 3],
        turn: f64,
    ) -> bool {
        let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let cube = Zonotope::new([0.0; 3], axes).expect("finite");
        let extents = [Extent::of(cube.generators()); 2];
        let at = |place, angle| Pose::from_axis_angle([0.0, 0.0, 1.0], angle, place).expect("an axis");
        let (then, now) = (at(start, 0.0), at(to, turn));
        let first = Query::of_placed(cube.at(&Pose::IDENTITY), cube.at(&then));
        let kept = kept(&first, &extents).expect("there is room");
        kept.holds(&Query::of_placed(cube.at(&Pose::IDENTITY), cube.at(&now)), &extents)
    }

    #[test]
    fn a_direction_holds_as_far_as_it_has_room() {
        let outside = |query: &Query<'_, 3, Pose>, _: &[Extent; 2]| {
            Some(Kept::outside(query, [1.0, 0.0, 0.0], Bounded::exact(2.0)))
        };
        let holds = |x: f64, turn: f64| holds(outside, [3.0, 0.0, 0.0], [x, 7.0, -7.0], turn);
        assert!(holds(2.0 + 1e-13, 0.0) && !holds(2.0, 0.0) && !holds(-3.0, 0.0));
        // the turned cube reaches cos t + sin t ≤ 1 + t; the bound allows for 3 t
        assert!(holds(3.0, 0.3) && !holds(3.0, 0.4) && holds(2.1, 0.03) && !holds(2.1, 0.04));
    }

    #[test]
    fn a_gauge_holds_as_far_as_it_has_room() {
        let inside = |query: &Query<'_, 3, Pose>, extents: &[Extent; 2]| Kept::inside(query, 0.5, None, extents);
        let holds = |x: f64, turn: f64| holds(inside, [1.0, 0.0, 0.0], [x, 0.0, 0.0], turn);
        // the ball in the sum has a radius between 1.92 and 2
        assert!(holds(1.0, 0.0) && holds(1.95, 0.0) && !holds(2.0, 0.0) && holds(0.1, 0.0));
        // turning by t is a way of 3 √2 t
        assert!(holds(1.0, 0.2) && !holds(1.0, 0.25));
    }

    #[test]
    fn nothing_is_kept_of_a_gauge_without_room() {
        let flat = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
        let query = Query::of_placed(flat.at(&Pose::IDENTITY), flat.at(&Pose::IDENTITY));
        let extents = [Extent::of(flat.generators()); 2];
        assert!(Kept::inside(&query, 0.5, None, &extents).is_none() && gauge_bound(&query, &extents).is_none());
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let solid = [Extent::of(&cube); 2];
        for gauge in [1.0, 2.0, f64::INFINITY, f64::NAN] {
            assert!(Kept::inside(&query, gauge, None, &solid).is_none());
        }
        let bound = gauge_bound(&query, &solid).expect("the sum holds a ball");
        assert!((0.5..0.53).contains(&bound), "{bound}");
    }
}
