//! Progress bars on standard error; silent when that is no terminal.

use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::{JoinHandle, spawn};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work that is done sooner needs no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// The interval after which the elapsed time is drawn anew.
const TICK: Duration = Duration::from_millis(250);

/// A bar that appears after a second and vanishes when it is dropped.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    /// Shows the bar in time, unless the other end of its channel is dropped before.
    waiting: Option<(Sender<()>, JoinHandle<()>)>,
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
        let (sender, receiver) = channel();
        let own = bar.clone();
        let waiting = Some((sender, spawn(move || show_in_time(&own, &receiver))));
        Self { bar, waiting }
    }

    /// One more is done.
    pub fn step(&self) {
        self.bar.inc(1);
    }

    /// A part is done, and the next one has another name.
    pub fn next(&self, what: &str) {
        self.bar.set_prefix(what.to_owned());
        self.step();
    }

    /// Shows that the given number of steps is done.
    pub fn reach(&self, done: u64) {
        self.bar.set_position(done);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.waiting.take() {
            drop(sender);
            // a thread that could not draw leaves nothing to clear
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}

fn show_in_time(bar: &ProgressBar, ended: &Receiver<()>) {
    if ended.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
        bar.set_draw_target(ProgressDrawTarget::stderr());
        bar.enable_steady_tick(TICK);
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
