//! A stretch of a motion between two times, in whole numbers.

use dashu_int::IBig;

use super::quaternion::{Quaternion, Vector, cross, dot, image, mixed_rotation, multiple, sum};
use super::root::{ROOT_PLACES, quotient_above, root_above};

/// A stretch of a motion: the placements x ↦ (P(s) + R(q(s)) (W x + arm)) / W for s in [0, 1], P and q linear, that are
/// off the motion by at most an angle about its axis. About that axis they are all turns between those at both ends.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    /// The quaternion at both ends, or one that stays.
    pub(super) turns: Vec<Quaternion>,
    /// P at both ends.
    pub(super) base: [Vector; 2],
    pub(super) arm: Vector,
    /// W.
    pub(super) weight: IBig,
    /// The bound of the angle at either end, in units of 2^-160.
    pub(super) ends_off: [IBig; 2],
    /// By how much the angle between the ends may be farther off.
    pub(super) chord: IBig,
    /// The axis about which a motion turns at constant rate.
    pub(super) axis: Option<Axis>,
}

impl Stretch {
    /// |q|² W at the begin, a positive number.
    pub(super) fn scale(&self) -> IBig {
        dot(&self.turns[0], &self.turns[0]) * &self.weight
    }

    /// The image of a point at the begin, times that number.
    pub(super) fn image(&self, point: &Vector) -> Vector {
        let turn = &self.turns[0];
        let arm = sum(&multiple(&self.weight, point), &self.arm);
        sum(&multiple(&dot(turn, turn), &self.base[0]), &image(&mixed_rotation(turn, turn), &arm))
    }

    /// The bound of the angle, in units of 2^-160.
    pub(super) fn angle_off(&self) -> IBig {
        self.end_off() + &self.chord
    }

    /// The bound of the angle at both ends.
    pub(super) fn end_off(&self) -> IBig {
        let [first, last] = &self.ends_off;
        first.max(last).clone()
    }
}

/// A direction of an axis.
#[derive(Debug, Clone)]
pub(super) struct Axis {
    /// A vector along it, of any length but 0.
    pub(super) vector: Vector,
    /// Its length in units of 2^-`places`, rounded down.
    pub(super) length: IBig,
    pub(super) places: usize,
}

impl Axis {
    /// At least the length of a vector's part across the axis, in units of 2^-64.
    pub(super) fn across(&self, u: &Vector) -> IBig {
        let across = cross(u, &self.vector);
        let product = root_above(&dot(&across, &across)) << (ROOT_PLACES + self.places);
        quotient_above(&product, &self.length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_across_an_axis_is_bounded_from_above_and_nothing_along_it() {
        let vector = |v: [i32; 3]| v.map(IBig::from);
        let axis = Axis { vector: vector([0, 3, 4]), length: IBig::from(5) << 8_usize, places: 8 };
        assert!(axis.across(&vector([0, -6, -8])) <= IBig::ONE);
        let across = axis.across(&vector([7, 3, 4]));
        let seven = IBig::from(7) << 64_usize;
        assert!(across >= seven && across <= &seven + (IBig::ONE << 40_usize), "{across}");
    }
}
