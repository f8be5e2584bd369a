//! The test of two boxes of which the second one is turned: for the trees of other libraries, which have none.
//!
//! Separating axes after Gottschalk, Lin and Manocha (1996): the normals of the faces, then the products of edges.

use zonotope::Pose;

/// A share of a box's coordinates that rounding stays far below; by so much every box is larger than it is.
pub const ROUNDING: f64 = 1e-12;

/// A box along the axes.
#[derive(Clone, Copy)]
pub struct Cuboid {
    pub middle: [f64; 3],
    pub half: [f64; 3],
}

impl Cuboid {
    /// The box between two corners, larger by more than rounding.
    #[inline]
    pub fn between(low: [f64; 3], high: [f64; 3]) -> Self {
        let reach = (0..3).fold(0.0, |reach: f64, k| reach.max(low[k].abs()).max(high[k].abs()));
        let middle = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
        Self { middle, half: [0, 1, 2].map(|k| 0.5 * (high[k] - low[k]) + ROUNDING * reach) }
    }

    /// The square of half the diagonal: which of two boxes is the larger one.
    #[inline]
    pub fn size(&self) -> f64 {
        self.half.iter().map(|c| c * c).sum()
    }
}

/// A pose with the magnitudes of its matrix.
#[derive(Clone, Copy)]
pub struct Turn {
    rows: [[f64; 3]; 3],
    magnitudes: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl Turn {
    pub fn of(pose: &Pose) -> Self {
        let rows = pose.matrix();
        // edges that are nearly parallel have a product of no direction
        let magnitudes = rows.map(|row| row.map(|c| c.abs() + ROUNDING));
        Self { rows, magnitudes, shift: pose.translation() }
    }

    /// The place of a point.
    #[inline]
    pub fn image(&self, x: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| {
            let [a, b, c] = self.rows[i];
            a * x[0] + b * x[1] + c * x[2] + self.shift[i]
        })
    }

    /// Whether no axis separates a box from another one under the pose, among the first `AXES` of the fifteen.
    #[inline]
    pub fn meet<const AXES: usize>(&self, a: &Cuboid, b: &Cuboid) -> bool {
        let Self { rows: r, magnitudes: m, .. } = self;
        let moved = self.image(b.middle);
        let t = [0, 1, 2].map(|i| moved[i] - a.middle[i]);
        let (p, q) = (&a.half, &b.half);
        for i in 0..3 {
            if t[i].abs() > p[i] + m[i][0] * q[0] + m[i][1] * q[1] + m[i][2] * q[2] {
                return false;
            }
        }
        if AXES == 3 {
            return true;
        }
        for j in 0..3 {
            let along = t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j];
            if along.abs() > q[j] + m[0][j] * p[0] + m[1][j] * p[1] + m[2][j] * p[2] {
                return false;
            }
        }
        if AXES == 6 {
            return true;
        }
        for i in 0..3 {
            let (next, last) = ((i + 1) % 3, (i + 2) % 3);
            for j in 0..3 {
                let (after, before) = ((j + 1) % 3, (j + 2) % 3);
                let along = t[last] * r[next][j] - t[next] * r[last][j];
                let of_a = p[next] * m[last][j] + p[last] * m[next][j];
                if along.abs() > of_a + q[after] * m[i][before] + q[before] * m[i][after] {
                    return false;
                }
            }
        }
        true
    }
}
