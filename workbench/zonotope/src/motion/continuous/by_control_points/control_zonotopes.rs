//! A direction along which all Bernstein coefficients of a gap are positive, as one that separates the origin from six
//! zonotopes: the k-th coefficient along u is the least u · z over the k-th *control zonotope*.
//!
//! The search is that of Gilbert, Johnson and Keerthi over the hull of the six. The coefficients along the direction
//! that it finds are known with the bound of all doubles of the stretch.

use super::super::SeparatingDirection;
use super::super::doubles::doubt_along;
use super::super::gap::{ArcPair, Matrix, Stretch};
use super::super::parts::body::{Body, Side};
use super::super::simplex_search::{Lowest, Outcome, search};
use crate::motion::bernstein::{self, INVERSE_BINOMIALS, convolution, elevated};
use crate::motion::quaternion::{image, transposed_image};
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};

/// The control zonotopes of the gap along directions that are fixed in space or in one of the bodies.
pub(super) struct ControlZonotopes<'s, 'a> {
    stretch: &'s Stretch<'a, f64>,
    /// The body that a direction leads from, and the other.
    order: [usize; 2],
    arms: [[f64; 3]; 2],
    /// The path between the bases, which does not depend on the direction.
    path: [[f64; 3]; 6],
    frame: Frame,
    rounding: f64,
}

/// The frame in which a direction is fixed.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Frame {
    Space,
    Body,
}

/// A direction along which all coefficients are positive as they are rounded.
pub(super) struct Found {
    pub(super) direction: SeparatingDirection,
    /// Whether they are positive for certain.
    pub(super) is_proved: bool,
}

impl<'s, 'a> ControlZonotopes<'s, 'a> {
    /// The control zonotopes for directions that are fixed in space.
    pub(super) fn in_space(stretch: &'s Stretch<'a, f64>) -> Self {
        let path = by_coordinates(|k| convolution(&stretch.square, &stretch.path.map(|base| base[k])));
        Self::new(stretch, [0, 1], path, Frame::Space)
    }

    /// The control zonotopes for directions that are fixed in one body, from that body to the other.
    pub(super) fn in_frame(stretch: &'s Stretch<'a, f64>, own: usize) -> Self {
        let other = 1 - own;
        let sign = if own == 0 { 1.0 } else { -1.0 };
        let rotations = &stretch.rotations[own];
        let path = by_coordinates(|k| {
            // the k-th coordinate of R⁻¹ path
            let turned: [f64; 4] = (0..3).fold([0.0; 4], |total, i| {
                let column = rotations.each_ref().map(|m| sign * m[i][k]);
                let term: [f64; 4] = convolution(&column, &stretch.path.map(|base| base[i]));
                std::array::from_fn(|j| total[j] + term[j])
            });
            convolution(&stretch.squares[other], &turned)
        });
        Self::new(stretch, [own, other], path, Frame::Body)
    }

    fn new(stretch: &'s Stretch<'a, f64>, order: [usize; 2], path: [[f64; 3]; 6], frame: Frame) -> Self {
        let arms = order.map(|i| stretch.arcs[i].arm_of(&stretch.bodies[i].center()));
        Self { stretch, order, arms, path, frame, rounding: stretch.rounding() }
    }

    /// A direction that separates the origin from all control zonotopes, searched for from first ones, which are those
    /// of the frame, from the body in which they are fixed to the other.
    pub(super) fn separating_direction(&self, first: &[[f64; 3]], tally: &mut dyn Tally) -> Option<Found> {
        let mut is_proved = false;
        let found = search(first, 0.0, |u| {
            tally.add(Operation::SupportEvaluation, self.support_evaluations());
            let direction = self.direction(u);
            let margin = self.stretch.margin_along(&direction) * self.weight(0) * self.weight(1);
            let vertices = self.extreme_points(u);
            let excess: [f64; 6] = std::array::from_fn(|k| {
                // the margin times the square, of which the degree is raised
                let square =
                    [0, 1].map(|i| if i <= k { self.stretch.square.get(k - i).copied().unwrap_or(0.0) } else { 0.0 });
                dot(u, &vertices[k]) - margin * (square[0] + square[1]) * INVERSE_BINOMIALS[k]
            });
            let least = (1..6).fold(0, |least, k| if excess[k] < excess[least] { k } else { least });
            is_proved = bernstein::is_above(&excess, doubt_along(self.rounding, &direction));
            Lowest { point: vertices[least], is_found: is_proved || excess[least] > 0.0 }
        });
        let Outcome::Found(u) = found else { return None };
        Some(Found { direction: self.direction(&u), is_proved })
    }

