//! The folder that a run writes into: one run at a time has it, and a finished one is kept.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::report::{MANIFEST, OutputFile};

/// Stands in the folder while a run is not finished; the run holds a lock on it.
const UNFINISHED: &str = "reproduce.unfinished";
/// The folder of the raw records within that of the run.
pub(super) const RECORDS: &str = "records";

/// Why a run does not get its folder.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FolderError {
    /// The folder holds something that no interrupted run has left behind.
    #[error("{}: is not empty; --force writes into it, --out names another folder", .0.display())]
    NotEmpty(PathBuf),
    /// Another run writes into the folder.
    #[error(
        "{}: another run writes into it; wait until it ends, or name another folder by --out (a run that died no \
         longer counts: the same command takes over its folder)",
        .0.display()
    )]
    InUse(PathBuf),
    /// The system knows no lock of a file there, so that two runs could write into one folder.
    #[error("{}: cannot be locked, as files on some network file systems cannot: {source}", .path.display())]
    Unlocked {
        /// The file.
        path: PathBuf,
        /// The system's complaint.
        source: io::Error,
    },
    /// The folder, or a file in it, cannot be made, read or removed.
    #[error("{}: cannot be used: {source}", .path.display())]
    Unusable {
        /// The folder or the file.
        path: PathBuf,
        /// The system's complaint.
        source: io::Error,
    },
}

/// The folder of a run.
#[derive(Debug)]
pub(super) struct Folder {
    path: PathBuf,
    /// The file that stands for the unfinished run. The system gives up its lock with the process, however that ends.
    _lock: File,
}

impl Folder {
    /// Takes the folder for this run: a new or empty one, one that an interrupted run has left behind, or any one by
    /// force. One that another run writes into is refused in any case.
    pub(super) fn claim(path: &Path, force: bool) -> Result<Self, FolderError> {
        fs::create_dir_all(path).map_err(unusable(path))?;
        let is_empty = fs::read_dir(path).map_err(unusable(path))?.next().is_none();
        let unfinished = path.join(UNFINISHED);
        if !force && !is_empty && !unfinished.exists() {
            return Err(FolderError::NotEmpty(path.to_path_buf()));
        }
        let lock = File::options().create(true).append(true).open(&unfinished).map_err(unusable(&unfinished))?;
        match lock.try_lock() {
            // A run that ended just now has taken the file away: its folder is finished.
            Ok(()) if unfinished.exists() => {}
            Ok(()) | Err(TryLockError::WouldBlock) => return Err(FolderError::InUse(path.to_path_buf())),
            Err(TryLockError::Error(source)) => return Err(FolderError::Unlocked { path: unfinished, source }),
        }
        // A folder that has a manifest is complete: from here on it is not.
        let manifest = path.join(MANIFEST);
        match fs::remove_file(&manifest) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(unusable(&manifest)(error)),
            _ => {}
        }
        Ok(Self { path: path.to_path_buf(), _lock: lock })
    }

    /// The folder of the raw records.
    pub(super) fn records(&self) -> PathBuf {
        self.path.join(RECORDS)
    }

    /// The files that the runner wrote.
    pub(super) fn record_files(&self) -> Result<Vec<OutputFile>, FolderError> {
        [("counts.jsonl", true), ("times.jsonl", false), ("environment.json", false)]
            .into_iter()
            .map(|(name, deterministic)| {
                let path = format!("{RECORDS}/{name}");
                let file = self.path.join(&path);
                let content = fs::read(&file).map_err(unusable(&file))?;
                Ok(OutputFile::new(path, &content, deterministic))
            })
            .collect()
    }

    /// The run is complete.
    pub(super) fn release(self) -> Result<(), FolderError> {
        let unfinished = self.path.join(UNFINISHED);
        fs::remove_file(&unfinished).map_err(unusable(&unfinished))
    }
}

fn unusable(path: &Path) -> impl FnOnce(io::Error) -> FolderError {
    let path = path.to_path_buf();
    |source| FolderError::Unusable { path, source }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_one_run_at_a_time() {
        let parent = tempfile::tempdir().expect("a temporary folder");
        let path = parent.path().join("run");
        let first = Folder::claim(&path, false).expect("a new folder");
        for force in [false, true] {
            let refused = Folder::claim(&path, force).expect_err("the first run has it");
            assert!(matches!(refused, FolderError::InUse(folder) if folder == path), "with force: {force}");
        }
        drop(first);
        assert!(path.join(UNFINISHED).exists(), "a run that dies leaves its mark");
        let second = Folder::claim(&path, false).expect("the same command goes on");
        fs::write(path.join(MANIFEST), "{}").expect("written");
        second.release().expect("the run is complete");
        assert!(!path.join(UNFINISHED).exists());
        assert!(matches!(Folder::claim(&path, false), Err(FolderError::NotEmpty(_))));
        drop(Folder::claim(&path, true).expect("by force"));
        assert!(!path.join(MANIFEST).exists(), "a folder that is written into is not complete");
    }
}
