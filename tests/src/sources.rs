//! The workspace as files: where its crates are, and the texts in them.

use std::path::{Path, PathBuf};

/// The folder of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("this crate is a folder of the workspace").to_path_buf()
}

/// A text file of the workspace.
#[derive(Debug)]
pub struct Source {
    /// The path from the workspace's folder, with forward slashes.
    pub path: String,
    /// The text of the file.
    pub text: String,
}

impl Source {
    /// The file's name without its folder.
    pub fn name(&self) -> &str {
        self.path.rsplit('/').next().unwrap_or(&self.path)
    }

    /// Whether the file holds only tests.
    pub fn is_test(&self) -> bool {
        self.path.contains("/tests/") || self.name() == "tests.rs"
    }

    /// The text up to the first unit test module.
    pub fn without_unit_tests(&self) -> &str {
        self.text.split("#[cfg(test)]\nmod tests {").next().unwrap_or(&self.text)
    }

    /// The lines that are neither comments nor documentation, with their numbers from 1.
    pub fn code_lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let is_code = |line: &str| !line.trim_start().starts_with("//");
        self.without_unit_tests()
            .lines()
            .enumerate()
            .filter(move |(_, line)| is_code(line))
            .map(|(index, line)| (index + 1, line))
    }
}

/// The files below `folder` (from the workspace's folder) whose names end in one of `endings`, in order of path.
///
/// Build output, version control and what others wrote are left out.
pub fn files(folder: &str, endings: &[&str]) -> Vec<Source> {
    let mut found = Vec::new();
    collect(&root(), &root().join(folder), endings, &mut found);
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

/// The folders whose files are no sources.
const LEFT_OUT: [&str; 5] = [".git", "target", "proptest-regressions", "node_modules", "dist"];

fn collect(root: &Path, folder: &Path, endings: &[&str], found: &mut Vec<Source>) {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for entry in entries {
        let path = entry.expect("a listed file exists").path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if path.is_dir() {
            if !LEFT_OUT.contains(&name) {
                collect(root, &path, endings, found);
            }
        } else if endings.iter().any(|ending| name.ends_with(ending)) {
            let relative = path.strip_prefix(root).expect("the file is below the folder");
            found.push(Source {
                path: relative.to_string_lossy().replace('\\', "/"),
                text: std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())),
            });
        }
    }
}

/// The folder of the library's sources.
pub const LIBRARY: &str = "workbench/zonotope/src";

/// The folder of the source files of the interface of questions and answers.
pub const BATCH: &str = "workbench/batch/src";

/// The folder of the source files of the verifier.
pub const VERIFIER: &str = "workbench/verifier/src";
