//! The interface as its callers see it: what is read, what is refused, what is answered and what is proved.

mod json;
mod many_points;
mod places;
mod poses;
mod transcript;
mod verdicts;
