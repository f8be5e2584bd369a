//! Coordinates for the floating-point search: of ordinary size, in the affine hull of the points, with lengths as they
//! are.

use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::zonotope::ray_exit::dot;

/// Orthonormal axes of the affine hull of points, within rounding; of all space, these are the coordinate axes exactly.
pub(super) struct Frame<const D: usize> {
    pub(super) exponent: i64,
    origin: [f64; D],
    axes: Vec<[f64; D]>,
    /// Orthonormal directions in the frame, the one farthest along which the points spread first.
    pub(super) long: Vec<[f64; D]>,
    /// The points in the frame; the first `rank` coordinates count.
    pub(super) points: Vec<[f64; D]>,
}

/// Points are taken to lie in a subspace if they are nearer to it than this times their spread.
const RELATIVE_DISTANCE_OFF_SUBSPACE: f64 = 1e-13;

impl<const D: usize> Frame<D> {
    /// The frame of points; of rank 0 just when all are equal.
    pub(super) fn new(points: &[[f64; D]]) -> Self {
        let origin = points[0];
        // Halved, a difference never overflows; whole, it never underflows.
        let reach = points.iter().flatten().fold(0.0, |max: f64, c| max.max(c.abs()));
        let (factor, lost) = if reach > 1.0 { (0.5, 1) } else { (1.0, 0) };
        let differences = |p: &[f64; D]| -> [f64; D] { std::array::from_fn(|c| p[c] * factor - origin[c] * factor) };
        let largest = points.iter().flat_map(differences).fold(0.0, |max: f64, c| max.max(c.abs()));
        let exponent = binary_exponent(largest).map_or(0, |e| i64::from(e) + 1 + lost);
        let scaled: Vec<[f64; D]> =
            points.iter().map(|p| differences(p).map(|c| scale_by_power_of_two(c, lost - exponent))).collect();
        let mut axes = long_axes(&scaled);
        let mut long: Vec<[f64; D]> = (0..axes.len()).map(unit_vector).collect();
        if axes.len() == D {
            std::mem::swap(&mut axes, &mut long);
        }
        let mut frame = Self { exponent, origin, axes, long, points: Vec::new() };
        frame.points = scaled.iter().map(|p| frame.inside(p)).collect();
        frame
    }

    pub(super) fn rank(&self) -> usize {
        self.axes.len()
    }

    fn inside(&self, v: &[f64; D]) -> [f64; D] {
        std::array::from_fn(|a| self.axes.get(a).map_or(0.0, |axis| dot(axis, v)))
    }

    /// A vector of the frame, scaled, in the coordinates of space.
    pub(super) fn outside(&self, v: &[f64; D]) -> [f64; D] {
        let mut sum = [0.0; D];
        for (axis, &along) in self.axes.iter().zip(v) {
            sum = std::array::from_fn(|c| sum[c] + along * axis[c]);
        }
        sum
    }

    /// A vector of the frame in the units of the input.
    pub(super) fn vector(&self, v: &[f64; D]) -> [f64; D] {
        self.outside(v).map(|c| scale_by_power_of_two(c, self.exponent))
    }

    /// A point of the frame in the units of the input, the nearest doubles but for rounding.
    pub(super) fn point(&self, p: &[f64; D]) -> [f64; D] {
        let half = self.outside(p).map(|c| scale_by_power_of_two(c, self.exponent - 1));
        std::array::from_fn(|c| (2.0 * (self.origin[c] / 2.0 + half[c])).clamp(-f64::MAX, f64::MAX))
    }
}

/// Orthonormal axes: each points to the vector that is farthest from the span of those before, until all are in it.
fn long_axes<const D: usize>(vectors: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut rest = vectors.to_vec();
    let mut axes: Vec<[f64; D]> = Vec::with_capacity(D);
    while axes.len() < D {
        let Some(far) = rest.iter().copied().max_by(|a, b| dot(a, a).total_cmp(&dot(b, b))) else { break };
        if dot(&far, &far).sqrt() <= RELATIVE_DISTANCE_OFF_SUBSPACE {
            break;
        }
        let mut unit = far;
        // Twice is enough for orthogonality to rounding.
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
