//! Families of point sets in the plane.
//!
//! | family | points on the hull | what it is for |
//! | --- | --- | --- |
//! | `circle`, `ellipse`, `ellipse_thin` | nearly all | the whole cost after the hull shows |
//! | `random_convex` | all | as above, with irregular edges |
//! | `regular_polygon` | all | centrally symmetric: all lines of 4.1 meet in one point |
//! | `gaussian`, `disc`, `clustered` | few | the hull is the cost |
//! | `lattice` | few | many ties |
//! | `symmetric`, `duplicates`, `collinear` | varies | degenerate input |

mod catalog;
pub mod circle;
pub mod clustered;
pub mod degenerate;
pub mod disc;
pub mod ellipse;
mod family;
pub mod gaussian;
pub mod lattice;
pub mod random_convex;
pub mod regular_polygon;

pub use catalog::{FAMILIES, find};
pub use family::{Family, HullSize};
