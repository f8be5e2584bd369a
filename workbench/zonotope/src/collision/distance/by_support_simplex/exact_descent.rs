//! The point of a zonotope nearest to a point outside of it, exactly, from extreme vertex to extreme vertex.
//!
//! A simplex of extreme vertices has a point x nearest to the point b. The extreme vertex in the direction b − x is no
//! farther in that direction than x just when no point of the zonotope is nearer than x. Otherwise it joins the
//! simplex, and the next x is nearer. So no simplex occurs twice; there are finitely many, and the descent ends.

use super::exact_simplex::ExactSimplex;
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, difference, dot, multiple, negated, sum};

/// The direction from the nearest point x to b.
#[derive(Debug)]
pub(super) struct Descended {
    /// u, a positive multiple of b − x.
    pub(super) direction: ExactVector,
    /// u · (b − x).
    pub(super) along: Dyadic,
    /// The sign of u · g for each generator.
    pub(super) signs: Vec<i8>,
    /// How many extreme vertices were looked at.
    pub(super) steps: u64,
}

/// The same where the nearest point to `end` in the plane or on the line that at most two generators span has
/// coefficients in [−1, 1]: then none of them turns away from the direction. `None` elsewhere.
pub(super) fn over_whole_face(generators: &[ExactVector], end: &ExactVector) -> Option<Descended> {
    let direction = match generators {
        [] => end.clone(),
        [v] => {
            let (along, square) = (dot(end, v), dot(v, v));
            let foot = multiple(&along, v);
            (along.abs() <= square && !square.is_zero()).then(|| difference(&multiple(&square, end), &foot))?
        }
        [v, w] => {
            let normal = cross(v, w);
            let square = dot(&normal, &normal);
            let coefficients = [cross(end, w), cross(v, end)].map(|c| dot(&c, &normal).abs());
            let is_inside = !square.is_zero() && coefficients.iter().all(|c| *c <= square);
            let is_ahead = dot(&normal, end).sign().is_gt();
            is_inside.then(|| if is_ahead { normal } else { negated(normal) })?
        }
        _ => return None,
    };
    let along = dot(&direction, end);
    let signs = vec![0; generators.len()];
    along.sign().is_gt().then_some(Descended { direction, along, signs, steps: 1 })
}

/// The direction to a point `end` from the nearest point of the zonotope of some of a query's generators, centred at
/// the origin, which does not hold `end`; `start` is any first direction. O(m) exact operations a step.
pub(super) fn descend(
    query: &dyn KernelQuery,
    indices: &[u32],
    generators: &[ExactVector],
    end: &ExactVector,
    start: &ExactVector,
) -> Descended {
    let mut direction = start.clone();
    let mut simplex: Option<ExactSimplex> = None;
    let mut steps = 0;
    loop {
        steps += 1;
        let table = DirectionSigns::new(query, &direction);
        let signs: Vec<i8> = indices.iter().map(|&index| table.sign(index as usize, &direction)).collect();
        let extreme = generators.iter().zip(&signs).fold(negated(end.clone()), |vertex, (generator, &sign)| {
            if sign < 0 { difference(&vertex, generator) } else { sum(&vertex, generator) }
        });
        match &mut simplex {
            None => simplex = Some(ExactSimplex::of(extreme)),
            Some(simplex) => {
                let level = dot(&direction, simplex.vertex());
                if dot(&direction, &extreme) <= level {
                    return Descended { along: -level, direction, signs, steps };
                }
                simplex.add(extreme);
            }
        }
        let nearest = simplex.as_ref().expect("the first step made a simplex").nearest();
        direction = negated(nearest.clone());
    }
}
