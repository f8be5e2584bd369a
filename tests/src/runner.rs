//! Running a property on many instances of a strategy, the same ones for the same seed.

use families::drawn::properties::hold;
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, TestCaseResult};

/// The variable of the environment that chooses how many instances a property sees: `long` is its only value.
pub const CASES_VARIABLE: &str = "ZONOTOPE_CASES";

/// An ordinary run draws one in so many of the instances that a long run draws.
const ORDINARY_SHARE: u32 = 12;

/// An ordinary run draws at least so many instances, if a long run does.
const ORDINARY_MINIMUM: u32 = 4;

/// Whether a long run is asked for.
pub fn is_long() -> bool {
    let value = std::env::var(CASES_VARIABLE);
    assert!(value.is_err() || value.as_deref() == Ok("long"), "{CASES_VARIABLE} has one value");
    value.is_ok()
}

/// The number of instances that a property sees whose long run has `long_run` of them.
///
/// The instances of an ordinary run are the first of the long run.
pub fn cases(long_run: u32) -> u32 {
    if is_long() { long_run } else { long_run.min(ORDINARY_MINIMUM.max(long_run.div_ceil(ORDINARY_SHARE))) }
}

/// Fails with the smallest instance found for which `property` does not hold, among `long_run` of them, or the share
/// of an ordinary run.
pub fn for_all<S>(strategy: &S, long_run: u32, property: impl Fn(S::Value) -> TestCaseResult)
where
    S: Strategy<Tree: 'static, Value: 'static>,
{
    let config =
        Config { cases: cases(long_run), failure_persistence: None, max_shrink_iters: 4000, ..Config::default() };
    hold(config, strategy, property);
}

/// Properties in the notation of `proptest!`, behind the number of instances of a long run.
#[macro_export]
macro_rules! properties {
    (
        $long_run:expr;
        $($(#[$attribute:meta])* fn $name:ident($($value:pat in $strategy:expr),+ $(,)?) $body:block)*
    ) => {
        $($(#[$attribute])*
        fn $name() {
            $crate::runner::for_all(&($($strategy,)+), $long_run, |($($value,)+)| {
                $body
                Ok(())
            });
        })*
    };
}
