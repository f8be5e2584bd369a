//! Samples of the time in which two bodies are said not to meet.
//!
//! A distance at a time that is more than what the bodies move until both ends of an interval proves, but for
//! rounding, that they do not meet in it; else the interval is halved.

/// Intervals shorter than this are not halved: the bodies are so near there that samples leave it open.
const SHORTEST: f64 = 1.0 / (1u64 << 24) as f64;

/// The relation of samples to an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Samples {
    /// They prove the bodies free where the answer says so, but for rounding.
    Prove,
    /// They agree and leave intervals open.
    Agree,
    /// They contradict it.
    Contradict,
}

impl Samples {
    /// Holds the time until `end`, in which two bodies are said not to meet, to at most `limit` samples.
    ///
    /// The bodies are as far apart as `distance_at` says, from below, and come nearer by no more than `speed` a unit of
    /// time; where the distance is zero, `meet` says whether they overlap by more than rounding.
    pub fn of_free_time(
        end: f64,
        speed: f64,
        limit: u32,
        distance_at: impl Fn(f64) -> f64,
        meet: impl Fn(f64) -> bool,
    ) -> Self {
        // nothing is said to be free before a contact at the start
        let mut open = if end > 0.0 { vec![[0.0, end]] } else { Vec::new() };
        let mut samples = Self::Prove;
        for _ in 0..limit {
            let Some([from, until]) = open.pop() else { return samples };
            let half = (until - from) / 2.0;
            let middle = from + half;
            let distance = distance_at(middle);
            if distance > speed * half {
                continue;
            }
            if distance == 0.0 && meet(middle) {
                return Self::Contradict;
            }
            if half <= SHORTEST {
                samples = Self::Agree;
                continue;
            }
            open.extend([[middle, until], [from, middle]]);
        }
        if open.is_empty() { samples } else { Self::Agree }
    }
}
