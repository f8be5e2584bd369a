//! The nearest point of a zonotope to a displacement outside of it: a cone of directions, the exact problem of the
//! generators that cross it, and the proof that the cone was wide enough.

use std::ops::Range;

use super::direction_guess;
use super::exact_descent::{Descended, descend, over_whole_face};
use super::face_point::{Share, shares};
use super::fixed_signs::fixed_signs;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, difference, dot, exact, is_zero, multiple, rounded_direction};
use crate::numeric::linear::{euclidean_norm, max_norm};
use crate::tally::{Operation, Tally};

/// By how much a cone is made wider that did not hold the direction.
const WIDENING: f64 = 64.0;

/// The angle of the cone around an answer that was not in the cone which led to it.
const RECHECKED_ANGLE: f64 = 1e-12;

/// The nearest point x to a displacement p.
#[derive(Debug)]
pub(super) struct NearestPoint {
    /// A positive multiple u of p − x.
    pub(super) direction: ExactVector,
    /// u · (p − x).
    pub(super) along: Dyadic,
    /// The coefficient of each generator that is 1 or −1; 0 for those below.
    pub(super) signs: Vec<i8>,
    /// The coefficients that are neither: at most two, of independent generators, in the order of their indices.
    pub(super) ratios: Vec<(usize, Dyadic, Dyadic)>,
    /// The generators that are orthogonal to u and not zero, in increasing order.
    pub(super) orthogonal: Vec<usize>,
}

/// The nearest point to the displacement of a query, which is not in the zonotope; `start` is a direction in which the
/// displacement is beyond it, at least nearly.
///
/// Where the answer for a cone is not in it, that answer may be right all the same: the signs in a narrow cone around
/// it tell. Otherwise the cone was too narrow.
pub(super) fn find(query: &dyn KernelQuery, start: [f64; 3], tally: &mut dyn Tally) -> NearestPoint {
    let p = query.exact();
    let start = if start.iter().all(|c| c.is_finite()) && max_norm(&start) > 0.0 {
        rounded_direction(&exact(start))
    } else {
        rounded_direction(&p)
    };
    let mut cone = direction_guess::cone(query, &p, start, tally);
    loop {
        let around = match nearest_in(query, &p, &cone, tally) {
            Ok(nearest) => return nearest,
            Err(direction) => {
                let center = rounded_direction(&direction);
                DirectionCone { center, axes: None, ball: RECHECKED_ANGLE * euclidean_norm(&center) }
            }
        };
        if let Ok(nearest) = nearest_in(query, &p, &around, tally) {
            return nearest;
        }
        cone.ball *= WIDENING;
    }
}

/// The nearest point, if the direction to it is in a cone; else the direction that is found with the signs that
/// generators have in that cone.
fn nearest_in(
    query: &dyn KernelQuery,
    p: &ExactVector,
    cone: &DirectionCone,
    tally: &mut dyn Tally,
) -> Result<NearestPoint, ExactVector> {
    tally.add(Operation::SearchStep, 1);
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let (mut crossing, mut indices) = (Vec::new(), Places::new());
    query.split(cone, &mut crossing, &mut indices);
    let signs = fixed_signs(query, cone, &indices);
    let end = difference(p, &query.signed_sum(&signs));
    let center = exact(cone.center);
    let generators: Vec<ExactVector> = indices.iter().map(|&index| query.exact_generator(index as usize)).collect();
    let found =
        over_whole_face(&generators, &end).unwrap_or_else(|| descend(query, &indices, &generators, &end, &center));
    tally.add(Operation::ExactFallback, found.steps * indices.len() as u64);
    // scaled such that its product with the centre is that of the centre itself, a direction of the cone is near it
    if indices.len() == query.len() || cone.contains_exactly(&found.direction, &center) {
        Ok(with_face(&indices, generators, signs, &end, found))
    } else {
        Err(found.direction)
    }
}

/// The coefficients of the generators that cross the cone: signs off the face, those of the point in it.
fn with_face(
    crossing: &[u32],
    generators: Vec<ExactVector>,
    mut signs: Vec<i8>,
    end: &ExactVector,
    found: Descended,
) -> NearestPoint {
    let Descended { direction, along, signs: own, .. } = found;
    let (mut face, mut left) = (Vec::new(), end.clone());
    for ((&index, generator), sign) in crossing.iter().zip(generators).zip(own) {
        signs[index as usize] = sign;
        match sign {
            0 => face.push((index as usize, generator)),
            _ => left = difference(&left, &multiple(&Dyadic::from_f64(f64::from(sign)), &generator)),
        }
    }
    // x − Σ ± g over the generators off the face is left − (along / u · u) u
    let square = dot(&direction, &direction);
    let target = difference(&multiple(&square, &left), &multiple(&along, &direction));
    let (members, generators): (Vec<usize>, Vec<ExactVector>) = face.into_iter().unzip();
    let mut ratios = Vec::new();
    for (&index, share) in members.iter().zip(shares(&target, &square, &generators)) {
        match share {
            Share::Whole(sign) => signs[index] = sign,
            Share::Ratio(numerator, denominator) => ratios.push((index, numerator, denominator)),
        }
    }
    let is_spanning = |place: &usize| !is_zero(&generators[*place]);
    let orthogonal = (0..members.len()).filter(is_spanning).map(|place| members[place]).collect();
    NearestPoint { direction, along, signs, ratios, orthogonal }
}

/// The indices of the generators of each body.
pub(super) fn bodies(query: &dyn KernelQuery) -> [Range<usize>; 2] {
    let [first, _] = query.parts();
    let middle = first.rows.len();
    [0..middle, middle..query.len()]
}
