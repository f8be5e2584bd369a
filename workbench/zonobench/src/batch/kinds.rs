//! The kinds of question that are answered: one row of a table each.

mod min_area;
mod support;

use serde_json::Value;

use super::fields::Fields;
use super::refusal::Refusal;

/// A kind of question.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// What it asks, in one line.
    pub summary: &'static str,
    /// The fields of its input, all of them required.
    pub fields: &'static [&'static str],
    /// The methods that answer it, the default first.
    pub methods: fn() -> Vec<&'static str>,
    /// Answers it: input, one of the methods, seed.
    pub(super) solve: fn(&Fields<'_>, &'static str, u64) -> Result<Value, Refusal>,
}

/// Every kind that is answered.
pub static KINDS: &[Kind] = &[min_area::KIND, support::KIND];

/// An answer's content.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solution {
    pub(super) method: &'static str,
    pub(super) result: Value,
}