    /// A direction of the frame as one from the first body to the second.
    fn direction(&self, u: &[f64; 3]) -> SeparatingDirection {
        match (self.frame, self.order[0]) {
            (Frame::Space, _) => SeparatingDirection::Space(*u),
            (Frame::Body, 0) => SeparatingDirection::First(*u),
            (Frame::Body, _) => SeparatingDirection::Second(u.map(|c| -c)),
        }
    }

    fn body(&self, place: usize) -> &Body<'a> {
        &self.stretch.bodies[self.order[place]]
    }

    fn weight(&self, place: usize) -> f64 {
        self.stretch.arcs[self.order[place]].weight
    }

    /// The rotations of the other body as the direction's body sees it.
    fn seen(&self, u: &[f64; 3]) -> [[f64; 3]; 5] {
        let pull = if self.order[0] == 0 { transposed_image } else { image };
        self.stretch.seen().each_ref().map(|m| pull(m, u))
    }

    fn support_evaluations(&self) -> u64 {
        match self.frame {
            Frame::Space => self.stretch.support_evaluations(&SeparatingDirection::Space([0.0; 3])),
            Frame::Body => self.stretch.support_evaluations(&SeparatingDirection::First([0.0; 3])),
        }
    }

    /// Of each control zonotope the point that is lowest along a direction.
    fn extreme_points(&self, u: &[f64; 3]) -> [[f64; 3]; 6] {
        let apart = match self.frame {
            Frame::Space => self.apart_in_space(u),
            Frame::Body => self.apart_in_body(u),
        };
        std::array::from_fn(|j| [0, 1, 2].map(|k| (self.path[j][k] + apart[j][k]) * INVERSE_BINOMIALS[j]))
    }

    fn apart_in_space(&self, u: &[f64; 3]) -> [[f64; 3]; 6] {
        let ArcPair { arcs, rotations, squares, .. } = &**self.stretch;
        let ends = [0, 1].map(|i| {
            let scale = [1.0, -1.0][i] * arcs[i].weight;
            let placed = |m: &Matrix<f64>, farthest: &[f64; 3]| {
                image(m, &[0, 1, 2].map(|k| self.arms[i][k] + scale * farthest[k]))
            };
            if arcs[i].is_translation {
                let [farthest] = self.farthest(i, &[transposed_image(&rotations[i][0], u)]);
                let end = placed(&rotations[i][0], &farthest);
                return [end, end.map(|c| 2.0 * c), end];
            }
            let farthest = self.farthest(i, &rotations[i].each_ref().map(|m| transposed_image(m, u)));
            [0, 1, 2].map(|k| placed(&rotations[i][k], &farthest[k]))
        });
        let [a, b] = [arcs[0].weight, arcs[1].weight];
        by_coordinates(|k| {
            let to: [f64; 5] = convolution(&squares[0], &ends[1].map(|v| a * v[k]));
            let from: [f64; 5] = convolution(&squares[1], &ends[0].map(|v| b * v[k]));
            elevated(&std::array::from_fn::<_, 5, _>(|j| to[j] - from[j]))
        })
    }

    fn apart_in_body(&self, u: &[f64; 3]) -> [[f64; 3]; 6] {
        let [a, b] = [self.weight(0), self.weight(1)];
        let [own] = self.farthest(0, &[*u]);
        let own = [0, 1, 2].map(|k| b * self.arms[0][k] + a * b * own[k]);
        let farthest = self.farthest(1, &self.seen(u));
        let place = if self.order[0] == 0 { image } else { transposed_image };
        let others: [[f64; 3]; 5] = std::array::from_fn(|j| {
            place(&self.stretch.seen()[j], &[0, 1, 2].map(|k| a * self.arms[1][k] - a * b * farthest[j][k]))
        });
        by_coordinates(|k| {
            elevated(&std::array::from_fn::<_, 5, _>(|j| others[j][k] - self.stretch.square[j] * own[k]))
        })
    }

    fn farthest<const K: usize>(&self, place: usize, directions: &[[f64; 3]; K]) -> [[f64; 3]; K] {
        let side = if place == 0 { Side::Away } else { Side::Toward };
        self.body(place).farthest(side, directions)
    }
}

/// Vectors from their coordinates.
fn by_coordinates(coordinate: impl Fn(usize) -> [f64; 6]) -> [[f64; 3]; 6] {
    let [x, y, z] = [0, 1, 2].map(coordinate);
    std::array::from_fn(|j| [x[j], y[j], z[j]])
}
