//! Problem: whether two moving bodies meet, by methods that prove nothing: they are here to show what they miss.
//!
//! | file | what it asks |
//! |---|---|
//! | [`by_sampling`] | whether the bodies meet at some equally spaced times |
//! | [`by_hull_of_end_poses`] | whether the hulls of the bodies at both ends of each of some stretches meet |

pub mod by_hull_of_end_poses;
pub mod by_sampling;
