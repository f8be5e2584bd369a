//! The frame of a question about two hierarchies: the map from the units of the second mesh into those of the first,
//! and bounds of all that rounding does to it.
//!
//! # Derivation of the bounds
//!
//! Coordinates of either mesh are at most 1 in its units, 2^e_A and 2^e_B, e_B ≤ e_A. An affine map that is one to one
//! does not change whether sets meet, so the question is asked where the first mesh is as it is stored: the second one
//! is mapped by the inverse of the first pose after the second pose, x ↦ R x + s.
//!
//! Let ε bound the entries of Mᵀ M − I for both matrices. The inverse of M is (I + E)⁻¹ Mᵀ with entries of E up to ε,
//! so R is 2^(e_B − e_A) times M_Aᵀ M_B up to 6 ε and 2^-48 in each entry, and s is M_Aᵀ times the difference of the
//! translations up to (9 ε + 2^-49) times the sum of its coordinates, which is at most 3 |s|. A point is off by
//! (`POINT_OF_A_FRAME` + 64 ε) (1 + |s|) in each coordinate with room to spare, where ε is at most 1e-12. Here |s| is
//! the largest coordinate.
//!
//! A volume reaches at most [`REACH_LIMIT`] from the origin along each axis. A test of two volumes along a direction u,
//! |u| ≤ 1, adds up terms whose magnitudes sum up to at most 4 |s| + 128, each through fewer than a hundred roundings;
//! u in the frame of the second body is taken by Rᵀ u for R⁻¹ u, which 16 ε of it pays for. Together that is the
//! [`slack`](Frame::slack): a gap that is larger is proved.

use crate::numeric::linear::{dot, max_norm};
use crate::numeric::scaling::{scale_by_power_of_two, scaled_difference};
use crate::numeric::tolerance::{NODE_TEST, POINT_OF_A_FRAME, POSE_OF_A_FRAME};
use crate::zonotope::pose::Pose;

/// The farthest that a volume may reach from the origin along an axis, in units of its mesh.
pub const REACH_LIMIT: f64 = 16.0;

/// Poses whose matrices are farther from rotations than this do not make a frame.
const FARTHEST_FROM_ROTATION: f64 = 1e-12;

/// The map from the units of the second mesh into those of the first.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    /// R, by rows: a rotation, perhaps with a reflection, times `ratio`.
    pub matrix: [[f64; 3]; 3],
    /// The rotation of `matrix` transposed, by rows: directions of the first mesh as seen from the second.
    pub inverse_rotation: [[f64; 3]; 3],
    /// The unit of the second mesh in units of the first, at most 1; 0 where it is less than the least double.
    pub ratio: f64,
    /// s, of which coordinates are at most a sixty-fourth of the largest double.
    pub shift: [f64; 3],
    /// A computed gap along a direction of length at most 1 is off by less than this.
    pub slack: f64,
    /// A computed image of a point is off by less than this in each coordinate.
    pub point_error: f64,
}

impl Frame {
    /// The frame of two meshes under poses, in units of 2^`exponents`, the larger one first. `None` where a matrix is
    /// no rotation, or the shift leaves the range of doubles.
    pub(super) fn of_poses([a, b]: [&Pose; 2], exponents: [i64; 2]) -> Option<Self> {
        let off = a.distance_from_rotation().max(b.distance_from_rotation()) + POSE_OF_A_FRAME;
        let ratio = scale_by_power_of_two(1.0, exponents[1] - exponents[0]);
        if a == b && off <= FARTHEST_FROM_ROTATION && ratio == 1.0 {
            return Some(Self::of(Pose::IDENTITY.matrix(), ratio, [0.0; 3], 0.0));
        }
        let [to, from] = [a.translation(), b.translation()];
        let moved: [f64; 3] = std::array::from_fn(|k| scaled_difference(from[k], to[k], -exponents[0]));
        let (rows, columns) = (a.matrix(), b.matrix());
        let rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| rows[k][i] * columns[k][j]).sum::<f64>()));
        let shift = [0, 1, 2].map(|i| (0..3).map(|k| rows[k][i] * moved[k]).sum::<f64>());
        let is_usable = off <= FARTHEST_FROM_ROTATION && shift.iter().chain(&moved).all(|c| c.abs() <= f64::MAX / 64.0);
        is_usable.then(|| Self::of(rotation, ratio, shift, off))
    }

    /// The frame of two meshes that stand in the same coordinates and units, each point off by at most `error`.
    pub(super) fn of_rounded_points(error: f64) -> Self {
        let exact = Self::of(Pose::IDENTITY.matrix(), 1.0, [0.0; 3], 0.0);
        Self { slack: exact.slack + 6.0 * error, point_error: 2.0 * error, ..exact }
    }

    fn of(rotation: [[f64; 3]; 3], ratio: f64, shift: [f64; 3], off: f64) -> Self {
        let far = max_norm(&shift);
        let is_exact = off == 0.0;
        Self {
            matrix: rotation.map(|row| row.map(|c| c * ratio)),
            inverse_rotation: [0, 1, 2].map(|k| rotation.map(|row| row[k])),
            ratio,
            shift,
            slack: (4.0 * far + 128.0) * (NODE_TEST + 16.0 * off),
            point_error: if is_exact { 0.0 } else { (POINT_OF_A_FRAME + 64.0 * off) * (1.0 + far) },
        }
    }

    /// R v.
    #[inline(always)]
    pub fn turned(&self, v: &[f64; 3]) -> [f64; 3] {
        self.matrix.each_ref().map(|row| dot(row, v))
    }

    /// The vector of the first mesh as the second one sees it, but for `ratio`.
    #[inline(always)]
    pub fn turned_back(&self, v: &[f64; 3]) -> [f64; 3] {
        self.inverse_rotation.each_ref().map(|row| dot(row, v))
    }

    /// R x + s.
    #[inline(always)]
    pub fn image(&self, x: &[f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.turned(x);
        [a + self.shift[0], b + self.shift[1], c + self.shift[2]]
    }
}
