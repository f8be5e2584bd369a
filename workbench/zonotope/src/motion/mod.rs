//! Problem: what rigid motions of zonotopes of space do: the volumes that they sweep, and when two bodies meet first.
//!
//! A [`Motion`] is a placement for each time from 0 to 1. Its rational form, in which quaternions go linearly from one
//! to another, has a matrix of rationals at every rational time: no sine and no root is taken, and every decision is
//! exact. A rotation at constant rate is enclosed by such stretches, with a bound of the angle by which they are off.
//!
//! | module | problem | in the paper |
//! |---|---|---|
//! | [`space_time`] | a zonotope around all placements of a moving body | 6, Theorem 6.1 |
//! | [`continuous`] | whether two moving bodies meet during a step, and when first | 6 |
//!
//! | file | content |
//! |---|---|
//! | `path` | motions and how they are made |
//! | `piece` | a part of a rational motion, after those before it |
//! | `constant_rate` | a rotation at constant rate and the bound of the angle by which its stretches are off |
//! | `arc` | a stretch of a motion between two times: what all questions are asked about |
//! | `quaternion`, `bernstein`, `scalar` | quaternions, polynomials and the numbers that they are made of |

mod arc;
mod bernstein;
mod constant_rate;
pub mod continuous;
mod path;
mod piece;
mod quaternion;
mod scalar;
pub mod space_time;

pub use path::{KeyPose, Motion, MotionError, MotionPiece};
