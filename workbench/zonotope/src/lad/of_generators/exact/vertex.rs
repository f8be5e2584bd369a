//! A vertex that doubles found, as an exact optimum.
//!
//! Where a question is about a point of an edge of the body, the optimum is not unique, and doubles cannot prove any
//! vertex; they find one all the same. Whether it is optimal is seen from the signs of the generators at it, which
//! takes a hundredth of the time of a search in exact arithmetic.

use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::certify::rounded_optimum::RoundedOptimum;
use crate::lad::of_generators::exact::direction_signs::DirectionSigns;
use crate::lad::of_generators::exact::solve::{EXACT_SOLVE_LIMIT, ExactOptimum};
use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::exact_linear::{ExactVector, cross, dot, is_zero, negated, rounded_direction};
use crate::tally::{Operation, Tally};

impl ExactOptimum {
    /// The exact form of an optimum that was proved in doubles.
    pub(crate) fn at_vertex(
        query: &dyn KernelQuery,
        p: &ExactVector,
        vertex: &RoundedOptimum,
        cells: &NestedCells,
    ) -> Self {
        let [a, b] = vertex.basis.map(|index| query.exact_generator(index));
        let direction = if vertex.reversed { cross(&b, &a) } else { cross(&a, &b) };
        let signs = cells.coefficients(query, &vertex.cell(), 1.0);
        let mut signs: Vec<i8> = signs.into_iter().map(|sign| sign as i8).collect();
        for index in vertex.basis {
            signs[index] = 0;
        }
        Self::new(query, p, direction, signs, vertex.basis.to_vec())
    }

    /// A vertex that is probably the optimum, if exact arithmetic proves it.
    ///
    /// Generators beside the basis that are orthogonal to the direction belong to the same face of the body. Which two
    /// of them are the basis, and which signs the others have, is a problem of these generators alone, whose lines meet
    /// in the vertex.
    pub(crate) fn at_likely_vertex(
        query: &dyn KernelQuery,
        p: &ExactVector,
        basis: [usize; 2],
        cells: &NestedCells,
        tally: &mut dyn Tally,
    ) -> Option<Self> {
        let [a, b] = basis.map(|index| query.exact_generator(index));
        let product = cross(&a, &b);
        let side = dot(&product, p).sign();
        let direction = if side.is_lt() { negated(product) } else { product };
        let is_within = cells.steps().iter().all(|(cell, _)| cell.contains_exactly(&direction, p));
        if side.is_eq() || !is_within {
            return None;
        }
        tally.add(Operation::ExactFallback, 1);
        tally.add(Operation::GeneratorRead, query.len() as u64);
        let mut signs = cells.signs(query);
        let exact = DirectionSigns::new(query, &direction);
        let mut facet = Vec::new();
        for (index, sign) in signs.iter_mut().enumerate().filter(|(_, sign)| **sign == 0) {
            *sign = exact.sign(index, &direction);
            if *sign == 0 && !is_zero(&query.exact_generator(index)) {
                facet.push(index);
            }
        }
        if facet.len() > EXACT_SOLVE_LIMIT {
            return None;
        }
        if facet.len() > 2 {
            let center = rounded_direction(&direction);
            let optimum = Self::of_some(query, p, facet, signs, center, tally)?;
            return is_zero(&cross(&optimum.direction, &direction)).then_some(optimum);
        }
        let optimum = Self::new(query, p, direction, signs, basis.to_vec());
        optimum.is_balanced(query, p).then_some(optimum)
    }
}
