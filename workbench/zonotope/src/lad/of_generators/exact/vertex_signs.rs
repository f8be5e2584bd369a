//! A vertex with the exact signs of all generators at its direction.

use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::exact::solve::{EXACT_SOLVE_LIMIT, ExactOptimum};
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::exact_linear::{ExactVector, cross, dot, is_zero, negated, rounded_direction};
use crate::tally::Tally;

/// The generators of a facet of many directions are solved for if they are at most one in so many, however many that
/// is: generators of whole numbers have a sixth of them in some facets.
const LARGEST_FACET_SHARE: usize = 4;

/// A vertex with the exact signs of all generators at it.
pub(super) struct ExactVertex {
    /// The vertex, scaled: u · p > 0.
    pub(super) direction: ExactVector,
    /// 1 or −1 for each generator; 0 for those of the facet and for the zero vector.
    pub(super) signs: Vec<i8>,
    /// The generators other than zero that are orthogonal to the direction, in increasing order.
    pub(super) facet: Vec<usize>,
}

impl ExactVertex {
    /// The vertex of two generators; `None` where it is not in the cells, or is no vertex.
    pub(super) fn at(query: &dyn KernelQuery, p: &ExactVector, basis: [usize; 2], cells: &NestedCells) -> Option<Self> {
        let [a, b] = basis.map(|index| query.exact_generator(index));
        let product = cross(&a, &b);
        let side = dot(&product, p).sign();
        let direction = if side.is_lt() { negated(product) } else { product };
        let is_within = cells.steps().iter().all(|step| step.cell.contains_exactly(&direction, p));
        if side.is_eq() || !is_within {
            return None;
        }
        let mut signs = cells.signs(query);
        let exact = DirectionSigns::new(query, &direction);
        let mut facet = Vec::new();
        for (index, sign) in signs.iter_mut().enumerate().filter(|(_, sign)| **sign == 0) {
            *sign = exact.sign(index, &direction);
            if *sign == 0 && !is_zero(&query.exact_generator(index)) {
                facet.push(index);
            }
        }
        Some(Self { direction, signs, facet })
    }

    /// The optimum if it is at this vertex, whose facet has more than two directions.
    ///
    /// Which two generators of the facet are the basis, and which signs the others have, is a problem of these
    /// generators alone, whose lines meet in the vertex.
    pub(super) fn optimum_of_facet(
        self,
        query: &dyn KernelQuery,
        p: &ExactVector,
        tally: &mut dyn Tally,
    ) -> Option<ExactOptimum> {
        let Self { direction, signs, facet } = self;
        if facet.len() > EXACT_SOLVE_LIMIT.max(query.len() / LARGEST_FACET_SHARE) {
            return None;
        }
        let optimum = ExactOptimum::of_some(query, p, facet, signs, rounded_direction(&direction), tally)?;
        is_zero(&cross(&optimum.direction, &direction)).then_some(optimum)
    }
}
