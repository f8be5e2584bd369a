//! The environment of a run, which is recorded beside every time: machine, system, compiler, source revision.

use crate::seed::Digest;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::process::Command;

/// Overrides the source revision, for builds away from their repository.
pub const REVISION_VARIABLE: &str = "ZONOBENCH_REVISION";

/// Everything about the machine and the build that a time depends on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Environment {
    /// The version of this package.
    pub version: String,
    /// Source revision at the time of the run, with `-dirty` for a changed tree; `unknown` without a repository.
    pub revision: String,
    /// The compiler with its version.
    pub toolchain: String,
    /// Target triple, optimisation level and extra compiler flags.
    pub build: String,
    /// Hash of the running program: two builds of one revision differ here when their code does.
    pub program: String,
    /// The model of the processor.
    pub cpu: String,
    /// Logical processors available to the process.
    pub processors: usize,
    /// Operating system and architecture.
    pub system: String,
    /// The name of the machine; empty where it is of no interest.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub host: String,
}

impl Environment {
    /// The environment of the running process.
    pub fn current() -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            revision: revision(),
            toolchain: env!("EXPERIMENTS_TOOLCHAIN").to_owned(),
            build: env!("EXPERIMENTS_BUILD").to_owned(),
            program: program_hash(),
            cpu: cpu_model(),
            processors: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            host: std::fs::read_to_string("/proc/sys/kernel/hostname")
                .map_or_else(|_| String::new(), |name| name.trim().to_owned()),
        }
    }

    /// A short name by which the rows of times refer to the environment: of the program and the machine. The revision
    /// has no part in it, since it is that of the source when the program ran, and may be another one than was built.
    pub fn id(&self) -> String {
        let text = format!("{:?}", Self { revision: String::new(), ..self.clone() });
        format!("{:016x}", Digest::default().bytes(text.as_bytes()).finish())
    }
}

fn revision() -> String {
    if let Ok(revision) = std::env::var(REVISION_VARIABLE) {
        return revision;
    }
    let source = Path::new(env!("CARGO_MANIFEST_DIR"));
    Command::new("git")
        .arg("-C")
        .arg(source)
        .args(["describe", "--always", "--dirty", "--abbrev=40", "--exclude=*"])
        .output()
        .ok()
        .filter(|output| output.status.success())
        .map_or_else(|| "unknown".to_owned(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

fn program_hash() -> String {
    std::env::current_exe()
        .and_then(std::fs::read)
        .map_or_else(|_| "unknown".to_owned(), |bytes| format!("{:016x}", Digest::default().bytes(&bytes).finish()))
}

fn cpu_model() -> String {
    std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split_once(':')?.1.trim().to_owned())
        })
        .unwrap_or_else(|| "unknown".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_is_that_of_the_program_and_the_machine() {
        let here = Environment::current();
        let renamed = |change: fn(&mut Environment)| {
            let mut other = here.clone();
            change(&mut other);
            other.id() != here.id()
        };
        assert!(!renamed(|other| other.revision.push_str("-dirty")));
        assert!(renamed(|other| other.program.push('0')));
        assert!(renamed(|other| other.cpu.push('0')));
    }
}
