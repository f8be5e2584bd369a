//! Questions about a body: methods of [`Zonotope`] that put the question to the kernel, above four dimensions to brute
//! force.
//!
//! They hold no geometry of their own. A caller who wants another method, or operation counts, makes the [`Query`]
//! himself and hands it to a [`Method`].

use crate::collision::{Located, Method, Query, by_lad};
use crate::numeric::non_finite::NonFinite;
use crate::seed::DEFAULT_SEED;
use crate::zonotope::Zonotope;
use crate::zonotope::location::{Coefficients, Gauge, Location};

impl<const D: usize> Zonotope<D> {
    /// Whether a point lies in the closed body, exactly. O(n) expected in up to four dimensions, O(n^D) in rationals
    /// above.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; D]) -> Result<bool, NonFinite> {
        Ok(located(&Query::of_point(point, self)?).is_member())
    }

    /// The location of a point relative to the body, with a proof: coefficients of the generators, or a separating
    /// direction. The cost is that of [`contains`](Self::contains); the coefficients are written by
    /// [`Located::expand`].
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; D]) -> Result<Located<'_, D>, NonFinite> {
        let query = Query::of_point(point, self)?;
        let location = located(&query);
        Ok(Located::new(query, location))
    }

    /// The gauge of a point: how many times the body must be taken, from its centre, to hold it, within four units in
    /// the last place; with the location of the point, whose coefficients are written by [`Gauge::expand`]. The cost is
    /// that of [`locate`](Self::locate), and a pass or two over the generators for the last digits.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; D]) -> Result<Gauge<D, Located<'_, D>>, NonFinite> {
        let query = Query::of_point(point, self)?;
        let gauge = by_lad::nearly_measured(&query, &mut ()).unwrap_or_else(|| {
            let gauge = Method::BruteForce.gauge(&query, &mut ()).expect("brute force measures every displacement");
            gauge.map(|location| location.map(Coefficients::from))
        });
        Ok(gauge.map(|location| Located::new(query, location)))
    }

    /// Whether two closed bodies have a point in common, exactly; bodies that touch do. The cost is that of
    /// [`contains`](Self::contains) with the generators of both.
    pub fn intersects(&self, other: &Self) -> bool {
        located(&Query::between(self, other)).is_member()
    }

    /// The location of two bodies relative to each other, with a proof: inside if their interiors have a point in
    /// common, boundary if they only touch (or their sum is flat), outside if they are disjoint. It locates the
    /// difference of the centres relative to the generators of both (Lemma 5.1).
    pub fn intersection<'q>(&'q self, other: &'q Self) -> Located<'q, D> {
        let query = Query::between(self, other);
        let location = located(&query);
        Located::new(query, location)
    }
}

#[inline]
fn located<const D: usize>(query: &Query<'_, D>) -> Location<D, Coefficients> {
    by_lad::located(query, &mut ()).unwrap_or_else(|| {
        let location = Method::BruteForce.locate(query, DEFAULT_SEED, &mut ());
        location.ok().flatten().expect("brute force locates every displacement").map(Coefficients::from)
    })
}
