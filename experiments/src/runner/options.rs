//! The options of a run, who hears how it proceeds, and the guard of its work.

use crate::definition::Profile;
use crate::sharing::Shard;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

/// The options of a run.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// The profile.
    pub profile: Profile,
    /// Master seed: every other seed is derived from it.
    pub seed: u64,
    /// Threads for counting; 0 for all processors. Timing always uses one.
    pub threads: usize,
    /// The folder of the records; nothing is written without it.
    pub directory: Option<PathBuf>,
    /// Whether to time after counting.
    pub times: bool,
    /// A name for the content of inputs that are not part of the program; empty without any. Rows that a run with other
    /// inputs has left behind are not kept.
    pub own_inputs: String,
    /// The part of the cases that is run; all of them without one.
    pub shard: Option<Shard>,
}

/// Hears how a run proceeds; the program draws a bar from it.
pub trait Progress: Sync {
    /// `total` steps of a phase follow, `done` of which an earlier run has left behind.
    fn phase(&self, name: &str, total: usize, done: usize);
    /// A step is finished.
    fn step(&self, case: &str);
}

/// Progress that nobody hears.
impl Progress for () {
    fn phase(&self, _: &str, _: usize, _: usize) {}
    fn step(&self, _: &str) {}
}

/// Runs `work`; a panic becomes an error with its message.
pub(super) fn guarded<T>(work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| Err(panic_message(payload.as_ref())))
}

pub(super) fn panic_message(payload: &(dyn Any + Send)) -> String {
    let message = payload
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| payload.downcast_ref::<&str>().copied())
        .unwrap_or("no message");
    format!("panicked: {message}")
}
