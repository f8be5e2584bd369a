//! What a body of space under a pose is asked. A moved body keeps its generators: the pose is part of the question, and
//! exact like it.

use crate::collision::by_lad::{locate_posed, nearest_gauge_posed};
use crate::numeric::non_finite::NonFinite;
use crate::zonotope::Zonotope;
use crate::zonotope::location::{Gauge, Location};
use crate::zonotope::pose::Pose;
use crate::zonotope::posed_query::PosedQuery;
use crate::zonotope::prepared::{BodyView, PreparedBody};

/// A body of space where a pose puts it, as [`Zonotope::at`] or [`PreparedBody::at`] makes it: a reference to the body
/// beside the pose, nothing of it copied.
///
/// Bodies with and without a pose are asked about each other: wherever a posed body is expected, `&body` is the body as
/// it stands.
#[derive(Debug, Clone, Copy)]
pub struct PosedZonotope<'a> {
    body: BodyView<'a>,
    pose: Pose,
}

impl Zonotope<3> {
    /// The body where a pose puts it, without a copy of its generators. O(1).
    #[inline]
    pub fn at(&self, pose: &Pose) -> PosedZonotope<'_> {
        PosedZonotope::of(self, pose)
    }
}

impl<'a> From<&'a Zonotope<3>> for PosedZonotope<'a> {
    #[inline]
    fn from(body: &'a Zonotope<3>) -> Self {
        body.at(&Pose::IDENTITY)
    }
}

impl<'a> From<&'a PreparedBody> for PosedZonotope<'a> {
    #[inline]
    fn from(body: &'a PreparedBody) -> Self {
        body.at(&Pose::IDENTITY)
    }
}

impl<'a> PosedZonotope<'a> {
    #[inline]
    pub(super) fn of(body: impl Into<BodyView<'a>>, pose: &Pose) -> Self {
        Self { body: body.into(), pose: *pose }
    }

    /// The body, as it is without the pose.
    pub fn body(&self) -> &'a Zonotope<3> {
        self.body.body()
    }

    /// The pose.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Whether a point lies in the closed posed body, exactly. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn contains(&self, point: [f64; 3]) -> Result<bool, NonFinite> {
        Ok(locate_posed(&PosedQuery::of_point(point, self.body, &self.pose)?).is_member())
    }

    /// Where a point lies relative to the posed body, with a proof in coefficients of the generators as they are
    /// stored, or a direction. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn locate(&self, point: [f64; 3]) -> Result<Location<3>, NonFinite> {
        let query = PosedQuery::of_point(point, self.body, &self.pose)?;
        Ok(locate_posed(&query).with_nearest_basis(&query))
    }

    /// How many times the posed body must be taken, from its centre, to hold a point. O(n) expected.
    ///
    /// # Errors
    /// [`NonFinite`] if a coordinate of the point is NaN or infinite.
    pub fn gauge(&self, point: [f64; 3]) -> Result<Gauge<3>, NonFinite> {
        let query = PosedQuery::of_point(point, self.body, &self.pose)?;
        Ok(nearest_gauge_posed(&query))
    }

    /// Whether two closed bodies have a point in common where their poses put them, exactly. O(n) expected.
    pub fn intersects<'b>(&self, other: impl Into<PosedZonotope<'b>>) -> bool {
        locate_posed(&self.query(&other.into())).is_member()
    }

    /// How two bodies meet where their poses put them, with a proof. O(n) expected.
    #[inline]
    pub fn intersection<'b>(&self, other: impl Into<PosedZonotope<'b>>) -> Location<3> {
        let other = other.into();
        let query = self.query(&other);
        locate_posed(&query).with_nearest_basis(&query)
    }

    #[inline]
    pub(in crate::collision) fn query<'q>(&'q self, other: &'q PosedZonotope<'_>) -> PosedQuery<'q> {
        PosedQuery::between((self.body, &self.pose), (other.body, &other.pose))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::Status;

    #[test]
    fn a_turned_square_prism_meets_its_neighbour_at_the_edge() {
        let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
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
        assert!(std::ptr::eq(diamond.body(), &cube) && diamond.pose() == turned);
    }
}
