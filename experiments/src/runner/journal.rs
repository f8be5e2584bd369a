//! Files that survive a kill: an append-only journal while a run lasts, and whole files under their final names
//! afterwards.
//!
//! A journal is JSON Lines: a header that names the run, then one row a line. A kill can tear the last line; opening
//! the journal again drops everything from the first unreadable line on and continues behind it. A journal with another
//! header belongs to another run and is started anew.

use serde::{Serialize, de::DeserializeOwned};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// An open journal. Rows may be appended from several threads.
#[derive(Debug)]
pub(super) struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

impl Journal {
    /// Opens the journal at `path` for the run named by `header`, and returns the rows it already holds.
    pub fn open<Row: DeserializeOwned>(path: PathBuf, header: &str) -> io::Result<(Self, Vec<Row>)> {
        let text = match fs::read(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => Vec::new(),
            Err(error) => return Err(named(&path)(error)),
        };
        let (rows, kept) = readable_rows(&text, header);
        let begun = || {
            let mut file = OpenOptions::new().create(true).truncate(false).write(true).open(&path)?;
            file.set_len(kept as u64)?;
            io::Seek::seek(&mut file, io::SeekFrom::End(0))?;
            if kept == 0 {
                file.write_all(format!("{header}\n").as_bytes())?;
            }
            Ok(file)
        };
        let file = begun().map_err(named(&path))?;
        Ok((Self { path, file: Mutex::new(file) }, rows))
    }

    /// Appends rows with a single write.
    pub fn append<Row: Serialize>(&self, rows: &[Row]) -> io::Result<()> {
        let text = json_lines(rows)?;
        let mut file = self.file.lock().map_err(|_| io::Error::other("another thread failed while it wrote"))?;
        file.write_all(text.as_bytes()).map_err(named(&self.path))
    }

    /// Removes the journal: its rows are in a final file now.
    pub fn remove(self) -> io::Result<()> {
        fs::remove_file(&self.path).map_err(named(&self.path))
    }
}

/// The complete, readable rows under the right header, and the length of the text that holds them.
fn readable_rows<Row: DeserializeOwned>(text: &[u8], header: &str) -> (Vec<Row>, usize) {
    let mut lines = text.split_inclusive(|&byte| byte == b'\n');
    let Some(first) = lines.next().filter(|line| line.strip_suffix(b"\n") == Some(header.as_bytes())) else {
        return (Vec::new(), 0);
    };
    let mut rows = Vec::new();
    let mut kept = first.len();
    for line in lines {
        let Some(row) = line.strip_suffix(b"\n").and_then(|line| serde_json::from_slice(line).ok()) else {
            break;
        };
        rows.push(row);
        kept += line.len();
    }
    (rows, kept)
}

/// One JSON value a line.
pub(super) fn json_lines<Row: Serialize>(rows: &[Row]) -> io::Result<String> {
    let mut text = String::new();
    for row in rows {
        text.push_str(&serde_json::to_string(row)?);
        text.push('\n');
    }
    Ok(text)
}

/// Writes a whole file so that its final name never shows a part of it.
pub(super) fn write_atomically(path: &Path, text: &str) -> io::Result<()> {
    let mut temporary = path.as_os_str().to_owned();
    temporary.push(".new.partial");
    let temporary = PathBuf::from(temporary);
    let write = || {
        let mut file = File::create(&temporary)?;
        file.write_all(text.as_bytes())?;
        file.sync_all()?;
        fs::rename(&temporary, path)
    };
    write().map_err(named(path))
}

/// A complaint of the same kind that names the file within its directory.
fn named(path: &Path) -> impl FnOnce(io::Error) -> io::Error {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    move |error| io::Error::new(error.kind(), format!("{name}: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_torn_last_line_is_dropped_and_written_again() {
        let directory = tempfile::tempdir().expect("a temporary directory");
        let path = directory.path().join("rows.partial");
        let (journal, rows) = Journal::open::<u32>(path.clone(), "\"run 1\"").expect("a new file");
        assert!(rows.is_empty());
        journal.append(&[10, 11]).expect("room");
        drop(journal);
        fs::write(&path, "\"run 1\"\n10\n11\n1").expect("room");

        let (journal, rows) = Journal::open::<u32>(path.clone(), "\"run 1\"").expect("readable");
        assert_eq!(rows, [10, 11]);
        journal.append(&[12]).expect("room");
        assert_eq!(fs::read_to_string(&path).expect("readable"), "\"run 1\"\n10\n11\n12\n");
        journal.remove().expect("it exists");
        assert!(!path.exists());
    }

    #[test]
    fn a_header_of_another_run_or_a_torn_header_starts_anew() {
        let directory = tempfile::tempdir().expect("a temporary directory");
        let path = directory.path().join("rows.partial");
        for text in ["\"run 1\"\n10\n11\n", "\"run", ""] {
            fs::write(&path, text).expect("room");
            let (_, rows) = Journal::open::<u32>(path.clone(), "\"run 2\"").expect("readable");
            assert!(rows.is_empty());
            assert_eq!(fs::read_to_string(&path).expect("readable"), "\"run 2\"\n");
        }
    }

    #[test]
    fn everything_behind_an_unreadable_line_is_dropped() {
        let directory = tempfile::tempdir().expect("a temporary directory");
        let path = directory.path().join("rows.partial");
        fs::write(&path, "\"run\"\n1\n{{\n3\n").expect("room");
        let (_, rows) = Journal::open::<u32>(path.clone(), "\"run\"").expect("readable");
        assert_eq!(rows, [1]);
        assert_eq!(fs::read_to_string(&path).expect("readable"), "\"run\"\n1\n");
    }
}
