//! Coordinates for the search in floating point: orthonormal ones in the affine hull of the points, scaled by a power
//! of two.
//!
//! Lengths and angles are those of space but for that factor, so the total length may be minimised in the frame.

use crate::numeric::linear::dot;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two, scaled_difference};

/// Orthonormal axes of the affine hull of points, within rounding, and the points in their coordinates. If the points
/// span all space, the axes are the coordinate axes, so that no coordinate is rounded by turning.
pub(super) struct Frame<const D: usize> {
    /// Lengths of the frame times 2^exponent are lengths of the input.
    pub(super) exponent: i64,
    /// The point of the input at the origin of the frame.
    origin: [f64; D],
    /// The axes of the frame, in the coordinates of space.
    axes: Vec<[f64; D]>,
    /// Orthonormal directions in the frame: the first points from the origin to the farthest point, each other one to
    /// the point farthest from the span of those before.
    pub(super) long: Vec<[f64; D]>,
    /// The points in the frame; their coordinates beyond the first `rank` are zero.
    pub(super) points: Vec<[f64; D]>,
}

/// Points nearer to a subspace than this, beside their largest coordinate difference, count as points of the subspace.
const RELATIVE_DISTANCE_OFF_SUBSPACE: f64 = 1e-13;

impl<const D: usize> Frame<D> {
    /// The frame of points, at least one; its rank is 0 just when all points are equal.
    pub(super) fn new(points: &[[f64; D]]) -> Self {
        let origin = points[0];
        // Half of a difference that overflows does not, and exceeds by far what halving rounds.
        let differences = |p: &[f64; D], shift: i64| -> [f64; D] {
            std::array::from_fn(|c| scaled_difference(p[c], origin[c], shift))
        };
        let largest =
            |shift: i64| points.iter().flat_map(|p| differences(p, shift)).fold(0.0, |m: f64, c| m.max(c.abs()));
        let exponent = match binary_exponent(largest(0)).map(i64::from) {
            Some(exponent) if exponent < f64::MAX_EXP.into() => exponent + 1,
            Some(_) => 1 + binary_exponent(largest(-1)).map_or(0, i64::from) + 1,
            None => 0,
        };
        let scaled: Vec<[f64; D]> = points.iter().map(|p| differences(p, -exponent)).collect();
        let mut axes = long_axes(&scaled);
        let mut long: Vec<[f64; D]> = (0..axes.len()).map(unit_vector).collect();
        if axes.len() == D {
            std::mem::swap(&mut axes, &mut long);
        }
        let mut frame = Self { exponent, origin, axes, long, points: Vec::new() };
        frame.points = scaled.iter().map(|p| frame.inside(p)).collect();
        frame
    }

    /// The dimension of the points' affine hull.
    pub(super) fn rank(&self) -> usize {
        self.axes.len()
    }

    /// A vector of space in the coordinates of the frame, not scaled.
    pub(super) fn inside(&self, v: &[f64; D]) -> [f64; D] {
        std::array::from_fn(|a| self.axes.get(a).map_or(0.0, |axis| dot(axis, v)))
    }

    /// A vector of the frame in the coordinates of space, not scaled.
    pub(super) fn outside(&self, v: &[f64; D]) -> [f64; D] {
        let mut sum = [0.0; D];
        for (axis, &along) in self.axes.iter().zip(v) {
            sum = std::array::from_fn(|c| sum[c] + along * axis[c]);
        }
        sum
    }

    /// A vector of the frame in the coordinates and the units of the input.
    pub(super) fn vector(&self, v: &[f64; D]) -> [f64; D] {
        self.outside(v).map(|c| scale_by_power_of_two(c, self.exponent))
    }

    /// A point of the frame in the coordinates and the units of the input, rounded, and moved into the range of
    /// doubles.
    pub(super) fn point(&self, p: &[f64; D]) -> [f64; D] {
        let outside = self.outside(p);
        std::array::from_fn(|c| {
            let moved = self.origin[c] + scale_by_power_of_two(outside[c], self.exponent);
            // Halves are added if the shift alone overflows: they lose no more than the smallest double.
            let halves = || 2.0 * (self.origin[c] / 2.0 + scale_by_power_of_two(outside[c], self.exponent - 1));
            (if moved.is_finite() { moved } else { halves() }).clamp(-f64::MAX, f64::MAX)
        })
    }
}

/// Orthonormal axes of the span of vectors whose coordinates are at most 1: each axis points to the vector that is
/// farthest from the span of the axes before, until no vector is off that span.
fn long_axes<const D: usize>(vectors: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut rest = vectors.to_vec();
    let mut axes: Vec<[f64; D]> = Vec::with_capacity(D);
    while axes.len() < D {
        let Some(far) = rest.iter().copied().max_by(|a, b| dot(a, a).total_cmp(&dot(b, b))) else { break };
        if dot(&far, &far).sqrt() <= RELATIVE_DISTANCE_OFF_SUBSPACE {
            break;
        }
        let mut unit = far;
        // Gram and Schmidt's step, taken twice, leaves no more than rounding along the axes before.
        for _ in 0..2 {
            for axis in &axes {
                let along = dot(axis, &unit);
                unit = std::array::from_fn(|c| unit[c] - along * axis[c]);
            }
            let length = dot(&unit, &unit).sqrt();
            unit = unit.map(|c| c / length);
        }
        for v in &mut rest {
            let along = dot(&unit, v);
            *v = std::array::from_fn(|c| v[c] - along * unit[c]);
        }
        axes.push(unit);
    }
    axes
}

fn unit_vector<const D: usize>(axis: usize) -> [f64; D] {
    std::array::from_fn(|c| f64::from(u8::from(axis == c)))
}
