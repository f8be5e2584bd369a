//! Experiment definitions, the harness that runs them, and the instances they run on.
//!
//! - [`data`]: real inputs, compiled in; [`question`]: questions about bodies whose answers are known. The instances by
//!   family are the crate [`families`].
//! - [`definition`]: what an experiment is; [`definitions`]: the experiments; [`catalog`]: their list.
//! - [`runner`]: counts, times and records; [`record`]: the rows; [`environment`]: where they were made; [`seed`]:
//!   stable seeds; [`stopwatch`]: the only place that reads a clock; [`sharing`]: runs in parts, on many machines.
//! - [`moving`]: bodies that move, at a clearance; [`hierarchies`]: two copies of a mesh, at a distance.
//! - [`peers`]: the methods of other libraries beside ours, as a record and its tables.
//! - [`fit`]: growth laws with intervals and model comparison; [`analysis`]: from records to fits.
//! - [`findings`]: sentences about what was measured, made from records; [`measured`]: the numbers in them.
//!
//! `METHODOLOGY.md` in this crate's folder says how things are measured, and what the numbers cannot tell.

pub mod analysis;
pub mod catalog;
pub mod data;
pub mod definition;
pub mod definitions;
pub mod environment;
pub mod findings;
pub mod fit;
pub mod hierarchies;
pub mod measured;
pub mod moving;
pub mod peers;
pub mod question;
pub mod record;
pub mod runner;
pub mod seed;
pub mod sharing;
pub mod stopwatch;
