//! How many instances the library's property tests draw.

use proptest::test_runner::Config;

/// An ordinary run draws one in so many of the instances of a long run, which the variable `ZONOTOPE_CASES=long` of the
/// environment asks for. It is read when the tests are compiled, since the library reads no environment.
const ORDINARY_SHARE: u32 = 12;

/// An ordinary run draws at least so many instances, if a long run does.
const ORDINARY_MINIMUM: u32 = 8;

/// The configuration of a property whose long run has `long_run` instances. Those of an ordinary run are the first of
/// them.
pub(crate) fn config(long_run: u32) -> Config {
    let is_long = option_env!("ZONOTOPE_CASES") == Some("long");
    let ordinary = long_run.min(ORDINARY_MINIMUM.max(long_run.div_ceil(ORDINARY_SHARE)));
    Config::with_cases(if is_long { long_run } else { ordinary })
}
