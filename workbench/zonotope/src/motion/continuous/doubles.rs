//! Decisions about a gap in plain doubles: one bound of the rounding for all coefficients of a stretch, known before
//! they are computed.
//!
//! Let T = |q|_1² of each body, the larger of both ends, and L the sum of the magnitudes of all lengths that a gap is
//! made of, times the weights: both reaches, arms, bases and margins. Every coefficient, that of the gap itself as well
//! as that of a vertex of a control zonotope, is a sum of products whose magnitudes add up to at most 80 T_a T_b L |u|,
//! and each product goes through less than 300 roundings and those of the sum over the generators:
//!
//! | direction | magnitudes, in T_a T_b L times the sum of the magnitudes of its coordinates | of which |
//! |---|---|---|
//! | in space | 20 | the scaled coefficients of a rotation, 2, 4, 2 T, times those of the other square, 1, 2, 1 T: 2, 8, 12, 8, 2, and of the next degree at most 20 |
//! | in a body | 20 | the rotation of one as the other sees it: 2, 8, 12, 8, 2 T_a T_b |
//! | normal of edges | 80 | the rotations of both, 2, 4, 2 T each: 4, 16, 24, 16, 4, at most 40 of the next degree, and each determinant has two products |
//!
//! A margin along a direction may be √3 times the sum of the magnitudes of its coordinates, and L counts it once: it is
//! multiplied by the product of the squares alone, 1, 4, 6, 4, 1 T_a T_b and of the next degree at most 10, and 10 √3
//! is below 20.
//!
//! Halving a polynomial takes means of its coefficients, which makes them no larger, and five roundings each time.
//!
//! Of the roundings, 150 are those of the quaternions: a quaternion of the stretch is a sum of two that are not
//! opposite, so that its length is at least a third of the terms', each within 12 units; four of them are in a product.
//! The terms of an entry of a rotation have magnitudes that add up to 3 T, and go through these 150. Its value, at most
//! T, goes through the others. Together that is no more than 2 T through all 300.

use super::SeparatingDirection;
use super::gap::Stretch;
use super::parts::body::Body;
use crate::motion::bernstein;
use crate::numeric::linear::sum_norm;
use crate::numeric::tolerance::{GAP_ROUNDING, GENERATOR_ROUNDING, MODERATE_SIZES};

impl Stretch<'_, f64> {
    /// A bound of the error of each coefficient of the gap along a direction of which the coordinates' magnitudes add
    /// up to 1; infinite where products may leave the range of doubles.
    pub(super) fn rounding(&self) -> f64 {
        let [a, b] = &self.arcs;
        let turns = self.arcs.each_ref().map(|arc| {
            let [from, to] = arc.turns.each_ref().map(|q| q.iter().map(|c| c.abs()).sum::<f64>());
            from.max(to) * from.max(to)
        });
        let own = |i: usize| {
            let (arc, body) = (&self.arcs[i], &self.bodies[i]);
            arc.weight * (body.magnitude() + sum_norm(&body.center()) + self.margins[i].total())
                + sum_norm(&arc.arm)
                + arc.base_size
        };
        let lengths = b.weight * own(0) + a.weight * own(1);
        let size = turns[0] * turns[1] * lengths;
        let generators: usize = self.bodies.iter().map(Body::terms).sum();
        let factors = [turns[0], turns[1], a.weight, b.weight, lengths, size];
        if factors.iter().all(|factor| MODERATE_SIZES.contains(factor)) {
            (GAP_ROUNDING + GENERATOR_ROUNDING * generators as f64) * size
        } else {
            f64::INFINITY
        }
    }

    /// Whether a gap along a direction is positive during the stretch: for certain, or not for certain by its
    /// coefficients; `None` where rounding leaves a doubt.
    pub(super) fn is_positive(&self, gap: &[f64; 6], direction: &SeparatingDirection) -> Option<bool> {
        let doubt = doubt_along(self.rounding(), direction);
        if bernstein::is_above(&bernstein::unscaled(gap), doubt) {
            return Some(true);
        }
        gap.iter().any(|c| *c < -doubt).then_some(false)
    }
}

