//! Problem: a zonotope around all placements of a zonotope that turns about an axis and translates.
//!
//! A [`Sweep`] is the set of placements: turned about the axis line by any angle from 0 to a given one, then moved by
//! any part of a translation, on any schedule. A volume contains every one of them exactly. Let r be the largest
//! distance of a vertex from the axis, θ the angle and n the number of generators.
//!
//! | method | volume | generators |
//! |---|---|---|
//! | [`by_farthest_vertex`] (default) | Theorem 6.1: the body and a square around the circle of radius 2 r sin(θ/2) | n + 3 |
//! | [`by_middle_placement`] | the body turned halfway and a square around the circle of radius 2 r sin(θ/4) | n + 3 |
//! | [`by_least_rectangle`] | the body and the least rectangle around the arcs of its vertices | n + 3 |
//! | [`by_least_zonogon`] | the body and the zonogon of least area around these arcs | those of the zonogon more |
//! | [`by_shadow`] | the body turned halfway and two images of its shadow | 3n + 3 |
//! | [`by_turned_generators`] | each generator turned: three for one | 3n + 3 |
//! | [`brute_force`] | the truth: one exact placement against all facet normals | |
//!
//! Rounding adds a generator along each coordinate axis in which something was lost: at most three more.
//!
//! | file | content |
//! |---|---|
//! | `doors` | [`Zonotope::swept`](crate::Zonotope::swept) and its kin |
//! | `intervals` | a chain of volumes, one for each part of the angle |
//! | [`by_control_points`] | the volume of any rational motion |
//! | `parts` | angles, the plane of the rotation, the shadow of the body in it, the volume while it is put together |

pub mod brute_force;
pub mod by_control_points;
pub mod by_farthest_vertex;
pub mod by_least_rectangle;
pub mod by_least_zonogon;
pub mod by_middle_placement;
pub mod by_shadow;
pub mod by_turned_generators;
mod doors;
mod intervals;
mod method;
mod parts;
#[cfg(test)]
mod tests;

pub use super::sweep::{Sweep, SweepError};
pub use intervals::volumes_of_intervals;
pub use method::Method;
