//! What a prepared body of space is asked: the questions that a [`Zonotope`](crate::zonotope::Zonotope) answers, with
//! the same answers.

use super::of_posed_bodies::PosedZonotope;
use crate::collision::{Query, by_lad};
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::location::{Gauge, Location};
use crate::zonotope::pose::Pose;
use crate::zonotope::prepared::{BodyView, PreparedBody};

impl PreparedBody {
    /// Whether a point lies in the closed body, exactly. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        Ok(by_lad::locate(&Query::of_point_in(point, self)?).is_member())
    }

    /// Where a point lies relative to the body, with a proof. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Location<3>, NonFinite> {
        let query = Query::of_point_in(point, self)?;
        Ok(by_lad::locate(&query).with_nearest_basis(&query))
    }

    /// How many times the body must be taken, from its centre, to hold a point. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<Gauge<3>, NonFinite> {
        let query = Query::of_point_in(point, self)?;
        Ok(by_lad::nearest_gauge(&query))
    }

    /// Whether two closed bodies have a point in common, exactly; the other one may be prepared or not. O(n) expected.
    pub fn intersects<'a>(&'a self, other: impl Into<BodyView<'a>>) -> bool {
        by_lad::locate(&Query::between_bodies(self, other)).is_member()
    }

    /// How two bodies meet, with a proof. O(n) expected.
    pub fn intersection<'a>(&'a self, other: impl Into<BodyView<'a>>) -> Location<3> {
        let query = Query::between_bodies(self, other);
        by_lad::locate(&query).with_nearest_basis(&query)
    }

    /// The body where a pose puts it, without a copy of anything: blocks serve under any pose. O(1).
    #[inline]
    pub fn at(&self, pose: &Pose) -> PosedZonotope<'_> {
        PosedZonotope::of(self, pose)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Status;
    use crate::zonotope::Zonotope;

    #[test]
    fn a_prepared_cube_answers_as_a_cube_does() {
        let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
        let prepared = PreparedBody::new(cube.clone());
        for (factor, status) in [(0.5, Status::Inside), (1.0, Status::Boundary), (1.5, Status::Outside)] {
            let point = [0.25, 0.25, factor];
            assert_eq!(prepared.locate(point).map(|location| location.status()), Ok(status));
            assert_eq!(prepared.contains(point), Ok(factor <= 1.0));
            assert_eq!(prepared.gauge(point), cube.gauge(point));
            let other = cube.translated(point.map(|c| 2.0 * c)).expect("finite");
            assert_eq!(prepared.intersection(&other), cube.intersection(&other));
            assert_eq!(prepared.intersects(&PreparedBody::new(other.clone())), factor <= 1.0);
            let moved = Pose::from_translation(other.center()).expect("finite");
            assert_eq!(prepared.intersects(&other), prepared.at(&moved).intersects(&prepared));
        }
        assert!(prepared.contains([f64::NAN, 0.0, 0.0]).is_err() && prepared.locate([f64::INFINITY; 3]).is_err());
    }
}
