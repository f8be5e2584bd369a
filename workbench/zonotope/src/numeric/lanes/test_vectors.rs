//! Vectors of space on which the bounds of passes are tested.

use proptest::prelude::*;

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0f64,
        1 => -1e-300..1e-300f64,
        1 => -1e150..1e150f64,
        2 => (-3i32..4).prop_map(f64::from),
        1 => (-9i32..9).prop_map(|i| f64::from(i) * f64::from_bits(1)),
    ]
}

/// Up to forty vectors and one more, with coordinates that are tiny, huge, small integers and multiples of the least
/// double.
pub(crate) fn vectors() -> impl Strategy<Value = (Vec<[f64; 3]>, [f64; 3])> {
    let vector = || [coordinate(), coordinate(), coordinate()];
    (proptest::collection::vec(vector(), 0..40), vector())
}
