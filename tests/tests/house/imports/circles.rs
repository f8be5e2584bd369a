//! Circles of a graph of imports, between files or between the rooms of a folder.

use std::collections::{BTreeMap, BTreeSet};

use super::graph::Module;

/// For each file, or each room, those that it rests on.
pub type Graph = BTreeMap<Module, BTreeSet<Module>>;

/// The members of each circle.
pub fn circles(uses: &Graph) -> Vec<Vec<Module>> {
    let reached: BTreeMap<&Module, BTreeSet<&Module>> =
        uses.keys().map(|start| (start, reachable(start, uses))).collect();
    let mut found: Vec<Vec<Module>> = Vec::new();
    for (start, ends) in &reached {
        if ends.contains(start) && !found.iter().flatten().any(|seen| seen == *start) {
            let circle = ends.iter().filter(|end| reached.get(*end).is_some_and(|back| back.contains(start)));
            found.push(circle.map(|member| (*member).clone()).collect());
        }
    }
    found
}

/// The files or rooms that one imports, directly or through others.
fn reachable<'a>(start: &Module, uses: &'a Graph) -> BTreeSet<&'a Module> {
    let mut found = BTreeSet::new();
    let mut fresh: Vec<&Module> = uses.get(start).into_iter().flatten().collect();
    while let Some(next) = fresh.pop() {
        if found.insert(next) {
            fresh.extend(uses.get(next).into_iter().flatten());
        }
    }
    found
}

/// The graph of the rooms of a folder, files and folders side by side, from that of the files.
pub fn rooms(uses: &Graph, folder: &[String]) -> Graph {
    let room = |module: &Module| {
        (module.len() > folder.len() && module.starts_with(folder)).then(|| module[..=folder.len()].to_vec())
    };
    let mut rooms = Graph::new();
    for (own, others) in uses {
        let Some(own) = room(own) else { continue };
        let others = others.iter().filter_map(room).filter(|other| *other != own);
        rooms.entry(own.clone()).or_default().extend(others.collect::<Vec<_>>());
    }
    rooms
}

/// The folders of a crate.
pub fn folders(uses: &Graph) -> BTreeSet<Module> {
    uses.keys().flat_map(|module| (0..module.len()).map(|length| module[..length].to_vec())).collect()
}
