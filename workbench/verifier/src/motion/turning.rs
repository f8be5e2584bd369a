//! A rotation at constant rate: between two times it is enclosed by a quaternion of whole numbers that goes linearly.
//!
//! Let û be the unit vector of the axis and e(ψ) = cos ψ + sin ψ û, a quaternion that turns by 2 ψ. The motion turns by
//! e(h) with h linear in the time, from h_0 to h_1, and the stretch by a linear quaternion from q_0 to q_1 near e(h_0)
//! and e(h_1), all in one plane. There are two bounds of the angle between both rotations.
//!
//! **The linear path between e(h_0) and e(h_1).** Let 2 a = h_1 − h_0, so that the stretch turns by 4 a, and measure
//! from the middle: at the share (1 + x) / 2 of the time, −1 ≤ x ≤ 1, the chord is at the angle atan(x t), t = tan a,
//! and the motion at x a = x atan t. The difference, for x ≥ 0, is the integral over 0 ≤ τ ≤ t of
//!
//! ```text
//! x / (1 + x² τ²) − x / (1 + τ²) = x (1 − x²) τ² / ((1 + x² τ²) (1 + τ²)),
//! ```
//!
//! which is at least 0 and at most x (1 − x²) t³ / 3. The largest value of x (1 − x²) is 2 / (3 √3), so the rotations,
//! by twice these angles, differ by at most 4 t³ / (9 √3) < 257 t³ / 1000. And t ≤ a / (1 − a² / 2), since sin a ≤ a
//! and cos a ≥ 1 − a² / 2.
//!
//! **The ends.** If q_0 and q_1 are within η of e(h_0) and e(h_1), so is the path between of the chord, which is no
//! shorter than cos a. The angle between two vectors is at most the arc sine of η / cos a ≤ η π / (2 cos a), the
//! rotations differ by twice that, at most 4 η where cos a ≥ 0.9.
//!
//! **One turn alone.** Where nothing but this rotation moves, bodies are disjoint at every time of a stretch if they
//! are at every angle between its ends. The linear path goes through all angles between those of q_0 and q_1, which the
//! ends of the motion are within 4 η of: the bound of the ends alone is left.

mod sines;

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot};

use self::sines::{QuarterTurn, SINE_PLACES};
use super::quaternion::{Quaternion, Vector, cross, difference, dot, identity, multiple, sum};
use super::root::{quotient_above, root_above};
use super::stretch::{Axis, Stretch};
use crate::exact::grid::Grid;

/// The places after the point of the ends of a stretch: the double next to half a turn misses it by 2^-53, and the
/// cosine there misses −1 by the square of that, a gap that is shown.
const END_PLACES: usize = 144;

/// The places after the point of bounds of angles.
pub(super) const ANGLE_PLACES: usize = 160;

/// The largest angle of a stretch is 8 / 5: more than a quarter turn, and cos(2 / 5) is more than 0.9.
const LARGEST_ANGLE: [u32; 2] = [8, 5];

/// The rotation by so many units 2^-`places` of an angle about an axis through a point, while the body translates.
#[derive(Debug, Clone)]
pub(super) struct Turning {
    point: Vector,
    travel: Vector,
    /// The axis, of any length.
    axis: Vector,
    /// The length of the axis, in units of 2^-`length_places`, rounded down.
    length: IBig,
    length_places: usize,
    /// The bits of the axis.
    axis_bits: usize,
    angle: IBig,
    angle_places: usize,
    quarter: QuarterTurn,
}

impl Turning {
    /// The rotation; `None` about an axis that is zero.
    pub(super) fn new(point: Vector, travel: Vector, axis: [f64; 3], angle: f64) -> Option<Self> {
        let grid = Grid::of(axis);
        let axis = axis.map(|c| grid.units(c));
        let square = dot(&axis, &axis);
        if square == IBig::ZERO {
            return None;
        }
        let length_places = (END_PLACES + 16).saturating_sub(square.bit_len() / 2);
        let length = IBig::from((&square << (2 * length_places)).sqrt());
        let places = Grid::of([angle]).exponent().min(0);
        let whole = Grid::at(places).units(angle);
        let angle_places = places.unsigned_abs() as usize;
        let quarter = QuarterTurn::for_angles_below(whole.bit_len().saturating_sub(angle_places) + 1);
        let axis_bits = square.bit_len() / 2 + 1;
        Some(Self { point, travel, axis, length, length_places, axis_bits, angle: whole, angle_places, quarter })
    }

