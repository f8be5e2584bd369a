//! The facet normals of all zonotopes along some directions, enumerated, and the points that are extreme along them.

mod extreme_points;
mod normals;

pub(super) use extreme_points::extreme_points;
pub(super) use normals::facet_normals;
