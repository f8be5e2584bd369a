//! The kinds of question that are answered: one row of a table each.

mod collision;
mod combinatorics;
mod distance;
mod gauge;
mod hausdorff;
mod intersect;
mod member;
mod member_batch;
mod min_area;
mod min_length_all;
mod min_length_dirs;
mod reduce;
mod separator;
mod slope_selection;
mod support;
mod upper_hull;
mod walk;

use serde_json::Value;

pub use min_area::result as min_area_result;

use super::fields::Fields;
use super::refusal::Refusal;

/// A kind of question.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// What it asks, in one line.
    pub summary: &'static str,
    /// The fields that its input must have.
    pub fields: &'static [&'static str],
    /// The fields that its input may have as well.
    pub optional: &'static [&'static str],
    /// The methods that answer it, the default first.
    pub methods: fn() -> Vec<&'static str>,
    /// Answers it: input, the method that was asked for, seed.
    pub(super) solve: fn(&Fields<'_>, Option<&'static str>, u64) -> Result<Solution, Refusal>,
}

/// Every kind that is answered.
pub static KINDS: &[Kind] = &[
    member::KIND,
    intersect::KIND,
    gauge::KIND,
    distance::KIND,
    reduce::APPROX,
    reduce::REDUCE,
    hausdorff::KIND,
    member_batch::KIND,
    support::KIND,
    combinatorics::KIND,
    slope_selection::KIND,
    separator::KIND,
    upper_hull::KIND,
    walk::KIND,
    min_area::KIND,
    min_length_dirs::KIND,
    min_length_all::KIND,
];

/// An answer's content.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solution {
    pub(super) method: &'static str,
    pub(super) result: Value,
}
