//! Smallest zonotopes around a set of points.
//!
//! | problem | what it asks |
//! |---|---|
//! | [`centered_zonogon`] | the smallest zonogon with a given centre around points of the plane (4.1) |
//! | [`bisectors`] | the lines ℓ_t at which its combinatorial description changes (4.1) |
//! | [`min_area_zonogon`] | the zonogon of least area around points of the plane (4.1) |
//! | [`fixed_directions`] | the smallest zonotope along given directions around points of any dimension (4.2) |
//! | [`min_total_length`] | the zonotope of least total length around points of any dimension (4.3) |

pub mod bisectors;
mod boundary_vertex;
pub mod centered_zonogon;
pub mod fixed_directions;
mod half_turn;
pub mod min_area_zonogon;
pub mod min_total_length;
mod outward;
