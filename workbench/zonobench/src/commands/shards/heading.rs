//! The first line of a shard, which names the work and the program.

use experiments::environment::Environment;
use experiments::sharing::{Shard, ShardError};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::digest::sha256;

/// The first line of a shard.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::commands) struct Heading {
    kind: String,
    pub(super) index: usize,
    pub(super) count: usize,
    /// The version and the hash of the program: another one may find other numbers.
    version: String,
    program: String,
    /// The work, apart from who does it.
    pub(in crate::commands) work: Value,
    /// The number of lines that follow, and the digest of their text: a file that lost or changed some is no shard.
    pub(super) lines: usize,
    pub(super) sha256: String,
}

impl Heading {
    /// The heading of a shard that this program makes.
    pub(in crate::commands) fn new(kind: &str, shard: Shard, work: Value) -> Self {
        let Environment { version, program, .. } = Environment::current();
        let (kind, index, count) = (kind.to_owned(), shard.index(), shard.count());
        Self { kind, index, count, version, program, work, lines: 0, sha256: String::new() }
    }

    /// The heading before some lines, each with its end.
    pub(super) fn before(&self, lines: &str) -> Self {
        Self { lines: lines.lines().count(), sha256: sha256(lines.as_bytes()), ..self.clone() }
    }

    /// The kind of work.
    pub(in crate::commands) fn kind(&self) -> &str {
        &self.kind
    }

    /// The number of the shard among all.
    pub(in crate::commands) fn shard(&self) -> Result<Shard, ShardError> {
        Shard::new(self.index, self.count)
    }

    /// Holds the work of two shards against each other; the error names the first difference.
    pub(in crate::commands) fn check_same(&self, other: &Self) -> Result<(), String> {
        let both = |name: &str, mine: &dyn ToString, others: &dyn ToString| {
            let (mine, others) = (mine.to_string(), others.to_string());
            if mine == others { Ok(()) } else { Err(format!("its {name} is {mine}, not {others}")) }
        };
        both("kind", &self.kind, &other.kind)?;
        both("number of shards", &self.count, &other.count)?;
        both("version", &self.version, &other.version)?;
        both("program", &self.program, &other.program)?;
        let names = |work: &Value| work.as_object().into_iter().flatten().map(|(name, _)| name.clone()).collect();
        let mut all: Vec<String> = names(&self.work);
        all.extend(names(&other.work) as Vec<String>);
        all.iter().try_for_each(|name| both(name, &self.work[name], &other.work[name]))
    }
}
