//! The polytope of fixed normals (k-DOP): faces, edges and perhaps corners of the cube.
//!
//! A question has to know how far the polytope of the other mesh reaches along a direction that is no normal of it. The
//! direction is a combination of three of its normals with coefficients that are not negative, the corners of the cell
//! of the cube's symmetries in which it lies, and the reach at most the same combination of the reaches. The cells are
//! found once a question, so that a test is a product with a matrix of three entries a row, eight rows at a time.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::bvh::frame::Frame;
use crate::bvh::volume::{BoundingVolume, box_around};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::lanes::level::level_for_few;
use crate::numeric::linear::dot;
use crate::zonotope::Zonotope;

/// Rows side by side.
const LANES: usize = 8;

/// Rows of a test: at least as many as normals. What is left repeats the first normal.
const ROWS: usize = 2 * LANES;

/// Half of the normals: faces, edges and corners of the cube.
const NORMALS: [[f64; 3]; 13] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [0.0, 1.0, -1.0],
    [1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, -1.0],
    [1.0, -1.0, 1.0],
    [1.0, -1.0, -1.0],
];

/// The factors that make these normals unit vectors, rounded down.
const SHORTENING: [f64; 13] = {
    let (edge, corner) = (0.999_999 * std::f64::consts::FRAC_1_SQRT_2, 0.577_35);
    [1.0, 1.0, 1.0, edge, edge, edge, edge, edge, edge, corner, corner, corner, corner]
};

/// A polytope with the first N normals and their opposites: 9 of faces and edges, or all 13.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiscretePolytope<const N: usize> {
    /// The reaches along each normal, then along their opposites.
    reaches: [[f64; ROWS]; 2],
}

/// The polytope of 18 normals: faces and edges of the cube.
pub type Dop18 = DiscretePolytope<9>;

/// The polytope of 26 normals: faces, edges and corners of the cube.
pub type Dop26 = DiscretePolytope<13>;

/// A direction as a combination of three normals: which, on which side, and the coefficients.
#[derive(Debug, Clone, Copy, Default)]
struct Combination {
    normals: [(usize, usize); 3],
    coefficients: [f64; 3],
}

impl Combination {
    /// The combination that is a vector.
    fn of<const N: usize>(vector: &[f64; 3]) -> Self {
        let mut axes = [0, 1, 2];
        axes.sort_by(|&i, &j| vector[j].abs().total_cmp(&vector[i].abs()));
        let [x, y, z] = axes.map(|axis| vector[axis].abs());
        let signed = |parts: [bool; 3]| {
            let mut normal = [0.0; 3];
            for (axis, is_part) in axes.into_iter().zip(parts) {
                normal[axis] = if is_part { 1f64.copysign(vector[axis]) } else { 0.0 };
            }
            place(&normal)
        };
        let (face, edge) = (signed([true, false, false]), signed([true, true, false]));
        let (normals, coefficients) = if N == NORMALS.len() {
            ([face, edge, signed([true; 3])], [x - y, y - z, z])
        } else if x >= y + z {
            ([face, edge, signed([true, false, true])], [x - y - z, y, z])
        } else {
            let halves = [x + y - z, x - y + z, y + z - x].map(|c| 0.5 * c.max(0.0));
            ([edge, signed([true, false, true]), signed([false, true, true])], halves)
        };
        Self { normals, coefficients: coefficients.map(|c: f64| c.max(0.0)) }
    }
}

/// The position of a normal in the list, and whether its opposite stands there.
fn place(normal: &[f64; 3]) -> (usize, usize) {
    let opposite = normal.map(|c| 0.0 - c);
    let at = NORMALS.iter().position(|n| n == normal || *n == opposite);
    let at = at.expect("signs of one, two or three coordinates are a normal or its opposite");
    (at, usize::from(NORMALS[at] != *normal))
}

