//! Where the ray along p leaves Z, exactly: a supporting direction and the face of Z on it.

use std::cmp::Ordering;

use crate::collision::by_lad::proof::member_from_exact::Combination;
use crate::collision::by_lad::proof::separation::separation;
use crate::collision::{Location, Separation};
use crate::lad::by_pruning;
use crate::lad::of_generators::cells::direction_cone::Cell;
use crate::lad::of_generators::cells::nested::Trail;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::certify::rounded_optimum::Certain;
use crate::lad::of_generators::ladder::is_moderate;
use crate::lad::of_generators::plane::exact_chart::{Plane, PlaneProblem, Vectors};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::signed_sum::signed_sum;
use crate::numeric::vector::{ExactVector, cross, dot, exact, rounded_direction, sum};
use crate::tally::{Operation, Tally};
use crate::zonotope::query::Query;

/// The seed of the kernel: it decides the time, never the answer.
const SEED: u64 = 0x5a;

/// At most this many lines are solved exactly rather than fewer.
const FEW: usize = 300;

/// The optimum of min { h(u) : u · p = 1 } with its proof: Σ δ_i v_i = λ p, where δ = `signs` off the basis and in [−1, 1] on it, and
/// λ = `reach` / `along`. The gauge is 1 / λ.
#[derive(Debug)]
pub(crate) struct Exit {
    /// A minimiser, scaled: u · p > 0.
    pub(crate) direction: ExactVector,
    /// 1 or −1 for each generator; 0 for the basis and for the zero vector.
    pub(crate) signs: Vec<i8>,
    /// At most two generators, linearly independent, orthogonal to u.
    pub(crate) basis: Vec<usize>,
    /// Σ sign · v.
    pub(crate) sum: ExactVector,
    /// h(u) = u · `sum`, not negative; zero just when p is off the span of the generators.
    pub(crate) reach: Dyadic,
    /// u · p, positive.
    pub(crate) along: Dyadic,
}

