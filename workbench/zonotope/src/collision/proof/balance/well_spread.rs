//! Three generators that are far from lying in one plane, chosen from a sample.

use crate::collision::proof::vectors::first_of_largest;
use crate::numeric::linear::{cross, dot};

/// The number of generators from which the basis is chosen.
const BASIS_SAMPLE: usize = 16;

/// Three of some generators: the longest, the one farthest from its line, the one farthest from the plane of both.
pub(crate) fn well_spread(count: usize, generator: impl Fn(usize) -> [f64; 3]) -> Option<[usize; 3]> {
    let step = count.div_ceil(BASIS_SAMPLE).max(1);
    let best =
        |key: &dyn Fn(&[f64; 3]) -> f64| first_of_largest((0..count).step_by(step).map(|i| (key(&generator(i)), i)));
    let first = best(&|v| dot(v, v))?;
    let a = generator(first);
    let second = best(&|v| {
        let product = cross(&a, v);
        dot(&product, &product)
    })?;
    let normal = cross(&a, &generator(second));
    let third = best(&|v| dot(&normal, v).abs())?;
    (third != first && third != second).then_some([first, second, third])
}