/// The normals of one mesh, as the other one sees them.
#[derive(Debug, Clone)]
struct Rows {
    /// The shift of the other polytope along each normal.
    shifts: [f64; ROWS],
    /// The three normals of each combination: which side, and the position.
    normals: [[(u8, u8); ROWS]; 3],
    coefficients: [[f64; ROWS]; 3],
    shortening: [f64; ROWS],
}

impl Rows {
    fn new<const N: usize>(seen: impl Fn(usize) -> (f64, [f64; 3])) -> Self {
        let mut rows = Self {
            shifts: [0.0; ROWS],
            normals: [[(0, 0); ROWS]; 3],
            coefficients: [[0.0; ROWS]; 3],
            shortening: [0.0; ROWS],
        };
        for row in 0..ROWS {
            let normal = if row < N { row } else { 0 };
            let (shift, direction) = seen(normal);
            let combination = Combination::of::<N>(&direction);
            rows.shifts[row] = shift;
            rows.shortening[row] = SHORTENING[normal];
            for (part, ((at, side), c)) in combination.normals.into_iter().zip(combination.coefficients).enumerate() {
                rows.normals[part][row] = (side as u8, at as u8);
                rows.coefficients[part][row] = c;
            }
        }
        rows
    }

    /// The largest gap along the normals of `ours`, both polytopes scaled.
    #[inline(always)]
    fn gap<S: Simd, const N: usize>(
        &self,
        simd: S,
        (ours, scale): (&DiscretePolytope<N>, f64),
        (theirs, their_scale): (&DiscretePolytope<N>, f64),
    ) -> f64 {
        let mut largest = f64x8::splat(simd, f64::NEG_INFINITY);
        for block in 0..ROWS / LANES {
            let from = block * LANES;
            let in_block = |list: &[f64; ROWS]| f64x8::from_slice(simd, &list[from..from + LANES]);
            let mut reaches = [f64x8::splat(simd, 0.0); 2];
            for (normals, coefficients) in self.normals.iter().zip(&self.coefficients) {
                let coefficients = in_block(coefficients);
                for (opposite, reach) in reaches.iter_mut().enumerate() {
                    let mut gathered = [0.0; LANES];
                    for (to, (side, at)) in gathered.iter_mut().zip(&normals[from..from + LANES]) {
                        *to = theirs.reaches[(*side as usize ^ opposite) & 1][*at as usize % ROWS];
                    }
                    *reach += coefficients * f64x8::from_slice(simd, &gathered);
                }
            }
            let [forth, back] = reaches.map(|reach| reach * their_scale);
            let [ahead, behind] = ours.reaches.each_ref().map(|list| in_block(list) * scale);
            let shift = in_block(&self.shifts);
            let gap = (shift - back - ahead).max(-(behind + shift + forth));
            largest = largest.max(gap * in_block(&self.shortening));
        }
        largest.as_slice().iter().fold(f64::NEG_INFINITY, |largest, &gap| if gap > largest { gap } else { largest })
    }
}

/// The normals of both meshes, as the other one sees them.
#[derive(Debug, Clone)]
pub struct TurnedNormals {
    ratio: f64,
    first: Rows,
    second: Rows,
}

impl<const N: usize> BoundingVolume for DiscretePolytope<N> {
    const NAME: &'static str = if N == NORMALS.len() { "26-DOP" } else { "18-DOP" };
    const IS_FITTED_TO_HULL: bool = false;
    type Prepared = TurnedNormals;

    fn around(points: &[[f64; 3]], _effort: usize) -> Self {
        let reach = |normal: [f64; 3]| {
            // each sum is rounded to the next double above, so that no rounding takes a point out
            let height = |p: &[f64; 3]| {
                let first = normal[0] * p[0] + normal[1] * p[1];
                let first = if normal[0] * normal[1] == 0.0 { first } else { first.next_up() };
                let second = first + normal[2] * p[2];
                if normal[2] == 0.0 || normal[0] == 0.0 && normal[1] == 0.0 { second } else { second.next_up() }
            };
            points.iter().map(height).fold(f64::NEG_INFINITY, f64::max)
        };
        let of_normals = |sign: f64| -> [f64; ROWS] {
            let first = reach(NORMALS[0].map(|c| 0.0 + sign * c));
            let other = |row: usize| if row < N { reach(NORMALS[row].map(|c| 0.0 + sign * c)) } else { first };
            std::array::from_fn(|row| if row == 0 { first } else { other(row) })
        };
        Self { reaches: [of_normals(1.0), of_normals(-1.0)] }
    }

