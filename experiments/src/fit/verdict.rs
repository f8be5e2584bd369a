//! The verdict of samples on a bound from above, by an interval and a slack that was fixed beforehand.

use super::estimate::Estimate;
use serde::Serialize;

/// The height above zero that the exponent of y / M(n) may have for lower-order terms alone.
///
/// Counts are nearly free of noise, so an interval can be so narrow that a lower-order term keeps it off zero: 3n + 5
/// log n is no pure 3n at any size. The slack must tell neighbouring models apart: a factor log n has a local exponent
/// of 1 / ln n, that is 0.11 at 2^13, the geometric middle of 2^6 .. 2^20, and 0.14 at 2^10. Less than half of the
/// smaller one is 0.05.
pub const EXPONENT_SLACK: f64 = 0.05;

/// The verdict of the samples on one model; the module of the fits defines it.
///
/// It is a test of non-inferiority: that the samples grow no faster than the model has to be shown, and an interval
/// that is wide shows nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ModelVerdict {
    /// The whole interval is at most the slack, and it is not all below minus the slack.
    Within,
    /// The whole interval is below minus the slack.
    Below,
    /// The bound is a number, and no sample exceeds it; no law is fitted for that.
    Kept,
    /// The whole interval is above the slack, or a sample exceeds a bound that is a number.
    Above,
    /// The interval reaches beyond the slack, and has a part that does not.
    Undecided,
}

impl ModelVerdict {
    /// Every verdict: those that keep the bound, that which breaks it, that which leaves it open.
    pub const ALL: [Self; 5] = [Self::Within, Self::Below, Self::Kept, Self::Above, Self::Undecided];

    /// The verdict on the exponent of y / M(n).
    pub fn of(excess: Estimate) -> Self {
        if excess.high < -EXPONENT_SLACK {
            Self::Below
        } else if excess.high <= EXPONENT_SLACK {
            Self::Within
        } else if excess.low > EXPONENT_SLACK {
            Self::Above
        } else {
            Self::Undecided
        }
    }

    /// Whether the samples keep the bound; `None` while that is open.
    pub fn keeps_bound(self) -> Option<bool> {
        match self {
            Self::Within | Self::Below | Self::Kept => Some(true),
            Self::Above => Some(false),
            Self::Undecided => None,
        }
    }
}
