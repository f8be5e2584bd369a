//! A linear change of coordinates in which the normals of a set of lines point about equally everywhere.

use crate::lad::of_lines::subproblem::Subproblem;

/// A lower triangular matrix [[xx, 0], [yx, yy]] that makes the normals of a set of lines about equally long in all
/// directions: the inverse transposed Cholesky factor of Σ normal normalᵀ.
///
/// A square in the plane's own coordinates would not do: the lines of a long thin cloud or of nearly parallel planes
/// would all cross it before it is wide enough in the other direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub(super) xx: f64,
    pub(super) yx: f64,
    pub(super) yy: f64,
}

impl Frame {
    /// The frame of the lines of a subproblem; `None` when it is not finite.
    pub(crate) fn of(subproblem: &Subproblem) -> Option<Self> {
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        subproblem.lines.each_block(|_, block| {
            for (x, y) in block.normal_x.iter().zip(block.normal_y) {
                (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
            }
        });
        // Σ a aᵀ = C Cᵀ with C upper triangular, so that the frame (C⁻¹)ᵀ is lower triangular.
        let c_yy = yy.sqrt();
        let c_xy = xy / c_yy;
        let c_xx = (xx - c_xy * c_xy).sqrt();
        let frame = Self { xx: 1.0 / c_xx, yx: -c_xy / (c_xx * c_yy), yy: 1.0 / c_yy };
        [frame.xx, frame.yx, frame.yy].iter().all(|v| v.is_finite()).then_some(frame)
    }

    /// How far the value of a line with this normal changes over a cell of radius 1.
    pub(crate) fn reach(&self, x: f64, y: f64) -> f64 {
        let [u, v] = self.turned(x, y);
        u.abs() + v.abs()
    }

    /// The gradient of a linear function in the coordinates of the frame.
    pub(super) fn turned(&self, x: f64, y: f64) -> [f64; 2] {
        [self.xx * x + self.yx * y, self.yy * y]
    }
}
