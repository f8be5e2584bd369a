//! Running a property on many instances of a strategy, the same ones for the same seed.

use std::fmt::Debug;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, TestCaseError, TestRunner};

/// The variable of the environment that chooses how many instances a property sees: `long` is its only value.
pub const CASES_VARIABLE: &str = "ZONOTOPE_CASES";

/// An ordinary run draws one in so many of the instances that a long run draws.
const ORDINARY_SHARE: u32 = 12;

/// An ordinary run draws at least so many instances, if a long run does.
const ORDINARY_MINIMUM: u32 = 4;

/// The number of instances that a property sees whose long run has `long_run` of them.
///
/// The instances of an ordinary run are the first of the long run.
pub fn cases(long_run: u32) -> u32 {
    match std::env::var(CASES_VARIABLE) {
        Ok(value) => {
            assert_eq!(value, "long", "{CASES_VARIABLE} has one value");
            long_run
        }
        Err(_) => long_run.min(ORDINARY_MINIMUM.max(long_run.div_ceil(ORDINARY_SHARE))),
    }
}

/// Fails with the smallest instance found for which `property` does not hold, among `long_run` of them, or the share
/// of an ordinary run.
pub fn for_all<S>(strategy: &S, long_run: u32, property: impl Fn(S::Value) -> Result<(), TestCaseError>)
where
    S: Strategy,
    S::Value: Debug,
{
    let config =
        Config { cases: cases(long_run), failure_persistence: None, max_shrink_iters: 4000, ..Config::default() };
    if let Err(failure) = TestRunner::new(config).run(strategy, property) {
        panic!("{failure}");
    }
}
