//! The runner of property tests, compiled once for all of them.
//!
//! proptest compiles its runner anew for each type of values and each closure. Here all properties draw values of one
//! type and share one runner: with several hundred properties the runners would be an eighth of what is compiled.

use std::any::Any;
use std::fmt::{self, Debug, Formatter};

use proptest::strategy::{NewTree, Strategy, ValueTree};
use proptest::test_runner::{Config, TestCaseResult, TestRunner};

/// A value of any type.
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

/// The tree of a value of any type.
struct AnyTree<T>(T);

impl<T: ValueTree<Value: 'static>> ValueTree for AnyTree<T> {
    type Value = Drawn;

    fn current(&self) -> Drawn {
        Drawn(Box::new(self.0.current()))
    }

    fn simplify(&mut self) -> bool {
        self.0.simplify()
    }

    fn complicate(&mut self) -> bool {
        self.0.complicate()
    }
}

/// A strategy for values of any type.
struct AnyStrategy<'a>(&'a dyn Draws);

trait Draws {
    fn draw(&self, runner: &mut TestRunner) -> NewTree<AnyStrategy<'static>>;
}

impl<S: Strategy<Tree: 'static, Value: 'static>> Draws for S {
    fn draw(&self, runner: &mut TestRunner) -> NewTree<AnyStrategy<'static>> {
        Ok(Box::new(AnyTree(self.new_tree(runner)?)))
    }
}

impl Debug for AnyStrategy<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("a strategy")
    }
}

impl Strategy for AnyStrategy<'_> {
    type Tree = Box<dyn ValueTree<Value = Drawn>>;
    type Value = Drawn;

    fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
        self.0.draw(runner)
    }
}

/// Holds the values of a strategy to a property; fails with the smallest value found for which it does not hold.
pub fn hold<S>(config: Config, strategy: &S, property: impl Fn(S::Value) -> TestCaseResult)
where
    S: Strategy<Tree: 'static, Value: 'static>,
{
    run(config, &AnyStrategy(strategy), &|Drawn(value)| {
        property(*value.into_any().downcast().expect("the strategy drew it"))
    });
}

fn run(config: Config, strategy: &AnyStrategy<'_>, property: &dyn Fn(Drawn) -> TestCaseResult) {
    let mut runner = TestRunner::new(config);
    let failure = runner.run(strategy, property).err().map(|error| error.to_string());
    assert!(failure.is_none(), "{}\n{runner}", failure.unwrap_or_default());
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::test_runner::TestCaseError;

    fn below(limit: i32, value: i32) -> TestCaseResult {
        if value < limit { Ok(()) } else { Err(TestCaseError::fail("not below")) }
    }

    #[test]
    fn what_holds_holds_and_what_fails_is_told_by_the_smallest_value() {
        let config = || Config { failure_persistence: None, ..Config::with_cases(100) };
        hold(config(), &(0..50i32, 0..9u8), |(a, _)| below(50, a));
        let told = std::panic::catch_unwind(|| hold(config(), &(0..50i32), |a| below(17, a)));
        let told = told.expect_err("half of the values fail");
        let told = told.downcast_ref::<String>().expect("a message");
        assert!(told.contains("not below") && told.contains("\n    17,\n"), "{told}");
    }
}
