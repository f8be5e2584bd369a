//! A pivot: from a vertex that is not the optimum, proved so exactly, along one of its two lines to the best vertex on
//! that line.
//!
//! If the coefficient of a generator a leaves [−1, 1], the objective falls along the line of the other one, b, to
//! one side of the line of a. It falls until the slope, which the crossing of each line raises by a known amount, is
//! no longer negative. The slope at the start is exact but for one rounding, and where lines are crossed is known to
//! about two doubles, so that lines that nearly meet are told apart. The vertex is a guess all the same; the exact
//! check of the next one says whether it is the optimum.

use crate::lad::of_generators::exact::bundle::{Bundle, Share};
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::exact::vertex_signs::ExactVertex;
use crate::lad::of_generators::guess::crossings::CrossingList;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, dot, rounded_direction, sum};
use crate::numeric::linear;

/// The balance of the two bundles a and b of a vertex with the sum g of all other generators: −g · (b × p) and −g · (p
/// × a), each divided by p · (a × b), are their coefficients.
pub(super) struct Balance {
    bundles: [Bundle; 2],
    /// g.
    sum: ExactVector,
    duals: [ExactVector; 2],
    /// The products of g with the duals.
    products: [Dyadic; 2],
    /// Their magnitudes.
    sizes: [Dyadic; 2],
    /// |p · (a × b)|.
    volume: Dyadic,
    /// Whether p · (a × b) is negative.
    is_negative: bool,
}

impl Balance {
    /// The balance of two bundles and the sum of all other generators with their signs.
    pub(super) fn of(bundles: [Bundle; 2], sum: ExactVector, p: &ExactVector) -> Self {
        let [a, b] = bundles.each_ref().map(|bundle| &bundle.total);
        let duals = [cross(b, p), cross(p, a)];
        let volume = dot(a, &duals[0]);
        let products = duals.each_ref().map(|dual| dot(&sum, dual));
        let sizes = products.each_ref().map(|product| product.clone().abs());
        let is_negative = volume.sign().is_lt();
        Self { bundles, sum, duals, products, sizes, volume: volume.abs(), is_negative }
    }

    /// Whether both coefficients are in [−1, 1], so that the vertex is the optimum.
    pub(super) fn is_optimal(&self) -> bool {
        self.sizes.iter().all(|size| *size <= self.volume)
    }

    /// The optimum at a vertex that is optimal: the coefficients of bundles as signs of their members, of which one
    /// each keeps a coefficient between.
    pub(super) fn optimum(self, vertex: ExactVertex, query: &dyn KernelQuery, p: &ExactVector) -> ExactOptimum {
        let ExactVertex { direction, mut signs, facet, .. } = vertex;
        let numerators = self.products.map(|product| if self.is_negative { product } else { -product });
        let [first, second] = [0, 1].map(|k| {
            let share = Share { numerator: &numerators[k], denominator: &self.volume };
            self.bundles[k].distribute(query, &share, &mut signs)
        });
        let own = query.signed_sum_of(&mut facet.iter().map(|&index| (index, signs[index])));
        ExactOptimum::with_sum(p, direction, signs, vec![first, second], sum(&self.sum, &own))
    }

    /// The generators of the best vertex on the line along which the objective falls from a vertex that is not
    /// optimal; `None` where sizes are not moderate. O(n).
    pub(super) fn pivot(&self, vertex: &ExactVertex, query: &dyn KernelQuery) -> Option<[usize; 2]> {
        let leaving = usize::from(self.sizes[1] > self.sizes[0]);
        let [leaves, stays] = [leaving, 1 - leaving].map(|k| &self.bundles[k]);
        let side = if self.products[leaving].sign().is_gt() { -1.0 } else { 1.0 };
        let step = rounded_direction(&self.duals[leaving]).map(|c| side * c);
        let excess = (&self.sizes[leaving] - &self.volume).rounded_ratio(&self.volume);
        let total = leaves.total.each_ref().map(Dyadic::to_f64);
        let fall = linear::dot(&total, &step).abs() * excess;
        let direction = DoubleDoubleDirection::of(&vertex.direction);
        let mut crossings = CrossingList::with_capacity(query.len());
        for (line, v) in query.generators().enumerate() {
            let rate = linear::dot(&v, &step) * f64::from(vertex.signs[line]);
            if rate < 0.0 {
                let distance = direction.moderate_product(&v)?.rounded().value.abs();
                crossings.push(distance / -rate, -rate, line);
            }
        }
        crossings.select(fall / 2.0).map(|crossing| [stays.first(), crossing.line])
    }
}
