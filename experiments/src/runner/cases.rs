//! Which cases an experiment has, in the order of the record files.

use crate::data;
use crate::definition::{Case, Experiment, Profile};

/// The cases of `experiment`: real inputs first, then families by size, then variants and instances.
pub fn cases(experiment: &Experiment, profile: Profile, master_seed: u64) -> Vec<Case> {
    let real = experiment.real_inputs.iter().map(|&name| (name, own_size(name).unwrap_or(0), 1));
    let instances = |family| match families::points::find(family) {
        Some(family) if !family.is_random => 1,
        _ => experiment.instances.get(profile),
    };
    let sizes = experiment.sizes.get(profile);
    let is_run = |family: &&str| profile == Profile::Full || !experiment.only_full.contains(family);
    let families = experiment.families.iter().copied().filter(is_run);
    let generated = families.flat_map(|family| sizes.iter().map(move |&n| (family, n, instances(family))));
    let mut cases = Vec::new();
    for (family, n, instances) in real.chain(generated) {
        for variant in experiment.variants.iter().filter(|variant| n <= variant.largest.get(profile)) {
            for instance in 0..instances {
                cases.push(Case::new(master_seed, experiment.id, family, variant.id, n, instance));
            }
        }
    }
    cases
}

/// The number of points of an input that has one instance: a real one or a solid.
pub fn own_size(name: &str) -> Option<usize> {
    data::size(name).or_else(|| families::clouds::solid(name).map(|vertices| vertices.len()))
}

/// The cases that are timed, grouped by input: repetitions of a group's cases are interleaved.
pub fn timed_groups(experiment: &Experiment, profile: Profile, master_seed: u64) -> Vec<Vec<Case>> {
    let Some(timing) = experiment.timing else {
        return Vec::new();
    };
    let sizes = timing.sizes.get(profile);
    let timed = cases(experiment, profile, master_seed).into_iter().filter(|case| {
        case.instance == 0 && (sizes.contains(&case.n) || experiment.real_inputs.contains(&case.family))
    });
    let mut groups: Vec<Vec<Case>> = Vec::new();
    for case in timed {
        match groups.last_mut() {
            Some(group) if group[0].family == case.family && group[0].n == case.n => group.push(case),
            _ => groups.push(vec![case]),
        }
    }
    groups
}
