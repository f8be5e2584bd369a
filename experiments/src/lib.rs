//! Experiment definitions, the harness that runs them, and the instances they run on.
//!
//! - [`families`]: deterministic generators of point sets and line sets.
//! - [`data`]: real inputs, compiled in.

pub mod data;
pub mod families;
