//! The product of two doubles and what rounding it leaves behind.

/// a · b as an unevaluated sum of two doubles, the rounded product and its error (Dekker, Veltkamp); exact unless a
/// part overflows or underflows.
#[inline]
pub(crate) fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a_head, a_tail), (b_head, b_tail)) = (halves(a), halves(b));
    (product, ((a_head * b_head - product) + a_head * b_tail + a_tail * b_head) + a_tail * b_tail)
}

/// A double as the sum of two of at most 26 bits each.
#[inline]
fn halves(value: f64) -> (f64, f64) {
    const SPLITTER: f64 = ((1_u64 << 27) + 1) as f64;
    let scaled = SPLITTER * value;
    let head = scaled - (scaled - value);
    (head, value - head)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use proptest::prelude::*;

    properties! {
        #[test]
        fn products_are_exact(a in -1e100..1e100f64, b in -1e-90..1e100f64) {
            let (head, tail) = exact_product(a, b);
            let exact = |v: f64| Dyadic::from_f64(v);
            prop_assert_eq!(head, a * b);
            prop_assert_eq!(exact(head) + exact(tail), exact(a) * exact(b));
        }
    }
}
