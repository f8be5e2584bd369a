//! A vector that turns about an axis: rational points of its arc, and corners of tangents between them.
//!
//! A rotation is a quaternion (W, −Y a) of whole numbers: its half-angle has the tangent Y |a| / W. Between two of them
//! the vector stays in the triangle of its images and of the corner that the polar form of both gives, since the
//! rotation by a quaternion that goes linearly from one to the other is a convex combination of these three.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot};

use crate::exact::linear::{Vector, dot};
use crate::exact::proportion::Proportion;

/// The places of sines and cosines, and of the root of the axis, beyond those that a small angle takes.
const BITS: usize = 128;

/// By so many units the last angle is above the one that was asked for: far more than sines and roots are off.
const MARGIN: u32 = 1 << 16;

/// An angle above that of a whole turn: the placements of a larger one are the same.
const WHOLE_TURN: f64 = 6.3;

/// The rotations about an axis by parts of an angle.
#[derive(Debug)]
pub(super) struct Turning {
    axis: Vector,
    /// The axis' square, and its length times 2^`shift`.
    square: IBig,
    length: IBig,
    shift: usize,
    /// Half of the angle in units 2^−`places`, a little above it.
    half_angle: IBig,
    places: usize,
}

/// A quaternion (W, −Y a).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Rotation {
    w: IBig,
    y: IBig,
}

impl Turning {
    /// The rotations by parts of an angle that is not negative, about an axis that is not zero.
    pub(super) fn new(axis: Vector, angle: f64) -> Self {
        let square = dot(&axis, &axis);
        let shift = (2 * BITS + 64).saturating_sub(square.bit_len()).div_ceil(2);
        let length = IBig::from((&square << (2 * shift)).sqrt());
        let angle = Proportion::of_double(angle.min(WHOLE_TURN));
        // the unit of a double is below its 53 places
        let small = usize::try_from(-angle.exponent()).unwrap_or(0);
        let places = BITS + small;
        let exponent = -i32::try_from(places).unwrap_or(i32::MAX);
        let half = angle.times(&Proportion::whole(IBig::ONE, -1));
        let half_angle = half.floor_at(exponent);
        let half_angle = if angle.is_zero() { IBig::ZERO } else { half_angle + IBig::from(MARGIN) };
        Self { axis, square, length, shift, half_angle, places }
    }

    /// The rotation by part / 2^depth of the angle.
    pub(super) fn rotation(&self, part: u64, depth: u32) -> Rotation {
        let x = (&self.half_angle * IBig::from(part)) >> (depth as usize);
        let [cosine, sine] = cosine_and_sine(&x, self.places);
        Rotation { w: cosine * &self.length, y: sine << self.shift }
    }

    /// The image of u under the turn back, times a positive number, which comes second; of two rotations the corner of
    /// the tangents. `None` if they are half a turn apart.
    pub(super) fn turned_back(&self, u: &Vector, from: &Rotation, to: &Rotation) -> Option<(Vector, IBig)> {
        let a = &self.axis;
        let sines = &from.y * &to.y;
        let along = dot(a, u);
        let across = [(1, 2), (2, 0), (0, 1)].map(|(i, k)| &a[i] * &u[k] - &a[k] * &u[i]);
        let cosines = &from.w * &to.w;
        let squared = &sines * &self.square;
        let own = &cosines - &squared;
        let on_axis = &sines * along * IBig::from(2);
        let mixed = &from.w * &to.y + &to.w * &from.y;
        let image = (0..3).map(|k| &own * &u[k] + &on_axis * &a[k] - &mixed * &across[k]).collect();
        let scale = cosines + squared;
        (scale > IBig::ZERO).then_some((image, scale))
    }
}

