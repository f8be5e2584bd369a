//! A line of the plane, exactly, and its name in the input.

use crate::numeric::dyadic::Dyadic;

/// The index of a line in the input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LineIndex(pub u32);

impl LineIndex {
    /// The index as a position in the input slice.
    pub fn position(self) -> usize {
        self.0 as usize
    }
}

/// The exact line normal · x + offset = 0, with a weight multiplied in where there is one.
#[derive(Debug, Clone)]
pub struct ExactLine {
    /// The coefficients of x and y.
    pub normal: [Dyadic; 2],
    /// The constant coefficient.
    pub offset: Dyadic,
}

impl ExactLine {
    /// The homogeneous coordinates [X, Y, W] of the common point of two lines, W ≥ 0; W = 0 when they are parallel.
    pub fn meet(&self, other: &Self) -> [Dyadic; 3] {
        let ([a, b], c) = (&self.normal, &self.offset);
        let ([d, e], f) = (&other.normal, &other.offset);
        let point = [b * f - c * e, c * d - a * f, a * e - b * d];
        if point[2].sign().is_lt() { point.map(|v| -v) } else { point }
    }

    /// normal · [X, Y] + offset · W at a point in homogeneous coordinates: its sign is the point's side when W > 0.
    pub fn evaluate(&self, [x, y, w]: &[Dyadic; 3]) -> Dyadic {
        &self.normal[0] * x + &self.normal[1] * y + &self.offset * w
    }

    /// The same line, scaled by a power of two so that the larger coordinate of its normal is about 1.
    pub(crate) fn normalized(self) -> Self {
        let shift = self.normal.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
        Self { normal: self.normal.map(|v| v.scaled(-shift)), offset: self.offset.scaled(-shift) }
    }

    /// The direction of the line: its normal turned by a quarter counter-clockwise.
    pub fn direction(&self) -> [Dyadic; 2] {
        [-self.normal[1].clone(), self.normal[0].clone()]
    }
}
