//! The answer in doubles: coefficients, a point of each body, the faces that they lie on.

use std::array;
use std::ops::Range;

use super::nearest_point::{NearestPoint, bodies};
use crate::collision::Witness;
use crate::collision::distance::answer::{Feature, FeatureKind, Gap};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, is_zero, multiple, sum};

/// The gap between two bodies whose centres are `ends`, from the nearest point to their displacement.
pub(super) fn gap(query: &dyn KernelQuery, ends: &[ExactVector; 2], nearest: NearestPoint) -> Gap<3> {
    let [first, second] = bodies(query);
    let [reach, other] = [&first, &second].map(|body| reach(query, &nearest, body));
    let points = [reach.from(&ends[0], 1.0), other.from(&ends[1], -1.0)];
    let features = [first, second].map(|body| feature(query, &nearest.orthogonal, body));
    let mut coefficients: Vec<f64> = nearest.signs.iter().map(|&sign| f64::from(sign)).collect();
    for (index, numerator, denominator) in &nearest.ratios {
        coefficients[*index] = numerator.rounded_ratio(denominator);
    }
    let basis = nearest.ratios.into_iter().map(|(index, _, _)| index).collect();
    let NearestPoint { direction, along, .. } = nearest;
    Gap { direction, along, nearest: Witness { coefficients, basis }, points, features }
}

/// Σ δ_i g_i over the generators of one body, as a vector over a positive number.
struct Reach {
    vector: ExactVector,
    scale: Dyadic,
}

impl Reach {
    /// The point with this vector from a centre, or with its opposite.
    fn from(&self, center: &ExactVector, factor: f64) -> [f64; 3] {
        let vector = multiple(&Dyadic::from_f64(factor), &self.vector);
        let point = sum(&multiple(&self.scale, center), &vector);
        point.map(|c| c.rounded_ratio(&self.scale))
    }
}

fn reach(query: &dyn KernelQuery, nearest: &NearestPoint, body: &Range<usize>) -> Reach {
    let own = |(index, &sign): (usize, &i8)| if body.contains(&index) { sign } else { 0 };
    let signs: Vec<i8> = nearest.signs.iter().enumerate().map(own).collect();
    let whole = Reach { vector: query.signed_sum(&signs), scale: Dyadic::one() };
    let terms = nearest.ratios.iter().filter(|(index, _, _)| body.contains(index));
    terms.fold(whole, |Reach { vector, scale }, (index, numerator, denominator)| {
        let term = multiple(&(numerator * &scale), &query.exact_generator(*index));
        Reach { vector: sum(&multiple(denominator, &vector), &term), scale: &scale * denominator }
    })
}

/// The face of a body that is spanned by those generators that are orthogonal to the direction.
fn feature(query: &dyn KernelQuery, orthogonal: &[usize], body: Range<usize>) -> Feature {
    let own: Vec<usize> = orthogonal.iter().copied().filter(|index| body.contains(index)).collect();
    let vectors: Vec<ExactVector> = own.iter().map(|&index| query.exact_generator(index)).collect();
    let dimension = match vectors.split_first() {
        None => 0,
        Some((first, others)) if others.iter().all(|v| is_zero(&cross(first, v))) => 1,
        Some(_) => 2,
    };
    let generators = own.into_iter().map(|index| index - body.start).collect();
    Feature { kind: FeatureKind::of_dimension(dimension), generators }
}

/// The gap of bodies of R^D from that of the same bodies in space, where all further coordinates are 0.
pub(super) fn lowered<const D: usize>(gap: Gap<3>) -> Gap<D> {
    let Gap { direction, along, nearest, points, features } = gap;
    Gap {
        direction: array::from_fn(|k| direction[k].clone()),
        along,
        nearest,
        points: points.map(|point| array::from_fn(|k| point[k])),
        features,
    }
}
