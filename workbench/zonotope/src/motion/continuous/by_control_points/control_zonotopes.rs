//! A direction along which all Bernstein coefficients of a gap are positive, as one that separates the origin from six
//! zonotopes: the k-th coefficient along u is the least u · z over the k-th *control zonotope*.
//!
//! The search is that of Gilbert, Johnson and Keerthi in doubles over the hull of the six. It proves nothing: the
//! direction that it finds is tried.

use super::super::body::Body;
use super::super::gap::{Matrix, Stretch};
use crate::collision::distance::NearestSimplex;
use crate::motion::bernstein::{convolution, elevated};
use crate::motion::quaternion::{image, transposed_image};
use crate::numeric::bounded::Bounded;
use crate::numeric::lanes::extreme_sums;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};

/// Steps of the search; a separation with a gap takes a few, and where there is none the simplex is soon full.
const STEP_LIMIT: usize = 24;

/// The search ends where the nearest point is within this share of the farthest vertex: the origin is on the hull.
const RELATIVE_DISTANCE: f64 = 1e-24;

/// The inverses of the binomial coefficients of degree 5: those of scaled Bernstein coefficients.
const INVERSE_BINOMIALS: [f64; 6] = [1.0, 0.2, 0.1, 0.1, 0.2, 1.0];

/// The control zonotopes of the gap along directions that are fixed in space or in one of the bodies.
pub(super) struct ControlZonotopes<'a> {
    bodies: [Body<'a>; 2],
    arms: [[f64; 3]; 2],
    squares: [[f64; 3]; 2],
    square: [f64; 5],
    weights: [f64; 2],
    /// What does not depend on the direction: the path between the bases.
    path: [[f64; 3]; 6],
    turns: Turns,
}

/// The rotations of the bodies as a direction sees them.
enum Turns {
    /// Both bodies turn, or translate alone.
    Space(Box<[[Matrix<f64>; 3]; 2]>, [bool; 2]),
    /// The second body turns as the first one sees it.
    First(Box<[Matrix<f64>; 5]>),
}

impl<'a> ControlZonotopes<'a> {
    /// The control zonotopes for directions that are fixed in space.
    pub(super) fn in_space(stretch: &Stretch<'a, Bounded>) -> Self {
        let square = values(&stretch.square);
        let path = stretch.path.each_ref().map(values);
        let path = by_coordinates(|k| convolution(&square, &path.map(|base| base[k])));
        let rotations = stretch.rotations.each_ref().map(|list| list.each_ref().map(matrix));
        let turns = Turns::Space(Box::new(rotations), stretch.arcs.each_ref().map(|arc| arc.is_translation));
        Self::new(stretch, [0, 1], path, turns)
    }

