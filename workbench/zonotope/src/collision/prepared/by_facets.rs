//! Repeated queries, by all facets: one product with the point for each pair of generators.
//!
//! # Statement
//! Input: a body Z of space. Output: a structure that answers for any point how many times Z must be taken to hold it,
//! and whether it is in the interior, on the boundary or outside, exactly. Z is closed: touching is
//! [`Status::Boundary`], and so is every member of a flat Z. Zero, parallel and coplanar generators and none at all are
//! ordinary input.
//!
//! # Source
//! The other end of Lemma 5.3's trade-off, m = n²: the facets are the vertices of the dual arrangement. A logarithmic
//! query would locate the point among them; here each of them is looked at, which is quicker where they are few.
//!
//! # Method
//! 1. For each pair of generators take the normal u = v × w and its reach h(u), exactly, and keep u / h(u), rounded: a
//!    vertex of the polar body. Those of coplanar generators are kept once.
//! 2. The gauge of a displacement p is the largest |u · p| / h(u): one pass in doubles, with a bound on its error.
//! 3. Where that leaves a doubt of the status, or of more of the gauge than 2^-36, where Z is flat, or the lengths of
//!    the polar body's vertices are beyond 2^±200, the kernel answers.
//!
//! # Complexity
//! n generators: O(n³) exact operations to build, 24 bytes for each of at most n (n − 1) / 2 pairs, O(n²) a query.
//!
//! # Shapes
//! `body`: any order, duplicates allowed.
//!
//! # Numerics
//! Every decision is exact. The gauge is within its error, at most 2^-36 of it.
//!
//! # Errors
//! [`NonFinite`] if a coordinate of a point is NaN or infinite.
//!
//! # Checked by
//! The kernel and the rational twin, on all families.
//!
//! # Example
//! ```
//! use zonotope::{Status, Zonotope, collision::prepared::PreparedByFacets};
//! // the cube [−1, 1]³ has three pairs of facets
//! let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let cube = PreparedByFacets::new(Zonotope::new([0.0; 3], axes).unwrap());
//! assert_eq!((cube.facet_count(), cube.gauge([2.0, 0.5, -1.0]).map(|gauge| gauge.0)), (3, Ok(2.0)));
//! assert_eq!(cube.status([1.0, 0.0, 0.5]), Ok(Status::Boundary));
//! ```

use crate::collision::{Query, Status, by_lad};
use crate::numeric::bounded::difference;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{cross, dot as exact_dot, exact, is_zero};
use crate::numeric::linear::{dot, max_norm, sum_norm};
use crate::numeric::non_finite::NonFinite;
use crate::numeric::tolerance::{GAUGE_ACCURACY, MODERATE_SIZES, PRODUCT_OF_ROUNDED_VECTORS, PRODUCT_UNDERFLOW};
use crate::zonotope::Zonotope;

/// A body of space with its facets, for many queries.
#[derive(Debug, Clone)]
pub struct PreparedByFacets {
    body: Zonotope<3>,
    /// u / h(u) for a normal u of each pair of opposite facets; none where the kernel answers.
    polar: Vec<[f64; 3]>,
    /// The largest |·|_1 of them.
    longest: f64,
}

impl PreparedByFacets {
    /// Lists the facets of a body. O(n³).
    pub fn new(body: Zonotope<3>) -> Self {
        let polar = polar_vertices(body.generators());
        let longest = polar.iter().map(sum_norm).fold(0.0, f64::max);
        let is_moderate = polar.iter().all(|w| MODERATE_SIZES.contains(&sum_norm(w)));
        Self { body, polar: if is_moderate { polar } else { Vec::new() }, longest }
    }

    /// The body.
    pub fn body(&self) -> &Zonotope<3> {
        &self.body
    }

    /// How many pairs of opposite facets are listed: none of a flat body, or of one of extreme size.
    pub fn facet_count(&self) -> usize {
        self.polar.len()
    }

