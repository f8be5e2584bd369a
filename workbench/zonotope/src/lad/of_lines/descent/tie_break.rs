//! Whether a vertex where many lines meet is optimal: its lines are moved apart at random and solved as a problem of
//! their own.
//!
//! The vertex is optimal if and only if minus the gradient of all other lines is a combination of the normals of its
//! lines with coefficients in [−1, 1]. Offsets do not enter this condition, so the lines may be given any. Random ones
//! make the vertices of the new problem ordinary, and its certificate, coefficients that are ±1 off two lines, is one
//! for the old vertex; where the new problem is unbounded, the objective falls along one of the lines.
//!
//! The obvious ways are worse: a search among the signs of k lines is exponential in k, sorting them by angle for the
//! zonogon of their normals costs O(k log k) exact comparisons, and a symbolic perturbation decides every sign by a
//! cascade of determinants. The random offsets are exact doubles, so the problem is one like any other, and any solver
//! of such a problem serves.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::face_dimension::face_dimension;
use super::solution::{Decision, Solution};
use crate::lad::of_lines::subproblem::{Subdifferential, Subproblem};

/// Size of a normal below which the random offset is of size 1: in proportion to the normal it would underflow.
const SMALLEST_NORMAL_FOR_OFFSETS: f64 = 1e-200;

/// The means to decide at a vertex where many lines meet.
///
/// The solver is a field because it is the whole method again, on a smaller problem: this file knows nothing of
/// methods.
#[derive(Debug)]
pub(crate) struct TieBreak<T> {
    /// The seed of the random offsets.
    pub(crate) seed: u64,
    /// A solver of any subproblem, given a seed.
    pub(crate) solve: fn(&Subproblem, u64, &mut T) -> Solution,
}

impl<T> TieBreak<T> {
    /// Decides at a vertex that is minimal along a line through it. The cost is that of the solver for the k lines
    /// through the vertex.
    pub(super) fn decide(&self, subproblem: &Subproblem, around: &Subdifferential, tally: &mut T) -> Decision {
        let lines = &around.through;
        let mut random = Pcg64Mcg::seed_from_u64(self.seed);
        let mut offset = |line: u32| {
            let [x, y] = subproblem.normal(line);
            let size = x.abs() + y.abs();
            random.random_range(-1.0..1.0) * if size > SMALLEST_NORMAL_FOR_OFFSETS { size } else { 1.0 }
        };
        let offsets = lines.iter().map(|&line| offset(line)).collect();
        let Subdifferential { signs, gradient, gradient_error, .. } = around;
        let moved = subproblem.moved_apart(lines, offsets, signs.clone(), *gradient, *gradient_error);
        match (self.solve)(&moved, random.random(), tally) {
            Solution::Optimal(optimal) => Decision::Optimal {
                face_dimension: if subproblem.asks_place_only() { 0 } else { face_dimension(&moved, &optimal) },
                through: lines.iter().copied().zip(optimal.signs).collect(),
                basis: optimal.basis.iter().map(|&i| lines[i as usize]).collect(),
            },
            Solution::Unbounded { along, .. } => {
                let (line, forward) = along.expect("a point that is minimal along a line is left along another one");
                Decision::Descend { line: lines[line as usize], forward }
            }
        }
    }
}
