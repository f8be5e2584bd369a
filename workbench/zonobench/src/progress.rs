//! Progress bars on standard error; silent when that is no terminal.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What is done sooner needs no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar that appears after a second and vanishes when it is dropped.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    shown: OnceLock<()>,
}

impl Progress {
    /// A bar of known length.
    pub fn of(total: u64, what: &str) -> Self {
        let style = ProgressStyle::with_template("{prefix} {wide_bar} {pos}/{len} {elapsed}");
        Self::drawn(ProgressBar::new(total), style.expect("the template is well formed"), what)
    }

    /// A count of things whose number is not known.
    pub fn counting(what: &str) -> Self {
        let style = ProgressStyle::with_template("{pos} {prefix} {elapsed}");
        Self::drawn(ProgressBar::no_length(), style.expect("the template is well formed"), what)
    }

    fn drawn(bar: ProgressBar, style: ProgressStyle, what: &str) -> Self {
        bar.set_draw_target(ProgressDrawTarget::hidden());
        bar.set_style(style);
        bar.set_prefix(what.to_owned());
        Self { bar, shown: OnceLock::new() }
    }

    /// One more is done.
    pub fn step(&self) {
        self.bar.inc(1);
        self.show_in_time();
    }

    fn show_in_time(&self) {
        if self.bar.elapsed() >= PATIENCE {
            self.shown.get_or_init(|| self.bar.set_draw_target(ProgressDrawTarget::stderr()));
        }
    }

    /// A part is done, and the next one has another name.
    pub fn next(&self, what: &str) {
        self.bar.set_prefix(what.to_owned());
        self.step();
    }

    /// So many are done.
    pub fn reach(&self, done: u64) {
        self.bar.set_position(done);
        self.show_in_time();
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// The progress of a run of experiments: one bar a phase.
#[derive(Debug, Default)]
pub struct RunProgress(Mutex<Option<Progress>>);

impl experiments::runner::Progress for RunProgress {
    fn phase(&self, name: &str, total: usize, done: usize) {
        let bar = Progress::of(total as u64, name);
        bar.reach(done as u64);
        *self.bar() = Some(bar);
    }

    fn step(&self, _case: &str) {
        if let Some(bar) = &*self.bar() {
            bar.step();
        }
    }
}

impl RunProgress {
    /// A thread that panicked leaves a bar that is still good to draw on.
    fn bar(&self) -> MutexGuard<'_, Option<Progress>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
