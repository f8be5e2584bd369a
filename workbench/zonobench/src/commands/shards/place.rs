//! The place of a shard, where it appears whole.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use experiments::sharing::Shard;

use super::error::ShardsError;
use super::heading::Heading;
use crate::output::{Existing, write_whole};

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
    /// If what is there is no shard, or that of other work.
    pub(in crate::commands) fn is_written(&self, heading: &Heading) -> Result<bool, ShardsError> {
        let file = self.file();
        let opened = match File::open(&file) {
            Ok(opened) => opened,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(false),
            Err(source) => return Err(ShardsError::Unreadable { path: file, source }),
        };
        let mut line = String::new();
        let read = BufReader::new(opened).read_line(&mut line);
        read.map_err(|source| ShardsError::Unreadable { path: file.clone(), source })?;
        let found: Heading = serde_json::from_str(&line)
            .map_err(|error| ShardsError::NoShard { file: file.clone(), reason: error.to_string() })?;
        match found.check_same(heading) {
            Ok(()) => Ok(true),
            Err(difference) => Err(ShardsError::Foreign { file, other: "the one asked for".into(), difference }),
        }
    }

    /// Writes the shard whole.
    pub(in crate::commands) fn write(&self, heading: &Heading, lines: &[String]) -> Result<(), ShardsError> {
        let heading = serde_json::json!(heading.before(lines.len())).to_string();
        let mut content = heading + "\n";
        for line in lines {
            content.push_str(line);
            content.push('\n');
        }
        write_whole(&self.file(), content.as_bytes(), Existing::Replace)?;
        // A new name is on the disk when its folder is; where a folder cannot be told to, the system does so in time.
        let _ = File::open(&self.folder).and_then(|folder| folder.sync_all());
        Ok(())
    }
}
