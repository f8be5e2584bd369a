//! Partial sums kept side by side: a fixed number of them, so that the compiler vectorises a pass and the result is the
//! same on every machine.

/// Partial sums kept side by side.
pub(super) const LANES: usize = 8;

/// The sum of the partial sums, neighbours first.
#[inline(always)]
pub(super) fn joined(lanes: [f64; LANES]) -> f64 {
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + b) + (c + d)) + ((e + f) + (g + h))
}

/// Vectors and a direction of space, if D is 3.
#[inline(always)]
pub(super) fn in_space<'a, const D: usize>(
    vectors: &'a [[f64; D]],
    direction: &'a [f64; D],
) -> Option<(&'a [[f64; 3]], &'a [f64; 3])> {
    let direction = direction.as_slice().try_into().ok()?;
    Some((vectors.as_flattened().as_chunks().0, direction))
}
