//! The shards in folders, all of one piece of work.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::error::ShardsError;
use super::heading::Heading;
use crate::digest::sha256;

/// The most missing shards that a complaint names.
const NAMED_LIMIT: usize = 8;

/// A shard that was read.
#[derive(Debug)]
pub(in crate::commands) struct Part {
    pub(in crate::commands) file: PathBuf,
    pub(in crate::commands) heading: Heading,
    content: String,
}

impl Part {
    /// The lines behind the heading.
    pub(in crate::commands) fn lines(&self) -> impl Iterator<Item = &str> {
        self.content.lines().skip(1)
    }

    pub(super) fn read(file: PathBuf) -> Result<Self, ShardsError> {
        let no_shard = |reason: String| ShardsError::NoShard { file: file.clone(), reason };
        let content = fs::read(&file).map_err(|source| ShardsError::Unreadable { path: file.clone(), source })?;
        let content = String::from_utf8(content).map_err(|error| no_shard(error.to_string()))?;
        let heading: Heading = serde_json::from_str(content.lines().next().unwrap_or_default())
            .map_err(|error| no_shard(format!("its first line is no heading: {error}")))?;
        heading.shard().map_err(|error| no_shard(error.to_string()))?;
        let lines = content.lines().count() - 1;
        if lines != heading.lines || !content.ends_with('\n') {
            return Err(no_shard(format!("{lines} whole lines follow its heading, not {}", heading.lines)));
        }
        let text = content.split_once('\n').map_or("", |(_, text)| text);
        if sha256(text.as_bytes()) != heading.sha256 {
            return Err(no_shard("its lines are not those that were written".to_owned()));
        }
        Ok(Self { file, heading, content })
    }
}

/// All shards in the folders, in their order.
///
/// # Errors
/// If a shard is missing or is there twice, or if they belong to several works; each is named.
pub(in crate::commands) fn read(folders: &[PathBuf]) -> Result<Vec<Part>, ShardsError> {
    let mut files = Vec::new();
    for folder in folders {
        files.extend(shards_in(folder)?);
    }
    let mut runs: Vec<Vec<Part>> = Vec::new();
    for file in files {
        let part = Part::read(file)?;
        match runs.iter_mut().find(|run| run[0].heading.check_same(&part.heading).is_ok()) {
            Some(run) => run.push(part),
            None => runs.push(vec![part]),
        }
    }
    if runs.len() > 1 {
        return Err(mixed(runs));
    }
    let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
    for part in runs.into_iter().flatten() {
        if let Some(earlier) = parts.get(&part.heading.index) {
            return Err(ShardsError::Twice { files: [earlier.file.clone(), part.file] });
        }
        parts.insert(part.heading.index, part);
    }
    let Some(heading) = parts.values().next().map(|part| part.heading.clone()) else {
        return Err(ShardsError::None(folders.to_vec()));
    };
    let missing: Vec<usize> = (0..heading.count).filter(|index| !parts.contains_key(index)).collect();
    if missing.is_empty() {
        return Ok(parts.into_values().collect());
    }
    let name = |index: &usize| format!("{index}/{}", heading.count);
    let mut names = missing.iter().take(NAMED_LIMIT).map(name).collect::<Vec<_>>().join(", ");
    if missing.len() > NAMED_LIMIT {
        names.push_str(", …");
    }
    let missing = match missing.len() {
        1 => "1 shard is".to_owned(),
        many => format!("{many} shards are"),
    };
    Err(ShardsError::Missing { missing, names })
}

/// The complaint about shards of several runs, the largest first.
fn mixed(mut runs: Vec<Vec<Part>>) -> ShardsError {
    runs.sort_by_key(|run| std::cmp::Reverse(run.len()));
    let first = runs[0][0].heading.clone();
    let told = |run: &Vec<Part>| {
        let known = format!("{} as {}", run.len(), run[0].file.display());
        match run[0].heading.check_same(&first) {
            Ok(()) => known,
            Err(difference) => format!("{known}: {difference}"),
        }
    };
    ShardsError::Mixed { runs: runs.iter().map(told).collect() }
}

/// The files of a folder that have the name of a shard, in the order of their names.
fn shards_in(folder: &Path) -> Result<Vec<PathBuf>, ShardsError> {
    let unreadable = |source| ShardsError::Unreadable { path: folder.to_path_buf(), source };
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let file = entry.map_err(unreadable)?.path();
        if file.extension().is_some_and(|extension| extension == "shard") {
            files.push(file);
        }
    }
    files.sort();
    Ok(files)
}
