//! The extent of a run: everything, or a few experiments and figures with what belongs to them.

use experiments::catalog::EXPERIMENTS;
use experiments::definition::Experiment;
use figures::catalog::FIGURES;
use figures::figure::Figure;
use paper_checks::Claim;
use paper_checks::catalog::CLAIMS;

use crate::commands::usage::Usage;

/// The experiments that are run, the figures that are drawn and the claims that are checked, in the order of their
/// catalogs.
#[derive(Debug)]
pub(super) struct Selection {
    pub(super) experiments: Vec<&'static Experiment>,
    pub(super) figures: Vec<&'static Figure>,
    pub(super) claims: Vec<&'static Claim>,
}

impl Selection {
    /// Everything where no ids are given. Else the experiments with these ids and those that the figures with these
    /// ids show; these figures and all others that show nothing but these experiments; the claims that rest on these
    /// experiments and on no others.
    pub(super) fn of(ids: &[String]) -> Result<Self, Usage> {
        if ids.is_empty() {
            let (experiments, figures) = (EXPERIMENTS.iter().collect(), FIGURES.iter().collect());
            return Ok(Self { experiments, figures, claims: CLAIMS.to_vec() });
        }
        let is_named = |id: &str| ids.iter().any(|named| named == id);
        let is_known = |id: &str| experiments::catalog::find(id).is_some() || figures::catalog::find(id).is_some();
        if let Some(unknown) = ids.iter().find(|id| !is_known(id)) {
            return Err(Usage::UnknownId(unknown.clone()));
        }
        let named_figures = || FIGURES.iter().filter(|figure| is_named(figure.id));
        let is_shown = |id: &str| named_figures().any(|figure| figure.experiments.contains(&id));
        let is_run = |id: &str| is_named(id) || is_shown(id);
        let rests_on_these = |needed: &[&str]| !needed.is_empty() && needed.iter().all(|id| is_run(id));
        Ok(Self {
            experiments: EXPERIMENTS.iter().filter(|experiment| is_run(experiment.id)).collect(),
            figures: FIGURES
                .iter()
                .filter(|figure| is_named(figure.id) || rests_on_these(figure.experiments))
                .collect(),
            claims: CLAIMS.iter().copied().filter(|claim| rests_on_these(&claim.experiments())).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn selected(ids: &[&str]) -> Result<[Vec<&'static str>; 3], Usage> {
        let ids: Vec<String> = ids.iter().map(|&id| id.to_owned()).collect();
        let Selection { experiments, figures, claims } = Selection::of(&ids)?;
        Ok([
            experiments.iter().map(|experiment| experiment.id).collect(),
            figures.iter().map(|figure| figure.id).collect(),
            claims.iter().map(|claim| claim.id).collect(),
        ])
    }

    #[test]
    fn everything_or_what_belongs_together() {
        let [experiments, figures, claims] = selected(&[]).expect("everything");
        assert_eq!([experiments.len(), figures.len(), claims.len()], [EXPERIMENTS.len(), FIGURES.len(), CLAIMS.len()]);
        for figure in FIGURES {
            let [experiments, figures, claims] = selected(&[figure.id]).expect("a figure");
            assert!(figures.contains(&figure.id));
            assert!(figure.experiments.iter().all(|id| experiments.contains(id)), "{}", figure.id);
            assert_eq!(experiments.len(), figure.experiments.len(), "{}", figure.id);
            for claim in claims {
                let claim = paper_checks::catalog::find(claim).expect("a claim");
                assert!(claim.experiments().iter().all(|id| experiments.contains(id)), "{}", claim.id);
            }
        }
        let [experiments, figures, _] = selected(&["hull-scaling"]).expect("an experiment");
        assert_eq!(experiments, ["hull-scaling"]);
        for id in figures {
            assert_eq!(figures::catalog::find(id).expect("a figure").experiments, ["hull-scaling"]);
        }
    }

    #[test]
    fn what_is_unknown_is_named() {
        let refused = selected(&["hull-scaling", "no-such-id"]).expect_err("an unknown id").to_string();
        assert!(refused.starts_with("'no-such-id': there is no experiment or figure of this name"), "{refused}");
    }
}
