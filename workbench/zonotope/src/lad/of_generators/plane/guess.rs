//! A guess: a point of the plane of directions, and a parallelogram around it.

/// A point near the optimum, the band of lines whose kinks were rounded off, and the sides of a parallelogram around
/// the point in which the optimum is likely to be.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Guess {
    pub(crate) point: [f64; 2],
    pub(crate) band: f64,
    pub(crate) sides: [[f64; 2]; 2],
}

impl Guess {
    /// Whether the distance of a point is at most `times` that of the corner between the sides.
    pub(crate) fn is_near(&self, point: [f64; 2], times: f64) -> bool {
        let square = |[x, y]: [f64; 2]| x * x + y * y;
        let off = [point[0] - self.point[0], point[1] - self.point[1]];
        square(off) <= times * times * (square(self.sides[0]) + square(self.sides[1]))
    }
}
