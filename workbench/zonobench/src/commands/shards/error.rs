//! Faults of shards.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::output::OutputError;

/// Why shards are not written or read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ShardsError {
    /// A file or a folder cannot be read.
    #[error("{}: cannot be read", .path.display())]
    Unreadable {
        /// The file or folder.
        path: PathBuf,
        /// The system's complaint.
        source: io::Error,
    },
    /// A file has the name of a shard but not its content.
    #[error("{}: is no shard: {reason}", .file.display())]
    NoShard {
        /// The file.
        file: PathBuf,
        /// The fault.
        reason: String,
    },
    /// A shard, or what is kept while one is made, belongs to other work than this run, or to another program.
    #[error("{}: belongs to another run than the one asked for: {difference}", .path.display())]
    Foreign {
        /// The file, or the folder of an interrupted shard.
        path: PathBuf,
        /// The first thing in which they differ.
        difference: String,
    },
    /// Shards of several runs, or of several programs, lie together. None of them is said to be the wrong one.
    #[error("the shards are of {} runs: {}", .runs.len(), .runs.join("; "))]
    Mixed {
        /// Each run with its number of shards, one of them, and what tells it from the first.
        runs: Vec<String>,
    },
    /// A shard is there twice.
    #[error("{} and {}: are the same shard", .files[0].display(), .files[1].display())]
    Twice {
        /// The files.
        files: [PathBuf; 2],
    },
    /// Folders hold no shards.
    #[error("{}: no shard is there", listed(.0))]
    None(Vec<PathBuf>),
    /// Shards are missing.
    #[error("{missing} missing: {names}")]
    Missing {
        /// Their number in words.
        missing: String,
        /// The first of them.
        names: String,
    },
    /// A shard cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

fn listed(folders: &[PathBuf]) -> String {
    folders.iter().map(|folder| folder.display().to_string()).collect::<Vec<_>>().join(", ")
}
