//! [`Zonotope<3>`] as a shape of parry3d (the build in doubles): every algorithm of that library that takes a support
//! map takes a zonotope, GJK, EPA, ray and shape casts among them. Nothing is converted: n generators stand for a
//! polyhedron of up to n (n − 1) + 2 vertices.
//!
//! Those algorithms work in rounded arithmetic with tolerances of their own. Where a decision must be right, near
//! contact above all, ask [`collision`](crate::collision).
//!
//! ```
//! use parry3d_f64::math::{Pose, Vector};
//! use parry3d_f64::query::details::intersection_test_support_map_support_map;
//! use parry3d_f64::shape::Ball;
//! use zonotope::zonotope::Zonotope;
//!
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
//! let meets = |x| {
//!     let pose = Pose::from_translation(Vector::new(x, 0.0, 0.0));
//!     intersection_test_support_map_support_map(&pose, &cube, &Ball::new(0.5))
//! };
//! assert!(meets(1.25) && !meets(1.75));
//! # Ok::<(), zonotope::zonotope::ZonotopeError>(())
//! ```

use parry3d_f64::math::Vector;
use parry3d_f64::shape::SupportMap;

use crate::zonotope::{PreparedBody, Zonotope, passes};

impl SupportMap for PreparedBody {
    /// As for the body itself, from generators that are laid out for it: for bodies that are asked often.
    fn local_support_point(&self, direction: Vector) -> Vector {
        let [x, y, z] = self.extreme_sum(&direction.to_array());
        Vector::from_array(self.body().center()) + Vector::new(x, y, z)
    }
}

impl SupportMap for Zonotope<3> {
    /// A vertex that is extreme in the direction, in one vectorised pass over the generators; rounded as
    /// [`passes::extreme_sum`] says.
    fn local_support_point(&self, direction: Vector) -> Vector {
        let [x, y, z] = passes::extreme_sum(self.generators(), &direction.to_array());
        Vector::from_array(self.center()) + Vector::new(x, y, z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use parry3d_f64::math::Pose;
    use parry3d_f64::query::details::{contact_support_map_support_map, intersection_test_support_map_support_map};
    use parry3d_f64::shape::Cuboid;
    use proptest::prelude::*;

    fn box_of(center: [f64; 3], sides: [f64; 3]) -> Zonotope<3> {
        let axis = |i: usize| std::array::from_fn(|k| if i == k { sides[i] } else { 0.0 });
        Zonotope::new(center, (0..3).map(axis).collect()).expect("finite")
    }

    #[test]
    fn two_cubes_meet_up_to_a_distance_of_two() {
        let (a, b) = (box_of([0.0; 3], [1.0; 3]), box_of([0.0; 3], [1.0; 3]));
        for (distance, meet) in [(0.5, true), (1.99, true), (2.01, false), (9.0, false)] {
            let pose = Pose::from_translation(Vector::new(distance, 0.3, 0.2));
            assert_eq!(intersection_test_support_map_support_map(&pose, &a, &b), meet, "{distance}");
        }
    }

    #[test]
    fn a_contact_has_the_depth_of_the_overlap() {
        let (a, b) = (box_of([0.0; 3], [1.0, 2.0, 3.0]), Cuboid::new(Vector::new(1.0, 1.0, 1.0)));
        let pose = Pose::from_translation(Vector::new(1.75, 0.1, -0.2));
        let contact = contact_support_map_support_map(&pose, &a, &b, 0.0).expect("they overlap by a quarter");
        assert!((contact.dist + 0.25).abs() < 1e-9, "{}", contact.dist);
    }

    properties! {
        #[test]
        fn the_support_point_is_extreme(
            generators in proptest::collection::vec([-9i8..10, -9i8..10, -9i8..10], 0..20),
            center in [-9i8..10, -9i8..10, -9i8..10],
            direction in [-9i8..10, -9i8..10, -9i8..10],
        ) {
            let generators = generators.into_iter().map(|g| g.map(f64::from)).collect();
            let (center, direction) = (center.map(f64::from), direction.map(f64::from));
            let body = Zonotope::new(center, generators).expect("finite");
            let direction_of_parry = Vector::from_array(direction);
            let point = body.local_support_point(direction_of_parry);
            prop_assert_eq!(PreparedBody::new(body.clone()).local_support_point(direction_of_parry), point);
            prop_assert_eq!(point.dot(direction_of_parry), body.support(direction).value());
        }
    }
}
