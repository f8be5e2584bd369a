//! Counting what an algorithm does: exact, machine-independent, free when unused.
//!
//! An algorithm that counts takes a [`Tally`]. The unit type counts nothing and compiles to nothing, `&mut ()`;
//! [`OperationCounts`] keeps a number for each [`Operation`] and for each [`Rung`]. Growth claims are fitted on these
//! numbers, never on times.

mod reads;
mod rung;

use crate::tables::named_variants;

pub(crate) use reads::Reads;
pub use rung::{Rung, Stage};

named_variants! {
    /// What is counted.
    pub enum Operation;
    /// One line of an arrangement read and evaluated; divided by the number of lines: passes over the data.
    LineEvaluation => "line_evaluation";
    /// One line of a part of the input read and evaluated: of a sample, or of what is left when all other lines are
    /// summed up.
    PartEvaluation => "part_evaluation";
    /// Two keys (positions along a line, slopes, coordinates) compared in a sort, a merge or a selection.
    Comparison => "comparison";
    /// One orientation test of three points.
    Turn => "turn";
    /// One point read by a pass over the points.
    PointRead => "point_read";
    /// One point read by the scan of Theorem 4.6 for the farthest points along the normals of all facets.
    /// Reads of a proof that follows the scan, which is not of the paper, are counted apart from these.
    ScanRead => "scan_read";
    /// One generator read and evaluated; divided by the number of generators: passes over the data.
    GeneratorRead => "generator_read";
    /// One entry of a matrix read by a linear program: of its rows, of the inverse of its basis, or of the factors of
    /// an engine's equations.
    EntryRead => "entry_read";
    /// One step of an outer search: a line search, a vertical line, a cell.
    SearchStep => "search_step";
    /// One sign that floating point could not decide and exact arithmetic did.
    ExactFallback => "exact_fallback";
    /// One stretch of time of which a method asked whether moving bodies are disjoint during it.
    Stretch => "stretch";
    /// One value of the support function of a body along one direction; a question about bodies that stand counts the
    /// passes over the generators of each.
    SupportEvaluation => "support_evaluation";
    /// One test whether the bounding volumes of two nodes are disjoint.
    NodeTest => "node_test";
    /// One test whether two triangles of meshes meet, or how far apart they are.
    TriangleTest => "triangle_test";
}

/// A counter of operations.
pub trait Tally {
    /// Adds `count` operations.
    fn add(&mut self, operation: Operation, count: u64);

    /// Notes the method that answered a question.
    fn answered_by(&mut self, rung: Rung);
}

impl Tally for () {
    #[inline(always)]
    fn add(&mut self, _: Operation, _: u64) {}

    #[inline(always)]
    fn answered_by(&mut self, _: Rung) {}
}

/// A reference to a tally counts as the tally does: functions that are compiled for every tally take one that is known
/// only when the program runs.
impl Tally for &mut dyn Tally {
    #[inline]
    fn add(&mut self, operation: Operation, count: u64) {
        (**self).add(operation, count);
    }

    #[inline]
    fn answered_by(&mut self, rung: Rung) {
        (**self).answered_by(rung);
    }
}

/// A number for each operation and for each rung.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct OperationCounts {
    operations: [u64; Operation::ALL.len()],
    rungs: [u64; Rung::ALL.len()],
}

impl OperationCounts {
    /// How many operations of this kind were counted.
    pub fn get(&self, operation: Operation) -> u64 {
        self.operations[operation as usize]
    }

    /// How many questions this method answered.
    pub fn answers_of(&self, rung: Rung) -> u64 {
        self.rungs[rung as usize]
    }

    /// Adds the counts of another run.
    pub fn merge(&mut self, other: &Self) {
        let counts = other.operations.iter().chain(&other.rungs);
        for (sum, count) in self.operations.iter_mut().chain(&mut self.rungs).zip(counts) {
            *sum += count;
        }
    }

    /// Every operation with its count, in the order of [`Operation::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Operation, u64)> + '_ {
        Operation::ALL.into_iter().map(|operation| (operation, self.get(operation)))
    }
}

impl Tally for OperationCounts {
    #[inline]
    fn add(&mut self, operation: Operation, count: u64) {
        self.operations[operation as usize] += count;
    }

    #[inline]
    fn answered_by(&mut self, rung: Rung) {
        self.rungs[rung as usize] += 1;
    }
}
