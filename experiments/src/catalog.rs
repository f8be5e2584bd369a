//! The list of experiments. Adding one is one file in [`definitions`](crate::definitions) and one entry here.

use crate::definition::Experiment;
use crate::definitions::{
    area_ratio, coherence, collision_scaling, directions_scaling, enclosing_quality, faces_scaling, fallback_rate,
    few_generators, gap_curve, gauge_passes, hierarchy_levels, hull_scaling, lad_race, lad_scaling, least_volume,
    length_ratio, mesh_node_tests, methods_agree, min_area_scaling, min_area_stages, motion_clearance, motion_misses,
    net_points, net_scaling, patches_error, patches_scaling, points_scaling, pruning_passes, query_growth,
    query_trade_off, reduction_error, rung_shares, scan_race, slope_selection_scaling, swept_volumes, tree_queries,
    walk_steps, wrong_answers,
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
    net_scaling::PLANE,
    net_scaling::SPACE,
    net_points::EXPERIMENT,
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
    query_growth::EXPERIMENT,
    tree_queries::EXPERIMENT,
    reduction_error::EXPERIMENT,
    patches_error::EXPERIMENT,
    patches_scaling::EXPERIMENT,
    hierarchy_levels::EXPERIMENT,
    walk_steps::EXPERIMENT,
    coherence::EXPERIMENT,
    swept_volumes::OPERATIONS,
    swept_volumes::EXCESS,
    motion_clearance::GROWTH,
    motion_clearance::STRENGTH,
    motion_misses::EXPERIMENT,
    mesh_node_tests::COUNTS,
    mesh_node_tests::TIMES,
    least_volume::EXPERIMENT,
];

/// The experiment called `id`, if there is one.
pub fn find(id: &str) -> Option<&'static Experiment> {
    EXPERIMENTS.iter().find(|experiment| experiment.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::{Case, Profile, Quantity};
    use crate::fit::{LAST_DOUBLINGS, SIZES_OF_LAST_DOUBLINGS};
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
                let found = families::points::find(id).is_some()
                    || families::lines::find(id).is_some()
                    || families::bodies::is_known(id)
                    || families::clouds::find(id).is_some()
                    || families::motions::find(id).is_some()
                    || crate::hierarchies::mesh(id).is_ok();
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

    /// The experiments with laws whose sizes cost too much for four doublings.
    const SHORTER: [&str; 1] = ["directions-scaling"];

    /// The experiments whose sizes are no powers of two, and leave a little less than four doublings to the second fit.
    const UNEVEN: [&str; 2] = ["patches-error", "motion-clearance"];

    #[test]
    fn laws_of_counts_have_five_sizes_over_their_last_four_doublings() {
        for experiment in EXPERIMENTS.iter().filter(|experiment| !SHORTER.contains(&experiment.id)) {
            for plan in experiment.fits.iter().filter(|plan| !matches!(plan.quantity, Quantity::Time(_))) {
                let variant = experiment.variants.iter().find(|variant| variant.id == plan.variant);
                for profile in PROFILES {
                    let largest = variant.expect("it is among the variants").largest.get(profile);
                    let all = experiment.sizes.get(profile).iter().copied();
                    let sizes: Vec<usize> = all.filter(|n| (plan.smallest..=largest).contains(n)).collect();
                    let [first, last] = [sizes[0], sizes[sizes.len() - 1]];
                    let second: Vec<usize> = sizes.iter().copied().filter(|n| n << LAST_DOUBLINGS >= last).collect();
                    let doublings = LAST_DOUBLINGS - i32::from(UNEVEN.contains(&experiment.id));
                    let is_long = first << LAST_DOUBLINGS <= last
                        && second[0] << doublings <= last
                        && second.len() >= SIZES_OF_LAST_DOUBLINGS;
                    assert!(is_long, "{}: {} of {} in {profile}", experiment.id, plan.quantity, plan.variant);
                }
            }
        }
    }

    /// A quantity of zeros has no law, and the bound would be judged by nothing.
    #[test]
    fn what_has_a_bound_is_measured() {
        for experiment in EXPERIMENTS {
            for plan in experiment.fits.iter().filter(|plan| plan.bound.is_some()) {
                if matches!(plan.quantity, Quantity::Time(_)) {
                    continue;
                }
                let n = experiment.sizes.get(Profile::Quick).iter().copied().find(|&n| n >= plan.smallest);
                let case = Case::new(1, experiment.id, plan.families[0], plan.variant, n.expect("a size"), 0);
                let measured = (experiment.measure)(&case).expect("the smallest case is measured");
                let value = match plan.quantity {
                    Quantity::AllCounts => measured.counts.values().sum::<u64>() as f64,
                    Quantity::Count(name) => measured.counts[name] as f64,
                    Quantity::Value(name) | Quantity::Time(name) => measured.values[name],
                };
                assert!(value > 0.0, "{}: {} of {} is {value}", experiment.id, plan.quantity, plan.variant);
            }
        }
    }

    #[test]
    fn what_cannot_grow_slower_is_compared_with_that() {
        for experiment in EXPERIMENTS {
            for plan in experiment.fits {
                assert!(plan.floor.is_none_or(|model| plan.models.contains(&model)), "{}", experiment.id);
            }
        }
    }

    #[test]
    fn fits_ask_for_what_exists() {
        for experiment in EXPERIMENTS {
            for plan in experiment.fits {
                assert!(experiment.variants.iter().any(|v| v.id == plan.variant), "{}", experiment.id);
                assert!(plan.families.iter().all(|f| experiment.families.contains(f)), "{}", experiment.id);
                assert!(plan.bound.is_none_or(|bound| plan.models.contains(&bound.model)), "{}", experiment.id);
                assert!(
                    !matches!(plan.quantity, Quantity::Time(_)) || experiment.timing.is_some(),
                    "{}",
                    experiment.id
                );
            }
        }
    }
}
