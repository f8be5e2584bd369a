//! Whether two moving bodies meet, by the convex hulls of what they are at both ends of a stretch.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a number of stretches. Output: the begin of the first stretch at
//! which the hulls meet. They contain the volumes swept by translations, and of rotations neither the bulge of the arcs
//! nor what turns back: none does not say that the bodies do not meet.
//!
//! # Source
//! The rival of Section 6 that planners use: a body cast from one pose to the next.
//!
//! # Method
//! The search of Gilbert, Johnson and Keerthi over the difference of the hulls, in doubles. The farthest point of a
//! hull along a direction is that of one of the two placements.
//!
//! # Complexity
//! O(n) for each step of a search, of which there are few.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1].
//!
//! # Numerics
//! Everything is in doubles; hulls that touch may be told either way.
//!
//! # Checked by
//! Translations, of which it misses nothing.
//!
//! # Example
//! ```
//! use rivals::first_contact::by_hull_of_end_poses::first_meeting_stretch;
//! use zonotope::{Zonotope, motion::Motion};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! assert_eq!(first_meeting_stretch([&cube, &other], [&right, &Motion::rest()], 3), Some(1.0 / 3.0));
//! ```

use zonotope::Pose;
use zonotope::collision::distance::NearestSimplex;
use zonotope::motion::Motion;
use zonotope::zonotope::Zonotope;
use zonotope::zonotope::passes::extreme_sum;

use crate::products::dot;

/// Steps of a search; hulls with a gap take a few, and where there is none the simplex is soon full.
const STEP_LIMIT: usize = 24;

/// The search ends where the nearest point is within this share of the farthest vertex, as squares: the hulls touch to
/// rounding.
const RELATIVE_DISTANCE: f64 = 1e-28;

/// The begin of the first of so many equal stretches on which the hulls of the bodies at both ends meet.
pub fn first_meeting_stretch(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2], stretches: u32) -> Option<f64> {
    let time = |i: u32| f64::from(i) / f64::from(stretches.max(1));
    (0..stretches.max(1)).map(|i| [time(i), time(i + 1)]).find_map(|times| {
        let poses = |i: usize| -> Option<[Pose; 2]> {
            let [from, to] = times.map(|time| motions[i].pose_at(time));
            Some([from?, to?])
        };
        let (p, q) = (poses(0)?, poses(1)?);
        hulls_meet(bodies, [&p, &q]).then_some(times[0])
    })
}

/// Whether no direction is found that separates the hulls.
fn hulls_meet([a, b]: [&Zonotope<3>; 2], [p, q]: [&[Pose; 2]; 2]) -> bool {
    let mut u = [1.0, 0.0, 0.0];
    let mut simplex = NearestSimplex::<3>::new();
    for _ in 0..STEP_LIMIT {
        // the point of the difference of the hulls that is least along u
        let (near, far) = (farthest(b, q, &u.map(|c| -c)), farthest(a, p, &u));
        let point = [0, 1, 2].map(|k| near[k] - far[k]);
        if dot(&u, &point) > 0.0 {
            return false;
        }
        if simplex.has_vertex(&point) {
            return true;
        }
        let Some(nearest) = simplex.add(point) else { return true };
        let square = dot(&nearest, &nearest);
        if simplex.is_full() || square.is_nan() || square <= RELATIVE_DISTANCE * simplex.largest_square() {
            return true;
        }
        u = nearest;
    }
    true
}

/// The point of a body at two poses that is farthest along a direction.
fn farthest(body: &Zonotope<3>, poses: &[Pose; 2], u: &[f64; 3]) -> [f64; 3] {
    let [first, second] = poses.each_ref().map(|pose| {
        let (rows, translation) = (pose.matrix(), pose.translation());
        let own = [0, 1, 2].map(|k| rows[0][k] * u[0] + rows[1][k] * u[1] + rows[2][k] * u[2]);
        let (sum, center) = (extreme_sum(body.generators(), &own), body.center());
        let point = [0, 1, 2].map(|k| center[k] + sum[k]);
        [0, 1, 2].map(|i| dot(&rows[i], &point) + translation[i])
    });
    if dot(&first, u) < dot(&second, u) { second } else { first }
}
