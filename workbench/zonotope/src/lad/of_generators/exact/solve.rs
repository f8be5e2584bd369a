//! The exact optimum: where the ray along p leaves Z, as a supporting direction and the face of Z on it.

use std::sync::OnceLock;

use crate::lad::by_pruning;
use crate::lad::of_generators::cells::nested::{NestedCell, NestedCells};
use crate::lad::of_generators::plane::exact_chart::{ChartProblem, ExactChart, Vectors};
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, dot, sum};
use crate::seed::EXACT_STAGE_SEED;
use crate::tally::{Operation, Tally};

/// A cell with at most this many lines is solved exactly; a smaller one that search found within it is not needed.
pub(super) const EXACT_SOLVE_LIMIT: usize = 300;

/// The optimum of min { h(u) : u · p = 1 } with its proof: Σ δ_i v_i = λ p, where δ = `signs` off the basis and in
/// [−1, 1] on it, and λ = `reach` / `along`. The gauge is 1 / λ.
#[derive(Debug, Clone)]
pub(crate) struct ExactOptimum {
    /// A minimiser, scaled: u · p > 0.
    pub(crate) direction: ExactVector,
    /// 1 or −1 for each generator; 0 for the basis and for the zero vector. Listed when they are asked for, where the
    /// sum was known without them.
    signs: OnceLock<Vec<i8>>,
    /// The cells that fix the signs, where these are not listed.
    cells: Option<Box<(NestedCells, DirectionCone)>>,
    /// At most two generators, linearly independent, orthogonal to u.
    pub(crate) basis: Vec<usize>,
    /// Σ sign · v.
    pub(crate) sum: ExactVector,
    /// h(u) = u · `sum`, not negative; zero just when p is off the span of the generators.
    pub(crate) reach: Dyadic,
    /// u · p, positive.
    pub(crate) along: Dyadic,
}

impl ExactOptimum {
    /// The optimum of all generators at once, in coordinates around a direction if one is given. Exact arithmetic for
    /// every generator.
    pub(crate) fn of_whole(
        query: &dyn KernelQuery,
        p: &ExactVector,
        center: Option<[f64; 3]>,
        tally: &mut dyn Tally,
    ) -> Self {
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let none = [Dyadic::zero(), Dyadic::zero(), Dyadic::zero()];
        let plane = ChartProblem::new(Vectors::all(query), &none, ExactChart::new(p.clone(), center));
        let outcome = by_pruning::minimize(&plane.problem, EXACT_STAGE_SEED, &mut &mut *tally);
        let optimum = outcome.optimum().expect("a sum of absolute values is bounded below");
        let direction = plane.direction(optimum.point_in(&plane.problem));
        let basis = optimum.certificate.basis.iter().map(|line| line.position()).collect();
        Self::new(query, p, direction, optimum.certificate.signs.clone(), basis)
    }

