//! The order of the report: the chapters with their figures, experiments and claims, and the numbers of
//! figures.

use experiments::definition::Experiment;
use paper_checks::ClaimResult;

use crate::report::DrawnFigure;
use crate::report::Evidence;
use crate::report::chapter::Chapter;
use crate::report::chapters::CHAPTERS;

/// The report's parts, in their order.
pub(super) struct Layout<'a> {
    /// The plots of experiments that the reader's file has changed.
    pub(super) own_figures: Vec<&'a DrawnFigure>,
    /// The chapters that something was found for.
    pub(super) parts: Vec<Part<'a>>,
    /// Figures that belong to no chapter.
    pub(super) other_figures: Vec<&'a DrawnFigure>,
    /// Experiments that belong to no chapter.
    pub(super) other_experiments: Vec<&'static Experiment>,
}

/// A chapter with what this run has for it.
pub(super) struct Part<'a> {
    pub(super) chapter: &'static Chapter,
    /// The figures that stand open, in the chapter's order.
    pub(super) pictures: Vec<&'a DrawnFigure>,
    /// Its other figures.
    pub(super) folded: Vec<&'a DrawnFigure>,
    pub(super) experiments: Vec<&'static Experiment>,
    pub(super) results: Vec<&'a ClaimResult>,
}

impl<'a> Layout<'a> {
    /// The layout of what was found.
    pub(super) fn of(evidence: &'a Evidence) -> Self {
        let shown = || evidence.figures.iter().filter(|drawn| drawn.figure.deterministic);
        // A run with the reader's own file draws nothing else.
        let is_own = evidence.config.is_some();
        let figures = || shown().filter(|_| !is_own);
        let part = |&chapter: &&'static Chapter| {
            let own = || figures().filter(|drawn| home_of_figure(drawn) == Some(chapter.id));
            let picture = |id: &&str| own().find(|drawn| drawn.figure.id == *id);
            let at_home = |experiment: &&'static Experiment| home(experiment) == Some(chapter.id);
            Part {
                chapter,
                pictures: chapter.pictures.iter().filter_map(picture).collect(),
                folded: own().filter(|drawn| !chapter.pictures.contains(&drawn.figure.id)).collect(),
                experiments: evidence.experiments.iter().copied().filter(at_home).collect(),
                results: evidence.claims.iter().filter(|result| chapter.claims.contains(&result.claim.id)).collect(),
            }
        };
        let is_shown = |part: &Part<'_>| evidence.only.is_empty() || part.has_findings();
        Self {
            own_figures: shown().filter(|_| is_own).collect(),
            parts: CHAPTERS.iter().map(part).filter(is_shown).collect(),
            other_figures: figures().filter(|drawn| home_of_figure(drawn).is_none()).collect(),
            other_experiments: evidence.experiments.iter().copied().filter(|other| home(other).is_none()).collect(),
        }
    }

    /// The place of a figure among all of the page, from 0.
    pub(super) fn number_of(&self, id: &str) -> Option<usize> {
        let in_parts = self.parts.iter().flat_map(|part| part.pictures.iter().chain(&part.folded));
        self.own_figures.iter().chain(in_parts).chain(&self.other_figures).position(|drawn| drawn.figure.id == id)
    }
}

impl Part<'_> {
    fn has_findings(&self) -> bool {
        !(self.pictures.is_empty() && self.folded.is_empty() && self.experiments.is_empty())
    }
}

/// The chapter of an experiment.
fn home(experiment: &Experiment) -> Option<&'static str> {
    let listed = CHAPTERS.iter().find(|chapter| chapter.experiments.contains(&experiment.id));
    listed.map(|chapter| chapter.id).or_else(|| home_of_claims(experiment.claims))
}

/// The chapter of a figure: the one that names it among its pictures, or that of its experiments, or of its claims.
fn home_of_figure(drawn: &DrawnFigure) -> Option<&'static str> {
    let figure = drawn.figure;
    let named = CHAPTERS.iter().find(|chapter| chapter.pictures.contains(&figure.id)).map(|chapter| chapter.id);
    let experiments = || figure.experiments.iter().filter_map(|id| experiments::catalog::find(id));
    named.or_else(|| experiments().filter_map(home).next()).or_else(|| home_of_claims(figure.claims))
}

/// The chapter of the first of these claims that has one.
fn home_of_claims(claims: &[&str]) -> Option<&'static str> {
    let home = |claim: &&str| CHAPTERS.iter().find(|chapter| chapter.claims.contains(claim));
    claims.iter().find_map(home).map(|chapter| chapter.id)
}
