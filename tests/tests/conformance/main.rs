//! Every fast method against the exact twin of its problem, on all instance families.

mod centered;
mod collision;
mod cutting;
mod distance;
mod dynamic_hull;
mod faces;
mod fixed_directions;
mod hull;
mod kernel;
mod min_area;
mod min_total_length;
mod prepared;
mod reduction;
mod slope_selection;