/// The cosine and the sine of x from 0 to about 3.2, in units 2^−places, each off by less than a hundred of them.
fn cosine_and_sine(x: &IBig, places: usize) -> [IBig; 2] {
    let mut term = IBig::ONE << places;
    let mut sums = [IBig::ZERO, IBig::ZERO];
    let mut power = 0_u32;
    while term != IBig::ZERO {
        let sum = &mut sums[(power % 2) as usize];
        if power % 4 < 2 {
            *sum += &term
        } else {
            *sum -= &term
        }
        power += 1;
        term = ((term * x) >> places) / IBig::from(power);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_by_known_values() {
        let values = [
            (0.0, 1.0, 0.0),
            (1.0, 0.540_302_305_868_139_7, 0.841_470_984_807_896_5),
            (0.5, 0.877_582_561_890_372_7, 0.479_425_538_604_203),
            (3.0, -0.989_992_496_600_445_4, 0.141_120_008_059_867_2),
        ];
        for (x, exact_cosine, exact_sine) in values {
            let units = Proportion::of_double(x).floor_at(-100);
            let [cosine, sine] = cosine_and_sine(&units, 100).map(|c| Proportion::whole(c, -100).nearest());
            assert!((cosine - exact_cosine).abs() < 1e-15 && (sine - exact_sine).abs() < 1e-15, "{x}");
        }
    }

    #[test]
    fn a_quarter_turn_and_its_corner() {
        let turning = Turning::new(vec![IBig::ZERO, IBig::ZERO, IBig::from(3)], std::f64::consts::FRAC_PI_2);
        let u: Vector = [1, 0, 5].map(IBig::from).to_vec();
        let [from, to] = [turning.rotation(0, 0), turning.rotation(1, 0)];
        let image = |from: &Rotation, to: &Rotation| {
            let (image, scale) = turning.turned_back(&u, from, to).expect("less than half a turn");
            let scale = Proportion::whole(scale, 0);
            image.iter().map(|c| Proportion::whole(c.clone(), 0).over(&scale).expect("positive").nearest()).collect()
        };
        let near = |found: Vec<f64>, exact: [f64; 3]| found.iter().zip(exact).all(|(f, e)| (f - e).abs() < 1e-15);
        assert!(near(image(&from, &from), [1.0, 0.0, 5.0]));
        assert!(near(image(&to, &to), [0.0, -1.0, 5.0]));
        assert!(near(image(&from, &to), [1.0, -1.0, 5.0]), "the corner of both tangents");
        assert_eq!(turning.rotation(2, 1), to);
    }

    #[test]
    fn the_length_of_an_axis_has_160_bits_whatever_it_is() {
        for axis in [[1, 1, 0], [3, -4, 0], [0, 0, 1], [1 << 30, 7, 1 << 29]] {
            let turning = Turning::new(axis.map(IBig::from).to_vec(), 1.0);
            let fine = &turning.square << (2 * turning.shift);
            let next = &turning.length + IBig::ONE;
            assert!(&turning.length * &turning.length <= fine && fine < &next * &next, "{axis:?}");
            assert!((160..=161).contains(&turning.length.bit_len()), "{axis:?}: {}", turning.length.bit_len());
        }
    }

    #[test]
    fn half_of_a_small_angle_has_as_many_places_as_that_of_a_large_one() {
        let half = |angle: f64| {
            let turning = Turning::new([0, 0, 1].map(IBig::from).to_vec(), angle);
            (turning.half_angle, turning.places)
        };
        // The half is 2^-61 in units of 2^-188, or 3/2 in units of 2^-128, and a little above.
        let above = IBig::from(MARGIN);
        assert_eq!(half(2f64.powi(-60)), ((IBig::ONE << 127_usize) + &above, 188));
        assert_eq!(half(3.0), ((IBig::from(3) << 127_usize) + above, 128));
        assert_eq!(half(0.0).0, IBig::ZERO);
    }

    #[test]
    fn rotations_half_a_turn_apart_have_no_corner() {
        let turning = Turning::new([0, 0, 1].map(IBig::from).to_vec(), 1.0);
        let u: Vector = [1, 0, 5].map(IBig::from).to_vec();
        let rotation = |w: i32, y: i32| Rotation { w: IBig::from(w), y: IBig::from(y) };
        assert_eq!(turning.turned_back(&u, &rotation(1, 0), &rotation(0, 1)), None);
        assert_eq!(turning.turned_back(&u, &rotation(1, 0), &rotation(-1, 1)), None);
        assert!(turning.turned_back(&u, &rotation(1, 0), &rotation(1, 1)).is_some());
    }
}
