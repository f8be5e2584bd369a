//! The facet normals of all zonotopes along some directions, enumerated, and what the points look like along them.

mod extreme_points;
mod normals;

pub(super) use extreme_points::extreme_points;
pub(super) use normals::facet_normals;
