//! Whether a frame is worth an attempt to use, or to keep, what the last one found out.
//!
//! Where bodies move so fast that little of a frame holds in the next, what is kept costs more than it saves. So there
//! is an account of the generators read, in terms of all: an attempt is charged with what it read, and every frame that
//! is no pause pays [`ALLOWANCE`] off, nearly what a fresh query reads. The first attempts, which only lay the ground
//! for others, are within the [`CREDIT`]. Where the debt exceeds that, there is a pause in which frames are asked about
//! afresh, after which one more attempt in vain leads to the next pause, twice as long. In the end one frame in
//! [`LONGEST_PAUSE`] is dearer than a fresh query. A pause ends where what was kept before it has paid half the debt,
//! and is forgotten when all of it is paid.

/// The part of all generators that a frame may read on the average; a fresh query reads them once or twice.
const ALLOWANCE: f64 = 0.75;

/// The charge for a generator that is read to bring sums up to date: it is tried against several cells, and copied.
pub(super) const COPY_CHARGE: f64 = 2.0;

/// The debt that leads to a pause: finding an optimum, then the drift, and making sums near the next optimum are
/// charged with about so much.
const CREDIT: f64 = 8.0;

/// The longest pause, in frames.
const LONGEST_PAUSE: u32 = 64;

/// The account.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Pace {
    /// What was read and is not paid for.
    debt: f64,
    /// The length of the last pause, 0 if it is forgotten.
    pause: u32,
    /// How many frames of it are left.
    left: u32,
}

impl Pace {
    /// A frame was told without an attempt.
    pub(super) fn told(&mut self) {
        self.attempted(0.0);
    }

    /// Whether this frame is outside of a pause.
    pub(super) fn is_due(&mut self) -> bool {
        let is_due = self.left == 0;
        self.left = self.left.saturating_sub(1);
        is_due
    }

    /// An attempt was made, which is charged with so much, in terms of reading all generators once.
    pub(super) fn attempted(&mut self, charge: f64) {
        self.debt = (self.debt + charge - ALLOWANCE).max(0.0);
        if self.debt < CREDIT / 2.0 {
            self.left = 0;
        }
        if self.debt == 0.0 {
            self.pause = 0;
        }
        if self.debt > CREDIT {
            self.debt = CREDIT;
            self.pause = (2 * self.pause + 1).min(LONGEST_PAUSE);
            self.left = self.pause;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many attempts are made in so many frames, each of which reads nearly all generators four times.
    fn attempts(pace: &mut Pace, frames: u32) -> usize {
        let attempt = |_: &u32| {
            let is_due = pace.is_due();
            if is_due {
                pace.attempted(3.5);
            }
            is_due
        };
        (0..frames).filter(attempt).count()
    }

    #[test]
    fn pauses_double_until_the_debt_is_paid() {
        let mut pace = Pace::default();
        // frames 0 to 2, 4, 8, 16, 32, 64 and 128, then one in 65
        assert_eq!(attempts(&mut pace, 129), 9);
        assert_eq!(attempts(&mut pace, 650), 10);
        while !pace.is_due() {}
        (0..20).for_each(|_| pace.told());
        // the credit is there again
        assert_eq!(attempts(&mut pace, 3), 3);
        assert!(!pace.is_due() && pace.is_due());
    }
}
