//! Rotations about an axis line followed by translations, from their definition.

use dashu_ratio::RBig;

use crate::definitions::ratio::integer;
use crate::definitions::space::{Body, Vector};

/// The placements of Section 6: turned about an axis line by a part of an angle, then moved by a part of a translation.
///
/// An angle is the tangent of its half divided by the length of the axis vector, so that every matrix is rational.
#[derive(Clone, Debug)]
pub(crate) struct Turning {
    /// A point of the axis line.
    pub(crate) axis_point: Vector,
    /// A vector along the axis, of any length above zero.
    pub(crate) axis: Vector,
    /// The tangent of half the whole angle, divided by the length of the axis vector.
    pub(crate) half_tangent: RBig,
    /// The whole translation.
    pub(crate) translation: Vector,
}

impl Turning {
    /// A vector after a rotation whose half has `part` times the tangent: v + 2 (w × v + w × (w × v)) / (1 + |w|²) for
    /// the vector w along the axis as long as that tangent.
    pub(crate) fn turned(&self, part: &RBig, vector: &Vector) -> Vector {
        let factor = part * &self.half_tangent;
        let w = Vector(self.axis.0.each_ref().map(|c| c * &factor));
        let once = w.cross(vector);
        let double = integer(2) / (integer(1) + w.dot(&w));
        vector.plus(&double, &once.plus(&integer(1), &w.cross(&once)))
    }

    /// A point after the rotation and `moved` times the translation.
    pub(crate) fn placed_point(&self, part: &RBig, moved: &RBig, point: &Vector) -> Vector {
        let turned = self.turned(part, &self.axis_point.to(point));
        self.axis_point.plus(&integer(1), &turned).plus(moved, &self.translation)
    }

    /// A body after the rotation and `moved` times the translation.
    pub(crate) fn placed(&self, part: &RBig, moved: &RBig, body: &Body) -> Body {
        Body {
            center: self.placed_point(part, moved, &body.center),
            generators: body.generators.iter().map(|generator| self.turned(part, generator)).collect(),
        }
    }

    /// The squared distance of a point from the axis line.
    pub(crate) fn squared_distance(&self, point: &Vector) -> RBig {
        let across = self.axis.cross(&self.axis_point.to(point));
        across.dot(&across) / self.axis.dot(&self.axis)
    }

    /// The square of twice the sine of half the angle at `part` of the tangent.
    pub(crate) fn squared_chord(&self, part: &RBig) -> RBig {
        let factor = part * &self.half_tangent;
        let square = &factor * &factor * self.axis.dot(&self.axis);
        integer(4) * &square / (integer(1) + square)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definitions::ratio::fraction;

    #[test]
    fn a_quarter_turn_takes_x_to_y() {
        let quarter = Turning {
            axis_point: Vector::at([1, 0, 0]),
            axis: Vector::at([0, 0, 2]),
            half_tangent: fraction(1, 2),
            translation: Vector::at([0, 0, 4]),
        };
        let moved = quarter.placed_point(&integer(1), &fraction(1, 4), &Vector::at([3, 0, 5]));
        assert_eq!(moved, Vector::at([1, 2, 6]));
        assert_eq!(quarter.squared_distance(&Vector::at([3, 0, 5])), integer(4));
        assert_eq!(quarter.squared_chord(&integer(1)), integer(2));
    }
}
