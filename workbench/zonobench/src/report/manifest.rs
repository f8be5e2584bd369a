//! The manifest: what a run was, and the hash of every file that it wrote.

use serde::Serialize;

use crate::digest::sha256;

/// The list of what a finished run wrote.
pub const MANIFEST: &str = "manifest.json";

/// A file of a run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct OutputFile {
    /// Its path in the run's folder, with forward slashes.
    pub path: String,
    /// The SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
    /// Whether the same seed and profile give the same bytes on every machine, with any number of threads.
    pub deterministic: bool,
}

impl OutputFile {
    /// The entry of a file with the given content.
    pub fn new(path: impl Into<String>, content: &[u8], deterministic: bool) -> Self {
        Self { path: path.into(), sha256: sha256(content), deterministic }
    }
}

/// The description of a run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Manifest {
    /// The program's version.
    pub version: String,
    /// The source revision, compiler, build and machine.
    pub environment: experiments::environment::Environment,
    /// The profile.
    pub profile: String,
    /// The master seed.
    pub seed: u64,
    /// The command line that repeats the run.
    pub command: String,
    /// The files, in the order of their paths.
    pub outputs: Vec<OutputFile>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_the_standard_one() {
        let entry = OutputFile::new("a", b"abc", true);
        assert_eq!(entry.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
