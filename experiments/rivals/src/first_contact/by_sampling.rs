//! Whether two moving bodies meet, by questions at equally spaced times.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a number of steps. Output: the first of the times at which the
//! bodies meet; none where they meet at none of these, which does not say that they do not meet.
//!
//! # Source
//! The rival that Section 6 begins with: a motion looked at once a frame.
//!
//! # Method
//! The bodies are asked as they stand at each time.
//!
//! # Complexity
//! O(n) expected a step.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1].
//!
//! # Numerics
//! Each question is answered exactly for the placements as they are rounded.
//!
//! # Checked by
//! Its contacts are not earlier than the first one by control points.
//!
//! # Example
//! ```
//! use rivals::first_contact::by_sampling::first_sampled_contact;
//! use zonotope::{Zonotope, motion::Motion};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! assert_eq!(first_sampled_contact([&cube, &other], [&right, &Motion::rest()], 4), Some(0.5));
//! ```

use zonotope::motion::Motion;
use zonotope::zonotope::Zonotope;

/// The first of the times 0, 1/`steps`, …, 1 at which the bodies meet. A placement that leaves the range of doubles
/// meets nothing.
pub fn first_sampled_contact(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2], steps: u32) -> Option<f64> {
    let [a, b] = bodies;
    let times = (0..=steps).map(|i| f64::from(i) / f64::from(steps.max(1)));
    times.into_iter().find(|&time| {
        let [p, q] = motions.map(|motion| motion.pose_at(time));
        p.zip(q).is_some_and(|(p, q)| a.at(&p).intersects(b.at(&q)))
    })
}
