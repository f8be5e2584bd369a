//! The plane { u : u · p = 1 } in doubles: for guesses.

use super::cell::Cell;
use super::smooth::Guess;

/// Coordinates (x, y) = (u_i, u_j) of the plane, k the axis along which p is longest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chart {
    axes: [usize; 3],
    /// p_i / p_k and p_j / p_k.
    slopes: [f64; 2],
    /// 1 / p_k.
    inverse: f64,
}

impl Chart {
    pub(super) fn new(p: [f64; 3]) -> Self {
        let longest = if p[0].abs() >= p[1].abs() && p[0].abs() >= p[2].abs() {
            0
        } else if p[1].abs() >= p[2].abs() {
            1
        } else {
            2
        };
        let [i, j, k] = [(longest + 1) % 3, (longest + 2) % 3, longest];
        Self { axes: [i, j, k], slopes: [p[i] / p[k], p[j] / p[k]], inverse: 1.0 / p[k] }
    }

    /// The line a x + b y + c = v · u.
    #[inline(always)]
    pub(super) fn line(&self, v: &[f64; 3]) -> [f64; 3] {
        let [i, j, k] = self.axes;
        [v[i] - v[k] * self.slopes[0], v[j] - v[k] * self.slopes[1], v[k] * self.inverse]
    }

    /// The line with the inverse length of its generator; the zero vector as a line without normal.
    #[inline(always)]
    pub(super) fn weighted_line(&self, v: &[f64; 3]) -> [f64; 4] {
        let [a, b, c] = self.line(v);
        let length = v[0].abs() + v[1].abs() + v[2].abs();
        [a, b, c, 1.0 / length.max(f64::MIN_POSITIVE)]
    }

    fn direction(&self, [x, y]: [f64; 2], height: f64) -> [f64; 3] {
        let [i, j, k] = self.axes;
        let mut u = [0.0; 3];
        u[i] = x;
        u[j] = y;
        u[k] = height * self.inverse - x * self.slopes[0] - y * self.slopes[1];
        u
    }

    /// The direction u of a point, u · p = 1.
    pub(super) fn point(&self, point: [f64; 2]) -> [f64; 3] {
        self.direction(point, 1.0)
    }

    /// The cell of a guess, with its sides stretched.
    pub(super) fn cell(&self, guess: &Guess, stretch: f64) -> Cell {
        let side = |v: [f64; 2]| self.direction(v.map(|c| c * stretch), 0.0);
        Cell { center: self.point(guess.point), sides: guess.sides.map(side) }
    }
}
