//! Questions about a body of space where it stands: under a pose, or prepared. A moved body keeps its generators: the
//! pose is part of the question, and exact like it.

use crate::collision::Located;
use crate::collision::by_lad::{decide, nearly_measured};
use crate::collision::distance::penetration::{Penetration, by_inner_polytope};
use crate::collision::distance::{Proximity, by_support_simplex};
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::location::Gauge;
use crate::zonotope::pose::Standing;
use crate::zonotope::prepared::PreparedBody;
use crate::zonotope::query::{Placed, Query};

impl<'a, P: Standing> Placed<'a, 3, P> {
    /// Whether a point lies in the closed body, exactly. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        Ok(decide(&Query::of_point_in(point, *self)?, &mut ()).is_member())
    }

    /// The location of a point relative to the body, with a proof in coefficients of the generators as they are stored,
    /// or a direction. O(n) expected; the coefficients are written by [`Located::expand`].
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Located<'a, 3, P>, NonFinite> {
        let query = Query::of_point_in(point, *self)?;
        let location = decide(&query, &mut ());
        Ok(Located::new(query, location))
    }

    /// The gauge of a point: how many times the body must be taken, from its centre, to hold it; with the location of
    /// the point. O(n) expected; the coefficients are written by [`Gauge::expand`].
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<Gauge<3, Located<'a, 3, P>>, NonFinite> {
        let query = Query::of_point_in(point, *self)?;
        let gauge = nearly_measured(&query, &mut ()).expect("the kernel answers in space");
        Ok(gauge.map(|location| Located::new(query, location)))
    }

    /// Whether two closed bodies have a point in common where they stand, exactly. O(n) expected.
    pub fn intersects<'b>(&self, other: impl Into<Placed<'b, 3, P>>) -> bool {
        decide(&self.query(other.into()), &mut ()).is_member()
    }

    /// The location of two bodies relative to each other where they stand, with a proof. O(n) expected.
    pub fn intersection<'q>(&self, other: impl Into<Placed<'q, 3, P>>) -> Located<'q, 3, P>
    where
        'a: 'q,
    {
        let query = self.query(other.into());
        let location = decide(&query, &mut ());
        Located::new(query, location)
    }

    /// The Euclidean distance of two closed bodies where they stand, 0 where they meet; within two units in the last
    /// place. Expected O(n), mostly in doubles and pairs of them; the points, faces and coefficients that prove it are
    /// those of [`proximity`](Self::proximity).
    pub fn distance<'b>(&self, other: impl Into<Placed<'b, 3, P>>) -> f64 {
        by_support_simplex::distance(&self.query(other.into()), &mut ())
    }

    /// Proximity of two closed bodies where they stand, exactly for the poses as they are given. Expected O(n) for each
    /// of a few steps.
    pub fn proximity<'b>(&self, other: impl Into<Placed<'b, 3, P>>) -> Proximity<3> {
        let query = self.query(other.into());
        by_support_simplex::proximity(&query, &mut ()).with_nearest_basis(&query)
    }

    /// Depth to which two bodies overlap where they stand, within a hundredth. O(n) for each of some ten to some
    /// hundred vertices.
    pub fn penetration<'b>(&self, other: impl Into<Placed<'b, 3, P>>) -> Penetration<3> {
        by_inner_polytope::penetration(&self.query(other.into()), &mut ())
    }

    fn query<'q>(&self, other: Placed<'q, 3, P>) -> Query<'q, 3, P>
    where
        'a: 'q,
    {
        Query::of_placed(*self, other)
    }
}

impl PreparedBody {
    /// Whether a point lies in the closed body, exactly. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        self.placed().contains(point)
    }

    /// The location of a point relative to the body, with a proof. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Located<'_, 3>, NonFinite> {
        self.placed().locate(point)
    }

    /// The gauge of a point: how many times the body must be taken, from its centre, to hold it; with the location of
    /// the point. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<Gauge<3, Located<'_, 3>>, NonFinite> {
        self.placed().gauge(point)
    }

    /// Whether two closed bodies have a point in common, exactly; the other one may be prepared or not. O(n) expected.
    pub fn intersects<'b>(&self, other: impl Into<Placed<'b>>) -> bool {
        self.placed().intersects(other)
    }

    /// The location of two bodies relative to each other, with a proof. O(n) expected.
    pub fn intersection<'q>(&'q self, other: impl Into<Placed<'q>>) -> Located<'q, 3> {
        self.placed().intersection(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Status;
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;

    fn cube() -> Zonotope<3> {
        Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite")
    }

    #[test]
    fn a_turned_square_prism_meets_its_neighbour_at_the_edge() {
        let cube = cube();
        // (x, y) to (x − y, x + y): the square [−1, 1]² becomes the diamond |x| + |y| ≤ 2
        let turned = Pose::new([[1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]).expect("finite");
        let diamond = cube.at(&turned);
        assert_eq!(diamond.contains([1.5, 0.5, 0.0]), Ok(true));
        assert_eq!(diamond.contains([1.5, 0.75, 0.0]), Ok(false));
        assert_eq!(diamond.locate([2.0, 0.0, 0.0]).map(|location| location.status()), Ok(Status::Boundary));
        let gauge = diamond.gauge([3.0, 1.0, 0.0]).expect("finite");
        assert!((gauge.value - 2.0).abs() <= gauge.error);
        assert!(diamond.contains([0.0, f64::NAN, 0.0]).is_err());
        for (x, status) in [(2.5, Status::Inside), (3.0, Status::Boundary), (3.0f64.next_up(), Status::Outside)] {
            let neighbour = cube.translated([x, 0.0, 0.0]).expect("finite");
            let moved = Pose::from_translation([x, 0.0, 0.0]).expect("finite");
            assert_eq!(diamond.intersection(&neighbour).status(), status);
            assert_eq!(diamond.intersection(cube.at(&moved)).status(), status);
            assert_eq!(diamond.intersects(&neighbour), status != Status::Outside);
        }
        assert!(std::ptr::eq(diamond.generators(), cube.generators()) && *diamond.standing() == turned);
    }

    #[test]
    fn a_prepared_cube_answers_as_a_cube_does() {
        let cube = cube();
        let prepared = PreparedBody::new(cube.clone());
        for (factor, status) in [(0.5, Status::Inside), (1.0, Status::Boundary), (1.5, Status::Outside)] {
            let point = [0.25, 0.25, factor];
            assert_eq!(prepared.locate(point).map(|location| location.status()), Ok(status));
            assert_eq!(prepared.contains(point), Ok(factor <= 1.0));
            let [of_prepared, own] =
                [prepared.gauge(point), cube.gauge(point)].map(|gauge| gauge.map(|gauge| gauge.expand()));
            assert_eq!(of_prepared, own);
            let other = cube.translated(point.map(|c| 2.0 * c)).expect("finite");
            assert_eq!(prepared.intersection(&other).expand(), cube.intersection(&other).expand());
            assert_eq!(prepared.intersects(&PreparedBody::new(other.clone())), factor <= 1.0);
            let moved = Pose::from_translation(other.center()).expect("finite");
            assert_eq!(prepared.intersects(&other), prepared.at(&moved).intersects(&prepared));
        }
        assert!(prepared.contains([f64::NAN, 0.0, 0.0]).is_err() && prepared.locate([f64::INFINITY; 3]).is_err());
    }
}
