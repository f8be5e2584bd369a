//! Figures of the paper and of the workbench, drawn to byte-stable SVG.
//!
//! - [`style`]: the one look: colours, line weights, text sizes.
//! - [`scene`]: pictures of geometry; [`axes`]: plots of measurements.
//! - [`min_area`]: what the figures of section 4.1 share; [`growth_plot`]: what the plots of experiments share.
//! - [`own_data`]: pictures of a reader's own data.
//! - [`moving`]: pictures of bodies in motion.
//! - [`portrait`]: a body alone.
//! - [`solid`]: bodies of space; [`skin`]: meshes inside of them.
//! - [`figure`]: what a figure is; [`gallery`]: the figures; [`catalog`]: their list.
//!
//! The folder `gallery` beside the sources holds the drawings of all figures that depend on neither clock nor machine;
//! a test draws them again and compares bytes. `ZONOTOPE_BLESS=1 cargo test -p figures` writes them anew.

pub mod axes;
pub mod catalog;
mod duality;
pub mod figure;
pub mod gallery;
pub mod growth_plot;
pub mod min_area;
pub mod moving;
pub mod own_data;
pub mod portrait;
pub mod scene;
pub mod skin;
pub mod solid;
pub mod style;
