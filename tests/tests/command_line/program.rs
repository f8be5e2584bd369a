//! The program, and folders for it to work in.

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use tempfile::TempDir;

pub(crate) fn zonobench() -> Command {
    Command::new(env!("CARGO_BIN_EXE_zonobench_under_test"))
}

pub(crate) fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// The file names in a folder, in order.
pub(crate) fn contents(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("a listed file").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

pub(crate) fn written(folder: &TempDir, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
    let file = folder.path().join(name);
    fs::write(&file, content).expect("the input is written");
    file
}

/// The output of a command that succeeds.
pub(crate) fn output(command: &mut Command) -> String {
    String::from_utf8(command.assert().success().get_output().stdout.clone()).expect("the output is text")
}
