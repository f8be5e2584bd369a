//! The growth models that measurements are compared with.

use serde::{Deserialize, Serialize};
use std::fmt;

/// A function M(n) of the size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GrowthModel {
    /// 1: for quantities that should not depend on n.
    Constant,
    /// n.
    Linear,
    /// n log n.
    Linearithmic,
    /// n log^2 n.
    LinearLogSquared,
    /// n^2.
    Quadratic,
    /// n^(1/4).
    FourthRoot,
    /// n^(1/2).
    SquareRoot,
    /// n^(3/2).
    ThreeHalves,
    /// n^3.
    Cubic,
    /// log^2 n.
    LogSquared,
    /// n^(-1/2).
    InverseSquareRoot,
    /// 1 / n.
    Inverse,
    /// n^(-5/4).
    InverseFiveQuarters,
}

impl GrowthModel {
    /// The four models that a running time is compared with.
    pub const RUNNING_TIMES: &'static [Self] =
        &[Self::Linear, Self::Linearithmic, Self::LinearLogSquared, Self::Quadratic];

    /// Powers of n alone, for sizes of what is built rather than for running times.
    pub const POWERS: &'static [Self] =
        &[Self::SquareRoot, Self::Linear, Self::ThreeHalves, Self::Quadratic, Self::Cubic];

    /// The models of errors and times that fall when more is spent on them.
    pub const FALLING: &'static [Self] =
        &[Self::InverseFiveQuarters, Self::Inverse, Self::InverseSquareRoot, Self::Constant];

    /// The running-time models and the constant.
    pub const ALL: &'static [Self] =
        &[Self::Constant, Self::Linear, Self::Linearithmic, Self::LinearLogSquared, Self::Quadratic];

    /// M(n), with logarithms to base 2, for n >= 2.
    pub fn value(self, n: f64) -> f64 {
        let log = libm::log2(n);
        match self {
            Self::Constant => 1.0,
            Self::Linear => n,
            Self::Linearithmic => n * log,
            Self::LinearLogSquared => n * log * log,
            Self::Quadratic => n * n,
            Self::FourthRoot => n.sqrt().sqrt(),
            Self::SquareRoot => n.sqrt(),
            Self::ThreeHalves => n * n.sqrt(),
            Self::Cubic => n * n * n,
            Self::LogSquared => log * log,
            Self::InverseSquareRoot => 1.0 / n.sqrt(),
            Self::Inverse => 1.0 / n,
            Self::InverseFiveQuarters => 1.0 / (n * n.sqrt().sqrt()),
        }
    }

    /// The natural logarithm of M(n).
    pub fn ln_value(self, n: f64) -> f64 {
        libm::log(self.value(n))
    }
}

impl fmt::Display for GrowthModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Constant => "1",
            Self::Linear => "n",
            Self::Linearithmic => "n log n",
            Self::LinearLogSquared => "n log^2 n",
            Self::Quadratic => "n^2",
            Self::FourthRoot => "n^(1/4)",
            Self::SquareRoot => "n^(1/2)",
            Self::ThreeHalves => "n^(3/2)",
            Self::Cubic => "n^3",
            Self::LogSquared => "log^2 n",
            Self::InverseSquareRoot => "n^(-1/2)",
            Self::Inverse => "1 / n",
            Self::InverseFiveQuarters => "n^(-5/4)",
        })
    }
}