    /// Whether the axis stays where it is.
    pub(super) fn only_turns(&self) -> bool {
        self.travel.iter().all(|c| *c == IBig::ZERO)
    }

    /// Whether the body stays where it is.
    pub(super) fn is_rest(&self) -> bool {
        self.only_turns() && self.angle == IBig::ZERO
    }

    /// Whether the angle between two times, in units of 2^-`places`, is small enough for one stretch.
    pub(super) fn is_one_stretch(&self, [from, to]: [&IBig; 2], places: usize) -> bool {
        let [most, over] = LARGEST_ANGLE.map(IBig::from);
        self.angle_between([from, to]) * over <= most << (places + self.angle_places)
    }

    /// The magnitude of the angle between two times.
    fn angle_between(&self, [from, to]: [&IBig; 2]) -> IBig {
        let angle = (to - from) * &self.angle;
        if angle < IBig::ZERO { -angle } else { angle }
    }

    /// The stretch between two times of one.
    pub(super) fn stretch(&self, [from, to]: [&IBig; 2], places: usize) -> Stretch {
        let weight = IBig::ONE << places;
        let base = [from, to].map(|time| sum(&multiple(&weight, &self.point), &multiple(time, &self.travel)));
        let arm = multiple(&-&weight, &self.point);
        if self.angle == IBig::ZERO {
            let (ends_off, chord) = ([IBig::ZERO, IBig::ZERO], IBig::ZERO);
            return Stretch { turns: vec![identity()], base, arm, weight, ends_off, chord, axis: None };
        }
        let mut turns = vec![self.turned(from, places)];
        // Rounding to 2^-144 leaves an end within 2^-142, see `turned`; no turn is not rounded.
        let off = |time: &IBig| {
            if *time == IBig::ZERO { IBig::ZERO } else { IBig::ONE << (ANGLE_PLACES - END_PLACES + 4) }
        };
        let ends_off = [off(from), off(to)];
        let mut chord = IBig::ZERO;
        if from != to {
            turns.push(self.turned(to, places));
            chord = self.chord([from, to], places);
        }
        let axis = Axis { vector: self.axis.clone(), length: self.length.clone(), places: self.length_places };
        Stretch { turns, base, arm, weight, ends_off, chord, axis: Some(axis) }
    }

    /// 257 t³ / 1000, rounded up.
    fn chord(&self, times: [&IBig; 2], places: usize) -> IBig {
        let one = IBig::ONE << ANGLE_PLACES;
        let quarter = self.angle_between(times) << ANGLE_PLACES;
        let a = (quarter >> (places + self.angle_places + 2)) + IBig::ONE;
        let cosine = &one - ((&a * &a) >> (ANGLE_PLACES + 1)) - IBig::ONE;
        let tangent = quotient_above(&(&a << ANGLE_PLACES), &cosine);
        let cube = quotient_above(&(&tangent * &tangent * &tangent), &(IBig::ONE << (2 * ANGLE_PLACES)));
        quotient_above(&(cube * IBig::from(257)), &IBig::from(1000))
    }

    /// The quaternion at a time, times a power of two: (c, m · axis) with c and m times the length of the axis within
    /// 2^(1 − 144) of cosine and sine. They are rounded by at most 2^-144; the error of both and that of the length,
    /// 2^-150 of it, are far less. Together they are within η = 2^(2 − 144).
    fn turned(&self, time: &IBig, places: usize) -> Quaternion {
        let [sine, cosine] = self.quarter.sine_and_cosine(&(time * &self.angle), places + self.angle_places + 1);
        let cosine = (cosine >> (SINE_PLACES - END_PLACES)) << self.axis_bits;
        let along = (sine << (self.axis_bits + self.length_places)) / &self.length;
        let along = along >> (SINE_PLACES - END_PLACES);
        let [x, y, z] = multiple(&along, &self.axis);
        [cosine, x, y, z]
    }