    fn prepared(frame: &Frame) -> TurnedNormals {
        let back = frame.inverse_rotation;
        let forth = [0, 1, 2].map(|k| back.map(|row| row[k]));
        let seen = |by: &[[f64; 3]; 3], normal: &[f64; 3]| by.each_ref().map(|row| dot(row, normal));
        let first = Rows::new::<N>(|k| (dot(&NORMALS[k], &frame.shift), seen(&back, &NORMALS[k])));
        let second = Rows::new::<N>(|k| {
            let normal = seen(&forth, &NORMALS[k]);
            // the first polytope as the second one sees it is shifted back
            (-dot(&normal, &frame.shift), normal)
        });
        TurnedNormals { ratio: frame.ratio, first, second }
    }

    #[inline]
    fn gap(&self, other: &Self, turned: &TurnedNormals) -> f64 {
        dispatch!(level_for_few(), simd => {
            let [ours, theirs] = [(self, 1.0), (other, turned.ratio)];
            turned.first.gap(simd, ours, theirs).max(turned.second.gap(simd, theirs, ours))
        })
    }

    #[inline]
    fn is_apart(&self, other: &Self, turned: &TurnedNormals, least: f64) -> bool {
        dispatch!(level_for_few(), simd => {
            let [ours, theirs] = [(self, 1.0), (other, turned.ratio)];
            turned.first.gap(simd, ours, theirs) > least || turned.second.gap(simd, theirs, ours) > least
        })
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        let height = |normal: &[f64; 3]| {
            let [x, y, z] = [0, 1, 2].map(|k| Dyadic::from_f64(normal[k] * point[k]));
            x + y + z
        };
        let [forth, back] = &self.reaches;
        NORMALS.iter().take(N).zip(forth.iter().zip(back)).all(|(normal, (forth, back))| {
            let height = height(normal);
            height <= Dyadic::from_f64(*forth) && -height <= Dyadic::from_f64(*back)
        })
    }

    fn as_zonotope(&self) -> Zonotope<3> {
        // the first three normals are the axes
        let [high, low] = [0, 1].map(|side| [0, 1, 2].map(|k| self.reaches[side][k]));
        let half = |sign: f64| [0, 1, 2].map(|k| 0.5 * (high[k] + sign * low[k]));
        box_around(half(-1.0), half(1.0))
    }

    fn expected_overlaps(&self) -> f64 {
        // of the box of its first three normals, which is a bound from above
        let half = |k: usize| 0.5 * (self.reaches[0][k] + self.reaches[1][k]);
        let axes = [[half(0), 0.0, 0.0], [0.0, half(1), 0.0], [0.0, 0.0, half(2)]];
        crate::bvh::volume::expected_overlaps_of_generators(&axes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_are_the_vector() {
        for vector in [[1.0, 2.0, 3.0], [-0.25, 4.0, 0.5], [0.0, 0.0, -2.0], [1.0, -1.0, 1.0], [3.0, -2.0, 2.0]] {
            for Combination { normals, coefficients } in [Combination::of::<9>(&vector), Combination::of::<13>(&vector)]
            {
                let mut sum = [0.0; 3];
                for ((normal, side), c) in normals.into_iter().zip(coefficients) {
                    assert!(c >= 0.0);
                    let sign = if side == 0 { c } else { -c };
                    (0..3).for_each(|k| sum[k] += sign * NORMALS[normal][k]);
                }
                assert_eq!(sum, vector);
            }
        }
    }
}
