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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_then_the_farthest_from_its_line_and_from_the_plane_are_taken() {
        let rows = [[1.0, 0.0, 0.0], [4.0, 0.0, 0.0], [3.0, 1.0, 0.0], [1.0, 2.0, 0.1], [-1.0, 1.0, 0.5]];
        assert_eq!(well_spread(5, |i| rows[i]), Some([1, 3, 4]));
        // of many, one in a few is looked at
        let many: Vec<[f64; 3]> = (0..40).map(|i| rows[(i / 3) % 5]).collect();
        let found = well_spread(40, |i| many[i]).expect("they span space");
        assert!(found.iter().all(|i| i % 3 == 0) && found.map(|i| many[i]) == [rows[1], rows[3], rows[4]], "{found:?}");
    }

    #[test]
    fn vectors_of_a_plane_are_not_spread_even_where_rounding_says_so() {
        assert_eq!(well_spread(0, |_| [1.0; 3]), None);
        assert_eq!(well_spread(2, |i| [1.0, i as f64, 0.0]), None);
        let mut told = 0;
        for i in 0..200u32 {
            let [x, y, z] = [0.1, 0.7, 0.3].map(|c| c * f64::from(i + 1));
            let rows = [[x, y, z], [y, -z, x], [z, 0.4 * x, 0.9 * y]].map(|v| v.map(|c| c * 1.1));
            let two = [rows[0], rows[1]];
            // the product of one of two with their normal is rounding
            let found = well_spread(2, |i| two[i]);
            told += u32::from(found.is_none());
            assert!(found.is_none(), "{found:?} {two:?}");
            let [a, b, c] = well_spread(3, |i| rows[i]).expect("they span space");
            assert!(a != b && b != c && c != a);
        }
        assert_eq!(told, 200);
    }
}
