//! A pivot: from a vertex that is not the optimum, proved so exactly, along one of its two lines to the best vertex on
//! that line.
//!
//! Where the coefficient of a generator a leaves [−1, 1], the objective falls along the line of the other one, b, to
//! one side of the line of a. It falls until the slope, which the crossing of each line raises by a known amount, is
//! no longer negative. The slope at the start is exact but for one rounding, and where lines are crossed is known to
//! about two doubles, so that lines that nearly meet are told apart. The vertex is a guess all the same; the exact
//! check of the next one says whether it is the optimum.

use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::generators::KernelQuery;
use crate::lad::of_generators::guess::crossings::CrossingList;
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, dot, rounded_direction};
use crate::numeric::linear;

/// How the two generators a and b of a vertex balance the sum g of all others: −g · (b × p) and −g · (p × a), each
/// divided by p · (a × b), are their coefficients.
pub(super) struct Balance {
    basis: [usize; 2],
    duals: [ExactVector; 2],
    /// The products of g with the duals.
    products: [Dyadic; 2],
    /// Their magnitudes.
    sizes: [Dyadic; 2],
    /// |p · (a × b)|.
    volume: Dyadic,
}

impl Balance {
    /// The balance at a vertex of two generators.
    pub(super) fn at(vertex: &ExactOptimum, query: &dyn KernelQuery, p: &ExactVector) -> Option<Self> {
        let [first, second] = vertex.basis[..] else { return None };
        let [a, b] = [first, second].map(|index| query.exact_generator(index));
        let duals = [cross(&b, p), cross(p, &a)];
        let products = duals.each_ref().map(|dual| dot(&vertex.sum, dual));
        let sizes = products.each_ref().map(|product| product.clone().abs());
        let volume = dot(&a, &duals[0]).abs();
        Some(Self { basis: [first, second], duals, products, sizes, volume })
    }

    /// Whether both coefficients are in [−1, 1], so that the vertex is the optimum.
    pub(super) fn is_optimal(&self) -> bool {
        self.sizes.iter().all(|size| *size <= self.volume)
    }

    /// The generators of the best vertex on the line along which the objective falls from a vertex that is not
    /// optimal; `None` where sizes are not moderate. O(n).
    pub(super) fn pivot(&self, vertex: &ExactOptimum, query: &dyn KernelQuery) -> Option<[usize; 2]> {
        let leaving = usize::from(self.sizes[1] > self.sizes[0]);
        let (leaves, stays) = (self.basis[leaving], self.basis[1 - leaving]);
        let side = if self.products[leaving].sign().is_gt() { -1.0 } else { 1.0 };
        let step = rounded_direction(&self.duals[leaving]).map(|c| side * c);
        let excess = (&self.sizes[leaving] - &self.volume).rounded_ratio(&self.volume);
        let fall = linear::dot(&query.generator(leaves), &step).abs() * excess;
        let direction = DoubleDoubleDirection::of(&vertex.direction);
        let mut crossings = CrossingList::with_capacity(query.len());
        for (line, v) in query.generators().enumerate() {
            let rate = linear::dot(&v, &step) * f64::from(vertex.signs[line]);
            if rate < 0.0 {
                let distance = direction.moderate_product(&v)?.rounded().value.abs();
                crossings.push(distance / -rate, -rate, line);
            }
        }
        crossings.select(fall / 2.0).map(|crossing| [stays, crossing.line])
    }
}
