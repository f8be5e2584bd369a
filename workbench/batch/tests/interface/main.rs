//! The interface as its callers see it: what is read, what is refused, what is answered and what is proved.

mod false_answers;
mod json;
mod many_points;
mod places;
mod transcript;
mod verdicts;
