//! Figures of the paper and of the workbench, drawn to byte-stable SVG.
//!
//! - [`style`]: the one look: colours, line weights, text sizes.
//! - [`scene`]: pictures of geometry; [`axes`]: plots of measurements.
//! - [`figure`]: what a figure is.

pub mod axes;
pub mod figure;
pub mod scene;
pub mod style;
