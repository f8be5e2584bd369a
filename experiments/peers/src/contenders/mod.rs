//! The methods that run side by side.
//!
//! The preparation of a method (its own form of the body) is outside the measurement; that
//! favours those that need much, the explicit polyhedra above all.

mod linear_programs;
mod ours;
mod parry;
mod parry_f32;

use experiments::question::Question;

/// A method, ready to be asked.
pub struct Contender {
    /// Stable name; the tables of `experiments::peers` have the name for people.
    pub id: &'static str,
    /// Larger bodies are not given to it.
    pub largest: usize,
    /// Makes its form of the question; none if it cannot take the body at all.
    pub prepare: for<'a> fn(&'a Question) -> Option<Work<'a>>,
}

/// The work that is measured.
pub type Work<'a> = Box<dyn FnMut() -> Answer + 'a>;

/// The answer of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Whether the displacement lies in the body, that is, whether the two bodies meet.
    Member(bool),
    /// It gave up.
    Failed,
    /// It is no method: the pass that others are compared with.
    Nothing,
}

/// Every contender; the pass comes first.
pub static CONTENDERS: &[Contender] = &[
    ours::PASS,
    ours::LOCATE,
    ours::GAUGE,
    ours::INTERSECTION,
    ours::INTERSECTION_WRITTEN,
    ours::INTERSECTION_OF_ROWS,
    ours::INTERSECTION_POSED,
    ours::GAUGE_PREPARED,
    ours::DISTANCE,
    ours::PROXIMITY,
    ours::PENETRATION,
    ours::SLOPE_SELECTION,
    ours::EXPLICIT_FACES,
    ours::GJK,
    parry::GJK,
    parry::GJK_POSED,
    parry::DISTANCE,
    parry::PENETRATION,
    parry_f32::GJK,
    parry::POLYHEDRON,
    linear_programs::CLARABEL,
    linear_programs::MICROLP,
];
