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

use crate::motion::Motion;
use crate::zonotope::Zonotope;

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
