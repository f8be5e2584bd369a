//! A direction along which all Bernstein coefficients of a gap are positive, as one that separates the origin from six
//! zonotopes: the k-th coefficient along u is the least u · z over the k-th *control zonotope*.
//!
//! The search is that of Gilbert, Johnson and Keerthi in doubles over the hull of the six. It proves nothing: the
//! direction that it finds is tried.

use crate::collision::distance::NearestSimplex;
use crate::motion::arc::{Arc, displacement};
use crate::motion::bernstein::{convolution, elevated};
use crate::motion::quaternion::{image, transposed_image};
use crate::numeric::linear::dot;
use crate::zonotope::Zonotope;

/// Steps of the search; a separation with a gap takes a few, and where there is none the simplex is soon full.
const STEP_LIMIT: usize = 24;

/// The search ends where the nearest point is within this share of the farthest vertex: the origin is on the hull.
const RELATIVE_DISTANCE: f64 = 1e-24;

/// The binomial coefficients of degree 5: those of scaled Bernstein coefficients.
const BINOMIALS: [f64; 6] = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];

/// The control zonotopes of the gap along directions that are fixed in space or in the first body.
pub(super) struct ControlZonotopes<'a> {
    bodies: [&'a Zonotope<3>; 2],
    arms: [[f64; 3]; 2],
    squares: [[f64; 3]; 2],
    weights: [f64; 2],
    /// What does not depend on the direction: the path between the bases.
    path: [[f64; 3]; 6],
    turns: Turns,
}

/// The rotations of the bodies as a direction sees them.
enum Turns {
    /// Both bodies turn.
    Space(Box<[[[[f64; 3]; 3]; 3]; 2]>),
    /// The second body turns as the first one sees it.
    First(Box<[[[f64; 3]; 3]; 5]>),
}

impl<'a> ControlZonotopes<'a> {
    /// The control zonotopes for directions that are fixed in space.
    pub(super) fn in_space(bodies: [&'a Zonotope<3>; 2], arcs: [&Arc<f64>; 2]) -> Self {
        let squares = arcs.map(Arc::square);
        let both: [f64; 5] = convolution(&squares[0], &squares[1]);
        let path = displacement(arcs[0], arcs[1]);
        let path = by_coordinates(|k| convolution(&both, &path.map(|base| base[k])));
        Self::new(bodies, arcs, path, Turns::Space(Box::new(arcs.map(Arc::rotations))))
    }

    /// The control zonotopes for directions that are fixed in the first body.
    pub(super) fn in_first(bodies: [&'a Zonotope<3>; 2], arcs: [&Arc<f64>; 2]) -> Self {
        let path = displacement(arcs[0], arcs[1]);
        let rotations = arcs[0].rotations();
        let path = by_coordinates(|k| {
            // the k-th coordinate of R_aᵀ path
            let turned: [f64; 4] = (0..3).fold([0.0; 4], |total, i| {
                let term: [f64; 4] = convolution(&rotations.map(|m| m[i][k]), &path.map(|base| base[i]));
                std::array::from_fn(|j| total[j] + term[j])
            });
            convolution(&arcs[1].square(), &turned)
        });
        Self::new(bodies, arcs, path, Turns::First(Box::new(arcs[0].rotations_seen(arcs[1]))))
    }

    fn new(bodies: [&'a Zonotope<3>; 2], arcs: [&Arc<f64>; 2], path: [[f64; 3]; 6], turns: Turns) -> Self {
        Self {
            bodies,
            arms: [0, 1].map(|i| arcs[i].arm_of(&bodies[i].center())),
            squares: arcs.map(Arc::square),
            weights: arcs.map(|arc| arc.weight),
            path,
            turns,
        }
    }

    /// A direction that separates the origin from all control zonotopes, searched for from a first one.
    pub(super) fn separating_direction(&self, first: [f64; 3]) -> Option<[f64; 3]> {
        let mut u = first;
        let mut simplex = NearestSimplex::<3>::new();
        for _ in 0..STEP_LIMIT {
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

    /// Of each control zonotope the point that is least along a direction.
    fn extreme_points(&self, u: &[f64; 3]) -> [[f64; 3]; 6] {
        let [a, b] = self.weights;
        let apart: [[f64; 3]; 6] = match &self.turns {
            Turns::Space(rotations) => {
                let ends = [0, 1].map(|i| {
                    let (sign, own) = ([1.0, -1.0][i], self.weights[i]);
                    rotations[i].map(|m| {
                        let farthest = signed_sum(self.bodies[i], &transposed_image(&m, u));
                        let point = [0, 1, 2].map(|k| self.arms[i][k] + sign * own * farthest[k]);
                        image(&m, &point)
                    })
                });
                by_coordinates(|k| {
                    let to: [f64; 5] = convolution(&self.squares[0], &ends[1].map(|v| a * v[k]));
                    let from: [f64; 5] = convolution(&self.squares[1], &ends[0].map(|v| b * v[k]));
                    elevated(&std::array::from_fn::<_, 5, _>(|j| to[j] - from[j]))
                })
            }
            Turns::First(seen) => {
                let own = signed_sum(self.bodies[0], u);
                let own = [0, 1, 2].map(|k| b * self.arms[0][k] + a * b * own[k]);
                let others = seen.each_ref().map(|m| {
                    let farthest = signed_sum(self.bodies[1], &transposed_image(m, u));
                    image(m, &[0, 1, 2].map(|k| a * self.arms[1][k] - a * b * farthest[k]))
                });
                let both: [f64; 5] = convolution(&self.squares[0], &self.squares[1]);
                by_coordinates(|k| elevated(&std::array::from_fn::<_, 5, _>(|j| others[j][k] - both[j] * own[k])))
            }
        };
        std::array::from_fn(|j| [0, 1, 2].map(|k| (self.path[j][k] + apart[j][k]) / BINOMIALS[j]))
    }
}

/// Vectors from their coordinates.
fn by_coordinates(coordinate: impl Fn(usize) -> [f64; 6]) -> [[f64; 3]; 6] {
    let [x, y, z] = [0, 1, 2].map(coordinate);
    std::array::from_fn(|j| [x[j], y[j], z[j]])
}

/// The sum of the generators, each with the sign with which it goes along a direction.
fn signed_sum(body: &Zonotope<3>, direction: &[f64; 3]) -> [f64; 3] {
    body.generators().iter().fold([0.0; 3], |sum, g| {
        let sign = f64::copysign(1.0, dot(direction, g));
        [0, 1, 2].map(|k| sum[k] + sign * g[k])
    })
}
