//! Section 1: what zonotopes are and why they make good bounding volumes.

pub(crate) mod affine_cube_image;
pub(crate) mod boxes;
pub(crate) mod central_projection;
pub(crate) mod central_symmetry;
pub(crate) mod complexity;
pub(crate) mod construction_time;
pub(crate) mod facets_are_parallelepipeds;
pub(crate) mod familiar_polyhedra;
pub(crate) mod great_circle_arrangement;
pub(crate) mod implicit_representation;
pub(crate) mod minkowski_closure;
pub(crate) mod plane_symmetric_polygons;
pub(crate) mod space_symmetric_bodies;
pub(crate) mod tangent_plane;
pub(crate) mod variable_complexity;
pub(crate) mod zones;
