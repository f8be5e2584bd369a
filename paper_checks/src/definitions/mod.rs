//! The objects of the paper from their definitions, in exact rationals and without regard to speed: the checks' own
//! side of every comparison.
//!
//! | file | what it defines |
//! |---|---|
//! | [`plane`] | the geometry of Section 4.1: hulls, zonogons, the lines ℓ_t, f |
//! | `runs` | the combinatorial description of Z(O) and the paper's area formula |
//! | `subdifferential` | first-order facts about f |
//! | [`space`] | zonotopes of R^3 |
//! | `turning` | rotations about an axis and translations |
//! | `upper_hull` | the facets that look up, and the crossings dual to them |
//! | `enclosing` | zonotopes along given directions, in any dimension |
//! | `pyramids` | volumes in any dimension |
//! | `signs` | faces and arrangements in any dimension |
//! | `linear_program` | small linear programs |
//! | `ratio` | shorthand for exact rationals |

pub(crate) mod enclosing;
pub(crate) mod linear_program;
pub mod plane;
pub(crate) mod pyramids;
pub(crate) mod ratio;
pub(crate) mod runs;
pub(crate) mod signs;
pub mod space;
pub(crate) mod subdifferential;
pub(crate) mod turning;
pub(crate) mod upper_hull;
