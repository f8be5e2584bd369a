//! The report: what experiments, figures and claims found, as pages that need nothing but a browser.
//!
//! `report.html` holds nothing that depends on a clock or a machine, so that two runs with one seed and profile give
//! the same bytes; what depends on them stands in `times.html`.
//!
//! - [`chapter`] is what a chapter is, `chapters` has them, in the order of the page.
//! - `repeat` has the commands that find parts of it again.
//! - `tables` has every table, `pages` puts the two pages together.

pub mod chapter;
mod chapters;
mod evidence;
mod html;
mod manifest;
mod pages;
mod repeat;
mod tables;

pub use self::evidence::{DrawnFigure, Evidence, check_context, fits};

pub use manifest::{MANIFEST, Manifest, OutputFile};
pub use pages::{CITATION, report, times};
pub use repeat::USUAL_SEED;
