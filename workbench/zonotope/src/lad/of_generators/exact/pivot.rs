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
use crate::lad::of_generators::guess::crossings::{Crossing, select};
use crate::numeric::double_double::DoubleDoubleDirection;
use crate::numeric::exact_linear::{ExactVector, cross, dot, rounded_direction};
use crate::numeric::linear;

/// The generators of the best vertex on a line through a vertex, if the objective falls along it; `None` where sizes
/// are not moderate, too. O(n).
pub(super) fn pivoted(query: &dyn KernelQuery, p: &ExactVector, vertex: &ExactOptimum) -> Option<[usize; 2]> {
    let [first, second] = vertex.basis[..] else { return None };
    let [a, b] = [first, second].map(|index| query.exact_generator(index));
    let duals = [cross(&b, p), cross(p, &a)];
    let products = duals.each_ref().map(|dual| dot(&vertex.sum, dual));
    let sizes = products.each_ref().map(|product| product.clone().abs());
    let own = dot(&a, &duals[0]).abs();
    let (leaves, stays, place) = if sizes[0] >= sizes[1] { (first, second, 0) } else { (second, first, 1) };
    let excess = &sizes[place] - &own;
    if excess.sign().is_le() {
        return None;
    }
    let side = if products[place].sign().is_gt() { -1.0 } else { 1.0 };
    let step = rounded_direction(&duals[place]).map(|c| side * c);
    let fall = linear::dot(&query.generator(leaves), &step).abs() * excess.rounded_ratio(&own);
    let direction = DoubleDoubleDirection::of(&vertex.direction);
    let mut crossings = Vec::new();
    for (line, v) in query.generators().enumerate() {
        let rate = linear::dot(&v, &step) * f64::from(vertex.signs[line]);
        if rate < 0.0 {
            let distance = direction.moderate_product(&v)?.rounded().value.abs();
            crossings.push(Crossing { position: distance / -rate, weight: -rate, line });
        }
    }
    select(&mut crossings, fall / 2.0).map(|crossing| [stays, crossing.line])
}
