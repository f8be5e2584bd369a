//! The interface as its callers see it: what is read, what is refused, what is answered and what is proved.

mod enclosures_of_all_sizes;
mod false_answers;
mod hard_questions;
mod json;
mod many_points;
mod meshes;
mod motion;
mod names;
mod near_the_largest_double;
mod pictures;
mod places;
mod poses;
mod transcript;
mod verdicts;