/// A bound of the error of each coefficient along a direction, by that for one of which the coordinates' magnitudes add
/// up to 1; infinite where products with the direction may vanish or leave the range of doubles.
pub(super) fn doubt_along(rounding: f64, direction: &SeparatingDirection) -> f64 {
    let length = direction.length_at_most();
    if MODERATE_SIZES.contains(&length) { rounding * length } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::super::gap::ArcPair;
    use super::super::parts::margin::Margin;
    use super::super::tests::{random_body, random_parts};
    use super::*;
    use crate::motion::Motion;
    use crate::motion::constant_rate::Timing;
    use crate::numeric::dyadic::Dyadic;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;
    use std::rc::Rc;

    fn motion(rng: &mut Pcg64) -> Motion {
        if rng.random_bool(0.5) {
            return Motion::from_pieces(&random_parts(rng, 1)).expect("a motion");
        }
        let vector = |rng: &mut Pcg64| [0, 1, 2].map(|_| rng.random_range(-1.0..1.0));
        let (point, axis, gone) = (vector(rng), vector(rng), vector(rng));
        Motion::constant_rate(point, axis, rng.random_range(-1.5..1.5), gone).expect("an axis")
    }

    #[test]
    fn coefficients_in_doubles_are_within_the_bound_of_the_exact_ones() {
        let mut rng = Pcg64::seed_from_u64(11);
        for _ in 0..60 {
            let bodies = [6, 9].map(|n| random_body(&mut rng, n, 0.8));
            let bodies = bodies.each_ref().map(Body::of);
            let motions = [0, 1].map(|_| motion(&mut rng));
            let from = rng.random_range(0.0..0.9);
            let times = [from, from + 0.1 * rng.random_range(1e-6..1.0f64)];
            let axis = [0.6, 0.0, 0.8];
            let margin = Margin { distance: 1e-3, axis, of_other: 2e-3, of_normals: 3e-3 };
            let margins = [margin, Margin::NONE];
            let arcs = motions.each_ref().map(|motion| motion.rounded_arc(times, Timing::Timed));
            let rounded = Stretch::new(bodies, Rc::new(ArcPair::new(arcs)), margins);
            let arcs = motions.each_ref().map(|motion| motion.exact_arc(times, Timing::Timed));
            let exact = Stretch::new(bodies, Rc::new(ArcPair::<Dyadic>::new(arcs)), margins);
            let vector = |rng: &mut Pcg64| [0, 1, 2].map(|_| rng.random_range(-1.0..1.0));
            let directions = [
                SeparatingDirection::Space(vector(&mut rng)),
                SeparatingDirection::First(vector(&mut rng)),
                SeparatingDirection::Second(vector(&mut rng)),
                SeparatingDirection::Edges([vector(&mut rng), vector(&mut rng)]),
            ];
            for direction in &directions {
                let bound = rounded.rounding() * direction.length_at_most();
                assert!(bound.is_finite());
                let pairs = rounded.gap_along(direction).into_iter().zip(exact.gap_along(direction));
                for (value, truth) in pairs {
                    let off = (truth - Dyadic::from_f64(value)).abs();
                    assert!(off <= Dyadic::from_f64(bound), "{direction:?}: {} of {bound}", off.to_f64());
                }
            }
        }
    }

    #[test]
    fn numbers_that_may_leave_the_range_of_doubles_have_no_bound() {
        let bodies = [1e-200, 1e200].map(|size| random_body(&mut Pcg64::seed_from_u64(1), 3, size));
        let bodies = bodies.each_ref().map(Body::of);
        let arcs = [Motion::rest(), Motion::rest()].map(|motion| motion.rounded_arc([0.0, 1.0], Timing::Timed));
        let stretch = Stretch::new(bodies, Rc::new(ArcPair::new(arcs)), [Margin::NONE; 2]);
        let direction = SeparatingDirection::Space([1.0, 0.0, 0.0]);
        assert_eq!(stretch.rounding(), f64::INFINITY);
        assert_eq!(stretch.is_positive(&[1.0; 6], &direction), None);
        // so do directions
        for short in [5e-324, 1e-300, 1e-100] {
            let directions = [
                SeparatingDirection::First([0.0, short, 0.0]),
                SeparatingDirection::Edges([[short, 0.0, 0.0], [0.0, 0.0, 3.0]]),
                SeparatingDirection::Space([0.0; 3]),
            ];
            assert_eq!(directions.map(|direction| doubt_along(1e-13, &direction)), [f64::INFINITY; 3]);
        }
        assert_eq!(doubt_along(1e-13, &direction), 1e-13);
    }
}
