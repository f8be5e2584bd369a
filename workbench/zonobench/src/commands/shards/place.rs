//! The place of a shard, where it appears whole.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use experiments::sharing::Shard;

use super::error::ShardsError;
use super::heading::Heading;
use super::reading::Part;
use crate::output::{Existing, write_whole};

/// The file that says for which work a folder is kept.
const MARK: &str = "work.json";

/// The place of a shard in a folder.
#[derive(Debug)]
pub(in crate::commands) struct Place {
    folder: PathBuf,
    name: String,
}

impl Place {
    /// The place of a shard of some kind of work.
    pub(in crate::commands) fn new(folder: &Path, kind: &str, shard: Shard) -> Self {
        let name = format!("{kind}.{}-of-{}", shard.index(), shard.count());
        Self { folder: folder.to_path_buf(), name }
    }

    /// The file of the shard.
    pub(in crate::commands) fn file(&self) -> PathBuf {
        self.folder.join(format!("{}.shard", self.name))
    }

    /// The folder for what is kept while the shard is made.
    pub(in crate::commands) fn scratch(&self) -> PathBuf {
        self.folder.join(format!("{}.unfinished", self.name))
    }

    /// Whether the shard is there.
    ///
    /// # Errors
    /// If what is there is no whole shard, or that of other work.
    pub(in crate::commands) fn is_written(&self, heading: &Heading) -> Result<bool, ShardsError> {
        let found = match Part::read(self.file()) {
            Ok(part) => part.heading,
            Err(ShardsError::Unreadable { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
                return Ok(false);
            }
            Err(error) => return Err(error),
        };
        let foreign = |difference| ShardsError::Foreign { path: self.file(), difference };
        found.check_same(heading).map(|()| true).map_err(foreign)
    }

    /// Marks the folder for what is kept as that of some work.
    ///
    /// # Errors
    /// If an interrupted run of other work is there: what it has done is not given up without a word.
    pub(in crate::commands) fn begin(&self, heading: &Heading, force: bool) -> Result<(), ShardsError> {
        let (folder, mark) = (self.scratch(), self.scratch().join(MARK));
        let found = fs::read(&mark).ok().and_then(|text| serde_json::from_slice::<Heading>(&text).ok());
        if let Some(found) = found.filter(|_| !force) {
            return found.check_same(heading).map_err(|difference| ShardsError::Foreign { path: folder, difference });
        }
        let text = serde_json::json!(heading).to_string();
        Ok(write_whole(&mark, text.as_bytes(), Existing::Replace)?)
    }

    /// Writes the shard whole.
    pub(in crate::commands) fn write(&self, heading: &Heading, lines: &[String]) -> Result<(), ShardsError> {
        let mut text = String::new();
        for line in lines {
            text.push_str(line);
            text.push('\n');
        }
        let content = serde_json::json!(heading.before(&text)).to_string() + "\n" + &text;
        write_whole(&self.file(), content.as_bytes(), Existing::Replace)?;
        // A new name is on the disk when its folder is; where a folder cannot be told to, the system does so in time.
        let _ = File::open(&self.folder).and_then(|folder| folder.sync_all());
        Ok(())
    }
}
