//! The optimum of a query: a direction, and the gradients there that prove it.

use super::target::Target;
use crate::lad::LadOutcome;
use crate::lad::by_pruning;
use crate::lad::of_generators::plane::exact_chart::{ChartProblem, ExactChart, Vectors};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, dot, exact, rounded_direction, sum};
use crate::numeric::signed_sum::signed_sum;
use crate::seed::EXACT_STAGE_SEED;
use crate::tally::{Operation, Tally};

/// A direction u that minimises h(u) / u · p, u · p > 0: the sum of the generators with their signs there, and some
/// combination of the basis with coefficients in [−1, 1], is a multiple of p.
#[derive(Debug)]
pub(crate) struct Vertex {
    pub(crate) direction: ExactVector,
    /// Σ sign · v over the generators off the basis.
    pub(crate) sum: ExactVector,
    /// At most two generators, linearly independent, orthogonal to the direction.
    pub(crate) basis: Vec<usize>,
    /// The signs of generators that are orthogonal to the direction; perhaps those of others as well.
    pub(crate) signs: Vec<(usize, i8)>,
}

/// The part of a problem that is solved exactly: some generators, and the sum of all others with their signs.
#[derive(Debug)]
pub(crate) struct Reduced {
    pub(crate) members: Vec<usize>,
    pub(crate) others: ExactVector,
}

impl Reduced {
    /// The optimum, by exact arithmetic for each member; if there is none, a direction along which the reduced function
    /// falls without bound, orthogonal to p. `center` is a direction near the optimum.
    pub(crate) fn solve(
        &self,
        target: &Target<'_>,
        center: &ExactVector,
        tally: &mut dyn Tally,
    ) -> Result<Vertex, ExactVector> {
        tally.add(Operation::ExactFallback, 1);
        tally.add(Operation::PartEvaluation, self.members.len() as u64);
        let chart = ExactChart::new(target.p.clone(), Some(rounded_direction(center)));
        let plane = ChartProblem::new(Vectors::some(&target.query, self.members.clone()), &self.others, chart);
        let optimum = match by_pruning::minimize(&plane.problem, EXACT_STAGE_SEED, &mut &mut *tally) {
            LadOutcome::Optimal(optimum) => optimum,
            LadOutcome::Unbounded { direction: [x, y] } => return Err(plane.direction([x, y, Dyadic::zero()])),
        };
        let own = &optimum.certificate.signs;
        let signs: Vec<(usize, i8)> = self.members.iter().copied().zip(own.iter().copied()).collect();
        let signed = signed_sum(signs.iter().map(|&(index, sign)| (target.query.generator(index), sign)));
        Ok(Vertex {
            direction: plane.direction(optimum.point_in(&plane.problem)),
            sum: sum(&self.others, &signed),
            basis: optimum.certificate.basis.iter().map(|line| self.members[line.position()]).collect(),
            signs,
        })
    }

    /// The optimum at a direction to which all members are orthogonal; if it is not there, a direction in which the
    /// reduced function falls.
    pub(crate) fn solve_at(
        &self,
        direction: ExactVector,
        target: &Target<'_>,
        tally: &mut dyn Tally,
    ) -> Result<Vertex, ExactVector> {
        if let &[first, second] = &self.members[..]
            && self.balances([first, second], target)
        {
            let basis = vec![first.min(second), first.max(second)];
            return Ok(Vertex { direction, sum: self.others.clone(), basis, signs: Vec::new() });
        }
        let vertex = self.solve(target, &direction, tally)?;
        Ok(Vertex { direction, ..vertex })
    }

    /// Whether two members that are not parallel have coefficients in [−1, 1] that make the sum a multiple of p.
    fn balances(&self, pair: [usize; 2], target: &Target<'_>) -> bool {
        let vectors = pair.map(|index| exact(target.query.generator(index)));
        // others + α v + β w = λ p: the product with p × w leaves α
        let is_coefficient = |v: &ExactVector, w: &ExactVector| {
            let across = cross(&target.direction, w);
            let own = dot(v, &across);
            !own.is_zero() && dot(&self.others, &across).abs() <= own.abs()
        };
        let [v, w] = &vectors;
        is_coefficient(v, w) && is_coefficient(w, v)
    }
}
