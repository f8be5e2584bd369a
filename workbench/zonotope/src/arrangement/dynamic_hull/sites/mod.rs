//! What the hull is made of: points of the plane, or lines in their dual form, sorted once and for all.
//!
//! | file | what it holds |
//! |---|---|
//! | `site` | what the methods ask of a site: orders and turns, all of them exact |
//! | `planar_point` | points with two doubles |
//! | `sloped_line` | lines that are not vertical, with three doubles; the dual point is a quotient of them |
//! | `sorted_sites` | all sites that may ever be present, sorted, equal ones together |
//! | `presence` | which positions are present, and the next one that is |

mod planar_point;
pub(super) mod presence;
mod site;
mod sloped_line;
mod sorted_sites;

pub use planar_point::PlanarPoint;
pub use site::{Direction, DirectionError, Site};
pub use sloped_line::{SlopedLine, SlopedLineError};
pub use sorted_sites::{MAX_SITES, SiteIndex, SortedSites, TooManySites};
