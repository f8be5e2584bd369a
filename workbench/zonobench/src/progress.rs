//! Progress bars on standard error; silent when that is no terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar that vanishes when it is dropped.
#[derive(Debug)]
pub struct Progress(ProgressBar);

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
        bar.set_style(style);
        bar.set_prefix(what.to_owned());
        Self(bar)
    }

    /// One more is done.
    pub fn step(&self) {
        self.0.inc(1);
    }

    /// So many are done.
    pub fn reach(&self, done: u64) {
        self.0.set_position(done);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