    /// A bound of the distances of a body's points from the axis, in units 2^-32 of those of lengths.
    pub(super) fn reach(&self, center: &Vector, generators: &[Vector]) -> IBig {
        let off_axis = |v: &Vector| {
            let across = cross(&self.axis, v);
            root_above(&dot(&across, &across))
        };
        let all: IBig = generators.iter().map(off_axis).sum::<IBig>() + off_axis(&difference(center, &self.point));
        quotient_above(&(all << self.length_places), &self.length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turning(axis: [f64; 3], angle: f64) -> Turning {
        let zero = || [IBig::ZERO, IBig::ZERO, IBig::ZERO];
        Turning::new(zero(), zero(), axis, angle).expect("an axis")
    }

    #[test]
    fn an_axis_and_an_angle_have_places_by_their_size() {
        // The length 5 of the axis has three bits, and 7/2 is below 2^2.
        let found = turning([3.0, 0.0, -4.0], -3.5);
        assert_eq!((found.length, found.length_places), (IBig::from(5) << 158_usize, 158));
        assert_eq!(found.axis_bits, 3);
        assert_eq!((found.angle, found.angle_places), (IBig::from(-7), 1));
        let quarters = [found.quarter, QuarterTurn::for_angles_below(3)].map(|quarter| format!("{quarter:?}"));
        assert_eq!(quarters[0], quarters[1], "a bit is spare");
    }

    #[test]
    fn a_stretch_turns_by_eight_fifths_at_most() {
        let is_one = |angle: f64, [from, to]: [i32; 2], places: usize| {
            turning([0.0, 0.0, 1.0], angle).is_one_stretch([&IBig::from(from), &IBig::from(to)], places)
        };
        for sign in [1.0, -1.0] {
            assert!(
                is_one(sign * 1.6_f64.next_down(), [0, 1], 0) && !is_one(sign * 1.6, [0, 1], 0),
                "1.6 is above 8/5"
            );
            assert!(!is_one(sign * 2.0, [0, 1], 0) && is_one(sign * 2.0, [1, 2], 1));
            assert!(is_one(sign * 12.0, [3, 4], 3) && !is_one(sign * 13.0, [3, 4], 3));
        }
    }

    /// The sequence without a pattern gives a number of 32 bits at each step.
    fn next(state: &mut u64) -> u32 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 32) as u32
    }

    #[test]
    fn the_bound_of_a_chord_is_above_that_of_exact_numbers_by_little() {
        // With the angle 4 a and t = a / (1 - a² / 2) the bound is 257 t³ / 1000. Near the root of 2, beyond the angles
        // of a stretch, t is so large that each unit of a rounding shows.
        let (places, mut state) = (170_usize, 1_u64);
        for angle in [5.625, 1.5, -5.625, 0.125] {
            let turning = turning([0.0, 0.0, 1.0], angle);
            for _ in 0..50 {
                let to = (IBig::ONE << places) - IBig::from(next(&mut state));
                let found = turning.chord([&IBig::ZERO, &to], places);
                // The angle a is A / m, so that t is 2 A m / (2 m² - A²).
                let a = turning.angle_between([&IBig::ZERO, &to]);
                let m = IBig::ONE << (places + turning.angle_places + 2);
                let [above, below] = [IBig::from(2) * &a * &m, IBig::from(2) * &m * &m - &a * &a];
                let exact = (IBig::from(257) * &above * &above * &above) << ANGLE_PLACES;
                let over = IBig::from(1000) * &below * &below * &below;
                let found = found * &over;
                assert!(found >= exact, "{angle} {to}");
                assert!(found <= &exact + (&exact >> 140_usize) + over * IBig::from(4), "{angle} {to}");
            }
        }
    }
}
