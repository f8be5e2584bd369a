//! Readings and refusals of a JSON document.

use batch::json::{MAX_VALUES, ReadError, Tree, read};

fn tree(text: &str) -> Tree {
    read(text.as_bytes(), 100).expect("the text is JSON")
}

#[test]
fn values_keep_their_kind() {
    assert_eq!(tree("null"), Tree::Null);
    assert_eq!(tree(" true "), Tree::Bool(true));
    assert_eq!(tree("-0").float().map(f64::to_bits), Some((-0.0_f64).to_bits()));
    assert_eq!(tree("18446744073709551615").float(), Some(18_446_744_073_709_551_615.0));
    assert_eq!(tree("9007199254740993").float(), Some(9_007_199_254_740_992.0));
    assert_eq!(tree("5e-324").float(), Some(f64::from_bits(1)));
    assert_eq!(tree("\"-Infinity\"").float(), Some(f64::NEG_INFINITY));
    assert_eq!(tree("3.0").index(), Some(3));
    assert_eq!(tree("-1").index(), None);
    assert_eq!(tree("1.5").index(), None);
    assert_eq!(tree("{\"a\": [1]}").field("a").and_then(Tree::list).map(<[Tree]>::len), Some(1));
}

#[test]
fn mistakes_are_told_apart() {
    let error = |text: &str| read(text.as_bytes(), 4).expect_err("the text is refused");
    assert!(matches!(error("[1,\n 2"), ReadError::Syntax { line: 2, .. }));
    assert!(matches!(error("[1] 2"), ReadError::Syntax { .. }));
    assert!(matches!(error("NaN"), ReadError::Syntax { .. }));
    assert!(matches!(error("[1, 1e999]"), ReadError::OutOfRange { line: 1, .. }));
    assert!(matches!(error("[1, 2, 3, 4]"), ReadError::TooManyValues { limit: 4 }));
    assert!(matches!(error("{\"a\":1,\"a\":2}"), ReadError::RepeatedField { field, .. } if field == "a"));
}

#[test]
fn deep_nesting_is_refused_without_overflow() {
    let deep = "[".repeat(1_000_000);
    assert!(matches!(read(deep.as_bytes(), MAX_VALUES), Err(ReadError::Syntax { .. })));
    let deep = "{\"a\":".repeat(1_000_000);
    assert!(matches!(read(deep.as_bytes(), MAX_VALUES), Err(ReadError::Syntax { .. })));
}