    /// The control zonotopes for directions that are fixed in one body, from that body to the other.
    pub(super) fn in_frame(stretch: &Stretch<'a, Bounded>, own: usize) -> Self {
        let other = 1 - own;
        let path = stretch.path.each_ref().map(|path| values(path).map(|c| if own == 0 { c } else { -c }));
        let rotations = stretch.rotations[own].each_ref().map(matrix);
        let squares = values(&stretch.squares[other]);
        let path = by_coordinates(|k| {
            // the k-th coordinate of R⁻¹ path
            let turned: [f64; 4] = (0..3).fold([0.0; 4], |total, i| {
                let term: [f64; 4] = convolution(&rotations.map(|m| m[i][k]), &path.map(|base| base[i]));
                std::array::from_fn(|j| total[j] + term[j])
            });
            convolution(&squares, &turned)
        });
        let seen = stretch.seen().each_ref().map(matrix);
        let transposed = |m: Matrix<f64>| [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i]));
        let seen = if own == 0 { seen } else { seen.map(transposed) };
        Self::new(stretch, [own, other], path, Turns::First(Box::new(seen)))
    }

    fn new(stretch: &Stretch<'a, Bounded>, order: [usize; 2], path: [[f64; 3]; 6], turns: Turns) -> Self {
        Self {
            bodies: order.map(|i| stretch.bodies[i]),
            arms: order.map(|i| values(&stretch.arcs[i].arm_of(&stretch.bodies[i].center()))),
            squares: order.map(|i| values(&stretch.squares[i])),
            square: values(&stretch.square),
            weights: order.map(|i| stretch.arcs[i].weight.value),
            path,
            turns,
        }
    }

    /// A direction that separates the origin from all control zonotopes, searched for from a first one.
    pub(super) fn separating_direction(&self, first: [f64; 3], tally: &mut dyn Tally) -> Option<[f64; 3]> {
        let mut u = first;
        let mut simplex = NearestSimplex::<3>::new();
        for _ in 0..STEP_LIMIT {
            tally.add(Operation::SupportEvaluation, self.support_evaluations());
            let vertices = self.extreme_points(&u);
            let along = vertices.map(|z| dot(&u, &z));
            let least = (0..6).min_by(|&i, &j| along[i].total_cmp(&along[j]))?;
            if along[least] > 0.0 {
                return Some(u);
            }
            let nearest = simplex.add(vertices[least])?;
            let square = dot(&nearest, &nearest);
            if simplex.is_full() || square.is_nan() || square <= RELATIVE_DISTANCE * simplex.largest_square() {
                return None;
            }
            u = nearest;
        }
        None
    }

    fn support_evaluations(&self) -> u64 {
        match &self.turns {
            Turns::Space(_, is_translation) => is_translation.iter().map(|&is| if is { 1 } else { 3 }).sum(),
            Turns::First(_) => 6,
        }
    }

    /// Of each control zonotope the point that is least along a direction.
    fn extreme_points(&self, u: &[f64; 3]) -> [[f64; 3]; 6] {
        let [a, b] = self.weights;
        let apart: [[f64; 3]; 6] = match &self.turns {
            Turns::Space(rotations, is_translation) => {
                let ends = [0, 1].map(|i| {
                    let scale = [1.0, -1.0][i] * self.weights[i];
                    let placed = |m: &Matrix<f64>, farthest: &[f64; 3]| {
                        image(m, &[0, 1, 2].map(|k| self.arms[i][k] + scale * farthest[k]))
                    };
                    if is_translation[i] {
                        let [farthest] = self.farthest(i, &[transposed_image(&rotations[i][0], u)]);
                        let end = placed(&rotations[i][0], &farthest);
                        return [end, end.map(|c| 2.0 * c), end];
                    }
                    let farthest = self.farthest(i, &rotations[i].each_ref().map(|m| transposed_image(m, u)));
                    [0, 1, 2].map(|k| placed(&rotations[i][k], &farthest[k]))
                });
                by_coordinates(|k| {
                    let to: [f64; 5] = convolution(&self.squares[0], &ends[1].map(|v| a * v[k]));
                    let from: [f64; 5] = convolution(&self.squares[1], &ends[0].map(|v| b * v[k]));
                    elevated(&std::array::from_fn::<_, 5, _>(|j| to[j] - from[j]))
                })
            }
            Turns::First(seen) => {
                let [own] = self.farthest(0, &[*u]);
                let own = [0, 1, 2].map(|k| b * self.arms[0][k] + a * b * own[k]);
                let farthest = self.farthest(1, &seen.each_ref().map(|m| transposed_image(m, u)));
                let others: [[f64; 3]; 5] = std::array::from_fn(|j| {
                    image(&seen[j], &[0, 1, 2].map(|k| a * self.arms[1][k] - a * b * farthest[j][k]))
                });
                by_coordinates(|k| {
                    elevated(&std::array::from_fn::<_, 5, _>(|j| others[j][k] - self.square[j] * own[k]))
                })
            }
        };
        std::array::from_fn(|j| [0, 1, 2].map(|k| (self.path[j][k] + apart[j][k]) * INVERSE_BINOMIALS[j]))
    }

    fn farthest<const K: usize>(&self, body: usize, directions: &[[f64; 3]; K]) -> [[f64; 3]; K] {
        extreme_sums(Rows::new(self.bodies[body].generators()), directions)
    }
}

fn values<const N: usize>(list: &[Bounded; N]) -> [f64; N] {
    list.map(|c| c.value)
}

fn matrix(m: &Matrix<Bounded>) -> Matrix<f64> {
    m.each_ref().map(values)
}

/// Vectors from their coordinates.
fn by_coordinates(coordinate: impl Fn(usize) -> [f64; 6]) -> [[f64; 3]; 6] {
    let [x, y, z] = [0, 1, 2].map(coordinate);
    std::array::from_fn(|j| [x[j], y[j], z[j]])
}
