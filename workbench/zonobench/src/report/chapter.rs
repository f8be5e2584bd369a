//! A chapter of the report: a static value, one for every problem that the workbench solves.

use experiments::fit::GrowthModel;
use experiments::measured::Measured;

/// A chapter: one problem of the paper and the methods that solve it.
#[derive(Debug)]
pub struct Chapter {
    /// Its anchor in the page.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The place where the paper treats it.
    pub place: &'static str,
    /// The problem, for a reader who has not read the paper.
    pub statement: &'static str,
    /// The lesson, in one sentence with the numbers of this run; none where the run made no such records.
    pub lesson: fn(&Measured<'_>) -> Option<String>,
    /// The figures that stand open, in their order; the chapter's other figures are folded up.
    pub pictures: &'static [&'static str],
    /// The table that stands open.
    pub table: ChapterTable,
    /// The way it is solved, one paragraph each.
    pub method: &'static [&'static str],
    /// The costs of the methods.
    pub costs: &'static [Cost],
    /// The claims of the paper that it is about.
    pub claims: &'static [&'static str],
    /// The experiments that belong to it whatever claims they name. Other experiments belong to the chapter of the
    /// first claim that they name; figures belong where their experiments do, or else to the chapter of their first
    /// claim.
    pub experiments: &'static [&'static str],
    /// The commands that run it alone, each with its effect.
    pub commands: &'static [(&'static str, &'static str)],
}

/// A law of a method's cost: the sentence, and what holds it.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// The sentence.
    pub text: &'static str,
    /// The claim or experiment that states or measures the law.
    pub held: Held,
}

/// The evidence for a sentence that states a law. A test looks that it is the same law.
#[derive(Clone, Copy, Debug)]
pub enum Held {
    /// The claim of this id states it.
    Claim(&'static str),
    /// An experiment compares one of its methods with the law.
    Fit {
        /// The experiment's id.
        experiment: &'static str,
        /// The variant's id.
        method: &'static str,
        /// The law.
        law: GrowthModel,
    },
}

/// The one table of a chapter that stands open.
#[derive(Clone, Copy, Debug)]
pub enum ChapterTable {
    /// The growth laws of all the chapter's experiments, a row for each quantity of each method.
    Growth,
    /// The values of this experiment: where they are summed, over all inputs; else for each input.
    Values(&'static str),
    /// The values of this experiment on one input.
    ValuesOn(&'static str, &'static str),
    /// Words.
    Words {
        /// The heads of the columns.
        head: &'static [&'static str],
        /// The rows.
        rows: &'static [&'static [&'static str]],
    },
}
