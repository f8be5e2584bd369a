//! The polytope of fixed normals (k-DOP): faces, edges and perhaps corners of the cube.
//!
//! A question has to know how far the polytope of the other mesh reaches along a direction that is no normal of it. The
//! direction is a combination of three of its normals with coefficients that are not negative, the corners of the cell
//! of the cube's symmetries in which it lies, and the reach at most the same combination of the reaches. The cells are
//! found once a question, so that a test is a product with a matrix of three entries a row.

use crate::bvh::frame::Frame;
use crate::bvh::volume::BoundingVolume;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::dot;

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
    /// The reaches along each normal and along its opposite.
    reaches: [[f64; 2]; N],
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

    /// A bound for how far a polytope reaches along the direction and along its opposite.
    #[inline(always)]
    fn reaches<const N: usize>(&self, polytope: &DiscretePolytope<N>) -> [f64; 2] {
        let mut reaches = [0.0; 2];
        for ((normal, side), coefficient) in self.normals.iter().zip(self.coefficients) {
            reaches[0] += coefficient * polytope.reaches[*normal][*side];
            reaches[1] += coefficient * polytope.reaches[*normal][1 - *side];
        }
        reaches
    }
}

/// The position of a normal in the list, and whether its opposite stands there.
fn place(normal: &[f64; 3]) -> (usize, usize) {
    let opposite = normal.map(|c| 0.0 - c);
    let at = NORMALS.iter().position(|n| n == normal || *n == opposite);
    let at = at.expect("signs of one, two or three coordinates are a normal or its opposite");
    (at, usize::from(NORMALS[at] != *normal))
}

/// The normals of both meshes, as the other one sees them.
#[derive(Debug, Clone)]
pub struct TurnedNormals<const N: usize> {
    ratio: f64,
    /// Of the first mesh: the shift along a normal, and the normal as seen from the second mesh.
    first: [(f64, Combination); N],
    /// Of the second mesh likewise.
    second: [(f64, Combination); N],
}

impl<const N: usize> BoundingVolume for DiscretePolytope<N> {
    const NAME: &'static str = if N == NORMALS.len() { "26-DOP" } else { "18-DOP" };
    const IS_FITTED_TO_HULL: bool = false;
    type Turned = TurnedNormals<N>;

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
        Self { reaches: std::array::from_fn(|k| [reach(NORMALS[k]), reach(NORMALS[k].map(|c| 0.0 - c))]) }
    }

    fn turned(frame: &Frame) -> TurnedNormals<N> {
        let back = frame.inverse_rotation;
        let forth = [0, 1, 2].map(|k| back.map(|row| row[k]));
        let seen = |by: &[[f64; 3]; 3], normal: &[f64; 3]| by.each_ref().map(|row| dot(row, normal));
        let first = |k: usize| (dot(&NORMALS[k], &frame.shift), Combination::of::<N>(&seen(&back, &NORMALS[k])));
        let second = |k: usize| {
            let normal = seen(&forth, &NORMALS[k]);
            (dot(&normal, &frame.shift), Combination::of::<N>(&normal))
        };
        TurnedNormals { ratio: frame.ratio, first: std::array::from_fn(first), second: std::array::from_fn(second) }
    }

    #[inline]
    fn gap(&self, other: &Self, turned: &TurnedNormals<N>) -> f64 {
        let mut gap = f64::NEG_INFINITY;
        for (k, shortening) in SHORTENING.iter().enumerate().take(N) {
            let (shift, combination) = &turned.first[k];
            let [forth, back] = combination.reaches(other).map(|reach| turned.ratio * reach);
            let [ahead, behind] = self.reaches[k];
            let along_first = (shift - back - ahead).max(-behind - shift - forth);
            let (shift, combination) = &turned.second[k];
            let [ahead, behind] = combination.reaches(self);
            let [forth, back] = other.reaches[k].map(|reach| turned.ratio * reach);
            let along_second = (shift - back - ahead).max(-behind - shift - forth);
            gap = gap.max(along_first.max(along_second) * shortening);
        }
        gap
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        let height = |normal: &[f64; 3]| {
            let [x, y, z] = [0, 1, 2].map(|k| Dyadic::from_f64(normal[k] * point[k]));
            x + y + z
        };
        self.reaches.iter().zip(&NORMALS).all(|([forth, back], normal)| {
            let height = height(normal);
            height <= Dyadic::from_f64(*forth) && -height <= Dyadic::from_f64(*back)
        })
    }

    fn expected_overlaps(&self) -> f64 {
        // of the box of its first three normals, which is a bound from above
        let half = |k: usize| 0.5 * (self.reaches[k][0] + self.reaches[k][1]);
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
