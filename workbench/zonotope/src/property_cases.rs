//! The notation of the library's property tests, and the number of instances that they draw.

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

/// Properties in the notation of `proptest!`, which share one runner.
macro_rules! properties {
    (
        #![proptest_config($config:expr)]
        $($(#[$attribute:meta])* fn $name:ident($($value:pat in $strategy:expr),+ $(,)?) $body:block)*
    ) => {
        $($(#[$attribute])*
        fn $name() {
            let config = proptest::test_runner::Config {
                source_file: Some(file!()),
                test_name: Some(concat!(module_path!(), "::", stringify!($name))),
                ..$config
            };
            families::drawn::properties::hold(config, &($($strategy,)+), |($($value,)+)| {
                $body
                Ok(())
            });
        })*
    };
    ($($properties:tt)*) => {
        properties! { #![proptest_config(proptest::test_runner::Config::default())] $($properties)* }
    };
}
