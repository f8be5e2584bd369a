//! Bodies in motion: whether two zonotopes of space meet during a step of time, and when first; what a body sweeps.
//!
//! | file | content |
//! | --- | --- |
//! | `answer` | the answer as it is written, and what is proved of it |
//! | `check` | the order of the intervals, and what each status claims |
//! | `free` | an interval in which a direction separates the bodies, bisected where that is in doubt |
//! | `gap` | the gap along a direction as a polynomial in the time |
//! | `meeting` | a common point at one time, or two points near each other |
//! | `of_meshes` | the same of two meshes of triangles, by parts of them |
//! | `path` | motions, and their stretches between two times |
//! | `stretch` | the placements between two times, as the checks read them |
//! | `turning` | a rotation at constant rate, enclosed by stretches |
//! | `sweep` | a zonotope around all placements of a body that turns and translates |
//! | `sweep/turned_arc` | the arc of a turned vector, between rational points and corners of tangents |
//! | `turning/sines` | sines and cosines within a stated error |
//! | `quaternion`, `polynomial`, `root` | what these are made of |

pub(crate) mod answer;
pub(crate) mod check;
mod free;
mod gap;
mod meeting;
pub(crate) mod of_meshes;
pub(crate) mod path;
mod polynomial;
mod quaternion;
mod root;
mod stretch;
pub(crate) mod sweep;
#[cfg(test)]
mod tests;
mod turning;
