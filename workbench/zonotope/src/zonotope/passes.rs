//! Passes over generators in plain doubles, with bounds on their errors.
//!
//! A pass decides nothing by itself. [`Extents`] are read off once a body; with them every later pass has a bound on
//! its error, and only where that bound leaves a doubt is exact arithmetic needed.

pub use crate::numeric::lanes::{Extents, absolute_sum, extreme_sum};
