//! The runner of the library's property tests, and the number of instances that they draw.

use std::any::Any;
use std::fmt::Debug;

use proptest::strategy::{BoxedStrategy, Strategy};
use proptest::test_runner::{Config, TestCaseResult, TestRunner};

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

/// A value of any type that a property draws.
///
/// proptest compiles its runner anew for each type of values and each closure. All properties draw values of this one
/// type and share one runner: with several hundred properties the runners would be an eighth of what is compiled.
#[derive(Debug)]
struct Drawn(Box<dyn Value>);

trait Value: Any + Debug {
    fn into_any(self: Box<Self>) -> Box<dyn Any>;
}

impl<T: Any + Debug> Value for T {
    fn into_any(self: Box<Self>) -> Box<dyn Any> {
        self
    }
}

/// Holds the values of a strategy to a test.
pub(crate) fn check<S>(config: Config, strategy: S, test: impl Fn(S::Value) -> TestCaseResult)
where
    S: Strategy + 'static,
    S::Value: 'static,
{
    let drawn = strategy.prop_map(|value| Drawn(Box::new(value))).boxed();
    run(config, &drawn, &|Drawn(value)| test(*value.into_any().downcast().expect("the strategy drew it")));
}

fn run(config: Config, drawn: &BoxedStrategy<Drawn>, test: &dyn Fn(Drawn) -> TestCaseResult) {
    let mut runner = TestRunner::new(config);
    let failure = runner.run(drawn, test).err().map(|error| error.to_string());
    assert!(failure.is_none(), "{}\n{runner}", failure.unwrap_or_default());
}

/// Properties in the notation of `proptest!`, which share one runner: see [`Drawn`].
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
            $crate::property_cases::check(config, ($($strategy,)+), |($($value,)+)| {
                $body
                Ok(())
            });
        })*
    };
    ($($properties:tt)*) => {
        properties! { #![proptest_config(proptest::test_runner::Config::default())] $($properties)* }
    };
}
