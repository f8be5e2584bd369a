//! The names of families and of real inputs that an experiment takes, as complaints list them.

use std::collections::BTreeSet;

use experiments::data;
use experiments::definition::Experiment;
use experiments::runner;

/// The inputs of an experiment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sort {
    Points,
    Clouds,
    Lines,
    Bodies,
    Motions,
}

/// The sort of a family or of a real input.
pub(super) fn sort_of(name: &str) -> Option<Sort> {
    if ::families::points::find(name).is_some() || data::points(name).is_some() {
        Some(Sort::Points)
    } else if ::families::lines::find(name).is_some() {
        Some(Sort::Lines)
    } else if ::families::bodies::is_known(name) {
        Some(Sort::Bodies)
    } else if ::families::motions::find(name).is_some() {
        Some(Sort::Motions)
    } else if ::families::clouds::find(name).is_some() || runner::own_size(name).is_some() {
        Some(Sort::Clouds)
    } else {
        None
    }
}

/// Whether an experiment about inputs of some sorts takes those of another one: points of the plane are a cloud.
pub(super) fn takes(sorts: &[Sort], sort: Sort) -> bool {
    sorts.contains(&sort) || (sort == Sort::Points && sorts.contains(&Sort::Clouds))
}

/// The families that an experiment takes: its own, and the others of the same sorts.
pub(super) fn families(base: &Experiment, sorts: &[Sort]) -> Vec<&'static str> {
    let points = ::families::points::FAMILIES.iter().map(|family| family.id);
    let lines = ::families::lines::LINE_FAMILIES.iter().map(|family| family.id);
    let clouds = ::families::clouds::CLOUD_FAMILIES.iter().map(|family| family.id);
    let is_taken = |name: &&str| sort_of(name).is_some_and(|sort| takes(sorts, sort));
    let mut all = base.families.to_vec();
    all.extend(points.chain(lines).chain(clouds).filter(is_taken));
    let mut seen = BTreeSet::new();
    all.retain(|name| seen.insert(*name));
    all
}

/// The real inputs that an experiment about inputs of these sorts takes.
pub(super) fn inputs(sorts: &[Sort]) -> Vec<&'static str> {
    let outlines = data::outlines().iter().map(|outline| outline.name);
    let meshes = data::meshes().iter().map(|mesh| mesh.name);
    let solids = ::families::clouds::SOLIDS.iter().map(|solid| solid.name);
    let all = outlines.chain(["airports"]).chain(meshes).chain(solids);
    let is_input = |name: &&str| runner::own_size(name).is_some();
    all.filter(is_input).filter(|name| sort_of(name).is_some_and(|sort| takes(sorts, sort))).collect()
}
