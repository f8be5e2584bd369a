//! The least value over all directions of a function that is told from above at single directions and from below on
//! cells of directions.
//!
//! Functions of that kind are differences of support functions, h_A(u) − h_B(u) over unit vectors u: the penetration
//! depth of a point p in a body is the least h(u) − u · p, the Hausdorff distance of bodies one of which holds the
//! other is the largest difference. Neither has to be convex over the sphere, so descent alone proves nothing.
//!
//! | file | what it has |
//! |---|---|
//! | [`cell`] | cells of directions: squares on the sides of a cube |
//! | [`best_first`] | branch and bound over cells |

pub(crate) mod best_first;
pub(crate) mod cell;
