//! Three generators that are far from lying in one plane, chosen from a sample.

use crate::numeric::linear::{cross, dot};

/// The number of generators from which the basis is chosen.
const BASIS_SAMPLE: usize = 16;

/// Three of some generators: the longest, the one farthest from its line, the one farthest from the plane of both.
pub(crate) fn well_spread(count: usize, generator: impl Fn(usize) -> [f64; 3]) -> Option<[usize; 3]> {
    let step = count.div_ceil(BASIS_SAMPLE).max(1);
    let best = |key: &dyn Fn(&[f64; 3]) -> f64| {
        let keyed = (0..count).step_by(step).map(|i| (key(&generator(i)), i));
        keyed.fold((0.0, usize::MAX), |best, own| if own.0 > best.0 { own } else { best }).1
    };
    let first = best(&|v| dot(v, v));
    let a = (first != usize::MAX).then(|| generator(first))?;
    let second = best(&|v| {
        let product = cross(&a, v);
        dot(&product, &product)
    });
    let normal = (second != usize::MAX).then(|| cross(&a, &generator(second)))?;
    let third = best(&|v| dot(&normal, v).abs());
    (third != usize::MAX && third != first && third != second).then_some([first, second, third])
}
