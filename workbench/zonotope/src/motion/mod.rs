//! Problem: what rigid motions of zonotopes of space do: the volumes that they sweep, and when two bodies meet first.
//!
//! A [`Motion`] is a placement for each time from 0 to 1. Its rational form, in which quaternions go linearly from one
//! to another, has a matrix of rationals at every rational time: no sine and no root is taken, and every decision is
//! exact. A rotation at constant rate is enclosed by such arcs, with a bound of the angle by which they are off.
//!
//! A *part* is what a caller states, a *piece* is that part as the library keeps it, an *arc* is the motion of one body
//! between two times of one piece, and a *stretch* is a span of time with the arcs of both bodies. (The parts of a
//! mesh, in `continuous/of_meshes`, are its nodes and triangles.)
//!
//! | module | problem | in the paper |
//! |---|---|---|
//! | [`space_time`] | a zonotope around all placements of a moving body | 6, Theorem 6.1 |
//! | [`continuous`] | whether two moving bodies meet during a step, and when first | 6 |
//!
//! | file | content |
//! |---|---|
//! | `sweep` | an axis, an angle and a translation on any schedule |
//! | `path` | motions and how they are made |
//! | `piece` | a part of a rational motion, after those before it |
//! | `constant_rate` | a rotation at constant rate and the bound of the angle by which its arcs are off |
//! | `arc` | a motion between two times: what all questions are asked about |
//! | `quaternion`, `bernstein`, `scalar` | quaternions, polynomials and the numbers that they are made of |
//!
//! The files are read in this order: `scalar`, `bernstein`, `quaternion`, `arc`, `piece`, `sweep`, `constant_rate`,
//! `path`. Everything else asks a motion for arcs, in three kinds of numbers: exact ones (`exact_arc`), doubles with
//! bounds (`arc`) and doubles for guesses (`rounded_arc`); for how far an arc is off the motion (`angle_off`,
//! `distance_from_axis`, `unit_axis`); and for where time is to be cut (`breaks`, `quarter_turns`, `is_one_arc`).
//!
//! # A new kind of motion
//! A motion whose quaternion goes linearly in the time between rational ones is a constructor in `path` that makes
//! pieces, as [`Motion::through`] does: the volumes, the first contacts and their proofs need nothing more. Any other
//! is a variant beside the two of `path`, with the functions that match on them: its arcs are rational and near it, and
//! `as_sweep` gives a sweep around it. `angle_off` and `distance_from_axis` bound how far its arcs are off by an angle
//! about one axis, which is all that `continuous/parts/margin` subtracts: a motion whose base is off, too, as one that
//! is thrown, needs a bound of its own there and a volume that holds more than its sweep.
//!
//! - The margin takes the base of an arc to be on the axis and the body to be unturned at the time 0.
//! - `only_turns` says that the placements of an arc, whatever their times, are those of its angles: of a motion that
//!   turns back it is false. `quarter_turns` is about the largest rate, as the time is cut evenly.
//! - The bounds of rounding are constants of `numeric/tolerance`, each with its derivation.
//! - A file of a motion has its tests at its end; `continuous/tests` holds answers to samples and, through the
//!   verifier, to a second reading of the motion.
//!
//! The statement of a question is read in the crate `batch` (`kinds/motion/stated`), and once more, without this crate,
//! in the verifier (`motion/path`), whose `Motion` gets the same variant; `claimed_contact` of `batch` hands answers
//! over to it. Texts that name the motions which are not rational are in `continuous/of_meshes/answer`.

mod arc;
mod bernstein;
mod constant_rate;
pub mod continuous;
mod path;
mod piece;
mod quaternion;
mod scalar;
pub mod space_time;
mod sweep;

pub use path::{KeyPose, Motion, MotionError, MotionPiece};
