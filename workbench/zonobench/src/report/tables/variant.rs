//! The title of an experiment's variant as the tables write it.

use experiments::definition::Experiment;

use crate::report::html::Escaped;

/// The title of a variant, escaped; its id where the experiment has no such variant.
pub(super) fn variant_title(experiment: &Experiment, variant: &str) -> String {
    let found = experiment.variants.iter().find(|candidate| candidate.id == variant);
    Escaped(found.map_or(variant, |variant| variant.title)).to_string()
}