    /// Solves the problem of the generators that cross the given cells; `None` where the optimum found is not proved to
    /// be in the cells.
    pub(crate) fn in_cells(
        query: &dyn KernelQuery,
        p: &ExactVector,
        cells: &NestedCells,
        tally: &mut dyn Tally,
    ) -> Option<Self> {
        // of the problems that are small enough for exact arithmetic, the widest has the cell that most likely holds
        // the optimum
        let steps = cells.steps();
        let count =
            steps.iter().position(|step| step.crossing.len() <= EXACT_SOLVE_LIMIT).map_or(steps.len(), |step| step + 1);
        let NestedCell { cell, crossing, .. } = steps[..count].last()?;
        tally.add(Operation::ExactFallback, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let indices = crossing.iter().map(|&index| index as usize).collect();
        let signs = cells.up_to(count).signs(query);
        let optimum = Self::of_some(query, p, indices, signs, cell.coarse_center(), tally)?;
        let is_inside = steps[..count].iter().all(|step| step.cell.contains_exactly(&optimum.direction, p));
        is_inside.then_some(optimum)
    }

    /// The optimum of some generators and the sum of all others with their signs, in coordinates around a direction;
    /// `None` where that problem has none. Exact arithmetic for each of the generators that are some.
    pub(super) fn of_some(
        query: &dyn KernelQuery,
        p: &ExactVector,
        indices: Vec<usize>,
        mut signs: Vec<i8>,
        center: [f64; 3],
        tally: &mut dyn Tally,
    ) -> Option<Self> {
        let rest = query.signed_sum(&signs);
        let chart = ExactChart::new(p.clone(), Some(center));
        let plane = ChartProblem::new(Vectors::some(query, indices.clone()), &rest, chart);
        let outcome = by_pruning::minimize(&plane.problem, EXACT_STAGE_SEED, &mut &mut *tally);
        let optimum = outcome.optimum()?;
        let direction = plane.direction(optimum.point_in(&plane.problem));
        let own = &optimum.certificate.signs;
        for (&index, &sign) in indices.iter().zip(own) {
            signs[index] = sign;
        }
        let total = sum(&rest, &query.signed_sum_of(&mut indices.iter().copied().zip(own.iter().copied())));
        let basis = optimum.certificate.basis.iter().map(|line| indices[line.position()]);
        Some(Self::with_sum(p, direction, signs, basis.collect(), total))
    }

    pub(crate) fn new(
        query: &dyn KernelQuery,
        p: &ExactVector,
        direction: ExactVector,
        signs: Vec<i8>,
        basis: Vec<usize>,
    ) -> Self {
        let sum = query.signed_sum(&signs);
        Self::with_sum(p, direction, signs, basis, sum)
    }

    pub(crate) fn with_sum(
        p: &ExactVector,
        direction: ExactVector,
        signs: Vec<i8>,
        mut basis: Vec<usize>,
        sum: ExactVector,
    ) -> Self {
        basis.sort_unstable();
        let (reach, along) = (dot(&sum, &direction), dot(p, &direction));
        Self { direction, signs: signs.into(), cells: None, basis, sum, reach, along }
    }

    /// The optimum at a vertex of which the sum of all other generators is known, but not the sign of each.
    pub(super) fn with_cells(
        p: &ExactVector,
        direction: ExactVector,
        cells: (NestedCells, DirectionCone),
        basis: Vec<usize>,
        sum: ExactVector,
    ) -> Self {
        Self {
            signs: OnceLock::new(),
            cells: Some(Box::new(cells)),
            ..Self::with_sum(p, direction, vec![], basis, sum)
        }
    }

    /// The same optimum with listed signs of all generators.
    pub(crate) fn with_signs(&self, signs: Vec<i8>) -> Self {
        Self { signs: signs.into(), cells: None, ..self.clone() }
    }

    /// 1 or −1 for each generator; 0 for the basis and for the zero vector. O(n).
    pub(crate) fn signs(&self, query: &dyn KernelQuery) -> &[i8] {
        self.signs.get_or_init(|| {
            let (cells, last) = self.cells.as_deref().expect("signs that are not listed are those of cells");
            signs_in(query, cells, last, &self.basis)
        })
    }

    /// The gauge `along` / `reach` with a bound for its error.
    pub(crate) fn gauge(&self) -> (f64, f64) {
        exact_gauge(&self.along, &self.reach)
    }
}

/// The gauge `along` / `reach` of two numbers that are not negative, with a bound for its error.
pub(crate) fn exact_gauge(along: &Dyadic, reach: &Dyadic) -> (f64, f64) {
    if reach.is_zero() {
        return (f64::INFINITY, 0.0);
    }
    let value = along.rounded_ratio(reach);
    if value < f64::MAX {
        // half a unit in the last place, a little more, and a step where the value is denormal
        (value, value * f64::EPSILON + f64::from_bits(1))
    } else {
        (f64::MAX, f64::INFINITY)
    }
}

/// The signs of all generators at a vertex of which they are certain in doubles; 0 for the basis.
pub(super) fn signs_in(query: &dyn KernelQuery, cells: &NestedCells, last: &DirectionCone, basis: &[usize]) -> Vec<i8> {
    let signs = cells.coefficients(query, last, 1.0);
    let mut signs: Vec<i8> = signs.into_iter().map(|sign| sign as i8).collect();
    for &index in basis {
        signs[index] = 0;
    }
    signs
}
