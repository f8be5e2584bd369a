//! Where the ray along p leaves Z, exactly: a supporting direction and the face of Z on it.

use std::cmp::Ordering;

use super::plane::PlaneProblem;
use super::sums::signed_sum;
use crate::collision::{Displacement, Gauge, Location, Separation};
use crate::lad::by_pruning;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::vector::{ExactVector, dot};
use crate::tally::{Operation, Tally};

use super::separation::separation;
use super::witness::Combination;

/// The seed of the kernel: it decides the time, never the answer.
const SEED: u64 = 0x5a;

/// The optimum of min { h(u) : u · p = 1 } with its proof: Σ δ_i v_i = λ p, where δ = `signs` off the basis and in [−1, 1] on it, and
/// λ = `reach` / `along`. The gauge is 1 / λ.
#[derive(Debug)]
pub(super) struct Exit {
    /// A minimiser, scaled: u · p > 0.
    pub(super) direction: ExactVector,
    /// 1 or −1 for each generator; 0 for the basis and for the zero vector.
    pub(super) signs: Vec<i8>,
    /// At most two generators, linearly independent, orthogonal to u.
    pub(super) basis: Vec<usize>,
    /// Σ sign · v.
    pub(super) sum: ExactVector,
    /// h(u) = u · `sum`, not negative; zero just when p is off the span of the generators.
    pub(super) reach: Dyadic,
    /// u · p, positive.
    pub(super) along: Dyadic,
}

impl Exit {
    /// Solves the kernel problem of a question whose displacement p is not zero.
    pub(super) fn find(question: &Displacement<'_, 3>, p: &ExactVector, tally: &mut impl Tally) -> Self {
        tally.add(Operation::ExactFallback, 1);
        let plane = PlaneProblem::new(question, p.clone());
        let outcome = by_pruning::minimize_counted(&plane.problem, SEED, tally);
        let optimum = outcome.optimum().expect("a sum of absolute values is bounded below");
        let direction = plane.direction(optimum.homogeneous_point(&plane.problem));
        let basis = optimum.certificate.basis.iter().map(|line| line.position()).collect();
        Self::new(question, p, direction, plane.signs(&optimum.certificate.signs), basis)
    }

    pub(super) fn new(
        question: &Displacement<'_, 3>,
        p: &ExactVector,
        direction: ExactVector,
        signs: Vec<i8>,
        mut basis: Vec<usize>,
    ) -> Self {
        basis.sort_unstable();
        let sum = signed_sum(question.generators().copied().zip(signs.iter().copied()));
        let (reach, along) = (dot(&sum, &direction), dot(p, &direction));
        Self { direction, signs, basis, sum, reach, along }
    }

    /// The gauge is 1 / λ = `along` / `reach`.
    pub(super) fn gauge(&self, location: Location<3>) -> Gauge<3> {
        if self.reach.is_zero() {
            return Gauge { value: f64::INFINITY, error: 0.0, location };
        }
        let value = self.along.rounded_ratio(&self.reach);
        if value < f64::MAX {
            // half a unit in the last place, a little more, and a step where the value is denormal
            Gauge { value, error: value * f64::EPSILON + f64::from_bits(1), location }
        } else {
            Gauge { value: f64::MAX, error: f64::INFINITY, location }
        }
    }

    /// Where p lies, with its proof.
    pub(super) fn location(&self, question: &Displacement<'_, 3>, p: &ExactVector) -> Location<3> {
        match self.along.cmp(&self.reach) {
            Ordering::Greater => Location::Outside(self.separation(question, p)),
            order => {
                let combination = Combination::new(question, self, p);
                let interior = order == Ordering::Less && combination.spans_space();
                let witness = combination.witness();
                if interior { Location::Inside(witness) } else { Location::Boundary(witness) }
            }
        }
    }

    fn separation(&self, question: &Displacement<'_, 3>, p: &ExactVector) -> Separation<3> {
        separation(question, p, &self.direction, &self.basis)
    }
}
