//! What a chapter of the report is: a static value, one for every problem that the workbench solves.

pub use super::chapters::CHAPTERS;

/// A chapter: one problem of the paper and the methods that solve it.
#[derive(Debug)]
pub struct Chapter {
    /// Its anchor in the page.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Where the paper treats it.
    pub place: &'static str,
    /// The problem, for a reader who has not read the paper.
    pub statement: &'static str,
    /// How it is solved, one paragraph each.
    pub method: &'static [&'static str],
    /// The bound, and what is known to hold it.
    pub bound: &'static str,
    /// The claims of the paper that it is about.
    pub claims: &'static [&'static str],
    /// The experiments that belong to it whatever claims they name. Other experiments belong to the chapter of the
    /// first claim that they name; figures belong where their experiments do, or else to the chapter of their first
    /// claim.
    pub experiments: &'static [&'static str],
    /// How to run it alone: a command, and what it does.
    pub commands: &'static [(&'static str, &'static str)],
}
