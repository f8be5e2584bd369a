//! The list of the families of point sets.

use super::family::Family;
use super::{circle, clustered, degenerate, disc, ellipse, gaussian, lattice, random_convex, regular_polygon};

/// Every point family, in the order in which reports list them.
pub static FAMILIES: &[Family] = &[
    circle::CIRCLE,
    ellipse::ELLIPSE,
    ellipse::ELLIPSE_THIN,
    random_convex::RANDOM_CONVEX,
    regular_polygon::REGULAR_POLYGON,
    gaussian::GAUSSIAN,
    clustered::CLUSTERED,
    disc::DISC,
    lattice::LATTICE,
    degenerate::SYMMETRIC,
    degenerate::DUPLICATES,
    degenerate::COLLINEAR,
];

/// The family called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static Family> {
    FAMILIES.iter().find(|family| family.id == id)
}
