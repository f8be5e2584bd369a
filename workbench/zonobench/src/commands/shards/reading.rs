//! The shards in folders, all of one piece of work.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::error::ShardsError;
use super::heading::Heading;

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

    fn read(file: PathBuf) -> Result<Self, ShardsError> {
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
        Ok(Self { file, heading, content })
    }
}

/// All shards in the folders, in their order.
///
/// # Errors
/// If a shard is missing, is there twice, or belongs to other work than the first one; each is named.
pub(in crate::commands) fn read(folders: &[PathBuf]) -> Result<Vec<Part>, ShardsError> {
    let mut files = Vec::new();
    for folder in folders {
        files.extend(shards_in(folder)?);
    }
    let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
    let mut first: Option<(PathBuf, Heading)> = None;
    for file in files {
        let part = Part::read(file)?;
        let (other, heading) = first.get_or_insert_with(|| (part.file.clone(), part.heading.clone()));
        if let Err(difference) = part.heading.check_same(heading) {
            return Err(ShardsError::Foreign { file: part.file, other: other.clone(), difference });
        }
        if let Some(earlier) = parts.get(&part.heading.index) {
            return Err(ShardsError::Twice { files: [earlier.file.clone(), part.file] });
        }
        parts.insert(part.heading.index, part);
    }
    let Some((_, heading)) = first else {
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
