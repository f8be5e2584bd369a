//! The facet in which the ray from the centre of a prepared body through a point leaves it: gauge and status at once,
//! the proof on demand.

use std::cmp::Ordering;

use super::vertex::Vertex;
use crate::collision::proof::of_optimum;
use crate::collision::{Gauge, Location, Status};
use crate::lad::of_generators::exact::solve::ExactOptimum;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::numeric::exact_linear::negated;
use crate::zonotope::query::Query;

/// Where the ray from the centre through a point leaves the body.
#[derive(Debug)]
pub struct Facet<'b> {
    query: Query<'b, 3>,
    spans_space: bool,
    /// The optimum, with the signs of only those generators that its direction does not tell; none for the centre.
    optimum: Option<(ExactOptimum, Vec<(usize, i8)>)>,
}

impl<'b> Facet<'b> {
    /// The facet of the centre itself, from which there is no ray.
    pub(crate) fn of_center(query: Query<'b, 3>, spans_space: bool) -> Self {
        Self { query, spans_space, optimum: None }
    }

    /// The facet of an optimum for the query's displacement, or for its opposite.
    pub(crate) fn of_vertex(query: Query<'b, 3>, spans_space: bool, vertex: Vertex, is_opposite: bool) -> Self {
        let Vertex { mut direction, mut sum, basis, mut signs } = vertex;
        if is_opposite {
            (direction, sum) = (negated(direction), negated(sum));
            signs.iter_mut().for_each(|(_, sign)| *sign = -*sign);
        }
        let optimum = ExactOptimum::with_sum(&query.exact(), direction, Vec::new(), basis, sum);
        Self { query, spans_space, optimum: Some((optimum, signs)) }
    }

    /// The gauge within a bound of its error; infinite where no multiple of the body holds the point. O(1).
    pub fn value(&self) -> (f64, f64) {
        self.optimum.as_ref().map_or((0.0, 0.0), |(optimum, _)| optimum.gauge())
    }

    /// The generators, at most two, that span the facet in which the ray leaves the body; at the boundary of several
    /// facets those of one of them. O(1).
    pub fn basis(&self) -> &[usize] {
        self.optimum.as_ref().map_or(&[], |(optimum, _)| &optimum.basis)
    }

    /// Where the point lies, without a proof. O(1).
    pub fn status(&self) -> Status {
        let order = self.optimum.as_ref().map_or(Ordering::Less, |(optimum, _)| optimum.along.cmp(&optimum.reach));
        match order {
            Ordering::Less if self.spans_space => Status::Inside,
            Ordering::Less | Ordering::Equal => Status::Boundary,
            Ordering::Greater => Status::Outside,
        }
    }

    /// Whether the point is in the closed body. O(1).
    pub fn is_member(&self) -> bool {
        self.status().is_member()
    }

    /// Where the point lies, with its proof. O(n).
    pub fn location(&self) -> Location<3> {
        let optimum = self.optimum.as_ref().map_or(Optimum::Center, |(optimum, known)| {
            let mut signs = DirectionSigns::new(&self.query, &optimum.direction).all(&optimum.direction);
            known.iter().for_each(|&(index, sign)| signs[index] = sign);
            optimum.basis.iter().for_each(|&index| signs[index] = 0);
            Optimum::Exact(Box::new(optimum.with_signs(signs)))
        });
        of_optimum::location(&self.query, &optimum, &mut ())
    }

    /// The gauge with where the point lies. O(n).
    pub fn gauge(&self) -> Gauge<3> {
        let (value, error) = self.value();
        Gauge { value, error, location: self.location() }
    }
}
