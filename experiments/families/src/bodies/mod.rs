//! Families of generators: inputs of everything that is done with zonotopes.
//!
//! | family | what is hard about it |
//! | --- | --- |
//! | `random_bodies` | nothing: the reference |
//! | `box_sums` | six generators are two boxes; the facets of a box have parallel edges in threes |
//! | `polar_bodies` | generators on a cone: every facet meets the axis of symmetry at one of two distances |
//! | `sorted_bodies` | generators in the order of their directions: a strided sample is regular, a prefix is worthless |
//! | `heavy_tailed_bodies` | a few generators are as long as all others together: samples miss them |
//! | `lattice_bodies` | integer generators: parallel and coplanar ones everywhere, facets of many sides, exact touching |
//! | `parallel_bodies` | twenty directions, exactly parallel generators in each |
//! | `noisy_directions_bodies` | eight directions with noise of 1e-9: nearly parallel, never exactly |
//! | `near_plane_bodies` | nine in ten generators within 1e-6 of a plane |
//! | `flat_bodies` | all generators exactly in a plane: the body has no interior |
//! | `wide_scales_bodies` | lengths from 2^-200 to 2^200 |
//!
//! [`named`] has zonohedra with names.

mod box_sums;
mod catalog;
mod directions;
mod family;
mod lengths;
pub mod named;
mod planes;
mod polar;
mod random;

pub use catalog::{BODY_FAMILIES, NEAR_BALLS, PLANE_FAMILIES, SPACE_TIME_FAMILIES, find, is_known};
pub use family::BodyFamily;
pub(crate) use random::unit_vector;
