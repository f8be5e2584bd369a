//! The kinds of question that are answered: one value each, which owns both ends, the answer and its check.

mod arrangement;
mod bodies;
mod collision;
mod enclosing;
pub(super) mod meshes;
mod motion;

use serde_json::Value;

pub use collision::held::HeldBody;
pub use enclosing::min_area::result as min_area_result;
pub use motion::read_motion;

use verifier::Verdict;

use super::claimed::Traced;
use super::fields::Fields;
use super::placement::PLACED;
use super::refusal::Refusal;

/// The fields of a zonotope.
const BODY: [&str; 2] = ["center", "generators"];

/// A kind of question.
#[derive(Debug)]
pub struct Kind {
    /// Its name.
    pub name: &'static str,
    /// The question, in one line.
    pub summary: &'static str,
    /// The fields that its input must have.
    pub fields: &'static [&'static str],
    /// The fields that its input may have as well.
    pub optional: &'static [&'static str],
    /// The methods that answer it, the default first.
    pub methods: fn() -> Vec<&'static str>,
    /// Answers it: input, the method that was asked for, seed.
    pub(super) solve: fn(&Fields<'_>, Option<&'static str>, u64) -> Result<Solution, Refusal>,
    /// Checks an answer to it, sharing nothing with `solve`: input, result, the method that the answer names. The
    /// numbers of both are read here, the crate `verifier` judges them; an error is the complaint about what cannot be
    /// read.
    pub(super) check: fn(Traced<'_>, Traced<'_>, Option<&str>) -> Result<Verdict, String>,
}

/// Every kind that is answered.
pub static KINDS: &[Kind] = &[
    collision::member::KIND,
    collision::intersect::KIND,
    collision::gauge::KIND,
    collision::distance::KIND,
    motion::collide::KIND,
    meshes::mesh::KIND,
    bodies::reduce::APPROX,
    bodies::reduce::REDUCE,
    bodies::hausdorff::KIND,
    collision::member_batch::KIND,
    bodies::support::KIND,
    bodies::combinatorics::KIND,
    arrangement::slope_selection::KIND,
    arrangement::separator::KIND,
    arrangement::upper_hull::KIND,
    arrangement::walk::KIND,
    enclosing::min_area::KIND,
    enclosing::min_length_dirs::KIND,
    enclosing::min_length_all::KIND,
    motion::sweep::KIND,
    meshes::level::KIND,
];

/// An answer's content.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solution {
    pub(super) method: &'static str,
    pub(super) result: Value,
}