    /// The bytes that are held, the generators included.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(self.body.generators()) + size_of_val(&self.polar[..])
    }

    /// Where a point lies, exactly.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn status(&self, point: [f64; 3]) -> Result<Status, NonFinite> {
        let query = Query::of_point(point, &self.body)?;
        let (value, error) = self.estimate(&query);
        Ok(if value - error > 1.0 {
            Status::Outside
        } else if value + error < 1.0 {
            Status::Inside
        } else {
            by_lad::decide(&query, &mut ()).status()
        })
    }

    /// How many times the body must be taken, from its centre, to hold a point, and a bound on the error of that.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<(f64, f64), NonFinite> {
        let query = Query::of_point(point, &self.body)?;
        let (value, error) = self.estimate(&query);
        let is_known = error <= GAUGE_ACCURACY * value;
        Ok(if is_known { (value, error) } else { by_lad::facet(&query, &mut ()).value() })
    }

    /// The gauge by a pass over the facets, with a bound on its error, which is infinite where there are none.
    fn estimate(&self, query: &Query<'_, 3>) -> (f64, f64) {
        let p = difference(query.from(), query.to()).map(|c| c.value);
        let size = max_norm(&p);
        if self.polar.is_empty() || !(MODERATE_SIZES.contains(&size) || size == 0.0) {
            return (0.0, f64::INFINITY);
        }
        let value = self.polar.iter().fold(0.0f64, |largest, w| largest.max(dot(w, &p).abs()));
        (value, PRODUCT_OF_ROUNDED_VECTORS * self.longest * size + PRODUCT_UNDERFLOW)
    }
}

/// u / h(u) for the normals u of all facets, but for opposite ones, rounded once in each coordinate; none of a flat
/// body.
fn polar_vertices(generators: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let generators: Vec<[Dyadic; 3]> = generators.iter().map(|v| exact(*v)).collect();
    let mut polar = Vec::new();
    for (i, v) in generators.iter().enumerate() {
        for w in &generators[i + 1..] {
            let normal = cross(v, w);
            if is_zero(&normal) {
                continue;
            }
            let reach = generators.iter().fold(Dyadic::zero(), |sum, g| sum + exact_dot(&normal, g).abs());
            if reach.is_zero() {
                return Vec::new();
            }
            let turned =
                if normal.iter().find(|c| !c.is_zero()).is_some_and(|c| c.sign().is_lt()) { -1.0 } else { 1.0 };
            // without −0, so that equal vectors are of equal bits
            polar.push(normal.each_ref().map(|c| turned * c.rounded_ratio(&reach) + 0.0));
        }
    }
    let bits = |w: &[f64; 3]| w.map(f64::to_bits);
    polar.sort_unstable_by_key(bits);
    polar.dedup_by_key(|w| bits(w));
    polar
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            6 => (-3..=3i32).prop_map(f64::from),
            3 => -1.0..1.0f64,
            1 => (-3..=3i32).prop_map(|c| f64::from(c) * f64::from_bits(1)),
            1 => (-3..=3i32).prop_map(|c| f64::from(c) * 1e300),
        ]
    }

    properties! {
        #![proptest_config(crate::property_cases::config(256))]

        #[test]
        fn answers_are_the_truth(
            rows in proptest::collection::vec(proptest::array::uniform3(number()), 0..7),
            point in proptest::array::uniform3(number()),
            center in proptest::array::uniform3(number()),
        ) {
            let body = Zonotope::new(center, rows).expect("finite");
            let prepared = PreparedByFacets::new(body.clone());
            let vertex = body.support(point).point();
            for end in [point, vertex, center] {
                prop_assume!(end.iter().all(|c| c.is_finite()));
                let truth = brute_force::gauge(&Query::of_point(end, &body).expect("finite"));
                prop_assert_eq!(prepared.status(end), Ok(truth.location.status()));
                let (value, error) = prepared.gauge(end).expect("finite");
                prop_assert!(value == truth.value || (value - truth.value).abs() <= error + truth.error);
            }
        }
    }

    #[test]
    fn coplanar_generators_have_one_facet() {
        let rows = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let prism = PreparedByFacets::new(Zonotope::new([0.0; 3], rows.clone()).expect("finite"));
        assert_eq!(prism.facet_count(), 4);
        assert_eq!(prism.gauge([2.0, 0.0, 0.0]), prism.gauge([0.0, -2.0, 0.0]));
        let flat = PreparedByFacets::new(Zonotope::new([0.0; 3], rows[..3].to_vec()).expect("finite"));
        assert_eq!((flat.facet_count(), flat.status([0.5, 0.5, 0.0])), (0, Ok(Status::Boundary)));
        assert!(
            flat.bytes() < prism.bytes() && prism.status([f64::NAN; 3]).is_err() && flat.body().center() == [0.0; 3]
        );
    }
}
