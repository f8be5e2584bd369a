//! A body of space that is prepared for a number of queries: the structure that costs least for so many, behind the
//! methods of a body.
//!
//! Answers are those of the body itself. The structure ([`choice`](crate::collision::prepared::choice)) serves
//! membership; a tree serves locations and gauges of points as well. A proof in coefficients, and how two bodies meet,
//! take a pass over the generators in any case.

use super::located::Located;
use crate::collision::prepared::QueryStructure;
use crate::collision::prepared::choice::Kind;
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::Zonotope;
use crate::zonotope::location::{Coefficients, Gauge};
use crate::zonotope::query::{Placed, Query};

/// The most bytes that a structure may hold. A body that takes more itself stays as it is.
const BYTES_LIMIT: u64 = 1 << 34;

/// A body of space with the structure that suits a number of queries, as [`Zonotope::prepared_for`] makes it.
#[derive(Debug)]
pub struct PreparedFor {
    body: Zonotope<3>,
    structure: QueryStructure,
}

impl Zonotope<3> {
    /// The body, prepared for about so many queries in the structure that costs least.
    ///
    /// ```
    /// use zonotope::Zonotope;
    /// // the cube [−1, 1]³, whose three pairs of facets answer a million questions
    /// let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
    /// let prepared = cube.prepared_for(1_000_000);
    /// assert!(prepared.contains([1.0, 0.5, 0.0])? && !prepared.contains([1.0f64.next_up(), 0.5, 0.0])?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn prepared_for(&self, queries: u64) -> PreparedFor {
        let structure = QueryStructure::new(self.clone(), BYTES_LIMIT, queries);
        PreparedFor::with(self, structure.or_else(|_| QueryStructure::of_kind(self.clone(), Kind::Rows)))
    }
}

impl PreparedFor {
    fn with<E: std::fmt::Debug>(body: &Zonotope<3>, structure: Result<QueryStructure, E>) -> Self {
        Self { body: body.clone(), structure: structure.expect("every body may stay as it is") }
    }

    /// The structure that was chosen.
    pub fn structure(&self) -> &QueryStructure {
        &self.structure
    }

    /// Whether a point lies in the closed body, exactly.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        self.structure.contains(point)
    }

    /// The location of a point, with a proof in coefficients of the body's generators, or a separating direction. The
    /// proof of a tree's answer is written at once.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Located<'_, 3>, NonFinite> {
        let body = Placed::from(self);
        let Some(tree) = self.structure.tree() else { return body.locate(point) };
        let location = tree.locate(point, &mut ())?.expand();
        Ok(Located::new(Query::of_point_in(point, body)?, location.map(Coefficients::from)))
    }

    /// The gauge of a point: how many times the body must be taken, from its centre, to hold it; with the location of
    /// the point. The proof of a tree's answer is written at once.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<Gauge<3, Located<'_, 3>>, NonFinite> {
        let body = Placed::from(self);
        let Some(tree) = self.structure.tree() else { return body.gauge(point) };
        let measured = tree.gauge(point, &mut ())?;
        let (value, error) = measured.nearest_value();
        let location = measured.location.expand().map(Coefficients::from);
        Ok(Gauge { value, error, location: Located::new(Query::of_point_in(point, body)?, location) })
    }

    /// Whether two closed bodies have a point in common, exactly; the other one may be prepared or not.
    pub fn intersects<'b>(&self, other: impl Into<Placed<'b>>) -> bool {
        Placed::from(self).intersects(other)
    }

    /// The location of two bodies relative to each other, with a proof.
    pub fn intersection<'q>(&'q self, other: impl Into<Placed<'q>>) -> Located<'q, 3> {
        Placed::from(self).intersection(other)
    }
}

impl<'a> From<&'a PreparedFor> for Placed<'a> {
    fn from(prepared: &'a PreparedFor) -> Self {
        prepared.structure.blocks().map_or_else(|| (&prepared.body).into(), Self::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Status;
    use crate::interop::verifier::check_location;

    const KINDS: [Kind; 4] = [Kind::Rows, Kind::Blocks, Kind::DirectionTree, Kind::Facets];

    fn body(n: u32) -> Zonotope<3> {
        let number = |i: u32, of: u32| f64::from(i * i % of) / f64::from(of) - 0.4;
        let generators = (1..=n).map(|i| [number(i, 101), number(i, 83), number(i, 61)]);
        Zonotope::new([0.5, 0.0, -1.0], generators.collect()).expect("finite")
    }

    #[test]
    fn every_structure_answers_as_the_body_does() {
        for (n, kind) in [0u32, 2, 7, 40].into_iter().flat_map(|n| KINDS.map(|kind| (n, kind))) {
            let body = body(n);
            let prepared = PreparedFor::with(&body, QueryStructure::of_kind(body.clone(), kind));
            assert_eq!(prepared.structure().which(), kind);
            for i in 0..24u32 {
                let u = [i % 5, i % 7, i % 3].map(|c| f64::from(c) - 1.5);
                let (vertex, center) = (body.support(u).point(), body.center());
                let factor = [1.0, 0.5, 1.0 - 1e-12, 2.0][i as usize % 4];
                let point = [0, 1, 2].map(|k| center[k] + factor * (vertex[k] - center[k]));
                let truth = body.gauge(point).expect("finite");
                let status = truth.location.status();
                assert_eq!(prepared.contains(point), Ok(status != Status::Outside), "{kind:?}");
                let gauge = prepared.gauge(point).expect("finite");
                let is_near =
                    gauge.value == truth.value || (gauge.value - truth.value).abs() <= gauge.error + truth.error;
                assert!(is_near, "{kind:?}: {} {}", gauge.value, truth.value);
                for location in [prepared.locate(point).expect("finite"), gauge.location] {
                    assert_eq!(location.status(), status, "{kind:?}");
                    let query = Query::of_point(point, &body).expect("finite");
                    assert_eq!(check_location(&query, &location.expand()).proof().map(drop), Ok(()));
                }
                let other = body.translated(point).expect("finite");
                assert_eq!(prepared.intersection(&other).expand(), body.intersection(&other).expand());
                assert_eq!(prepared.intersects(&other), body.intersects(&other));
            }
            assert!(prepared.gauge([f64::NAN; 3]).is_err() && prepared.contains([f64::INFINITY; 3]).is_err());
            assert!(prepared.intersects(&prepared));
        }
    }

    #[test]
    fn more_queries_are_worth_more_preparation() {
        let chosen = |n, queries| body(n).prepared_for(queries).structure().which();
        assert_eq!(chosen(100, 1), Kind::Rows);
        assert_eq!(chosen(100, 200), Kind::Blocks);
        assert_eq!(chosen(4096, 1_000), Kind::DirectionTree);
        assert_eq!(chosen(6, 1_000_000), Kind::Facets);
    }
}
