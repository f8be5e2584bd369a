//! Every fast method against the exact twin of its problem, on all instance families.

mod arrangement;
mod body_distances;
mod centered;
mod collision;
mod distance;
mod faces;
mod fixed_directions;
mod hierarchy;
mod hull;
mod in_each_dimension;
mod kernel;
mod linear_program;
mod min_area;
mod min_total_length;
mod prepared;
mod reduction;
mod rivals;
mod tracking;
