//! The list of experiments. Adding one is one file in [`definitions`](crate::definitions) and one entry here.

use crate::definition::Experiment;
use crate::definitions::{
    area_ratio, coherence, collision_scaling, directions_scaling, enclosing_quality, faces_scaling, fallback_rate,
    few_generators, gap_curve, gauge_passes, hierarchy_levels, hull_scaling, lad_race, lad_scaling, length_ratio,
    methods_agree, min_area_scaling, min_area_stages, points_scaling, pruning_passes, query_trade_off, reduction_error,
    rung_shares, scan_race, slope_selection_scaling, tree_queries, walk_steps, wrong_answers,
};

/// Every experiment, in the order of reports.
pub static EXPERIMENTS: &[Experiment] = &[
    min_area_scaling::EXPERIMENT,
    min_area_stages::EXPERIMENT,
    lad_scaling::EXPERIMENT,
    lad_race::EXPERIMENT,
    pruning_passes::EXPERIMENT,
    slope_selection_scaling::EXPERIMENT,
    hull_scaling::EXPERIMENT,
    methods_agree::EXPERIMENT,
    area_ratio::EXPERIMENT,
    directions_scaling::EXPERIMENT,
    points_scaling::EXPERIMENT,
    scan_race::EXPERIMENT,
    length_ratio::EXPERIMENT,
    gap_curve::EXPERIMENT,
    few_generators::EXPERIMENT,
    enclosing_quality::EXPERIMENT,
    collision_scaling::EXPERIMENT,
    gauge_passes::EXPERIMENT,
    fallback_rate::EXPERIMENT,
    rung_shares::EXPERIMENT,
    faces_scaling::EXPERIMENT,
    wrong_answers::EXPERIMENT,
    query_trade_off::EXPERIMENT,
    tree_queries::EXPERIMENT,
    reduction_error::EXPERIMENT,
    hierarchy_levels::EXPERIMENT,
    walk_steps::EXPERIMENT,
    coherence::EXPERIMENT,
];

/// The experiment called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static Experiment> {
    EXPERIMENTS.iter().find(|experiment| experiment.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::{Profile, Quantity};
    use crate::families;
    use crate::runner;
    use std::collections::BTreeSet;

    const PROFILES: [Profile; 2] = [Profile::Quick, Profile::Full];

    #[test]
    fn ids_are_distinct() {
        let ids: BTreeSet<_> = EXPERIMENTS.iter().map(|experiment| experiment.id).collect();
        assert_eq!(ids.len(), EXPERIMENTS.len());
        for profile in PROFILES {
            let cases = EXPERIMENTS.iter().flat_map(|experiment| runner::cases(experiment, profile, 1));
            let ids: Vec<_> = cases.map(|case| case.id()).collect();
            assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        }
    }

    #[test]
    fn every_input_resolves() {
        for experiment in EXPERIMENTS {
            for id in experiment.families {
                let found = families::find(id).is_some()
                    || families::lines::find(id).is_some()
                    || families::bodies::is_known(id)
                    || families::clouds::find(id).is_some();
                assert!(found, "{}: {id}", experiment.id);
            }
            for name in experiment.real_inputs {
                assert!(runner::own_size(name).is_some(), "{}: {name}", experiment.id);
            }
        }
    }

    #[test]
    fn what_is_timed_is_also_counted() {
        for experiment in EXPERIMENTS {
            let Some(timing) = experiment.timing else { continue };
            for profile in PROFILES {
                assert!(timing.repetitions.get(profile) > 0, "{}", experiment.id);
                for n in timing.sizes.get(profile) {
                    assert!(experiment.sizes.get(profile).contains(n), "{}: {n}", experiment.id);
                }
            }
        }
    }

    #[test]
    fn fits_ask_for_what_exists() {
        for experiment in EXPERIMENTS {
            for plan in experiment.fits {
                assert!(experiment.variants.iter().any(|v| v.id == plan.variant), "{}", experiment.id);
                assert!(plan.families.iter().all(|f| experiment.families.contains(f)), "{}", experiment.id);
                assert!(plan.bound.is_none_or(|model| plan.models.contains(&model)), "{}", experiment.id);
                assert!(
                    !matches!(plan.quantity, Quantity::Time(_)) || experiment.timing.is_some(),
                    "{}",
                    experiment.id
                );
            }
        }
    }
}