impl Exit {
    /// Solves the kernel problem of a query whose displacement p is not zero.
    fn find(query: &Query<'_, 3>, p: &ExactVector, tally: &mut impl Tally) -> Self {
        tally.add(Operation::ExactFallback, 1);
        let center = match Self::of_longest(query, p, SEED, tally) {
            Ok(exit) => return exit,
            Err(center) => center,
        };
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let none = [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
        let plane = PlaneProblem::new(Vectors::All(query), &none, Plane::new(p.clone(), center));
        let outcome = by_pruning::minimize_counted(&plane.problem, SEED, tally);
        let optimum = outcome.optimum().expect("a sum of absolute values is bounded below");
        let direction = plane.direction(optimum.homogeneous_point(&plane.problem));
        let basis = optimum.certificate.basis.iter().map(|line| line.position()).collect();
        Self::new(query, p, direction, optimum.certificate.signs.clone(), basis)
    }

    /// The optimum after a search that left a trail.
    pub(crate) fn near(query: &Query<'_, 3>, p: &ExactVector, trail: &Trail, tally: &mut impl Tally) -> Self {
        let elsewhere = match Self::along_trail(query, p, trail, tally) {
            Ok(exit) => return exit,
            Err(elsewhere) => elsewhere,
        };
        // where the minimiser is not unique, another one of the same problem may be outside
        let around = elsewhere.and_then(|cell| {
            let reduced = Reduced::of_query(query, cell, query.len() / 16);
            let is_smaller = is_moderate(&reduced) && 2 * reduced.vectors.len() <= query.len();
            is_smaller.then(|| Trail::new(vec![(cell, reduced.indices)]))
        });
        around
            .and_then(|trail| Self::along_trail(query, p, &trail, tally).ok())
            .unwrap_or_else(|| Self::find(query, p, tally))
    }

    /// Solves the problem of the generators that cross the cells of a trail; a cell around its optimum if that is not proved to be in the cells.
    fn along_trail(
        query: &Query<'_, 3>,
        p: &ExactVector,
        trail: &Trail,
        tally: &mut impl Tally,
    ) -> Result<Self, Option<Cell>> {
        // the widest problem that is still small for exact arithmetic has the surest cell
        let steps = trail.steps();
        let count = steps.iter().position(|(_, crossing)| crossing.len() <= FEW).map_or(steps.len(), |step| step + 1);
        let (cell, indices) = steps[..count].last().ok_or(None)?;
        tally.add(Operation::ExactFallback, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let vectors: Vec<[f64; 3]> = indices.iter().map(|&index| query.generator(index as usize)).collect();
        let mut signs = trail.up_to(count).signs(query);
        let rest = signed_sum(query.generators().copied().zip(signs.iter().copied()));
        let plane = PlaneProblem::new(Vectors::Few(&vectors), &rest, Plane::new(p.clone(), Some(cell.coarse_center())));
        let outcome = by_pruning::minimize_counted(&plane.problem, SEED, tally);
        let optimum = outcome.optimum().ok_or(None)?;
        let direction = plane.direction(optimum.homogeneous_point(&plane.problem));
        let own = &optimum.certificate.signs;
        let is_inside = steps[..count].iter().all(|(cell, _)| cell.contains_exactly(&direction, p));
        if !is_inside {
            return Err(Some(cell.around_other(rounded_direction(&direction))));
        }
        for (&index, &sign) in indices.iter().zip(own) {
            signs[index as usize] = sign;
        }
        let total = sum(&rest, &signed_sum(vectors.iter().copied().zip(own.iter().copied())));
        let basis = optimum.certificate.basis.iter().map(|line| indices[line.position()] as usize);
        Ok(Self::with_sum(p, direction, signs, basis.collect(), total))
    }

    /// An optimum that doubles proved.
    pub(crate) fn of_certain(query: &Query<'_, 3>, p: &ExactVector, certain: &Certain, trail: &Trail) -> Self {
        let [a, b] = certain.vectors.map(exact);
        let direction = if certain.reversed { cross(&b, &a) } else { cross(&a, &b) };
        let signs = trail.coefficients(query, &certain.cell(), 1.0);
        let mut signs: Vec<i8> = signs.into_iter().map(|sign| sign as i8).collect();
        for index in certain.basis {
            signs[index] = 0;
        }
        Self::new(query, p, direction, signs, certain.basis.to_vec())
    }

    pub(crate) fn new(
        query: &Query<'_, 3>,
        p: &ExactVector,
        direction: ExactVector,
        signs: Vec<i8>,
        basis: Vec<usize>,
    ) -> Self {
        let sum = signed_sum(query.generators().copied().zip(signs.iter().copied()));
        Self::with_sum(p, direction, signs, basis, sum)
    }

    fn with_sum(
        p: &ExactVector,
        direction: ExactVector,
        signs: Vec<i8>,
        mut basis: Vec<usize>,
        sum: ExactVector,
    ) -> Self {
        basis.sort_unstable();
        let (reach, along) = (dot(&sum, &direction), dot(p, &direction));
        Self { direction, signs, basis, sum, reach, along }
    }

    /// The gauge `along` / `reach` with a bound for its error.
    pub(crate) fn value(&self) -> (f64, f64) {
        if self.reach.is_zero() {
            return (f64::INFINITY, 0.0);
        }
        let value = self.along.rounded_ratio(&self.reach);
        if value < f64::MAX {
            // half a unit in the last place, a little more, and a step where the value is denormal
            (value, value * f64::EPSILON + f64::from_bits(1))
        } else {
            (f64::MAX, f64::INFINITY)
        }
    }

    /// Where p lies, with its proof.
    pub(crate) fn location(&self, query: &Query<'_, 3>, p: &ExactVector) -> Location<3> {
        match self.along.cmp(&self.reach) {
            Ordering::Greater => Location::Outside(self.separation(query, p)),
            order => {
                let combination = Combination::new(query, self, p);
                let interior = order == Ordering::Less && combination.spans_space();
                let witness = combination.witness();
                if interior { Location::Inside(witness) } else { Location::Boundary(witness) }
            }
        }
    }

    fn separation(&self, query: &Query<'_, 3>, p: &ExactVector) -> Separation<3> {
        separation(query, p, &self.direction, &self.basis)
    }
}
